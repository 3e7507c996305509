import { expect, test } from '@playwright/test';
import { axeFindsNothing, createSession, fitsTheScreen, photograph } from './steps';

test('a reader has a figure computed, leaves, comes back and takes it home', async ({
  page,
  request,
}) => {
  await page.goto('/');
  await page.getByRole('link', { name: 'Reproductions' }).click();
  await expect(page.getByRole('heading', { level: 1, name: 'Reproductions' })).toBeVisible();
  await axeFindsNothing(page);
  await photograph(page, 'reproductions');

  await page
    .getByRole('link', {
      name: 'Steps taken before the robot arrived at the goal',
    })
    .click();
  await expect(page).toHaveURL(/\/reproduce\/figure-5\.12$/);
  await expect(page.getByText('sonarium reproduce figure-5.12')).toBeVisible();
  await page.getByRole('button', { name: 'Compute' }).click();

  // The computation is the server's: a reload neither stops it nor asks again.
  await page.reload();
  const table = page.getByRole('group', { name: 'Published and ours' });
  await expect(table).toBeVisible({ timeout: 100_000 });
  await expect(page.getByRole('button', { name: 'Compute' })).toBeHidden();

  // The page shows the server's numbers, each with verdict and reading.
  const result = await (await request.get('/api/v1/reproductions/figure-5.12')).json();
  const rows = table.locator('tbody tr:not(.arm)');
  await expect(rows).toHaveCount(result.rows.length);
  for (const [index, row] of result.rows.entries()) {
    await expect(rows.nth(index)).toContainText(row.verdict);
    await expect(rows.nth(index)).toContainText(String(row.n));
  }

  // A curve is a picture with words, a table for keys, and it changes with the preset.
  const curve = page.getByRole('region', { name: 'Number of steps per trial' });
  await expect(curve).toContainText('95 % interval of the mean over 200 sets');
  await expect(curve).toContainText('minimum and maximum over the first 10 sets');
  await expect(curve.getByRole('img')).toHaveAttribute('aria-label', /default: from/);
  await curve.getByText('All points of default as a table').click();
  const points = curve.getByRole('group', { name: 'Points of default' });
  await expect(points.locator('tbody tr')).toHaveCount(20);
  await page.getByRole('radio', { name: 'reflex' }).check();
  await expect(curve.getByRole('img')).toHaveAttribute('aria-label', /reflex: from/);
  await expect(page.getByRole('region', { name: 'Differences from the thesis' })).toContainText(
    'reflex',
  );
  await axeFindsNothing(page);
  await photograph(page, 'figure-5.12');

  const waiting = page.waitForEvent('download');
  await curve.getByRole('link', { name: 'CSV' }).click();
  expect((await waiting).suggestedFilename()).toBe('figure-5.12-curves.csv');
});

test('progress is shown until the result is there', async ({ page }) => {
  let done = 150;
  await page.route('**/figure-5.11/progress', (route) =>
    route.fulfill({
      json: { target: 'figure-5.11', state: 'running', done, of: 600, reason: null },
    }),
  );
  await page.route('**/reproductions/figure-5.11', () => {});
  await page.goto('/reproduce/figure-5.11');
  const status = page.getByRole('status');
  await expect(status).toContainText('25 % of 600 sets');
  await expect(page.getByRole('progressbar')).toHaveAttribute('value', '150');
  await axeFindsNothing(page);
  done = 450;
  await expect(status).toContainText('75 % of 600 sets');
  await photograph(page, 'reproduction-running');
});

test('first and last trajectory stand side by side, on a phone and in the dark too', async ({
  browser,
  request,
}) => {
  await request.get('/api/v1/reproductions/figure-5.10', { timeout: 100_000 });
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    colorScheme: 'dark',
    deviceScaleFactor: 2,
  });
  const page = await context.newPage();
  await page.goto('/reproduce/figure-5.10');
  const pictures = page.getByRole('region', { name: 'Pictures' });
  for (const words of [/trial 1:/, /trial 20:/]) {
    const picture = pictures.getByRole('img', { name: words });
    await expect
      .poll(() => picture.evaluate((image: HTMLImageElement) => image.naturalWidth))
      .toBeGreaterThan(100);
  }
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'figure-5.10-phone-dark');
  await page.setViewportSize({ width: 1440, height: 900 });
  const [first, last] = await pictures.locator('img').all();
  const tops = await Promise.all([first, last].map(async (each) => (await each?.boundingBox())?.y));
  expect(tops[0]).toBe(tops[1]);
  await photograph(page, 'figure-5.10-dark');
  await context.close();
});

test('a target that does not exist says so', async ({ page }) => {
  await page.goto('/reproduce/table-9.9');
  await expect(page.getByRole('heading', { level: 1 })).toContainText('no target table-9.9');
  await axeFindsNothing(page);
});

test('trial 1 and the last trial of a session are walked along side by side', async ({
  page,
  request,
}) => {
  const id = await createSession(request, {
    trials: 15,
    speed: 'max',
    seed: 1,
  });
  await request.post(`/api/v1/sessions/${id}/start`);
  await page.goto(`/sessions/${id}`);
  await expect(page.locator('.head .title')).toContainText('Finished', {
    timeout: 60_000,
  });
  const trials = await (await request.get(`/api/v1/sessions/${id}/trials`)).json();
  const pair = page.getByRole('region', { name: 'Two trials side by side' });
  await expect(pair.getByRole('img', { name: /^Trial 1:/ })).toBeVisible();
  await expect(pair.getByRole('img', { name: /^Trial 15:/ })).toBeVisible();
  await expect(pair).toContainText(`in ${trials[14].steps} steps`);

  // At the end all steps are drawn; at the beginning none.
  const left = pair.getByRole('img', { name: /^Trial 1:/ });
  await expect(left.locator('.dot')).toHaveCount(trials[0].steps + 1);
  await photograph(page, 'session-pair');
  await pair.getByRole('slider').fill('0');
  await expect(left.locator('.dot')).toHaveCount(1);
  await pair.getByRole('button', { name: 'Play both' }).click();
  await expect(left.locator('.dot')).toHaveCount(trials[0].steps + 1, {
    timeout: 30_000,
  });

  await pair.getByLabel('Left').selectOption('3');
  await expect(pair.getByRole('img', { name: /^Trial 3:/ })).toBeVisible();
  await axeFindsNothing(page);
  // The story begins without sessions.
  expect((await request.delete(`/api/v1/sessions/${id}`)).status()).toBe(204);
});
