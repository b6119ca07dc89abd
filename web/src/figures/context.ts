// What a figure is drawn from.

import type { PlyState, Report } from '../answer.ts'
import type { Curves } from '../solver/messages.ts'
import type { Along, State } from '../state.ts'

export interface Context {
  readonly state: State
  readonly report: Report
  readonly ply: PlyState | undefined
  readonly curves: Curves
  /** The twist that is held, of the state on show. */
  readonly twist: number
  /** What happened when the ply was last followed; with a jump, where it went: a signed angle. */
  readonly happened: readonly Happened[]
}

export interface Happened {
  readonly force: number
  readonly moment: number
  readonly pretwist: number
  readonly from: number
  readonly to: number | null
  readonly words: string
}

/** From where to where a datum runs. */
export type Window = readonly [number, number]

/** A range about 0 that holds what matters, with air. */
function about(...values: number[]): Window {
  const most = Math.max(...values.map((value) => (Number.isFinite(value) ? Math.abs(value) : 0)))
  return [-most, most]
}

export function windowOf(along: Along, context: Pick<Context, 'report' | 'ply' | 'twist'>): Window {
  const { strands: n, stiffness_ratio: gamma } = context.report
  const { force = 0, moment = 0, pretwist = 0 } = context.ply ?? {}
  switch (along) {
    case 'force': return about(0.6 * n, 1.25 * force)
    case 'moment': return about(0.5 * n, 1.6 * n * Math.min(3, gamma) * Math.min(3, Math.abs(pretwist)), 1.25 * moment)
    default: return about(2, 1.3 * pretwist)
  }
}

/** A state on a curve. */
export interface Point {
  readonly hand: 1 | -1
  readonly angle: number
  readonly datum: number
  readonly pressure: number
  readonly extension: number
  readonly rotation: number
  /** Points of one curve share it: a hand's states that press, or that would have to pull, without a break. */
  readonly curve: string
  readonly pulls: boolean
}

const COURSE = 8

/** The rows of a course as points, parted where the pressure changes its sign and where the datum leaves the window. */
export function points(rows: Float64Array, window: readonly [number, number]): Point[] {
  const found: Point[] = []
  let part = 0
  let last: Point | null = null
  const width = window[1] - window[0]
  for (let at = 0; at < rows.length; at += COURSE) {
    const [hand, angle, datum, pressure, , extension, rotation] = rows.subarray(at, at + COURSE) as unknown as [number, number, number, number, number, number, number]
    const inside = datum >= window[0] - width && datum <= window[1] + width
    const pulls = pressure < 0
    if (!inside) {
      last = null
      part += 1
      continue
    }
    const parted: boolean = last !== null && (last.hand !== hand || last.pulls !== pulls || Math.abs(last.datum - datum) > width)
    if (parted && last !== null && last.hand === hand && last.pulls !== pulls) {
      // both parts reach to where p₁ = 0
      const share: number = last.pressure / (last.pressure - pressure)
      const mix = (a: number, b: number): number => a + share * (b - a)
      const edge = { hand: hand as 1 | -1, angle: mix(last.angle, angle), datum: mix(last.datum, datum), pressure: 0, extension: mix(last.extension, extension), rotation: mix(last.rotation, rotation) }
      found.push({ ...edge, curve: last.curve, pulls: last.pulls })
      part += 1
      found.push({ ...edge, curve: `${hand}/${part}`, pulls })
    } else if (parted) part += 1
    last = { hand: hand as 1 | -1, angle, datum, pressure, extension, rotation, curve: `${hand}/${part}`, pulls }
    found.push(last)
  }
  return found
}
