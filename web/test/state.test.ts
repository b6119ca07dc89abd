import { describe, expect, test } from 'vitest'
import { History } from '../src/history.ts'
import { FIRST, fromHash, sameData, toHash, withData, withLook } from '../src/state.ts'
import type { State } from '../src/state.ts'

const STATES: State[] = [
  FIRST,
  withData(FIRST, { title: 'a & b = c # d % e + f / ü ½ "quoted" \\ <i>', pretwist: undefined, 'turns-per-length': '470 turns/m S' }),
  withLook({ ...FIRST, at: -60.3408 }, { cut: 0.345, paint: 'pressure', stripes: 0, inside: true, reading: 'radii', along: 'moment' }),
  { data: { strands: '', 'no such flag': '=&=', '': 'lost' }, at: 0, look: FIRST.look },
]

test('a link says the state, word for word', () => {
  for (const state of STATES) {
    const { '': lost, ...data } = state.data
    void lost
    const hash = toHash({ ...state, data })
    expect(fromHash(hash)).toEqual({ ...state, data })
    expect(toHash(fromHash(hash)!)).toBe(hash)
    // as an address keeps it
    expect(fromHash(new URL(hash, 'http://127.0.0.1/').hash)).toEqual({ ...state, data })
  }
})

test('data keep their order in a link, and what is changed its place', () => {
  const changed = withData(withData(FIRST, { force: '1' }), { strands: '4' })
  expect(Object.keys(fromHash(toHash(changed))!.data)).toEqual(['title', 'strands', 'stiffness-ratio', 'pretwist', 'force'])
  expect(sameData(changed, withData(changed, {}))).toBe(true)
  expect(sameData(changed, withData(changed, { force: undefined }))).toBe(false)
})

test('a link that says nothing sensible of how to look is looked at as usual', () => {
  expect(fromHash('')).toBeNull()
  expect(fromHash('#')).toBeNull()
  expect(fromHash('#cut=7&stripes=-1&paint=red&at=Q12&reading=x&along=y&strands=3')).toEqual({ data: { strands: '3' }, at: null, look: FIRST.look })
  expect(fromHash('#strands=%E0%A4%A')!.data).toEqual({ strands: '%E0%A4%A' })
})

describe('undo', () => {
  const force = (value: number): State => withData(FIRST, { force: String(value) })

  test('a drag is undone as a whole, however long it lasts, and so are changes of one thing close upon each other', () => {
    const history = new History(FIRST)
    history.change(force(1), 'drag 1', 0)
    history.change(force(2), 'drag 1', 60_000)
    history.change(force(3), 'force', 60_001)
    history.change(force(4), 'force', 60_300)
    history.change(force(5), 'force', 70_000)
    expect([history.undo(), history.undo(), history.undo()]).toEqual([force(4), force(2), FIRST])
    expect(history.canUndo).toBe(false)
    expect([history.redo(), history.redo(), history.redo(), history.redo()]).toEqual([force(2), force(4), force(5), force(5)])
  })

  test('a change after undo has no redo; an amendment changes the present alone', () => {
    const history = new History(FIRST)
    history.change(force(1), '', 0)
    history.amend({ ...history.now, at: 12 })
    history.undo()
    expect(history.now).toEqual(FIRST)
    expect(history.redo().at).toBe(12)
    history.undo()
    history.change(force(2), '', 1)
    expect(history.canRedo).toBe(false)
  })
})
