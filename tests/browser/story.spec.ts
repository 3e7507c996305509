import { expect, test, type Page } from '@playwright/test';
import { axeFindsNothing, createSession, fitsTheScreen, photograph } from './steps';

test('a newcomer creates a session, watches it learn and takes the report home', async ({
  page,
  browser,
  request,
}) => {
  const complaints = listenForComplaints(page);
  await page.goto('/');
  await expect(page.getByText('No session yet')).toBeVisible();
  const picture = page.locator('.experiments img').first();
  await expect(picture).toHaveJSProperty('complete', true);
  expect(await picture.evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(100);
  await axeFindsNothing(page);
  await photograph(page, 'home');

  // A refusal stands at its field, and nothing else is lost.
  await page.getByLabel('Trials', { exact: true }).fill('20');
  await page.getByLabel('Seed').fill('-3');
  await page.getByRole('button', { name: 'Create session' }).click();
  await expect(page.getByLabel('Seed')).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByLabel('Trials', { exact: true })).toHaveValue('20');
  await page.getByLabel('Seed').fill('5');
  await page.getByRole('button', { name: 'Create session' }).click();
  await expect(page).toHaveURL(/\/sessions\/\w+/);
  const id = page.url().split('/').pop() ?? '';
  const state = page.locator('.head .title');
  await expect(state).toContainText('Queued');

  // One step by key: the decision can be read, with its equations.
  await page.keyboard.press('s');
  await expect(page.getByText('Tick 1, trial 1, step 1')).toBeVisible();
  await expect(state).toContainText('Paused');
  const decision = page.getByRole('region', { name: 'Decision of this tick' });
  await expect(decision).toContainText('5.15');
  await expect(decision).toContainText('Reflex');

  // It runs, and a pause is acknowledged with its tick and holds.
  await page.keyboard.press('Space');
  await expect(state).toContainText('Running');
  await expect(page.locator('.progress')).toContainText('Trial 3', { timeout: 30_000 });
  await photograph(page, 'session-running');
  await page.keyboard.press('Space');
  await expect(page.getByRole('status').filter({ hasText: /Paused at tick \d+/ })).toBeVisible();
  const paused = await (await request.get(`/api/v1/sessions/${id}`)).json();
  expect(paused.state).toBe('paused');
  await expect(page.locator('.progress')).toContainText(`tick ${paused.tick}`);

  // To the end.
  await page.getByLabel('Speed').selectOption('max');
  await page.getByRole('button', { name: 'Resume' }).click();
  await expect(state).toContainText('Finished', { timeout: 60_000 });
  const rows = page.getByRole('region', { name: 'Table of trials' }).locator('tbody tr');
  await expect(rows).toHaveCount(20);

  // The page shows the numbers of the run, no others.
  const trials = await (await request.get(`/api/v1/sessions/${id}/trials`)).json();
  const last = trials[19];
  const row = rows.filter({ has: page.getByRole('button', { name: 'Show trial 20 in the arena' }) });
  await expect(row).toContainText(String(last.steps));
  await expect(row).toContainText(String(last.neurons));
  expect(last.steps).toBeLessThan(trials[0].steps);

  // A neuron of the network as it is at the end tells its four parameters and its birth.
  await expect(page.getByText(`${last.neurons} neurons, each at its birth place`)).toBeVisible();
  await page.getByLabel('Neuron', { exact: true }).selectOption({ index: 1 });
  await expect(page.getByText('Prototypical action p')).toBeVisible();
  await expect(page.getByText('Birth certificate')).toBeVisible();

  // An earlier trial in the arena.
  await page.getByRole('button', { name: 'Show trial 1 in the arena' }).click();
  const still = page.getByAltText('Path of trial 1');
  await expect(still).toBeVisible();
  await expect
    .poll(() => still.evaluate((image: HTMLImageElement) => image.naturalWidth))
    .toBeGreaterThan(100);
  await axeFindsNothing(page);
  await photograph(page, 'session-finished');

  // Downloads open.
  for (const [name, start] of [
    ['Trial 20 as HTML', '<!DOCTYPE html>'],
    ['Trial 20 as CSV', 'tick'],
  ] as const) {
    const waiting = page.waitForEvent('download');
    await page.getByRole('link', { name, exact: true }).click();
    const stream = await (await waiting).createReadStream();
    let text = '';
    for await (const chunk of stream) text += chunk;
    expect(text.startsWith(start), name).toBe(true);
  }
  const report = await browser.newPage();
  await report.goto(`/api/v1/sessions/${id}/report.html`);
  await expect(report.getByRole('heading', { level: 1 })).toBeVisible();
  await expect(report.locator('img').first()).toHaveJSProperty('complete', true);
  await axeFindsNothing(report);
  await report.close();

  // A second browser sees the same.
  const other = await browser.newPage();
  await other.goto(`/sessions/${id}`);
  await expect(other.getByRole('region', { name: 'Table of trials' }).locator('tbody tr')).toHaveCount(20);
  await expect(other.locator('.head .title')).toContainText('Finished');
  await other.close();
  expect(complaints).toEqual([]);
});

test('it works on a phone, in the dark and with a keyboard alone', async ({ browser }) => {
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    colorScheme: 'dark',
    deviceScaleFactor: 2,
  });
  const page = await context.newPage();
  await page.goto('/');
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'home-phone-dark');

  // To the form and through it by keyboard.
  const create = page.getByRole('button', { name: 'Create session' });
  for (let press = 0; press < 200; press += 1) {
    await page.keyboard.press('Tab');
    if (await create.evaluate((button) => button === document.activeElement)) break;
  }
  await page.keyboard.press('Enter');
  await expect(page).toHaveURL(/\/sessions\/\w+/);
  await page.keyboard.press('t');
  await expect(page.locator('.progress')).toContainText('Trial 2', { timeout: 60_000 });
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toBeHidden();
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'session-phone-dark');
  await context.close();
});

test('a lost connection is said and mended without losing history', async ({ page, request }) => {
  const id = await createSession(request, { trials: 3, speed: 'max', seed: 2 });
  let socket: { close(): Promise<void> } | undefined;
  await page.routeWebSocket(/\/stream/, (route) => {
    socket = route;
    route.connectToServer();
  });
  await page.goto(`/sessions/${id}`);
  await expect(page.locator('.head .title')).toContainText('Queued');
  await socket?.close();
  await expect(page.getByText(/connection (is )?lost/i).first()).toBeVisible();
  await request.post(`/api/v1/sessions/${id}/start`);
  await expect(page.getByText(/connection (is )?lost/i).first()).toBeHidden({ timeout: 30_000 });
  await expect(page.locator('.head .title')).toContainText('Finished');
  await expect(page.getByRole('region', { name: 'Table of trials' }).locator('tbody tr')).toHaveCount(3);
});

test('a session that does not exist says so', async ({ page }) => {
  await page.goto('/sessions/nobody');
  await expect(page.getByRole('heading', { level: 1 })).toContainText('no session nobody');
  await axeFindsNothing(page);
});

/** Errors of the page's own: scripts that threw, policies broken, files missing. */
function listenForComplaints(page: Page): string[] {
  const complaints: string[] = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    const refusal = message.text().includes('422');
    if (message.type() === 'error' && !refusal) complaints.push(message.text());
  });
  return complaints;
}
