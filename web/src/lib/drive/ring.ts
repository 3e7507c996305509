/** The polar plot of sonars that look ahead, as SVG paths: heading up, angles counter-clockwise from it. */

import { rings } from '../polar';

/** Radii of the plot: where reading 0 lies, and where the greatest does. */
export interface Ring {
  hub: number;
  rim: number;
}

/** Distances of the rings, metres; at most four, so that their names have room. */
export function ringLabels(range_m: number): number[] {
  const all = rings(range_m);
  return all.length > 4 ? all.filter((_, index) => index % 2 === 1) : all;
}

/** Place of a share of the range on a bearing. */
export function spotOf({ hub, rim }: Ring, share: number, bearing_deg: number): [number, number] {
  const radius = hub + share * (rim - hub);
  const along = (bearing_deg * Math.PI) / 180;
  return [rounded(-radius * Math.sin(along)), rounded(-radius * Math.cos(along))];
}

/** An arc at a share of the range, from a bearing to one further left. */
export function arc(ring: Ring, share: number, from_deg: number, to_deg: number): string {
  const radius = rounded(ring.hub + share * (ring.rim - ring.hub));
  return `M${spotOf(ring, share, from_deg)}A${radius},${radius} 0 0 0 ${spotOf(ring, share, to_deg)}`;
}

/** A sector from the hub to a share of the range, between bearings to its left and right. */
export function sector(ring: Ring, share: number, left_deg: number, right_deg: number): string {
  const within = `A${ring.hub},${ring.hub} 0 0 1 ${spotOf(ring, 0, right_deg)}`;
  return `${arc(ring, share, right_deg, left_deg)}L${spotOf(ring, 0, left_deg)}${within}Z`;
}

const rounded = (value: number) => Math.round(value * 100) / 100;
