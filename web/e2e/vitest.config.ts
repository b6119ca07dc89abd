import { defineConfig } from 'vitest/config'

// The page in a browser, as `nply explore` serves it: one browser and one server for all, a fresh profile for each look.
export default defineConfig({
  test: {
    dir: import.meta.dirname,
    globalSetup: [new URL('setup.ts', import.meta.url).pathname],
    testTimeout: 300_000,
    hookTimeout: 60_000,
    fileParallelism: false,
    // a browser without a graphics card on a busy machine now and then answers too late; what is wrong is wrong three times
    retry: 2,
  },
})
