/** Numbers, times and names as they stand on the screen. */

import type { Speed } from './protocol';

/** A number with a fixed count of decimals, a true minus sign and no negative zero. */
export function number(value: number, decimals = 2): string {
  if (!Number.isFinite(value)) return '–';
  const digits = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(digits) !== 0 ? `−${digits}` : digits;
}

/** Like [`number`], with a sign in any case. */
export function signed(value: number, decimals = 2): string {
  const text = number(value, decimals);
  return text.startsWith('−') ? text : `+${text}`;
}

/** A number as short as it can be said without losing more than the fifth digit. */
export function brief(value: number): string {
  return String(Number(value.toPrecision(5))).replace('-', '−');
}

/** Degrees with their unit. */
export function degrees(value: number, decimals = 1): string {
  return `${number(value, decimals)}°`;
}

/** Metres with their unit. */
export function metres(value: number, decimals = 2): string {
  return `${number(value, decimals)} m`;
}

/** "1 trial", "2 trials". */
export function count(amount: number, noun: string): string {
  return `${amount.toLocaleString('en')} ${amount === 1 ? noun : `${noun}s`}`;
}

/** A pace as a phrase. */
export function pace(speed: Speed): string {
  return speed === 'max' ? 'as fast as it goes' : `${brief(speed)} ticks/s`;
}

/** How long ago, in the largest unit that fits. */
export function ago(at: string, now: number): string {
  const seconds = Math.max(0, (now - Date.parse(at)) / 1000);
  if (!Number.isFinite(seconds)) return '';
  if (seconds < 45) return 'just now';
  const steps: [number, string][] = [
    [86400, 'day'],
    [3600, 'hour'],
    [60, 'minute'],
  ];
  for (const [length, unit] of steps) {
    if (seconds >= length) return `${count(Math.floor(seconds / length), unit)} ago`;
  }
  return '1 minute ago';
}

/** Date and time to the second, in the reader's zone. */
export function exact(at: string): string {
  const date = new Date(at);
  if (Number.isNaN(date.getTime())) return at;
  const two = (part: number) => String(part).padStart(2, '0');
  const day = [date.getFullYear(), two(date.getMonth() + 1), two(date.getDate())].join('-');
  return `${day} ${clock(at)}`;
}

/** Time of day to the second, in the reader's zone. */
export function clock(at: string): string {
  const date = new Date(at);
  if (Number.isNaN(date.getTime())) return at;
  return [date.getHours(), date.getMinutes(), date.getSeconds()]
    .map((part) => String(part).padStart(2, '0'))
    .join(':');
}

/** A name of the interface as words: `minimum-cost-path` becomes "minimum cost path". */
export function words(name: string): string {
  return name.replace(/[-_]/g, ' ');
}

/** A sentence's first letter in upper case. */
export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}
