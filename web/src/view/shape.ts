// What is seen of a ply, in numbers: lengths in strand radii, angles in rad.

import type { PlyState, Report } from '../answer.ts'
import type { Outline } from '../solver/messages.ts'

export interface Shape {
  readonly strands: number
  readonly theta: number
  readonly radiusRatio: number
  readonly hand: 1 | -1
  readonly pretwist: number
  /** p₁ r³/B. */
  readonly pressure: number
  readonly corePressure: number
  readonly core: number | null
  readonly touching: boolean
  readonly outline: Float64Array
  readonly sides: Float64Array
}

export function shapeOf(report: Report, state: PlyState | undefined, outline: Outline): Shape {
  const core = report.core_radius ?? null
  if (!state) return straight(report, outline)
  return {
    strands: report.strands,
    theta: state.helical_angle,
    radiusRatio: state.radius_ratio,
    hand: state.handedness,
    pretwist: state.pretwist,
    pressure: state.interstrand_pressure,
    corePressure: state.core_pressure ?? 0,
    core,
    touching: outline.sides.length > 0,
    ...outline,
  }
}

/** Strands side by side, as long as there is no state to show. */
function straight(report: Report, outline: Outline): Shape {
  const radiusRatio = report.strands === 2 ? 1 : 1 / Math.sin(Math.PI / report.strands)
  const pretwist = report.question.given['pretwist'] ?? 0
  return { strands: report.strands, theta: 0, radiusRatio, hand: 1, pretwist, pressure: 0, corePressure: 0, core: report.core_radius ?? null, touching: true, ...outline }
}

/** More strands than this are not drawn. */
export const MOST_DRAWN = 200

/** How much of the ply is shown, in strand radii: more of it where it is thick. */
export const HEIGHT = 15
export function heightOf(shape: Shape): number {
  return HEIGHT * thickness(shape)
}

/** 1 as long as the ply is not much thicker than straight strands. */
export function thickness(shape: Shape): number {
  const usual = 1.35 * (shape.strands === 2 ? 2 : 1 + 1 / Math.sin(Math.PI / shape.strands))
  const thick = Math.max(usual, shape.radiusRatio + 1)
  return Math.max(1, thick / 4.4)
}

/** Azimuth of strand 0's cut at a height, rad: everything turns alike. */
export function turnAt(shape: Shape, height: number): number {
  return (shape.hand * height * Math.tan(shape.theta)) / shape.radiusRatio
}
