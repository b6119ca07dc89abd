// How far a slider goes: in the unit in which the datum is written.

import type { Report, Written } from '../answer.ts'

export interface Range {
  readonly low: number
  readonly high: number
  readonly step: number
}

/** Dimensionless ends by flag, and the power of r (and of B) that turns them into SI. */
interface Extent {
  readonly low: number
  readonly high: number
  readonly length: number
  readonly stiffness: number
}

const TAU = 2 * Math.PI

function extent(flag: string, report: Report): Extent | null {
  const n = report.strands
  const of = (low: number, high: number, length = 0, stiffness = 0): Extent => ({ low, high, length, stiffness })
  const twist = 3
  const turns = 0.36 / Math.max(2, n) ** 0.85
  switch (flag) {
    case 'strands': return of(2, 12)
    case 'stiffness-ratio': return of(0.2, 2.5)
    case 'poissons-ratio': return of(0, 0.5)
    case 'pretwist': return of(-twist, twist)
    case 'surface-angle': return of(-1.25, 1.25)
    case 'turns-per-length': return of(-twist / TAU, twist / TAU, -1)
    case 'strand-twist': return of(-twist, twist, -1)
    case 'helical-angle': case 'lay-angle': return of(0, 1.52)
    case 'pitch-angle': return of(0.02, Math.PI / 2)
    case 'lay-length': return of(2 * n * 1.01, 24 * n, 1)
    case 'lay-ratio': return of(0.1, 20)
    case 'ply-turns-per-length': return of(-0.49 / n, 0.49 / n, -1)
    case 'radius-ratio': return of(n === 2 ? 1 : 1 / Math.sin(Math.PI / n), 6)
    case 'force': return of(-0.8 * n, 0.8 * n, -2, 1)
    case 'moment': return of(-1.4 * n, 1.4 * n, -1, 1)
    case 'ply-turns-per-strand-length': return of(-turns, turns, -1)
    case 'length-ratio': return of(0.05, 0.999)
    case 'support-core-radius': return of(0.02, 4, 1)
    case 'support-core-diameter': return of(0.04, 8, 1)
    default: return null
  }
}

/** The range of a datum's slider; none for what has no bounds, or is not written as a number. */
export function rangeOf(flag: string, report: Report, written: Written | undefined): Range | null {
  const bounds = extent(flag, report)
  if (!bounds || written?.number === undefined) return null
  const { low, high, length, stiffness } = bounds
  let unit = 1
  if (written.factor !== undefined) {
    const [r, B] = [report.strand_radius_m ?? 1, report.bending_stiffness_N_m2 ?? 1]
    // a turn counts as 2π rad in SI, as turns do here; angles are in rad
    const angle = flag.includes('turns') ? TAU : 1
    unit = (r ** length * B ** stiffness * angle) / written.factor
  }
  if (flag === 'strands') return { low, high, step: 1 }
  const step = niceStep(((high - low) * unit) / 600)
  return { low: Math.ceil((low * unit) / step) * step, high: Math.floor((high * unit) / step) * step, step }
}

/** 1, 2 or 5 times a power of ten. */
export function niceStep(rough: number): number {
  const power = 10 ** Math.floor(Math.log10(rough))
  const share = rough / power
  return (share > 5 ? 10 : share > 2 ? 5 : share > 1 ? 2 : 1) * power
}

/** A slider's number as it is written: no more digits than its step has. */
export function written(value: number, step: number, unit: string | undefined): string {
  const places = Math.max(0, Math.min(12, -Math.floor(Math.log10(step) + 1e-9)))
  const number = Number(value.toFixed(places))
  const text = Math.abs(number) >= 1e15 || (number !== 0 && Math.abs(number) < 1e-6) ? number.toExponential() : String(number)
  return unit ? `${text} ${unit}` : text
}
