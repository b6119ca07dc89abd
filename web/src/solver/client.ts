// The page's side of the solver's thread.

import type { Ask, Exchange, Reply } from './messages.ts'

export class Solver {
  readonly #worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
  readonly #waiting = new Map<number, { resolve: (answer: never) => void; reject: (error: Error) => void }>()
  #last = 0

  constructor() {
    this.#worker.addEventListener('message', (event: MessageEvent<Reply>) => {
      const { id, answer, failed } = event.data
      const waiting = this.#waiting.get(id)
      this.#waiting.delete(id)
      if (failed !== undefined) waiting?.reject(new Error(failed))
      else waiting?.resolve(answer as never)
    })
  }

  ask<K extends keyof Exchange>(kind: K, ask: Exchange[K]['ask']): Promise<Exchange[K]['answer']> {
    const id = ++this.#last
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject })
      this.#worker.postMessage({ id, kind, ask } as Ask)
    })
  }
}

/** Lets only one run at a time, and of those that come meanwhile only the last. */
export function latest<A>(run: (argument: A) => Promise<void>): (argument: A) => void {
  let busy = false
  let next: { argument: A } | null = null
  const go = async (argument: A): Promise<void> => {
    busy = true
    try {
      await run(argument)
    } finally {
      busy = false
      const following = next
      next = null
      if (following) void go(following.argument)
    }
  }
  return (argument) => {
    if (busy) next = { argument }
    else void go(argument)
  }
}
