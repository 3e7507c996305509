import { describe, expect, it } from 'vitest';

import { cone, fit, inWorld, onCanvas, shapeOf, shownOf, tip, wayShare } from './geometry';
import { sampleCourse } from './sample';

const close = (found: number[], expected: number[]) =>
  expected.forEach((value, index) => expect(found[index]).toBeCloseTo(value, 9));

it('turns the robot’s frame into the world', () => {
  close(inWorld({ x_m: 3, y_m: 1, heading_deg: 90 }, [0.375, 0.35]), [2.65, 1.375]);
  close(inWorld({ x_m: 0, y_m: 0, heading_deg: 180 }, [1, 2]), [-1, -2]);
});

it('opens a cone of 30 degrees around its axis', () => {
  const sonar = { x_m: 0.3, y_m: 0.1, bearing_deg: 60 };
  const [apex, ...arc] = cone(sonar, 15, 2);
  close(apex ?? [], [0.3, 0.1]);
  const bearings = arc.map(([x, y]) => (Math.atan2(y - 0.1, x - 0.3) * 180) / Math.PI);
  close(bearings.slice(0, 1), [45]);
  close(bearings.slice(-1), [75]);
  arc.forEach(([x, y]) => expect(Math.hypot(x - 0.3, y - 0.1)).toBeCloseTo(2, 9));
  close(tip(sonar, 2), [0.3 + 1, 0.1 + Math.sqrt(3)]);
});

describe('what is shown', () => {
  const pose = (x_m: number) => ({ x_m, y_m: 0, heading_deg: 0 });

  it('of a corridor follows the robot, and stops at its ends', () => {
    const course = sampleCourse();
    const middle = shownOf(course, pose(50));
    expect((middle[0] + middle[2]) / 2).toBeCloseTo(50, 9);
    expect(middle[2] - middle[0]).toBeLessThan(12);
    expect([middle[1] < -1.2, middle[3] > 1.2]).toEqual([true, true]);
    expect(shownOf(course, pose(1.2))[0]).toBeLessThan(0);
    expect(shownOf(course, pose(1.2))[0]).toBeGreaterThan(-1);
    expect(shownOf(course, pose(97))[2]).toBeLessThan(101);
  });

  it('of an approach is the last metres before the wall, more when the robot is further', () => {
    const course = sampleCourse({ kind: 'wall-approach', bounds_m: [-12, -10, 0, 10] });
    const [near, , end] = shownOf(course, pose(-0.6));
    expect([near < -2.5, near > -4, end > 0, end < 1]).toEqual([true, true, true, true]);
    expect(shownOf(course, pose(-9))[0]).toBeLessThan(-9.375);
  });

  it('of a block world is all of it', () => {
    const [x0, y0, x1, y1] = shownOf(
      sampleCourse({ kind: 'block-world', bounds_m: [0, 0, 9.5, 8] }),
      pose(4),
    );
    expect([x0 < 0, y0 < 0, x1 > 9.5, y1 > 8]).toEqual([true, true, true, true]);
  });

  it('has the shape that the panel keeps', () => {
    const course = sampleCourse();
    const [x0, y0, x1, y1] = shownOf(course, pose(50));
    expect(shapeOf(course)).toBeCloseTo((x1 - x0) / (y1 - y0), 9);
  });
});

it('lays a window into the middle of a canvas, y upwards', () => {
  const at = fit([0, 0, 10, 5], 400, 300);
  expect(at.scale).toBe(40);
  close(onCanvas(at, [0, 0]), [0, 250]);
  close(onCanvas(at, [10, 5]), [400, 50]);
});

it('says how much of the way is done', () => {
  const course = sampleCourse();
  expect(wayShare(course, 48.75)).toBe(0.5);
  expect([wayShare(course, -1), wayShare(course, 99)]).toEqual([0, 1]);
  expect(wayShare({ ...course, finish_m: null }, 3)).toBeNull();
});
