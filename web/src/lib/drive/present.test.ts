import { expect, it } from 'vitest';

import { lookOf, placeOf, shownMethods, sigmaOf } from './depths';
import { ECHOES, echoKind, isMarked, tally } from './echoes';
import { methodName, numeral, regionName, sonarName } from './names';
import { arc, ringLabels, sector, spotOf } from './ring';
import { sampleCourse, sampleCycle } from './sample';

it('names methods, regions and sonars', () => {
  const course = sampleCourse();
  expect([methodName('median-kalman'), methodName('some-new')]).toEqual([
    'Median + Kalman',
    'some new',
  ]);
  expect([regionName(course, 0), regionName({ ...course, rules: null }, 3), numeral(11)]).toEqual([
    'I far left',
    'IV',
    '12',
  ]);
  expect([sonarName(course, 3), sonarName(course, 9)]).toEqual([
    'sonar 3, 26° left',
    'sonar 9, 60° right',
  ]);
});

it('names regions by numeral alone where the rules have others', () => {
  const cut = (regions: number) =>
    sampleCourse({ regions: Array.from({ length: regions }, () => [0]) });
  expect([regionName(cut(7), 1), regionName(cut(3), 2)]).toEqual(['II', 'III']);
});

it('counts readings by kind, and tells kinds apart by mark and by colour', () => {
  const readings = ['ghost', 'echo', 'ghost', 'none'].map((echo) => ({ range_m: 1, echo }));
  expect(tally(readings).map(({ kind, n }) => [kind.echo, n])).toEqual([
    ['echo', 1],
    ['none', 1],
    ['ghost', 2],
  ]);
  for (const key of ['mark', 'colour', 'name'] as const)
    expect(new Set(ECHOES.map((each) => each[key])).size).toBe(ECHOES.length);
  expect(['echo', 'none', 'silent', 'dropped'].map(isMarked)).toEqual([false, false, true, true]);
  expect(echoKind('novel').name).toBe('novel');
});

it('always shows the method that drives', () => {
  const course = sampleCourse();
  expect(shownMethods(course, ['median'], 'minimum')).toEqual(['minimum', 'median']);
  expect(shownMethods(course, [], '')).toEqual([]);
  expect([placeOf(course, 'median-kalman'), placeOf(course, 'no such')]).toEqual([3, -1]);
});

it('knows which methods say how sure they are', () => {
  const cycle = sampleCycle(1);
  const sigmas = sampleCourse().methods.map(({ name }) => sigmaOf(cycle, 0, name));
  expect(sigmas).toEqual([null, 0.16, null, 0.16, 0.12]);
  expect(sigmaOf(cycle, 9, 'median-kalman')).toBeNull();
});

it('draws methods so that colour is not all that tells them apart', () => {
  const looks = sampleCourse().methods.map(({ name }) => lookOf(name));
  expect(new Set(looks.map(({ dash }) => dash.join())).size).toBe(looks.length);
  expect(new Set(looks.map(({ colour }) => colour)).size).toBe(looks.length);
});

it('lays sonars around the robot, heading up and left on the left', () => {
  const ring = { hub: 10, rim: 110 };
  expect(spotOf(ring, 0.5, 0)).toEqual([-0, -60]);
  expect(spotOf(ring, 1, 90)[0]).toBe(-110);
  expect(arc(ring, 1, -90, 90)).toMatch(/^M110,-?0A110,110 0 0 0 -110,-?0$/);
  expect(sector(ring, 0, 10, -10).endsWith('Z')).toBe(true);
  expect([ringLabels(2), ringLabels(1).length <= 4]).toEqual([[0.5, 1, 1.5, 2], true]);
});
