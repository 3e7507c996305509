import { expect, test } from '@playwright/test';
import { axeFindsNothing, createSession, fitsTheScreen, photograph } from './steps';

const SHORT = { 'corridor.length': 14, 'corridor.doors': 1, 'people.count': 2 };

test('a robot in the corridor is watched, and driven by another method with a silent sonar', async ({
  page,
  request,
}) => {
  const id = await createSession(request, {
    experiment: 'corridor',
    seed: 100,
    trials: 1,
    settings: { ...SHORT, compare: true },
  });
  await page.goto(`/sessions/${id}`);
  await expect(page.getByRole('heading', { level: 1 })).toHaveText('Corridor with people');
  await page.keyboard.press('s');
  await expect(page.locator('.progress')).toContainText('Run 1 of 2');
  await expect(page.getByRole('region', { name: 'Region III centre' })).toContainText('Median');
  await expect(page.getByRole('region', { name: 'Strongest rules' })).toContainText('safe');

  // Another method drives until the run ends, and a sonar falls silent.
  await page.getByLabel('Drives now').selectOption('median-kalman');
  const log = page.getByRole('region', { name: 'Event log' });
  await expect(log).toContainText('Driven by median-kalman until the run ends');
  await page.getByRole('button', { name: /^Silence .*sonar 4/i }).click();
  await expect(log).toContainText('Sonar 4 fell silent');
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('s');
  await expect(page.getByRole('list', { name: 'Kinds of readings' }).first()).toContainText('Silent 1');
  await axeFindsNothing(page);
  await fitsTheScreen(page);
  await photograph(page, 'corridor-paused');

  await page.getByLabel('Speed').selectOption('max');
  await page.getByRole('button', { name: 'Resume' }).click();
  await expect(page.getByText('Finished').first()).toBeVisible({ timeout: 60_000 });
  await expect(page.getByRole('region', { name: 'Table of runs' }).getByRole('row')).toHaveCount(3);
  await photograph(page, 'corridor-finished');

  // The way of a run that has ended, by its row and by the choice above the plan.
  await page.getByRole('button', { name: /^Show run 1 by/ }).first().click();
  const way = page.getByRole('img', { name: /^Path of run 1 by/ });
  await expect(way).toBeVisible();
  await expect
    .poll(() => way.evaluate((img: HTMLImageElement) => img.naturalWidth))
    .toBeGreaterThan(300);
  await axeFindsNothing(page);
  await photograph(page, 'corridor-past-run');
  await page.getByLabel('Show', { exact: true }).selectOption('live');
  await expect(way).toBeHidden();
});

test('the approach to a wall shows what each method tells, also on a dark phone', async ({
  page,
  request,
}) => {
  const id = await createSession(request, { experiment: 'wall-approach', seed: 1, trials: 3, speed: 'max' });
  await request.post(`/api/v1/sessions/${id}/start`);
  await page.emulateMedia({ colorScheme: 'dark' });
  await page.setViewportSize({ width: 390, height: 844 });
  await page.goto(`/sessions/${id}`);
  await expect(page.getByText('Finished').first()).toBeVisible({ timeout: 60_000 });
  await expect(page.getByRole('region', { name: 'Table of methods' })).toContainText('RMS');
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'wall-approach-phone-dark');
});

test('the 972 rules can be searched', async ({ page }) => {
  await page.goto('/rules/navigator');
  await expect(page.getByText('972 of 972 rules')).toBeVisible();
  await page.getByRole('combobox', { name: /^Centre/ }).selectOption('dangerous');
  await expect(page.getByText('324 of 972 rules')).toBeVisible();
  await axeFindsNothing(page);
  await photograph(page, 'rules');
});
