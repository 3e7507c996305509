import { expect, it } from 'vitest';

import { frameOf, neighbour, neuronAt, utilityRange } from './neuronmap';
import type { WorldView } from './protocol';
import { sampleNeuron } from './sample';

const world = { bounds_m: [0, 0, 4, 2], regions: ['room'] } as unknown as WorldView;
const neurons = [sampleNeuron(1, 1, 1), sampleNeuron(2, 3, 1), sampleNeuron(3, 1, 2)];
const map = { world, neurons, selected: null, winner: null };

it('fits the world with y up and one scale', () => {
  const frame = frameOf(world, 424, 424);
  expect([frame.scale, frame.x(0), frame.x(4), frame.y(0), frame.y(2)]).toEqual([
    100, 12, 412, 312, 112,
  ]);
});

it('finds the neuron under the pointer, and none in the open', () => {
  const frame = frameOf(world, 424, 224);
  expect(neuronAt(map, frame, 115, 110)).toBe(1);
  expect(neuronAt(map, frame, 200, 200)).toBeNull();
});

it('walks with the arrow keys and stays at the edge', () => {
  expect(neighbour(neurons, null, 'ArrowRight')).toBe(1);
  expect(neighbour(neurons, 1, 'ArrowRight')).toBe(2);
  expect(neighbour(neurons, 1, 'ArrowUp')).toBe(3);
  expect(neighbour(neurons, 1, 'ArrowLeft')).toBe(1);
});

it('ignores pending utilities', () => {
  const pending = { ...sampleNeuron(4, 0, 0), utility: null };
  expect(utilityRange([pending])).toBeNull();
  expect(utilityRange([...neurons, pending])).toEqual([-1, -1]);
});
