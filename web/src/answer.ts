// What the solver answers.

import type { Place } from './state.ts'

/** A state in the words of docs/json.md; dimensionless, `si` beside it where a scale is known. */
export interface PlyState {
  readonly handedness: 1 | -1
  readonly lay: 'Z' | 'S'
  readonly separated?: boolean
  readonly support?: 'neighbours' | 'core' | 'both' | 'none'
  readonly stability: 'stable' | 'unstable' | 'marginal' | null
  readonly fold?: boolean
  readonly helical_angle: number
  readonly helical_angle_deg: number
  readonly radius_ratio: number
  readonly pretwist: number
  readonly strand_twist: number
  readonly force: number
  readonly moment: number
  readonly interstrand_pressure: number
  readonly resultant_pressure: number
  readonly core_pressure?: number | null
  readonly margins?: Readonly<Record<string, Margin | null>>
  readonly si?: Readonly<Record<string, number | null>>
  readonly [name: string]: unknown
}

export interface Margin {
  readonly below: Limit | null
  readonly above: Limit | null
}

export interface Limit {
  readonly change: number
  readonly cause: 'separation' | 'fold' | 'most_turns' | 'straight' | 'rings'
  readonly helical_angle_deg: number
  readonly force: number | null
  readonly moment: number | null
}

export interface Report {
  readonly program: string
  readonly version: string
  readonly balance?: 'contact' | 'radial'
  readonly title?: string
  readonly strands: number
  readonly stiffness_ratio: number
  readonly core_radius?: number | null
  readonly question: { readonly find: string; readonly given: Readonly<Record<string, number>> }
  readonly strand_radius_m?: number | null
  readonly bending_stiffness_N_m2?: number | null
  readonly si_units?: Readonly<Record<string, string>>
  readonly straight_holds?: boolean | null
  readonly states: readonly PlyState[]
  readonly notes: readonly string[]
}

/** A refusal, in the command's own words. */
export interface Refusal {
  readonly sentence: string
  readonly message?: string
  readonly help?: string | null
  readonly shown?: string
  readonly key?: string | null
  readonly line?: number | null
}

/** A datum as it is written, and the unit it is in: one of it in SI. */
export interface Written {
  readonly flag: string
  readonly text: string
  readonly number?: number
  readonly unit?: string
  readonly factor?: number
}

export interface Solved {
  readonly report: Report
  /** Signed angles in the other balance, where both were worked out. */
  readonly other: readonly number[] | null
  readonly data: readonly Written[]
}

export interface WalkEvent {
  readonly event: string
  readonly carried_by: string | null
  readonly angle: number
  readonly force: number
  readonly moment: number
  readonly twist: number
  readonly jump: number | 'none' | null
}

/** How the ply got from one state to the next. */
export interface Walk {
  readonly stations: readonly number[]
  readonly events: readonly WalkEvent[]
  readonly arrived: boolean
  readonly end: string
}

export const signedAngle = (state: PlyState): number => state.handedness * state.helical_angle_deg

/** Straight strands, which have no hand and stand in no list. */
export const STRAIGHT = -1

/**
 * The number (from 0) of the state meant: the nearest to a place; else the first in which strands need not pull. `STRAIGHT` for straight
 * strands where they are in equilibrium, and where there is nothing else.
 */
export function chosen(report: Report, at: Place | null): number {
  const { states } = report
  if (states.length === 0) return STRAIGHT
  if (at === null) return Math.max(0, states.findIndex((state) => !state.separated))
  let best = report.straight_holds === true ? STRAIGHT : 0
  const off = (number: number): number => Math.abs((number === STRAIGHT ? 0 : signedAngle(states[number]!)) - at)
  states.forEach((_, i) => {
    if (off(i) < off(best)) best = i
  })
  return best
}

export function isRefusal(answer: object): answer is { error: Refusal } {
  return 'error' in answer
}
