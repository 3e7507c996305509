/** Files somebody chose or dropped: a world, or the picture and the description of a map. */

/** Only what is asked of a file here. */
interface Named {
  name: string;
}

/** A map's two files, as far as they are there. */
export interface MapFiles<F extends Named> {
  image: F | null;
  yaml: F | null;
}

/** What some files are. */
export type Found<F extends Named> =
  | { kind: 'world'; file: F }
  | { kind: 'map'; image: F; yaml: F }
  | { kind: 'half'; files: MapFiles<F>; missing: string }
  | { kind: 'none'; why: string };

const IMAGES = ['pgm', 'png'];
const DESCRIPTIONS = ['yaml', 'yml'];

/** What newly chosen files are, together with those chosen before. */
export function sorted<F extends Named>(files: F[], before: MapFiles<F>): Found<F> {
  const world = files.find((file) => ending(file) === 'toml');
  if (world) return { kind: 'world', file: world };
  const image = files.find((file) => IMAGES.includes(ending(file))) ?? before.image;
  const yaml = files.find((file) => DESCRIPTIONS.includes(ending(file))) ?? before.yaml;
  if (image && yaml) return { kind: 'map', image, yaml };
  const stranger = files.find((file) => ![...IMAGES, ...DESCRIPTIONS].includes(ending(file)));
  if (stranger || (!image && !yaml)) return { kind: 'none', why: refusal(stranger) };
  const missing = image
    ? `The YAML file that goes with ${image.name} is still missing: it says the resolution and the origin`
    : `The picture that goes with ${yaml?.name ?? 'the YAML file'} is still missing: a PGM or PNG file`;
  return { kind: 'half', files: { image, yaml }, missing };
}

function refusal(stranger: Named | undefined): string {
  const wanted = 'choose a world (TOML), or a map’s picture (PGM or PNG) with its YAML file';
  return stranger ? `${stranger.name} is none of these: ${wanted}` : `No file: ${wanted}`;
}

const ending = ({ name }: Named) => /\.([^.]+)$/.exec(name)?.[1]?.toLowerCase() ?? '';
