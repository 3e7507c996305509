/** Names of worlds: what stands in a file's name and in the setting `world`. */

/** The longest name. */
export const LONGEST = 64;

/** A name made from a title. */
export function nameFrom(title: string): string {
  return title
    .normalize('NFKD')
    .replace(/\p{Mark}/gu, '')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .slice(0, LONGEST)
    .replace(/^-+|-+$/g, '');
}

/** A name that none of the taken ones is: itself, or with a number. */
export function freeName(wanted: string, taken: string[]): string {
  const name = wanted || 'world';
  for (let number = 1; ; number += 1) {
    const found = number === 1 ? name : `${name.slice(0, LONGEST - 5)}-${number}`;
    if (!taken.includes(found) && found !== 'new') return found;
  }
}
