import { expect, test } from 'vitest'
import type { PlyState, Report } from '../src/answer.ts'
import { niceStep, rangeOf, written } from '../src/controls/range.ts'
import { csv } from '../src/download.ts'
import { digits, lengthUnit, measured, read, scaleOf } from '../src/reading.ts'

test('six digits, as the command prints them', () => {
  expect([30.61304609826961, 0, -1, 0.06371765611470258, 1234567, 12345.678, -3.5e-9].map((value) => digits(value))).toEqual([
    '30.613', '0', '−1', '0.0637177', '1.23457 · 10⁶', '12345.7', '−3.5 · 10⁻⁹',
  ])
})

test('units suit the size, and say what the number is', () => {
  const say = (...of: Parameters<typeof measured>) => Object.values(measured(...of)).join(' ')
  expect(say(0.002708, 'length')).toBe('2.708 mm')
  expect(say(1234, 'force')).toBe('1.234 kN')
  expect(say(8.2e-21, 'moment')).toBe('8.2 pN·nm')
  expect(say(0.5e-3, 'moment')).toBe('0.5 N·mm')
  expect(say(369.243, 'turns')).toBe('369.243 turns/m')
  expect(say(99_451_000, 'turns')).toBe('0.099451 turns/nm')
})

const DNA = { strands: 2, strand_radius_m: 1e-9, bending_stiffness_N_m2: 2.06e-28, states: [], notes: [] } as unknown as Report

test('an axis has the factor of its unit', () => {
  const { factor, unit } = scaleOf(DNA, 'force', 'units', 1)
  expect([unit, factor]).toEqual(['pN', expect.closeTo(206, 9)])
  expect(scaleOf(DNA, 'moment', 'units', 1)).toEqual({ unit: 'pN·nm', factor: expect.closeTo(206, 9) })
  expect(scaleOf(DNA, 'force', 'radii', 1)).toEqual({ unit: 'B/r²', factor: 1 })
})

test('lengths are read in the unit in which the strand is written', () => {
  const state = { outer_diameter: 4, si: { outer_diameter: 4e-9 } } as unknown as PlyState
  const unit = lengthUnit(DNA, [{ flag: 'radius', text: '10 Å', number: 10, unit: 'Å', factor: 1e-10 }])
  expect(read(state, 'outer_diameter', 'length', 'units', unit)).toMatchObject({ number: '40', unit: 'Å', value: 4 })
  expect(read(state, 'outer_diameter', 'length', 'radii', unit)).toMatchObject({ number: '4', unit: 'r' })
  expect(lengthUnit({ ...DNA, strand_radius_m: null }, [])).toBeNull()
})

test('a slider goes as far in one unit as in another', () => {
  const bare = { ...DNA, strand_radius_m: null, bending_stiffness_N_m2: null } as Report
  const inRadii = rangeOf('force', bare, { flag: 'force', text: '0', number: 0 })!
  const inPiconewtons = rangeOf('force', DNA, { flag: 'force', text: '0 pN', number: 0, unit: 'pN', factor: 1e-12 })!
  expect(Math.abs(inPiconewtons.high / inRadii.high / 206 - 1)).toBeLessThan(0.01) // up to a step
  const perTurn = rangeOf('turns-per-length', { ...DNA, strand_radius_m: 1e-3 }, { flag: 'turns-per-length', text: '1 turns/m', number: 1, unit: 'turns/m', factor: 2 * Math.PI })!
  expect(perTurn.high).toBeCloseTo(3 / (2 * Math.PI * 1e-3), -1) // the pretwist 3 in turns/m, r = 1 mm
  expect(rangeOf('title', DNA, undefined)).toBeNull()
})

test('a slider writes no more digits than its step has', () => {
  expect([written(0.1 + 0.2, 0.01, undefined), written(-470.4, 1, 'turns/m'), written(0, 0.5, 'N'), written(1e-9, 1e-12, undefined)]).toEqual(['0.3', '-470 turns/m', '0 N', '1e-9'])
  expect([0.0123, 0.02, 3, 7].map(niceStep)).toEqual([0.02, 0.02, 5, 10])
})

test('a table has every digit, an empty cell where there is no number, and quotes what would break it', () => {
  expect(csv(['a', 'b'], [[0.1 + 0.2, 'x'], [NaN, 'say "so", twice']])).toBe('a,b\n0.30000000000000004,x\n,"say ""so"", twice"\n')
})
