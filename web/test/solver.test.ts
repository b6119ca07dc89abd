// The solver as the page has it, against tables made by another route and against the sentences of the command.

import { beforeAll, describe, expect, test } from 'vitest'
import type { PlyState } from '../src/answer.ts'
import { signedAngle } from '../src/answer.ts'
import { begin } from '../src/controls/presets.ts'
import { toToml } from '../src/document.ts'
import { doors } from '../src/solver/doors.ts'
import type { Answer, Refused } from '../src/solver/messages.ts'
import type { Data } from '../src/state.ts'
import { contact_diagram, locus, read, report, solve, walk } from '../src/wasm/nply_wasm.js'
import { documents, solver, table, text } from './setup.ts'

let keys: ReturnType<typeof solver>['keys']
beforeAll(() => {
  keys = solver().keys
})

const ask = (data: Data, at: number | null = null): Answer | Refused => doors.solve({ data, at, before: null, along: 'force' })
const answer = (data: Data): Answer => {
  const got = ask(data)
  if ('error' in got) throw new Error(got.error.sentence)
  return got
}

test('balanced plies are those of the golden table, in both balances', () => {
  const rows = table('authorities/balanced_plies.csv')
  expect(rows.length).toBeGreaterThan(50)
  for (const row of rows) {
    const data = { strands: row['n']!, 'stiffness-ratio': row['gamma']!, pretwist: row['pretwist']!, balance: row['balance']! }
    const angle = Number(row['theta_deg']) * Number(row['handedness'])
    const state = answer(data).report.states.toSorted((a, b) => Math.abs(signedAngle(a) - angle) - Math.abs(signedAngle(b) - angle))[0] as PlyState
    expect(Math.abs(signedAngle(state) / angle - 1)).toBeLessThan(1e-12)
    expect(Math.abs(state.radius_ratio / Number(row['rho']) - 1)).toBeLessThan(1e-12)
    expect(Math.abs(state.interstrand_pressure - Number(row['p1_r3_over_B']))).toBeLessThan(1e-12 * Math.max(1, Math.abs(Number(row['p1_r3_over_B']))))
  }
})

test('every shared case that is solved has the answer of the command, byte for byte', () => {
  const { cases } = JSON.parse(text('tests/cases/list.json')) as {
    cases: { name: string; verb: string; document?: string; arguments: Data }[]
  }
  const solved = cases.filter(({ verb }) => verb === 'solve')
  expect(solved.length).toBeGreaterThan(5)
  for (const { name, document, arguments: given } of solved) {
    const opened = document ? doors.open({ name: document, text: text(document) }) : { data: {} }
    if ('error' in opened) throw new Error(opened.error.sentence)
    const said = JSON.parse(report(document ?? name, toToml({ ...opened.data, ...given }, keys), 'json')) as { text: string }
    expect(said.text.trimEnd(), name).toBe(text(`tests/cases/${name}.json`).trimEnd())
  }
})

describe('documents', () => {
  test('what is read and written again gives the same states', () => {
    let read = 0
    for (const { name, text } of [...documents('examples'), ...documents('tests/inputs/ok')]) {
      const opened = doors.open({ name, text })
      if ('error' in opened || opened.study) continue // of another kind: layered strands, paths, maps
      const whole = JSON.parse(solve(name, text))
      const again = JSON.parse(solve(name, toToml(opened.data, keys)))
      if ('error' in whole) continue // read, but of another command
      expect(again.report, name).toEqual(whole.report)
      read += 1
    }
    expect(read).toBeGreaterThan(20)
  })

  test('titles and odd texts survive', () => {
    const data = { title: 'a "b" \\ c\nd\u007f é', strands: '3', 'stiffness-ratio': '0.75', pretwist: '-1' }
    const opened = JSON.parse(read('ply.toml', toToml(data, keys))) as { data: { flag: string; text: string }[] }
    expect(Object.fromEntries(opened.data.map(({ flag, text }) => [flag, text]))).toEqual(data)
  })

  test('a title that looks like a number stays a text', () => {
    expect(answer({ title: '12', strands: '3', 'stiffness-ratio': '0.75', pretwist: '-1' }).report.title).toBe('12')
  })

  test('every preset that is a ply begins with states', () => {
    const { presets } = doors.hello({})
    let begun = 0
    for (const preset of presets) {
      const opened = doors.open({ name: preset.name, text: preset.text })
      if ('error' in opened) {
        expect(opened.error.sentence).toContain('construction')
        continue
      }
      const { report } = answer(begin(preset, opened.data).data)
      expect(report.states.length, preset.name).toBeGreaterThan(0)
      begun += 1
    }
    expect(begun).toBeGreaterThan(12)
  })
})

test('every refusal is the sentence of the command', () => {
  const sentences = text('crates/nply-sheet/tests/messages.txt').trim().split('\n')
  let compared = 0
  for (const folder of ['parse_error', 'unit_error', 'domain_error']) {
    for (const { name, text } of documents(`tests/inputs/${folder}`)) {
      if (/^\[\[(path|layer)|^\[map|^path|^\[construction/m.test(text)) continue // of other commands
      const given = name.replace('tests/inputs/', '')
      const { error } = JSON.parse(solve(given, text)) as { error?: { sentence: string } }
      const kept = sentences.some((sentence) => sentence.startsWith(`${given}:`))
      if (!error || !kept) continue // refused by another question, or only once it is solved
      expect(sentences, given).toContain(error.sentence)
      compared += 1
    }
  }
  expect(compared).toBeGreaterThan(80)
})

test('a refusal names its key, so that it can stand at the field', () => {
  const refused = ask({ strands: '3', 'stiffness-ratio': '0.75', pretwist: '-1', force: '2 mm' })
  expect('error' in refused && [refused.error.key, refused.error.sentence]).toEqual(['force', expect.stringContaining('what is wanted is a force')])
})

describe('the ply is followed', () => {
  const rods = { strands: '3', 'stiffness-ratio': '0.75', pretwist: '-1' }

  test('to the state that its branch leads to, and told where it ends', () => {
    const first = answer(rods)
    const pushed = doors.solve({ data: { ...rods, force: '-1.2' }, at: null, before: first.before, along: 'force' }) as Answer
    expect(pushed.walk?.arrived).toBe(true)
    const found = pushed.report.states[pushed.number]!
    expect([found.lay, found.stability]).toEqual(['Z', 'stable'])
    const over = doors.solve({ data: { ...rods, force: '-1.4' }, at: null, before: first.before, along: 'force' }) as Answer
    const fold = over.walk?.events.find((event) => event.event === 'fold')
    expect([fold?.jump, fold?.force]).toEqual(['none', expect.closeTo(-1.28727, 5)]) // as nply trace has it
  })

  test('through straight strands to the other hand, and not to what lies nearest', () => {
    const yarn = { strands: '3', 'stiffness-ratio': '0.75', pretwist: '0.406051' }
    const first = answer(yarn)
    const turned = doors.solve({ data: { ...yarn, moment: '1.5' }, at: first.before!.place, before: first.before, along: 'force' }) as Answer
    expect(first.report.states[first.number]!.lay).toBe('S')
    expect(turned.report.states[turned.number]!.lay).toBe('Z')
    // as margins of nply solve have it: the moment may rise by 0.9136 before the strands lie straight
    expect(turned.walk?.events.find((event) => event.event === 'straight')?.moment).toBeCloseTo(0.9136, 4)
  })

  test('from straight strands that are let go, to the angle of a simulation in three dimensions', () => {
    const at = (moment: number) => Float64Array.of(0.75, -1, 0, moment, NaN)
    const way = JSON.parse(walk(3, 'contact', false, 'dead_loads', 'pretwist', at(-2.25), at(0), 0, 0.01)) as { stations: number[]; arrived: boolean }
    expect([way.arrived, way.stations.at(-6), way.stations.at(-5)]).toEqual([true, 1, expect.closeTo(30.613, 4)])
  })
})

test('the separation locus is where p₁ of the states vanishes', () => {
  const rows = locus(3, 0.75, 'pretwist', -0.2, 41)
  for (const at of [10, 20, 30]) {
    const [hand, degrees, force, moment] = rows.subarray(4 * at, 4 * at + 4) as unknown as [number, number, number, number]
    const { report } = answer({ strands: '3', 'stiffness-ratio': '0.75', pretwist: '-0.2', force: String(force), moment: String(moment) })
    const state = report.states.find((one) => one.handedness === hand && Math.abs(one.helical_angle_deg - degrees) < 1e-6)
    expect(state?.interstrand_pressure).toBeCloseTo(0, 10)
  }
})

test('the contact diagram: 45° parts the pair of two strands, and three strands are as in the golden table', () => {
  const pair = contact_diagram(2, 200, 0)
  for (let at = 0; at < pair.length; at += 5) {
    const [branch, , degrees, shift] = pair.subarray(at, at + 5) as unknown as [number, number, number, number]
    if (branch === 0) expect(shift > 1e-9).toBe(degrees > 45)
    if (branch === 1) expect(shift).toBeLessThan(0)
  }
  const row = table('authorities/contact_geometry.csv').find((one) => one['n'] === '3' && Number(one['theta_deg']) === 60)!
  const three = contact_diagram(3, 2000, 2)
  let nearest = [Infinity, 0]
  for (let at = 0; at < three.length; at += 5) if (three[at] === 0 && Math.abs(three[at + 2]! - 60) < Math.abs(nearest[0]! - 60)) nearest = [three[at + 2]!, three[at + 3]!]
  expect(nearest[1]).toBeCloseTo(Number(row['x']), 2)
})

test('the cut is closed on itself and as wide as the ply', () => {
  const { outline, sides } = doors.outline({ strands: 3, angle: 0.5342984484796083, ratio: 1.2182310273467398, hand: 1 })
  let outermost = 0
  for (let i = 0; i < outline.length; i += 2) outermost = Math.max(outermost, Math.hypot(outline[i]!, outline[i + 1]!))
  expect(outermost).toBeCloseTo(2.21823, 3)
  // the contact line's radius is that of the report
  const { report } = answer({ strands: '3', 'stiffness-ratio': '0.75', pretwist: '-1' })
  expect(sides[2]).toBeCloseTo(report.states[0]!['contact_line_radius'] as number, 12)
})
