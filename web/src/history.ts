// Undo and redo: a line of states, and where on it the page stands.

import type { State } from './state.ts'

const MOST = 200

export class History {
  #past: State[] = []
  #future: State[] = []
  #now: State
  /** What the last change was of: changes alike, close upon each other, are one. */
  #last = { of: '', at: -Infinity }

  constructor(first: State) {
    this.#now = first
  }

  get now(): State {
    return this.#now
  }

  get canUndo(): boolean {
    return this.#past.length > 0
  }

  get canRedo(): boolean {
    return this.#future.length > 0
  }

  /** Another state; `of` names what was moved: a drag is undone as a whole, and so are changes of one thing close upon each other. */
  change(state: State, of: string, at: number): void {
    const TOGETHER = 800
    const same = of !== '' && of === this.#last.of && (of.startsWith('drag ') || at - this.#last.at < TOGETHER)
    if (!same) {
      this.#past.push(this.#now)
      if (this.#past.length > MOST) this.#past.shift()
    }
    this.#future = []
    this.#now = state
    this.#last = { of, at }
  }

  /** The same state, seen more closely: nothing to undo. */
  amend(state: State): void {
    this.#now = state
  }

  undo(): State {
    const before = this.#past.pop()
    if (before) {
      this.#future.push(this.#now)
      this.#now = before
      this.#last = { of: '', at: -Infinity }
    }
    return this.#now
  }

  redo(): State {
    const after = this.#future.pop()
    if (after) {
      this.#past.push(this.#now)
      this.#now = after
      this.#last = { of: '', at: -Infinity }
    }
    return this.#now
  }
}
