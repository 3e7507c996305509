import { afterEach, beforeEach, expect, it, vi } from 'vitest';

import { Throttle } from './throttle';

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it('acts at once, then at most every second with the newest value', () => {
  const seen: number[] = [];
  const throttle = new Throttle<number>(1000, (value) => seen.push(value));
  [1, 2, 3].forEach((value) => throttle.offer(value));
  expect(seen).toEqual([1]);
  vi.advanceTimersByTime(1000);
  expect(seen).toEqual([1, 3]);
  vi.advanceTimersByTime(5000);
  throttle.offer(4);
  expect(seen).toEqual([1, 3, 4]);
});

it('forgets what waits when it is stopped', () => {
  const seen: number[] = [];
  const throttle = new Throttle<number>(1000, (value) => seen.push(value));
  throttle.offer(1);
  throttle.offer(2);
  throttle.stop();
  vi.advanceTimersByTime(5000);
  expect(seen).toEqual([1]);
});
