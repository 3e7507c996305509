import { svelte } from '@sveltejs/vite-plugin-svelte';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  plugins: [svelte({ configFile: false })],
  build: { target: 'es2022', assetsInlineLimit: 0, modulePreload: { polyfill: false } },
  // `npm run dev` shows the page with the data of a running `sonarium serve`.
  server: { proxy: { '/api': { target: 'http://127.0.0.1:7380', ws: true } } },
  test: { include: ['src/**/*.test.ts'] },
});
