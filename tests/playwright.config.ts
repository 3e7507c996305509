import { defineConfig } from '@playwright/test';

// The server under test is started by the Rust test that runs this; see tests/browser.rs.
const url = process.env.SONARIUM_URL;
if (!url) throw new Error('Run these through `cargo test -p e2e --test browser`');

export default defineConfig({
  testDir: 'browser',
  outputDir: 'test-results',
  fullyParallel: false,
  workers: 1,
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: [['line']],
  use: {
    baseURL: url,
    launchOptions: {
      executablePath: process.env.CHROMIUM,
      args: [
        '--no-sandbox',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        '--disable-quic',
        '--no-first-run',
      ],
    },
  },
});
