// What the solver answers to each question of the page. The wasm behind it is set up by whoever calls.

import * as nply from '../wasm/nply_wasm.js'
import { chosen, isRefusal, signedAngle } from '../answer.ts'
import type { Refusal, Report, Solved, Walk } from '../answer.ts'
import { NAME, toToml } from '../document.ts'
import type { Key } from '../document.ts'
import type { Along } from '../state.ts'
import type { AngleLine, Answer, Before, Curves, CurvesAsked, Exchange, Hello, Leg, Outline, Question, Refused } from './messages.ts'

type Doors = { [K in keyof Exchange]: (ask: Exchange[K]['ask']) => Exchange[K]['answer'] }

/** Points of a curve of each hand, of the locus of each hand, of a cut. */
const POINTS = { course: 260, locus: 220, outline: 96, contact: 220, supported: 160 }
const LINES = [10, 20, 30, 40, 50, 60, 70, 80]
/** The longest step of a walk, in rad: what is on the way is found to rounding whatever it is. */
const STEP = 0.04

let keys: readonly Key[] = []
let contacts: { strands: number; rows: Float64Array } = { strands: 0, rows: new Float64Array() }

export const doors: Doors = {
  hello(): Hello {
    keys = JSON.parse(nply.keys()) as Key[]
    return { keys, presets: JSON.parse(nply.presets()) as Hello['presets'] }
  },

  solve(question: Question): Answer | Refused {
    const begun = performance.now()
    const toml = toToml(question.data, keys)
    const solved = JSON.parse(nply.solve(NAME, toml)) as Solved | { error: Refusal }
    if (isRefusal(solved)) return { error: solved.error, toml }
    const { report } = solved
    const walk = question.before ? follow(question.before, report) : null
    const place = walk && walk.arrived ? lastAngle(walk) : question.at
    const number = chosen(report, place)
    const state = report.states[number]
    const outline = state
      ? outlineOf(report.strands, state.helical_angle, state.radius_ratio, state.handedness, state.support ?? 'neighbours')
      : outlineOf(report.strands, 0, 1 / Math.sin(Math.PI / report.strands), 1, 'neighbours')
    const before = whereItIs(report, number)
    return { ...solved, toml, number, outline, walk, before, took: performance.now() - begun }
  },

  curves(asked: CurvesAsked): Curves {
    const { strands, ratio, balance, twistKind, twist, force, moment } = asked
    const along = (datum: string) => nply.course(strands, ratio, balance, datum, twistKind, twist, force, moment, POINTS.course)
    const round = (datum: Along) =>
      asked.supported
        ? nply.supported_course(strands, ratio, asked.core ?? NaN, datum, twistKind, twist, force, moment, ...asked.windows[datum], POINTS.supported)
        : new Float64Array()
    const lines: AngleLine[] = []
    for (const hand of [1, -1] as const) {
      for (const degrees of LINES) {
        const points = nply.angle_line(strands, ratio, balance, twistKind, twist, hand, degrees)
        if (points.length === 4) lines.push({ hand, degrees, points })
      }
    }
    if (contacts.strands !== strands) contacts = { strands, rows: nply.contact_diagram(strands, POINTS.contact, 6) }
    return {
      pretwist: along('pretwist'),
      force: along('force'),
      moment: along('moment'),
      supported: { pretwist: round('pretwist'), force: round('force'), moment: round('moment') },
      locus: nply.locus(strands, ratio, twistKind, twist, POINTS.locus),
      lines,
      contact: contacts.rows,
    }
  },

  open({ name, text }) {
    const read = JSON.parse(nply.read(name, text)) as { data: { flag: string; text: string }[]; study: boolean } | { error: Refusal }
    if (isRefusal(read)) return read
    return { data: Object.fromEntries(read.data.map(({ flag, text }) => [flag, text])), study: read.study }
  },

  report({ data, format }) {
    const toml = toToml(data, keys)
    if (format === 'toml') return { text: toml }
    return JSON.parse(nply.report(NAME, toml, format)) as { text: string } | { error: Refusal }
  },

  mesh({ data, number, format, stripes }) {
    return nply.mesh(NAME, toToml(data, keys), number + 1, format, 3, stripes)
  },

  outline({ strands, angle, ratio, hand }) {
    return outlineOf(strands, angle, ratio, hand, 'neighbours')
  },

  leg({ strands, ratio, from, to, place }: Leg) {
    const numbers = (data: Leg['from']) => Float64Array.of(ratio, ...data, NaN)
    return walked(nply.walk(strands, 'contact', false, 'dead_loads', 'pretwist', numbers(from), numbers(to), place, 0.01))
  },
}

function outlineOf(strands: number, angle: number, ratio: number, hand: number, support: string): Outline {
  const touching = support === 'neighbours' || support === 'both'
  return {
    outline: nply.outline(strands, angle, ratio, hand, POINTS.outline),
    sides: touching ? nply.touching_sides(strands, angle, hand) : new Float64Array(),
  }
}

/** What holds the state: enough to follow it when that changes. */
function whereItIs(report: Report, number: number): Before | null {
  const { given, find } = report.question
  const state = report.states[number]
  if (given['rotation'] !== undefined || given['extension'] !== undefined) return null
  if (!state && report.straight_holds !== true) return null
  const twistKind = given['strand_twist'] !== undefined ? 'strand_twist' : 'pretwist'
  const twist = state ? (twistKind === 'pretwist' ? state.pretwist : state.strand_twist) : given[twistKind]
  const [force, moment] = [state?.force ?? given['force'], state?.moment ?? given['moment']]
  if (twist === undefined || force === undefined || moment === undefined) return null
  return {
    strands: report.strands,
    balance: report.balance ?? 'contact',
    touching: find !== 'supported_states',
    twistKind,
    numbers: [report.stiffness_ratio, twist, force, moment, report.core_radius ?? NaN],
    place: state ? signedAngle(state) : 0,
  }
}

/** From where it was to the data of now, if the ply is held alike. */
function follow(before: Before, report: Report): Walk | null {
  const { given, find } = report.question
  const [force, moment] = [given['force'], given['moment']]
  if ((find !== 'states' && find !== 'supported_states') || force === undefined || moment === undefined) return null
  const twist = given[before.twistKind]
  const touching = find !== 'supported_states'
  const alike = before.strands === report.strands && before.balance === (report.balance ?? 'contact') && before.touching === touching
  if (twist === undefined || !alike) return null
  const core = report.core_radius ?? NaN
  if (Number.isNaN(core) !== Number.isNaN(before.numbers[4])) return null
  const to = [report.stiffness_ratio, twist, force, moment, core]
  if (to.every((value, i) => Object.is(value, before.numbers[i]))) return null
  return walked(
    nply.walk(before.strands, before.balance, touching, 'dead_loads', before.twistKind, Float64Array.from(before.numbers), Float64Array.from(to), before.place, STEP),
  )
}

function walked(json: string): Walk | null {
  const walk = JSON.parse(json) as Walk | { error: Refusal } | null
  return walk === null || isRefusal(walk) ? null : walk
}

function lastAngle(walk: Walk): number {
  const last = walk.stations.length - 6
  return walk.stations[last]! * walk.stations[last + 1]!
}
