// The numbers of the state that is looked at, the states to choose from, and both balances.

import type { PlyState, Report, Solved } from './answer.ts'
import { signedAngle, STRAIGHT } from './answer.ts'
import { byId, el } from './element.ts'
import { digits, read } from './reading.ts'
import type { Kind, LengthUnit, Read } from './reading.ts'
import type { Reading } from './state.ts'

export function verdict(state: PlyState): { words: string; kind: 'good' | 'bad' | 'plain' } {
  if (state.separated) return { words: 'would have to pull', kind: 'bad' }
  if (state.support === 'none') return { words: `free, ${state.stability ?? 'open'}`, kind: state.stability === 'stable' ? 'good' : 'bad' }
  const carried = state.support === 'core' ? 'on the core, ' : state.support === 'both' ? 'on core and neighbours, ' : ''
  if (state.stability === 'stable') return { words: `${carried}stable`, kind: 'good' }
  if (state.stability === 'unstable') return { words: `${carried}unstable`, kind: 'bad' }
  return { words: `${carried}${state.stability ?? 'touching'}`, kind: 'plain' }
}

export function showStates(report: Report, number: number, choose: (at: number) => void): void {
  const place = byId('states')
  const { states } = report
  const straight = report.straight_holds === true
  if (states.length === 0 && !straight) {
    place.replaceChildren(el('p', { className: 'none' }, 'No state is in equilibrium with these data.'))
    return
  }
  const places: { at: number; on: boolean; kind: string; content: HTMLElement[] }[] = states.map((state, i) => {
    const { words, kind } = verdict(state)
    const hand = state.handedness > 0 ? 'right-handed' : 'left-handed'
    const content = [el('span', { className: `hand ${state.lay}`, title: hand }, state.lay), el('span', { className: 'angle' }, `${digits(state.helical_angle_deg, 4)}°`), el('span', { className: 'verdict' }, words)]
    return { at: signedAngle(state), on: i === number, kind, content }
  })
  if (straight) places.push({ at: 0, on: number === STRAIGHT, kind: 'plain', content: [el('span', { className: 'angle' }, '0°'), el('span', { className: 'verdict' }, 'straight')] })
  const held = place.contains(document.activeElement)
  const chips = places.map(({ at, on, kind, content }, i) => {
    const chip = el('button', { type: 'button', className: `chip ${kind}`, role: 'radio', aria: { checked: String(on) }, tabIndex: on ? 0 : -1 }, ...content)
    chip.addEventListener('click', () => choose(at))
    chip.addEventListener('keydown', (event) => {
      const step = event.key === 'ArrowRight' || event.key === 'ArrowDown' ? 1 : event.key === 'ArrowLeft' || event.key === 'ArrowUp' ? -1 : 0
      if (step === 0) return
      event.preventDefault()
      choose(places[(i + step + places.length) % places.length]!.at)
    })
    return chip
  })
  place.replaceChildren(...chips)
  if (held) place.querySelector<HTMLElement>('[aria-checked="true"]')?.focus()
}

const ROWS: readonly (readonly [string, string, Kind | 'deg' | 'number' | 'percent'])[] = [
  ['Lay angle', 'helical_angle_deg', 'deg'],
  ['Lay length', 'lay_length', 'length'],
  ['Outer diameter', 'outer_diameter', 'length'],
  ['Helix radius R/r', 'radius_ratio', 'number'],
  ['Take-up', 'retraction_percent', 'percent'],
  ['Pretwist', 'pretwist', 'number'],
  ['Force', 'force', 'force'],
  ['Moment', 'moment', 'moment'],
  ['Pressure between neighbours p₁', 'interstrand_pressure', 'pressure'],
  ['Pressure from the core', 'core_pressure', 'pressure'],
  ['Gap between neighbours', 'neighbour_gap', 'length'],
  ['Ply turns', 'turns_per_ply_length', 'turns'],
  ['Strand twist left', 'strand_twist_per_length', 'turns'],
  ['Hole radius', 'hole_radius', 'length'],
]

export function showNumbers(state: PlyState | undefined, reading: Reading, length: LengthUnit | null): void {
  const place = byId('readout')
  if (!state) {
    place.replaceChildren()
    return
  }
  const rows = ROWS.flatMap(([label, name, kind]) => {
    const value = state[name]
    if (typeof value !== 'number') return []
    const shown: Read =
      kind === 'deg' ? { number: digits(value), unit: '°', value }
      : kind === 'percent' ? { number: digits(value), unit: '%', value }
      : kind === 'number' ? { number: digits(value), unit: '', value }
      : read(state, name, kind, reading, length)!
    const number = el('dd', { data: { name, value: String(value) } }, el('b', {}, shown.number), shown.unit ? el('span', { className: 'unit' }, kind === 'deg' ? '°' : ` ${shown.unit}`) : null)
    return [el('div', {}, el('dt', {}, label), number)]
  })
  place.replaceChildren(...rows, ...margins(state, reading))
}

const CAUSES: Readonly<Record<string, string>> = { separation: 'strands part', fold: 'it jumps', most_turns: 'no more turns fit', straight: 'it lies straight', rings: 'flat rings' }

/** How far the force may fall, and what happens then. */
function margins(state: PlyState, reading: Reading): HTMLElement[] {
  const of = (name: 'force' | 'moment', side: 'below' | 'above', label: string): HTMLElement[] => {
    const limit = state.margins?.[name]?.[side]
    if (!limit) return []
    const si = (limit as unknown as { si?: Record<string, number> }).si?.['change']
    const size = { ...state, change: Math.abs(limit.change), si: si === undefined ? undefined : { change: Math.abs(si) } } as unknown as PlyState
    const shown = read(size, 'change', name, reading, null, 4)!
    return [el('div', { className: 'margin' }, el('dt', {}, label), el('dd', {}, el('b', {}, shown.number), el('span', { className: 'unit' }, ` ${shown.unit}`), el('span', { className: 'cause' }, CAUSES[limit.cause] ?? limit.cause)))]
  }
  return [...of('force', 'below', 'Force may fall by'), ...of('moment', state.handedness > 0 ? 'below' : 'above', state.handedness > 0 ? 'Moment may fall by' : 'Moment may rise by')]
}

/** The same branch in the other balance, and by how much it differs. */
export function showBalances(solved: Solved, state: PlyState | undefined): void {
  const place = byId('balances')
  const mine = solved.report.balance
  if (!state || !mine || !solved.other) {
    place.replaceChildren()
    return
  }
  const here = signedAngle(state)
  const alike = solved.other.filter((angle) => Math.sign(angle) === Math.sign(here))
  const rank = solved.report.states.filter((one) => one.handedness === state.handedness).indexOf(state)
  const other = alike.length === solved.report.states.filter((one) => one.handedness === state.handedness).length ? alike[rank] : alike.toSorted((a, b) => Math.abs(a - here) - Math.abs(b - here))[0]
  const name = mine === 'contact' ? 'radial' : 'contact'
  const angle = (degrees: number): string => `${digits(Math.abs(degrees), 5)}°`
  const difference = other === undefined ? null : Math.abs(here) - Math.abs(other)
  place.replaceChildren(
    el('p', {},
      el('b', {}, mine === 'contact' ? 'Contact balance ' : 'Radial balance '), angle(here), ' · ',
      el('b', {}, `${name} `), other === undefined ? 'has no such state' : angle(other),
      difference === null ? null : el('span', { className: 'difference' }, Math.abs(difference) < 1e-9 ? ' · no difference' : ` · difference ${difference > 0 ? '+' : '−'}${digits(Math.abs(difference), 3)}°`)),
  )
}
