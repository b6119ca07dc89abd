// What the page asks the solver, and what it gets.

import type { Key } from '../document.ts'
import type { Refusal, Solved, Walk } from '../answer.ts'
import type { Along, Data, Place } from '../state.ts'

export interface Preset {
  readonly name: string
  readonly about: string
  readonly source: string
  readonly command: string
  readonly text: string
}

export interface Hello {
  readonly keys: readonly Key[]
  readonly presets: readonly Preset[]
}

/** Where the ply was before, so that it can be followed along its branch. */
export interface Before {
  readonly strands: number
  readonly balance: string
  readonly touching: boolean
  readonly numbers: readonly [ratio: number, twist: number, force: number, moment: number, core: number]
  readonly twistKind: TwistKind
  readonly place: Place
}

export type TwistKind = 'pretwist' | 'strand_twist'

export interface Question {
  readonly data: Data
  readonly at: Place | null
  readonly before: Before | null
  readonly along: Along
}

export interface Outline {
  /** x and y of the cut of strand 0 at height 0. */
  readonly outline: Float64Array
  /** Angles round a strand's section at which it touches its neighbours, radius and azimuth of the contact line; empty where none touch. */
  readonly sides: Float64Array
}

/** Arrays behind the figures; see crates/nply-wasm for their columns. */
export interface Curves {
  readonly pretwist: Float64Array
  readonly force: Float64Array
  readonly moment: Float64Array
  /** States with a core, or that may part, as each datum runs; empty where the document asks for touching strands alone. */
  readonly supported: Readonly<Record<Along, Float64Array>>
  readonly locus: Float64Array
  readonly lines: readonly AngleLine[]
  readonly contact: Float64Array
}

export interface AngleLine {
  readonly hand: 1 | -1
  readonly degrees: number
  /** f and m where the strands part, and of a point of the line on which they press. */
  readonly points: Float64Array
}

export interface Answer extends Solved {
  readonly toml: string
  /** The number of the state that is meant, from 0; −1 where there is none. */
  readonly number: number
  readonly outline: Outline
  readonly walk: Walk | null
  readonly before: Before | null
  /** What the solver took, in ms. */
  readonly took: number
}

export interface Refused {
  readonly error: Refusal
  readonly toml: string
}

export interface Opened {
  readonly data: Data
  readonly study: boolean
}

/** A leg for the story: a document, and from where to where. */
export interface Leg {
  readonly strands: number
  readonly ratio: number
  readonly from: readonly [twist: number, force: number, moment: number]
  readonly to: readonly [twist: number, force: number, moment: number]
  readonly place: Place
}

/** Every question with its answer. */
export interface Exchange {
  hello: { ask: Record<string, never>; answer: Hello }
  solve: { ask: Question; answer: Answer | Refused }
  curves: { ask: CurvesAsked; answer: Curves }
  open: { ask: { name: string; text: string }; answer: Opened | { error: Refusal } }
  report: { ask: { data: Data; format: 'text' | 'csv' | 'json' | 'toml' }; answer: { text: string } | { error: Refusal } }
  mesh: { ask: { data: Data; number: number; format: 'stl' | 'glb'; stripes: number }; answer: Uint8Array }
  outline: { ask: { strands: number; angle: number; ratio: number; hand: number }; answer: Outline }
  leg: { ask: Leg; answer: Walk | null }
}

export interface CurvesAsked {
  readonly strands: number
  readonly ratio: number
  readonly balance: string
  readonly twistKind: TwistKind
  readonly twist: number
  readonly pretwist: number
  readonly force: number
  readonly moment: number
  readonly core: number | null
  readonly supported: boolean
  readonly windows: Readonly<Record<Along, readonly [number, number]>>
}

export type Ask = { [K in keyof Exchange]: { id: number; kind: K; ask: Exchange[K]['ask'] } }[keyof Exchange]
export type Reply = { id: number; answer?: unknown; failed?: string }
