// The solver's own thread: the page never waits for it.

import init from '../wasm/nply_wasm.js'
import wasmUrl from '../wasm/nply_wasm_bg.wasm?url'
import { doors } from './doors.ts'
import type { Ask } from './messages.ts'

const ready = init({ module_or_path: wasmUrl })

self.addEventListener('message', (event: MessageEvent<Ask>) => {
  void ready.then(
    () => {
      const { id, kind, ask } = event.data
      try {
        const answer = (doors[kind] as (ask: unknown) => unknown)(ask)
        self.postMessage({ id, answer })
      } catch (error) {
        self.postMessage({ id, failed: String(error) })
      }
    },
    (error: unknown) => self.postMessage({ id: event.data.id, failed: `the solver cannot be loaded: ${String(error)}` }),
  )
})
