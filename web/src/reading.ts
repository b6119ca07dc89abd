// Numbers for a reader: six digits, as the command prints them, and units that suit.

import type { PlyState, Report, Written } from './answer.ts'
import type { Reading } from './state.ts'

export interface Read {
  readonly number: string
  readonly unit: string
  /** The number behind it, as in the report. */
  readonly value: number
}

export function digits(value: number, most = 6): string {
  if (value === 0) return '0'
  const size = Math.abs(value)
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa = '', exponent = ''] = value.toExponential(most - 1).split('e')
    return `${tidy(mantissa)} · 10${raised(Number(exponent))}`.replace('-', '−')
  }
  return tidy(value.toPrecision(most)).replace('-', '−')
}

const tidy = (text: string): string => (text.includes('.') ? text.replace(/\.?0+$/, '') : text)

const raised = (exponent: number): string => String(exponent).replace(/./g, (c) => '⁰¹²³⁴⁵⁶⁷⁸⁹⁻'['0123456789-'.indexOf(c)] ?? c)

const PREFIXES: readonly [string, number][] = [
  ['G', 1e9], ['M', 1e6], ['k', 1e3], ['', 1], ['m', 1e-3], ['µ', 1e-6], ['n', 1e-9], ['p', 1e-12], ['f', 1e-15],
]

/** What dimensionless numbers are measured in, and how their SI names are said. */
const KINDS = {
  length: { radii: 'r', si: ['m'] },
  perLength: { radii: '1/r', si: ['1/m'] },
  turns: { radii: 'turns/r', si: ['turns/m'] },
  force: { radii: 'B/r²', si: ['N'] },
  moment: { radii: 'B/r', si: ['N·m'] },
  pressure: { radii: 'B/r³', si: ['N/m'] },
} as const
export type Kind = keyof typeof KINDS

const LENGTHS: Readonly<Record<string, number>> = { km: 1e3, m: 1, cm: 1e-2, mm: 1e-3, µm: 1e-6, μm: 1e-6, um: 1e-6, nm: 1e-9, Å: 1e-10, pm: 1e-12, in: 0.0254, ft: 0.3048 }

export interface LengthUnit {
  readonly name: string
  readonly factor: number
}

/** The unit in which lengths are written, or one that suits a strand; none where it has no size. */
export function lengthUnit(report: Report, data: readonly Written[]): LengthUnit | null {
  const r = report.strand_radius_m
  if (!r) return null
  const own = data.find((one) => one.unit !== undefined && LENGTHS[one.unit] !== undefined && one.flag !== 'strand-length' && !one.flag.includes('persistence'))
  if (own?.unit !== undefined) return { name: own.unit, factor: LENGTHS[own.unit]! }
  const name = r < 2e-8 ? 'nm' : r < 2e-5 ? 'µm' : r < 0.5 ? 'mm' : 'm'
  return { name, factor: LENGTHS[name]! }
}

/** In SI with a prefix: `0.002708 m` is `2.708 mm`. Moments go by a prefix on the force and one on the length. */
export function measured(si: number, kind: Kind, most = 6): Omit<Read, 'value'> {
  const size = Math.abs(si)
  if (kind === 'perLength' || kind === 'turns') {
    const what = kind === 'turns' ? 'turns' : '1'
    const [name, factor] = size >= 1e7 ? ['nm', 1e-9] : size >= 1e4 && kind === 'perLength' ? ['mm', 1e-3] : size >= 1e5 ? ['mm', 1e-3] : ['m', 1]
    return { number: digits(si * factor, most), unit: `${what}/${name}` }
  }
  if (kind === 'moment') {
    const [name, factor] = size < 1e-15 ? ['pN·nm', 1e-21] : size < 1e-7 ? ['µN·mm', 1e-9] : size < 1 ? ['N·mm', 1e-3] : ['N·m', 1]
    return { number: digits(si / factor, most), unit: name }
  }
  const prefix = size === 0 ? (['', 1] as const) : (PREFIXES.find(([, factor]) => size >= factor * 0.9999999) ?? PREFIXES.at(-1)!)
  return { number: digits(si / prefix[1], most), unit: prefix[0] + KINDS[kind].si[0] }
}

/** A number of a state by its name in the report. */
export function read(state: PlyState, name: string, kind: Kind, reading: Reading, length: LengthUnit | null = null, most = 6): Read | null {
  const value = state[name]
  if (typeof value !== 'number') return null
  const si = state.si?.[name]
  if (kind === 'length' && length && reading === 'units' && typeof si === 'number') return { number: digits(si / length.factor, most), unit: length.name, value }
  if (reading === 'units' && typeof si === 'number') return { ...measured(si, kind, most), value }
  return { number: digits(value, most), unit: KINDS[kind].radii, value }
}

/** What a dimensionless number of a kind is multiplied by for an axis, and the unit's name there. */
export function scaleOf(report: Report, kind: 'force' | 'moment' | 'pressure' | 'turns', reading: Reading, largest: number): { factor: number; unit: string } {
  const [r, B] = [report.strand_radius_m, report.bending_stiffness_N_m2]
  const si = reading !== 'units' || !r ? null : kind === 'turns' ? 1 / (2 * Math.PI * r) : !B ? null : kind === 'force' ? B / r ** 2 : kind === 'moment' ? B / r : B / r ** 3
  if (si === null) return { factor: 1, unit: kind === 'turns' ? '' : KINDS[kind].radii }
  const { unit } = measured(si * largest, kind)
  const factors: Record<string, number> = { 'pN·nm': 1e-21, 'µN·mm': 1e-9, 'N·mm': 1e-3, 'N·m': 1, 'turns/m': 1, 'turns/mm': 1e3, 'turns/nm': 1e9 }
  const prefix = PREFIXES.find(([name]) => unit === name + (kind === 'pressure' ? 'N/m' : 'N'))
  return { factor: si / (factors[unit] ?? prefix?.[1] ?? 1), unit }
}
