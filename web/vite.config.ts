import { defineConfig } from 'vite'

// Static files that work from any folder of any web host: relative addresses, no script or style in the page itself.
export default defineConfig({
  base: './',
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 900,
  },
  worker: { format: 'es' },
})
