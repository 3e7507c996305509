import { expect, test, type Locator, type Page } from '@playwright/test';
import { axeFindsNothing, fitsTheScreen, photograph } from './steps';

/** A map of two rooms of 3 m x 4 m, as a mapping robot leaves it: a door of 1.2 m between them. */
function twoRooms(): { name: string; mimeType: string; buffer: Buffer }[] {
  const [width, height, cell_m] = [64, 44, 0.1];
  const cells = Buffer.alloc(width * height, 205);
  for (let row = 2; row < height - 2; row += 1) {
    for (let column = 2; column < width - 2; column += 1) {
      const rim = row === 2 || row === height - 3 || column === 2 || column === width - 3;
      const between = column >= 31 && column <= 32 && !(row >= 16 && row < 28);
      cells[row * width + column] = rim || between ? 0 : 254;
    }
  }
  const image = Buffer.concat([Buffer.from(`P5\n${width} ${height}\n255\n`), cells]);
  const yaml = [
    'image: rooms.pgm',
    `resolution: ${cell_m}`,
    'origin: [0.0, 0.0, 0.0]',
    'negate: 0',
    'occupied_thresh: 0.65',
    'free_thresh: 0.196',
  ].join('\n');
  return [
    { name: 'rooms.pgm', mimeType: 'image/x-portable-graymap', buffer: image },
    { name: 'rooms.yaml', mimeType: 'application/yaml', buffer: Buffer.from(yaml) },
  ];
}

test('a stranger brings a map, mends what is marked, saves it and runs a trial in it', async ({
  page,
}) => {
  const complaints = listenForComplaints(page);
  await page.goto('/worlds');
  await expect(page.getByRole('heading', { name: 'Laboratory', exact: true })).toBeVisible();
  await expect(page.getByText('No world of your own yet')).toBeVisible();
  await picturesAreThere(page);
  await axeFindsNothing(page);
  await photograph(page, 'worlds');

  // Files that are no map are refused by name; half a map waits for the other half.
  const [image, yaml] = twoRooms();
  if (!image || !yaml) throw new Error('a map has two files');
  await page.getByRole('link', { name: 'New world' }).click();
  const files = page.locator('input[type=file]');
  await files.setInputFiles([{ ...image, name: 'rooms.png', buffer: Buffer.from('no picture') }, yaml]);
  await expect(page.getByRole('alert')).toContainText(/image|picture/i);
  await files.setInputFiles([image]);
  await expect(page.getByText(/YAML file that goes with rooms.pgm is still missing/)).toBeVisible();
  await axeFindsNothing(page);
  await photograph(page, 'world-new');
  await files.setInputFiles([yaml]);
  const plan = page.getByRole('application');
  await expect(plan).toBeVisible();
  await expect(page.getByText(/Traced from rooms.pgm/)).toBeVisible();
  const at = await calibrated(page, plan);

  // Home in a wall: said, linked and marked.
  const check = page.getByRole('region', { name: 'Check' });
  await page.getByRole('button', { name: 'Place home' }).click();
  await click(plan, at(3.2, 1));
  await expect(check).toContainText('1 problem to mend');
  await expect(check).toContainText('Home must be');
  await expect.poll(() => redPixels(plan, at(3.2, 1))).toBeGreaterThan(40);
  await check.getByRole('button', { name: 'Mend Home' }).click();
  await expect(page.getByRole('textbox', { name: 'x', exact: true }).first()).toBeFocused();
  await axeFindsNothing(page);
  await photograph(page, 'world-problem');

  // Mended with the mouse: home, heading, goal, radius; undone and done again.
  await click(plan, at(1.2, 2.2));
  await page.getByRole('button', { name: 'Place goal' }).click();
  await click(plan, at(5.2, 2.2));
  await expect(check).toContainText('The robot can go from home to the goal');
  await expect.poll(() => redPixels(plan, at(3.2, 1))).toBe(0);
  await page.getByRole('button', { name: 'Move', exact: true }).click();
  const heading = page.getByRole('textbox', { name: 'Heading' });
  const before = await heading.inputValue();
  await drag(page, plan, headingHandle(at, before), at(1.2, 3.4));
  await expect(heading).toHaveValue(/^(89|90|91)$/);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(heading).toHaveValue(before);
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(heading).not.toHaveValue(before);
  await page.getByRole('textbox', { name: 'Radius' }).fill('0,4');
  await expect(check).toContainText('The robot can go from home to the goal');

  // Regions: proposed, none, and one cut by hand.
  const regions = page.getByRole('region', { name: 'Regions' });
  await regions.getByRole('button', { name: /Propose/ }).click();
  await expect(regions.locator('ol > li').nth(1)).toBeVisible();
  await regions.getByRole('button', { name: 'No regions' }).click();
  await regions.getByRole('button', { name: 'Add a region' }).click();
  await regions.getByRole('button', { name: 'Draw a line on the plan' }).click();
  await drag(page, plan, at(3.2, 3.8), at(3.2, 0.6));
  await expect(regions.getByLabel('Direction of line 1')).toHaveValue('x');
  await expect(regions.getByLabel('Bound of line 1')).toHaveValue(/^3\.(1|2)/);
  await expect(check).toContainText('The robot can go from home to the goal');
  await axeFindsNothing(page);
  await page.evaluate(() => scrollTo(0, 0));
  await photograph(page, 'world-editor');

  // Saved under a name; leaving with changes asks first.
  await page.getByRole('textbox', { name: 'Title' }).fill('Two rooms');
  await page.getByRole('textbox', { name: 'Name', exact: true }).first().fill('laboratory');
  await expect(page.getByText('There is a world of this name already')).toBeVisible();
  await page.getByRole('textbox', { name: 'Name', exact: true }).first().fill('two-rooms');
  await page.getByRole('link', { name: 'Worlds', exact: true }).click();
  await expect(page.getByRole('dialog')).toContainText('Leave without saving?');
  await page.getByRole('button', { name: 'Stay' }).click();
  await page.getByRole('button', { name: 'Save world' }).click();
  await expect(page).toHaveURL(/\/worlds\/two-rooms$/);
  await expect(page.getByText('Saved', { exact: true }).first()).toBeVisible();

  // A session in it, and a trial.
  await page.getByRole('link', { name: 'New session in this world' }).click();
  await expect(page.getByLabel('World', { exact: true })).toHaveValue('two-rooms');
  await page.getByLabel('Trials', { exact: true }).fill('1');
  await page.getByLabel('Seed').fill('1');
  await page.getByRole('button', { name: 'Create session' }).click();
  await expect(page).toHaveURL(/\/sessions\/\w+/);
  await page.getByLabel('Speed').selectOption('max');
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await expect(page.locator('.head .title')).toContainText('Finished', { timeout: 60_000 });
  await expect(page.locator('.head')).toContainText('Two rooms');
  await photograph(page, 'session-own-world');

  // It is among one's own, comes home as TOML and goes when asked to.
  await page.goto('/worlds');
  const card = page.getByRole('listitem').filter({ hasText: 'two-rooms' });
  const waiting = page.waitForEvent('download');
  await card.getByRole('link', { name: 'Download Two rooms as TOML' }).click();
  const toml = await textOf(await (await waiting).createReadStream());
  expect(toml).toContain('name = "two-rooms"');
  await card.getByRole('button', { name: 'Delete Two rooms' }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Delete' }).click();
  await expect(page.getByText('No world of your own yet')).toBeVisible();

  // What came home can be brought back.
  await page.getByRole('link', { name: 'New world' }).click();
  await files.setInputFiles([
    { name: 'two-rooms.toml', mimeType: 'application/toml', buffer: Buffer.from(toml) },
  ]);
  await expect(page.getByRole('textbox', { name: 'Title' })).toHaveValue('Two rooms');
  await expect(heading).toHaveValue(/^(89|90|91)$/);
  expect(complaints).toEqual([]);
});

test('a map keeps its picture, and blocks and rings are edited over it', async ({ page }) => {
  const complaints = listenForComplaints(page);
  await page.goto('/worlds/new');
  await page.locator('input[type=file]').setInputFiles(twoRooms());
  const plan = page.getByRole('application');
  const at = await calibrated(page, plan);
  await click(plan, at(1.2, 2.2));
  await page.getByRole('button', { name: 'Place goal' }).click();
  await click(plan, at(5.2, 2.2));
  await page.getByRole('textbox', { name: 'Name', exact: true }).first().fill('kept-rooms');
  await page.getByRole('button', { name: 'Save world' }).click();
  await expect(page).toHaveURL(/\/worlds\/kept-rooms$/);

  // Opened again, the picture lies under the plan; off the floor nothing else is drawn.
  await page.reload();
  const picture = page.getByRole('checkbox', { name: 'Map’s picture' });
  await expect(picture).toBeChecked();
  const wall = at(3.2, 1);
  const shown = await pixel(plan, wall);
  await picture.uncheck();
  await expect.poll(() => pixel(plan, wall)).not.toEqual(shown);
  await picture.check();
  await expect.poll(() => pixel(plan, wall)).toEqual(shown);

  // A block: drawn, a corner moved by keys, taken back in two steps.
  const blocks = page.getByRole('region', { name: 'Solid blocks' });
  const check = page.getByRole('region', { name: 'Check' });
  await page.getByRole('button', { name: 'Draw block', exact: true }).click();
  await drag(page, plan, at(4, 2.9), at(4.5, 3.3));
  await expect(blocks).toContainText('1 block');
  const corner = blocks.getByRole('textbox', { name: 'x of point 1' });
  const before = Number(await corner.inputValue());
  expect(Math.abs(before - 4)).toBeLessThan(0.06);
  await plan.focus();
  await page.keyboard.press('n');
  await page.keyboard.press('ArrowLeft');
  await expect.poll(async () => Number(await corner.inputValue())).toBeCloseTo(before - 0.1, 2);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect.poll(async () => Number(await corner.inputValue())).toBeCloseTo(before, 2);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(blocks).toContainText('0 blocks');

  // A ring: a point is added, and taken back.
  const rings = page.getByRole('region', { name: 'Rings round the floor' });
  await rings.getByLabel('Ring', { exact: true }).selectOption('0');
  const ys = rings.getByRole('textbox', { name: /^y of point/ });
  const points = await ys.count();
  expect(points).toBeGreaterThanOrEqual(12);
  await axeFindsNothing(page);
  await page.evaluate(() => scrollTo(0, 0));
  await photograph(page, 'world-shapes');
  await rings.getByRole('button', { name: 'Add a point' }).click();
  await expect(ys).toHaveCount(points + 1);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(ys).toHaveCount(points);
  await expect(check).toContainText('The robot can go from home to the goal');
  await page.getByRole('link', { name: 'Worlds', exact: true }).click();
  const card = page.getByRole('listitem').filter({ hasText: 'kept-rooms' });
  await card.getByRole('button', { name: /^Delete/ }).click();
  await page.getByRole('dialog').getByRole('button', { name: 'Delete' }).click();
  await expect(page.getByText('No world of your own yet')).toBeVisible();
  expect(complaints).toEqual([]);
});

test('a world is edited on a phone, in the dark and with a keyboard alone', async ({ browser }) => {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    colorScheme: 'dark',
    deviceScaleFactor: 2,
  });
  const page = await context.newPage();
  await page.goto('/worlds');
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'worlds-phone-dark');
  await page.getByRole('link', { name: 'Duplicate Laboratory', exact: true }).press('Enter');
  const plan = page.getByRole('application');
  await plan.focus();

  // Home into the wall south of the door, by keys; back by undo.
  const x = page.getByRole('textbox', { name: 'x', exact: true }).first();
  await expect(x).toHaveValue('0');
  await page.keyboard.press('h');
  for (let press = 0; press < 12; press += 1) await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Shift+ArrowLeft');
  await expect(x).toHaveValue('−1.21');
  await expect(page.getByRole('region', { name: 'Check' })).toContainText('The robot can go');
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByRole('region', { name: 'Check' })).toContainText('1 problem to mend');
  await page.keyboard.press('Control+z');
  await expect(x).toHaveValue('0');
  await page.keyboard.press(',');
  await expect(page.getByRole('textbox', { name: 'Heading' })).toHaveValue('5');

  // A field refuses what is no number, and a region is opened and turned over.
  await page.getByRole('textbox', { name: 'Radius' }).fill('wide');
  await expect(page.getByText('Give a number')).toBeVisible();
  await page.getByRole('textbox', { name: 'Radius' }).fill('0.6');
  await page.getByRole('button', { name: /^corridor/ }).press('Enter');
  await page.getByLabel('Side of line 1').selectOption('below');
  await expect(page.getByRole('button', { name: /^corridor/ })).toContainText('x < 3.75 m');
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'world-editor-phone-dark');
  await context.close();
});

test('a world that does not exist says so', async ({ page }) => {
  await page.goto('/worlds/atlantis');
  await expect(page.getByRole('heading', { level: 1 })).toContainText('no world atlantis');
  await axeFindsNothing(page);
});

type Place = { x: number; y: number };

/** Where places of the world lie on the plan, found by pressing it twice and reading the fields. */
async function calibrated(page: Page, plan: Locator): Promise<(x_m: number, y_m: number) => Place> {
  const box = await plan.boundingBox();
  if (!box) throw new Error('the plan is not shown');
  await page.getByRole('button', { name: 'Place home' }).click();
  const read = async (place: Place) => {
    await click(plan, place);
    const fields = page.getByRole('group', { name: /^Home/ });
    const value = async (label: string) =>
      Number((await fields.getByLabel(label, { exact: true }).inputValue()).replace('−', '-'));
    return { x_m: await value('x'), y_m: await value('y') };
  };
  const low = { x: box.width * 0.3, y: box.height * 0.7 };
  const high = { x: box.width * 0.7, y: box.height * 0.3 };
  const [from, to] = [await read(low), await read(high)];
  const scale = (high.x - low.x) / (to.x_m - from.x_m);
  return (x_m, y_m) => ({
    x: low.x + (x_m - from.x_m) * scale,
    y: low.y - (y_m - from.y_m) * scale,
  });
}

const click = (plan: Locator, position: Place) => plan.click({ position });

async function drag(page: Page, plan: Locator, from: Place, to: Place): Promise<void> {
  await plan.scrollIntoViewIfNeeded();
  const box = await plan.boundingBox();
  if (!box) throw new Error('the plan is not shown');
  await page.mouse.move(box.x + from.x, box.y + from.y);
  await page.mouse.down();
  await page.mouse.move(box.x + (from.x + to.x) / 2, box.y + (from.y + to.y) / 2, { steps: 4 });
  await page.mouse.move(box.x + to.x, box.y + to.y, { steps: 4 });
  await page.mouse.up();
}

/** Where the handle of the heading lies: outside the robot, or a little farther when it is small. */
function headingHandle(at: (x_m: number, y_m: number) => Place, degrees: string): Place {
  const angle = (Number(degrees.replace('−', '-')) * Math.PI) / 180;
  const [home, radius] = [at(1.2, 2.2), at(0.265, 0).x - at(0, 0).x];
  const out = Math.max(38, radius + 18);
  return { x: home.x + out * Math.cos(angle), y: home.y - out * Math.sin(angle) };
}

/** The colour at a place of the plan. */
async function pixel(plan: Locator, { x, y }: Place): Promise<number[]> {
  return plan.evaluate(
    (canvas: HTMLCanvasElement, at) => {
      const ratio = canvas.width / canvas.clientWidth;
      const { data } = canvas.getContext('2d')!.getImageData(at.x * ratio, at.y * ratio, 1, 1);
      return [...data];
    },
    { x, y },
  );
}

/** Pixels near a place of the plan in the colour that problems are marked with. */
async function redPixels(plan: Locator, { x, y }: Place): Promise<number> {
  return plan.evaluate(
    (canvas: HTMLCanvasElement, at) => {
      const bad = getComputedStyle(canvas).getPropertyValue('--bad').trim();
      const parts = [1, 3, 5].map((from) => parseInt(bad.slice(from, from + 2), 16));
      const ratio = canvas.width / canvas.clientWidth;
      const reach = 40 * ratio;
      const [left, top] = [at.x * ratio - reach, at.y * ratio - reach];
      const { data } = canvas.getContext('2d')!.getImageData(left, top, 2 * reach, 2 * reach);
      let found = 0;
      for (let index = 0; index < data.length; index += 4) {
        if (parts.every((part, offset) => Math.abs(data[index + offset] - part) < 3)) found += 1;
      }
      return found;
    },
    { x, y },
  );
}

async function picturesAreThere(page: Page): Promise<void> {
  for (const picture of await page.locator('main img').all()) {
    await picture.scrollIntoViewIfNeeded();
    await expect
      .poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth))
      .toBeGreaterThan(100);
  }
}

async function textOf(stream: AsyncIterable<Buffer>): Promise<string> {
  let text = '';
  for await (const chunk of stream) text += chunk;
  return text;
}

/** Errors of the page's own; refusals by the server are meant here. */
function listenForComplaints(page: Page): string[] {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    const refusal = /status of 4(09|12|22)/.test(message.text());
    if (message.type() === 'error' && !refusal) complaints.push(message.text());
  });
  return complaints;
}
