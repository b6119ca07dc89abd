// What goes with what: how one way of saying a thing is turned into another, with the numbers of the state on show.

import type { PlyState, Report } from '../answer.ts'
import type { State } from '../state.ts'
import { withData } from '../state.ts'

export const TWISTS = ['pretwist', 'surface-angle', 'turns-per-length', 'turns', 'end-rotation', 'strand-twist'] as const
export const LAYS = ['helical-angle', 'lay-angle', 'pitch-angle', 'lay-length', 'lay-ratio', 'ply-turns-per-length', 'radius-ratio', 'helix-radius', 'core-radius', 'core-diameter'] as const
export const TURNED = ['ply-rotation', 'ply-turns', 'ply-turns-per-strand-length'] as const
export const LENGTHS = ['ply-length', 'length-ratio'] as const
export const CORES = ['support-core-radius', 'support-core-diameter'] as const
export const SIZES = ['diameter', 'radius', 'linear-density'] as const

/** The flag of a group that is given. */
export function given(state: State, group: readonly string[]): string | undefined {
  return group.find((flag) => state.data[flag] !== undefined)
}

export type Ends = 'loads' | 'turned' | 'length'

export function endsOf(state: State): Ends {
  return given(state, TURNED) ? 'turned' : given(state, LENGTHS) ? 'length' : 'loads'
}

const clear = (flags: readonly string[]): Record<string, undefined> => Object.fromEntries(flags.map((flag) => [flag, undefined]))

/** A load (over B/r², B/r) that is left of rounding alone. */
const SLIGHT = 2e-5

const short = (value: number): string => String(Number(value.toPrecision(6)))

const lengthIn = (value: number, report: Report): string => {
  const r = report.strand_radius_m
  if (!r) return short(value)
  const metres = value * r
  const [unit, factor] = metres < 2e-8 ? ['nm', 1e-9] : metres < 2e-5 ? ['µm', 1e-6] : metres < 2 ? ['mm', 1e-3] : ['m', 1]
  return `${short(metres / Number(factor))} ${unit}`
}

const perLength = (turns: number, report: Report): string => {
  const r = report.strand_radius_m
  if (!r) return short(turns)
  return r < 1e-6 ? `${short((turns / r) * 1e-9)} turns/nm` : `${short(turns / r)} turns/m`
}

export function forceText(value: number, report: Report): string {
  const [r, B] = [report.strand_radius_m, report.bending_stiffness_N_m2]
  if (!r || !B) return short(value)
  const si = (value * B) / r ** 2
  const unit = B / r ** 2
  const [name, factor] = unit < 1e-9 ? ['pN', 1e-12] : unit < 1e-2 ? ['mN', 1e-3] : unit < 1e3 ? ['N', 1] : ['kN', 1e3]
  return `${short(si / Number(factor))} ${name}`
}

export function momentText(value: number, report: Report): string {
  const [r, B] = [report.strand_radius_m, report.bending_stiffness_N_m2]
  if (!r || !B) return short(value)
  const si = (value * B) / r
  const [name, factor] = B / r < 1e-15 ? ['pN nm', 1e-21] : B / r < 1e-5 ? ['mN mm', 1e-6] : ['N m', 1]
  return `${short(si / Number(factor))} ${name}`
}

/** The twist of a state, said in a way. */
export function twistText(flag: string, ply: PlyState, report: Report): string {
  switch (flag) {
    case 'surface-angle': return `${short((Math.atan(ply.pretwist) * 180) / Math.PI)} deg`
    case 'turns-per-length': return perLength(ply.pretwist / (2 * Math.PI), report)
    case 'strand-twist': return report.strand_radius_m ? `${short(ply.strand_twist / report.strand_radius_m)} rad/m` : short(ply.strand_twist)
    default: return short(ply.pretwist)
  }
}

/** The lay of a state, said in a way. */
export function layText(flag: string, ply: PlyState, report: Report): string {
  const number = (name: string): number => (typeof ply[name] === 'number' ? (ply[name] as number) : 0)
  switch (flag) {
    case 'pitch-angle': return `${short(number('pitch_angle_deg'))} deg`
    case 'lay-length': return lengthIn(number('lay_length'), report)
    case 'lay-ratio': return short(number('lay_ratio'))
    case 'ply-turns-per-length': return perLength(ply.handedness * number('turns_per_ply_length'), report)
    case 'radius-ratio': return short(ply.radius_ratio)
    default: return `${short(ply.helical_angle_deg)} deg`
  }
}

/** The twist is known, and the lay is found. */
export function knowTwist(state: State, flag: string, ply: PlyState | undefined, report: Report): State {
  const ends = endsOf(state)
  const text = ply ? twistText(flag, ply, report) : '-1'
  const loads: Record<string, string | undefined> = {}
  if (ply && ends !== 'length' && Math.abs(ply.force) > SLIGHT) loads['force'] = state.data['force'] ?? forceText(ply.force, report)
  if (ply && ends !== 'turned' && Math.abs(ply.moment) > SLIGHT) loads['moment'] = state.data['moment'] ?? momentText(ply.moment, report)
  return withData(state, { ...clear([...TWISTS, ...LAYS, 'hand', 'separation']), [flag]: text, ...loads })
}

/** The lay is known, and the twist that holds it is found. */
export function knowLay(state: State, flag: string, ply: PlyState | undefined, report: Report): State {
  const text = ply ? layText(flag, ply, report) : '20 deg'
  const hand = flag === 'ply-turns-per-length' ? undefined : (state.data['hand'] ?? (ply ? (ply.handedness > 0 ? 'right' : 'left') : 'right'))
  const both = state.data['force'] !== undefined && state.data['moment'] !== undefined
  const loads = both ? {} : clear(['force', 'moment'])
  return withData(state, { ...clear([...TWISTS, ...LAYS, ...TURNED, ...LENGTHS, ...CORES, 'separation']), ...loads, [flag]: text, hand })
}

export function holdEnds(state: State, ends: Ends, ply: PlyState | undefined, report: Report): State {
  const number = (name: string): number => (ply && typeof ply[name] === 'number' ? (ply[name] as number) : 0)
  const none = clear([...TURNED, ...LENGTHS])
  const force = state.data['force'] ?? (ply && Math.abs(ply.force) > SLIGHT ? forceText(ply.force, report) : undefined)
  const moment = state.data['moment'] ?? (ply && Math.abs(ply.moment) > SLIGHT ? momentText(ply.moment, report) : undefined)
  const turns = ply ? ply.handedness * (number('turns_per_strand_length') || Math.sin(ply.helical_angle) / (2 * Math.PI * ply.radius_ratio)) : 0.05
  switch (ends) {
    case 'turned': return withData(state, { ...none, moment: undefined, force, 'ply-turns-per-strand-length': perLength(turns, report) })
    case 'length': return withData(state, { ...none, force: undefined, moment, 'length-ratio': short(Math.min(0.999, number('extension') || 0.9)) })
    default: return withData(state, { ...none, force, moment })
  }
}

export function withCore(state: State, core: boolean, ply: PlyState | undefined, report: Report): State {
  if (!core) return withData(state, clear(CORES))
  const radius = Math.max(0.15, ply ? ply.radius_ratio - 1 + 0.15 : 0.5)
  return withData(state, { 'support-core-radius': lengthIn(radius, report) })
}

/** Under these loads, both free to follow: what the plane of force and moment is about. */
export function loaded(state: State, force: number, moment: number, ply: PlyState | undefined, report: Report): State {
  const twisted = given(state, TWISTS) ? state : knowTwist(state, 'pretwist', ply, report)
  return withData(twisted, { ...clear([...TURNED, ...LENGTHS]), force: forceText(force, report), moment: momentText(moment, report) })
}
