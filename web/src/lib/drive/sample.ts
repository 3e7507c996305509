/** A course, cycles and runs of chapter 2, for tests: as the server would send them. */

import type {
  CourseView,
  CycleView,
  DriveRunView,
  DriveScore,
  InferenceView,
  RuleBaseView,
  SetView,
  VariableView,
} from '../protocol';

const METHODS = ['minimum', 'minimum-kalman', 'median', 'median-kalman', 'median-walk'];

/** The TRC's front from the far left: x and y in metres, axis in degrees. */
const SONARS = [
  [0.325, 0.35, 60],
  [0.365, 0.335, 51],
  [0.375, 0.285, 40],
  [0.375, 0.2, 26],
  [0.375, 0.08, 9],
] as const;

/** The three sets of a depth with the corners of figure 2.7. */
function threats([dangerous, from, to, safe]: [number, number, number, number]): SetView[] {
  return [
    { name: 'safe', corners: [to, safe, 2, 2] },
    { name: 'steer', corners: [dangerous, from, to, safe] },
    { name: 'dangerous', corners: [0, 0, dangerous, from] },
  ];
}

/** The navigator of section 2.7 without its rules. */
export function sampleRules(): RuleBaseView {
  const depth = (name: string, corners: [number, number, number, number]): VariableView => ({
    name,
    unit: 'm',
    range: [0, 2],
    sets: threats(corners),
  });
  const output = (name: string, unit: string, range: [number, number]) => ({
    name,
    unit,
    range,
    sets: [],
  });
  return {
    name: 'navigator',
    title: 'The navigator of section 2.7',
    inputs: [
      depth('far_left', [0.15, 0.25, 0.35, 0.5]),
      depth('left', [0.2, 0.3, 0.55, 1]),
      depth('centre', [0.2, 0.3, 0.55, 1]),
      depth('right', [0.2, 0.3, 0.55, 1]),
      depth('far_right', [0.15, 0.25, 0.35, 0.5]),
      {
        name: 'velocity',
        unit: 'cm/s',
        range: [-10, 15],
        sets: [
          { name: 'reverse', corners: [-10, -10, -2, 0] },
          { name: 'slow', corners: [-2, 0, 3, 5] },
          { name: 'normal', corners: [3, 5, 8, 10] },
          { name: 'fast', corners: [8, 10, 15, 15] },
        ],
      },
    ],
    outputs: [output('v', 'cm/s', [-10, 15]), output('w', 'deg/s', [-10, 10])],
    rules: 972,
  };
}

/** The corridor, 100 m by 2.4 m with doors at 25, 50 and 75 m. */
export function sampleCourse(changes: Partial<CourseView> = {}): CourseView {
  const right = SONARS.map(([x_m, y_m, bearing_deg]) => ({
    x_m,
    y_m: -y_m,
    bearing_deg: -bearing_deg,
  })).reverse();
  return {
    kind: 'corridor',
    title: 'Corridor',
    bounds_m: [0, -1.2, 100, 1.2],
    faces: [
      { segment_m: [0, -1.2, 100, -1.2], surface: 'wall' },
      { segment_m: [100, 1.2, 0, 1.2], surface: 'wall' },
    ],
    robot_corners_m: [
      [0.375, -0.35],
      [0.375, 0.35],
      [-0.375, 0.35],
      [-0.375, -0.35],
    ],
    sonars: [...SONARS.map(([x_m, y_m, bearing_deg]) => ({ x_m, y_m, bearing_deg })), ...right],
    half_cone_deg: 15,
    sonar_range_m: 2,
    regions: [
      [0, 1, 2],
      [1, 2, 3, 4],
      [3, 4, 5, 6],
      [5, 6, 7, 8],
      [7, 8, 9],
    ],
    methods: METHODS.map((name) => ({ name, meaning: `the ${name}` })),
    drivers: ['minimum', 'median-kalman'],
    doors: [25, 50, 75].map((x_m) => ({ x_m, half_width_m: 0.9 })),
    finish_m: 97.5,
    person_radius_m: 0.22,
    chi_square: [0.000982, 5.0239],
    rules: sampleRules(),
    ...changes,
  };
}

/** A cycle of a run in the middle of the corridor; `cycle` is its tick too unless told otherwise. */
export function sampleCycle(cycle: number, changes: Partial<CycleView> = {}): CycleView {
  return {
    tick: cycle,
    round: 1,
    run: 1,
    cycle,
    time_s: 0.4 * cycle,
    method: 'median-kalman',
    pose: { x_m: 1.2 + 0.04 * cycle, y_m: 0, heading_deg: 0 },
    speed_m_s: 0.1,
    turn_deg_s: 0,
    compass_deg: 0,
    motor_load: 0,
    readings: Array.from({ length: 10 }, () => ({ range_m: 2, echo: 'none' })),
    regions: Array.from({ length: 5 }, () => ({
      live: 3,
      depths_m: [0.9, 1, 1.2, 1.3, 1.25],
      sigma_m: 0.16,
      walk_sigma_m: 0.12,
      truth_m: 1.2,
      nis: 1,
      nees: 0.5,
    })),
    inference: null,
    command_m_s: 0.1,
    command_deg_s: 0,
    bump: null,
    backing_off: false,
    clearance_m: 0.6,
    people_m: [],
    blind: null,
    ...changes,
  };
}

/** Half way between safe and steer on the left at 12 cm/s: two rules, each half as strong. */
export function sampleInference(): InferenceView {
  const safe = [1, 0, 0];
  const when = (left: string) => ['safe', left, 'safe', 'safe', 'safe', 'fast'];
  return {
    inputs: [2, 0.775, 2, 2, 2, 12],
    memberships: [safe, [0.5, 0.5, 0], safe, safe, safe, [0, 0, 0, 1]],
    fired: 2,
    firings: [
      { rule: 3, strength: 0.5, when: when('safe'), then: [15, 0], because: 'v R1, w R2' },
      { rule: 111, strength: 0.5, when: when('steer'), then: [13, -3.5], because: 'v R1, w R2' },
    ],
    outputs: [14, -1.75],
  };
}

/** What a run through the corridor came to. */
export function sampleScore(changes: Partial<DriveScore> = {}): DriveScore {
  return {
    time_s: 664,
    done: true,
    progress_m: 96.3,
    path_m: 96.7,
    forward_m_s: 0.1451,
    straightness: 0.996,
    heading_rms_deg: 5,
    speed_m_s: 0.146,
    slow_pct: 0,
    reverse_pct: 0,
    flips_per_min: 2.7,
    turn_deg_s: 0.58,
    wall_contacts: 0,
    door_contacts: 1,
    block_contacts: 0,
    people_contacts: 2,
    doors: 3,
    clean_doors: 2,
    clearance_m: 0.31,
    nis: 0.22,
    nees: null,
    blind: null,
    ...changes,
  };
}

/** A run of the corridor. */
export function sampleRun(round: number): DriveRunView {
  return {
    round,
    run: Math.ceil(round / 2),
    method: round % 2 === 1 ? 'minimum' : 'median-kalman',
    cycles: 1660,
    first_tick: 1,
    last_tick: 1660,
    outcome: { kind: 'drive', ...sampleScore() },
  };
}
