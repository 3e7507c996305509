import { expect, test, type Page } from '@playwright/test';
import { axeFindsNothing, createSession, fitsTheScreen, photograph } from './steps';

const stepPanel = (page: Page) => page.getByRole('region', { name: 'The last step with its numbers' });

test('a learner in the labyrinth is watched, changed and advised, and the biases are compared', async ({
  page,
}) => {
  await page.goto('/');
  const card = page.getByRole('article').filter({ hasText: 'labyrinth of 16 states' });
  await card.getByRole('button', { name: 'Choose for a new session' }).click();
  await expect(page.getByLabel('Begin with')).toHaveCount(0);
  await page.getByLabel('Trials an episode').fill('30');
  await page.getByText('All settings').click();
  await page.getByRole('searchbox', { name: 'Search the settings' }).fill('episodes');
  await page.getByLabel(/^Episodes/).fill('3');
  await axeFindsNothing(page);
  await photograph(page, 'home-labyrinth');
  await page.getByLabel('Seed').fill('5');
  await page.getByRole('button', { name: 'Create session' }).click();
  await expect(page).toHaveURL(/\/sessions\/\w+/);

  // One step by key: the choice and the update can be read with their numbers.
  await page.keyboard.press('s');
  await expect(page.locator('.progress')).toContainText('Round 1 of 18');
  await expect(stepPanel(page)).toContainText('Q(x,u) ← Q(x,u) + β δ');
  await expect(stepPanel(page)).toContainText('4.11');
  await expect(stepPanel(page)).toContainText('In #7');

  // A state is selected in the drawing by keyboard, and its row is shown.
  const plan = page.getByRole('application');
  await plan.focus();
  await page.keyboard.press('ArrowLeft');
  await expect(page.getByRole('region', { name: 'State in detail' })).toContainText('selected');

  // A value is changed in its cell; what is no number is not taken.
  const cell = page.locator('td.cell').first();
  await cell.click();
  const field = page.getByRole('textbox', { name: 'Values Q(x,u), #0, left' });
  await field.fill('much');
  await page.keyboard.press('Enter');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  await field.fill('0,25');
  await page.keyboard.press('Enter');
  await expect(page.getByText(/Q of #0, left is 0.25 from tick \d+ on/)).toBeVisible();
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('s');
  await expect(cell).toHaveText('0.25');

  // Advice that cannot be read is marked at its character; the mended one is in force.
  const advice = page.getByLabel('Rules, one a line');
  await advice.fill('if goal is ahead then forward\nif goal is behnd then left');
  await page.getByRole('button', { name: 'Give advice' }).click();
  await expect(page.getByRole('alert')).toContainText('Line 2, column 12');
  expect(await advice.evaluate((area: HTMLTextAreaElement) => area.selectionStart)).toBe(41);
  await axeFindsNothing(page);
  await advice.fill('if goal is ahead then forward\nif goal is behind then left');
  await page.getByRole('button', { name: 'Give advice' }).click();
  await expect(page.getByRole('alert')).toHaveCount(0);
  await page.getByRole('heading', { level: 1 }).click();
  await page.keyboard.press('s');
  const rules = page.getByRole('region', { name: 'Rules of advice' });
  await expect(rules.locator('tbody tr')).toHaveCount(2);
  await photograph(page, 'labyrinth-paused');

  // To the end of the episode, and of them all.
  await page.getByLabel('Speed').selectOption('max');
  await page.getByRole('heading', { level: 1 }).click();
  // While the server has not answered, keys do nothing.
  await expect(page.getByRole('group', { name: 'Controls' })).toHaveAttribute('aria-busy', 'false');
  await page.keyboard.press('t');
  await expect(page.locator('.progress')).toContainText('Round 2 of 18');
  await page.getByRole('button', { name: 'Resume' }).click();
  await expect(page.locator('.head .title')).toContainText('Finished', { timeout: 60_000 });
  const index = page.getByRole('region', { name: 'Index table' });
  await expect(index.locator('tbody tr')).toHaveCount(6);
  await expect(index).toContainText('reference');
  const effect = page.getByRole('region', { name: 'Effect of what was done' });
  await expect(effect).toContainText('if goal is ahead then forward');
  await expect(effect).toContainText('(2)');
  await expect(page.getByText('changed by hand')).toBeVisible();
  await axeFindsNothing(page);
  await photograph(page, 'labyrinth-finished');

  // Its values are taken into the form of a new session.
  await page.getByRole('button', { name: 'Values in a new session' }).click();
  await expect(page).toHaveURL(/\/\?like=/);
  const row = page.getByRole('listitem').filter({ hasText: 'learner.table' });
  await expect(row.locator('textarea')).toHaveValue(/^\[\[/);
  await expect(page.getByLabel('Trials an episode')).toHaveValue('30');
  await axeFindsNothing(page);
  await photograph(page, 'home-values');
  await page.getByRole('button', { name: 'Create session' }).click();
  await expect(page).toHaveURL(/\/sessions\/\w+/);
  await expect(page.locator('.progress')).toContainText('Round 1 of 21');
});

test('mazes, processes, levers and models of optimality have pages of their own', async ({
  page,
  request,
}) => {
  const finished = async (experiment: string, settings: object, trials: number) => {
    const body = { experiment, seed: 5, trials, settings, speed: 'max' };
    const id = await createSession(request, body);
    expect((await request.post(`/api/v1/sessions/${id}/start`)).ok()).toBe(true);
    await page.goto(`/sessions/${id}`);
    await expect(page.locator('.head .title')).toContainText('Finished', { timeout: 60_000 });
  };

  await finished('gridworld', { episodes: 2, 'learner.kind': 'dyna' }, 8);
  await expect(page.getByRole('application')).toHaveAccessibleName(/Maze of 47 cells/);
  await expect(page.getByRole('region', { name: 'Planning at work' })).toContainText('Backups');
  await axeFindsNothing(page);
  await photograph(page, 'maze');

  await finished('gridworld', { episodes: 2, world: 'repair' }, 5);
  await page.getByRole('button', { name: 'worn', exact: true }).click();
  await expect(page.getByRole('region', { name: 'State in detail' })).toContainText('broken 40 %');
  await axeFindsNothing(page);

  await finished('bandit', { episodes: 2 }, 100);
  await expect(page.getByRole('region', { name: 'Levers' }).locator('tbody tr')).not.toHaveCount(0);
  await expect(page.getByRole('region', { name: 'Index table' })).toContainText('ucb');
  await axeFindsNothing(page);
  await photograph(page, 'bandit');

  // Where the best policy changes: 2(h − 2) = 10(h − 5), 10(h − 5) = 11(h − 6), γ³ = 1/5, γ = 10/11.
  await finished('horizon', {}, 1);
  for (const place of ['h = 5.75', 'h = 16', 'γ = 0.585', 'γ = 0.909']) {
    await expect(page.getByText(place)).toBeVisible();
  }
  await axeFindsNothing(page);
  await photograph(page, 'horizon');
});

test('a tabular session fits a phone, in the dark', async ({ browser, request }) => {
  const settings = { episodes: 1 };
  const body = { experiment: 'gridworld', seed: 5, trials: 5, settings, speed: 'max' };
  const id = await createSession(request, body);
  const context = await browser.newContext({
    viewport: { width: 390, height: 844 },
    colorScheme: 'dark',
    deviceScaleFactor: 2,
  });
  const page = await context.newPage();
  await page.goto(`/sessions/${id}`);
  await expect(page.locator('.head .title')).toContainText('Queued');
  await page.keyboard.press('t');
  await expect(page.getByRole('region', { name: 'Index table' })).toContainText('q-learning');
  // One of the tables is shown at a time.
  const chances = page.locator('td[data-group="chances"]').first();
  await expect(chances).toBeHidden();
  await page.getByText('Chances', { exact: true }).first().click();
  await expect(chances).toBeVisible();
  await fitsTheScreen(page);
  await axeFindsNothing(page);
  await photograph(page, 'maze-phone-dark');
  await context.close();
});
