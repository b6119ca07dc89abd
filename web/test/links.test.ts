// Any text as a link: it gives a state that can be shown or none, and the state's own link gives the same state again.

import { expect, test } from 'vitest'
import { fromHash, MOST_STRIPES, toHash } from '../src/state.ts'

/** Random numbers from a seed (mulberry32), so that a run can be repeated. */
function random(seed: number) {
  let at = seed >>> 0
  return () => {
    at = (at + 0x6d2b79f5) >>> 0
    let t = at
    t = Math.imul(t ^ (t >>> 15), t | 1)
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61)
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296
  }
}

const WORDS = [
  '#', '&', '=', '%', '+', ' ', '%2', '%zz', '%00', '%F0%9F%A7%B6', '\ud83e\uddf6', '\ud800', '\udc00', '\0', '\u2028', '\u202e', '<script>',
  'strands', 'pretwist', 'diameter', 'title', 'at', 'cut', 'paint', 'stripes', 'inside', 'reading', 'along', '__proto__', 'constructor',
  'toString', 'hasOwnProperty', 'Z', 'S', 'Z0', 'S0', 'S12.5', 'Z90', 'Z91', 'Z1e3', 'ZInfinity', `Z${'9'.repeat(400)}`, '-1', '-0', '0', '1',
  '0x1', '1e308', '0.5', '.5', '5.', '0.99999999', '12', '13', 'NaN', 'Infinity', 'yes', 'no', 'pressure', 'radii', 'moment', '0.5 mm', '١',
] // prettier-ignore

function link(next: () => number): string {
  const pick = () => WORDS[Math.floor(next() * WORDS.length)] ?? ''
  const any = () => String.fromCharCode(Math.floor(next() * 0x10000))
  const token = () => (next() < 0.85 ? pick() : any())
  const shaped = () => `${token()}=${token()}${next() < 0.2 ? token() : ''}`
  const count = Math.floor(next() * 8)
  const parts = Array.from({ length: count }, () => (next() < 0.7 ? shaped() : token()))
  return (next() < 0.9 ? '#' : '') + parts.join(next() < 0.9 ? '&' : '')
}

test('any text as a link is a state that can be shown, and its own link is that state', { timeout: 60_000 }, () => {
  for (let seed = 1; seed <= 5000; seed++) {
    const hash = link(random(seed))
    const state = fromHash(hash)
    if (state === null) continue
    const { at, data, look } = state
    const shown = JSON.stringify([seed, hash])
    expect(at === null || (Math.abs(at) <= 90 && !Object.is(at, -0)), shown).toBe(true)
    expect(look.cut >= 0 && look.cut <= 1 && !Object.is(look.cut, -0), shown).toBe(true)
    expect(Number.isInteger(look.stripes) && look.stripes >= 0 && look.stripes <= MOST_STRIPES, shown).toBe(true)
    expect(['strands', 'pressure'].includes(look.paint) && ['units', 'radii'].includes(look.reading), shown).toBe(true)
    expect(['pretwist', 'force', 'moment'].includes(look.along) && typeof look.inside === 'boolean', shown).toBe(true)
    expect(Object.getPrototypeOf(data) === Object.prototype, shown).toBe(true)
    expect(Object.values(data).every(text => typeof text === 'string'), shown).toBe(true)
    // as a link it is shortened once (angle and cut to four digits, half letters replaced), and never again
    const own = toHash(state)
    const again = fromHash(own)
    if (again === null) {
      expect(own, shown).toBe('#')
      continue
    }
    expect(toHash(again), shown).toBe(own)
    expect(Object.keys(again.data).length, shown).toBe(Object.keys(data).length)
    expect({ ...again.look, cut: 0 }, shown).toEqual({ ...look, cut: 0 })
  }
})

test('names that every object has are data as any other', () => {
  const state = fromHash('#__proto__=1&constructor=2&strands=3')
  expect(Object.entries(state?.data ?? {})).toEqual([['__proto__', '1'], ['constructor', '2'], ['strands', '3']]) // prettier-ignore
  expect(({} as Record<string, unknown>)['1']).toBeUndefined()
  expect(toHash(state!)).toBe('#__proto__=1&constructor=2&strands=3')
})

test('an angle that is none is no place, and what is empty is no number', () => {
  for (const at of ['Z91', 'S1e3', 'ZInfinity', `Z${'9'.repeat(400)}`, 'Z', '12', 'z12', 'Z-1']) {
    expect(fromHash(`#strands=3&at=${at}`)?.at, at).toBeNull()
  }
  expect(Object.is(fromHash('#strands=3&at=S0')?.at, 0)).toBe(true)
  for (const cut of ['', '0x0', '1e-9', '-0', ' ']) expect(fromHash(`#strands=3&cut=${cut}`)?.look.cut, cut).toBe(1)
})
