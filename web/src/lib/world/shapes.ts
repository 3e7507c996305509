/** Shapes of the worlds interface. */

export interface WorldRule {
  axis?: 'x' | 'y' | null;
  a?: number | null;
  b?: number | null;
  above?: number | null;
  below?: number | null;
}
export interface WorldRegion {
  name: string;
  rules: WorldRule[];
}
export interface WorldFile {
  name: string;
  title: string;
  summary: string;
  source: string;
  walls: [number, number][][];
  blocks: [number, number][][];
  floor: [number, number][][];
  regions: WorldRegion[];
  home: { x: number; y: number; heading_deg: number };
  goal: { x: number; y: number; radius_m: number };
}
export interface PlaceView {
  x_m: number;
  y_m: number;
}
export interface WorldProblem {
  field: string;
  message: string;
  place: PlaceView | null;
  nearest: PlaceView | null;
}
export interface WorldSummary {
  name: string;
  title: string;
  summary: string;
  built_in: boolean;
  problem: string | null;
  bounds_m: [number, number, number, number] | null;
  walls: number;
  regions: string[];
}
export interface RegionShape {
  name: string;
  polygons_m: [number, number][][];
}
export interface WorldCheck {
  ok: boolean;
  world: WorldFile;
  problems: WorldProblem[];
  bounds_m: [number, number, number, number] | null;
  walls: number;
  regions: RegionShape[];
  clearance_m: number | null;
  distance_m: number;
  way_m: number | null;
  robot_radius_m: number;
  taken: string | null;
}
export interface MapPicture {
  png_base64: string;
  width_px: number;
  height_px: number;
  corner: PlaceView;
  yaw_deg: number;
  width_m: number;
  height_m: number;
}
export interface TraceDraft {
  world: WorldFile;
  resolution_m: number;
  width_cells: number;
  height_cells: number;
  free_cells: number;
  occupied_cells: number;
  unknown_cells: number;
  free_area_m2: number;
  segments_before: number;
  segments_after: number;
  specks_dropped: number;
  bounds_m: [number, number, number, number];
  picture: MapPicture;
}
export interface RegionProposal {
  regions: WorldRegion[];
  shapes: RegionShape[];
}
