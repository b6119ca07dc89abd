// The page: a state, the solver's answer to it, and the views of both.

import './styles/page.css'
import type { PlyState, Refusal, Report, Walk } from './answer.ts'
import { isRefusal, STRAIGHT } from './answer.ts'
import { begin } from './controls/presets.ts'
import { loaded } from './controls/choice.ts'
import { Panel } from './controls/panel.ts'
import { byId, el } from './element.ts'
import { forget, say, tell } from './events.ts'
import { windowOf } from './figures/context.ts'
import type { Context, Happened } from './figures/context.ts'
import type { Figure } from './figures/figure.ts'
import { History } from './history.ts'
import { digits, lengthUnit, scaleOf } from './reading.ts'
import { showBalances, showNumbers, showStates, verdict } from './readout.ts'
import { latest, Solver } from './solver/client.ts'
import type { Answer, Curves, CurvesAsked, Hello } from './solver/messages.ts'
import type { Along, State } from './state.ts'
import { FIRST, fromHash, MOST_STRIPES, sameData, toHash, withLook } from './state.ts'
import { Story } from './story.ts'
import { takeAway, takeDrops } from './take-away.ts'
import { isDark, pressureColour } from './theme.ts'
import { section } from './view/section.ts'
import { drawPly } from './view/drawn.ts'
import type { Scene } from './view/scene.ts'
import { heightOf, MOST_DRAWN, shapeOf } from './view/shape.ts'
import type { Shape } from './view/shape.ts'

const solver = new Solver()
const history = new History(fromHash(location.hash) ?? FIRST)

/** The last answer that was one: what is on show. */
let answer: Answer | null = null
let refusal: Refusal | null = null
let shape: Shape | null = null
let curves: Curves | null = null
let curvesOf = ''
let scene: Scene | null = null
/** Where there is no WebGL. */
let flat: HTMLCanvasElement | null = null
let figures: readonly Figure[] = []
let panel: Panel | null = null
let hello: Hello | null = null
let numbersShown: () => void = () => {}
let happened: readonly Happened[] = []
/** The state to which the answer belongs. */
let answered: State | null = null

// ---- a change of state

function change(state: State, of: string): void {
  const before = history.now
  history.change(state, of, performance.now())
  if (sameData(before, state)) redraw()
  else solve({ state, of })
}

function go(state: State): void {
  forget()
  solve({ state, of: 'history' })
}

/** Changes after which the ply is not followed from where it was. */
const ELSEWHERE = ['history', 'preset', 'story', 'choose']

const solve = latest<{ state: State; of: string }>(async ({ state, of }) => {
  // what a hand moves is followed along its branch; what is chosen, opened or undone is where it says
  const told = !ELSEWHERE.includes(of)
  const before = (told && answer?.before) || null
  const at0 = told ? (answered?.at ?? state.at) : state.at
  const got = await solver.ask('solve', { data: state.data, at: at0, before, along: state.look.along })
  if (isRefusal(got)) {
    refusal = got.error
    if (!answer) {
      // there is no answer yet to stand on: the first page's, behind the sentence
      const stand = await solver.ask('solve', { data: FIRST.data, at: null, before: null, along: state.look.along })
      if (!isRefusal(stand)) {
        answer = stand
        shape = shapeOf(stand.report, stand.report.states[stand.number], stand.outline)
      }
      showLook(history.now)
    }
    showPanel()
    document.body.classList.add('stale')
    ready()
    return
  }
  refusal = null
  answer = got
  const ply = got.report.states[got.number]
  // the place is kept, so that the next change starts from this branch
  const at = ply ? ply.handedness * ply.helical_angle_deg : got.report.straight_holds === true ? 0 : null
  answered = { ...state, at }
  if (sameData(history.now, state)) history.amend({ ...history.now, at })
  shape = shapeOf(got.report, ply, got.outline)
  if (got.walk && told) tell(got.walk, got.report, state.look.reading)
  if (!told) happened = []
  else if (got.walk && got.walk.events.length > 0) happened = [...happenings(got.walk, at), ...happened].slice(0, 4)
  document.body.classList.remove('stale')
  redraw()
  document.body.dataset['took'] = got.took.toFixed(2)
  ready()
  wantCurves()
})

/** The first numbers, or the first refusal, are on show. */
function ready(): void {
  document.body.dataset['ready'] = 'yes'
  document.body.dataset['first'] ??= performance.now().toFixed(0) // ms since the page was asked for
  numbersShown()
}

const askCurves = latest<{ asked: CurvesAsked; key: string }>(async ({ asked, key }) => {
  curves = await solver.ask('curves', asked)
  curvesOf = key
  showFigures()
})

function wantCurves(): void {
  const asked = curvesAsked()
  if (!asked) return
  const key = JSON.stringify(asked)
  if (key === curvesOf) showFigures()
  else askCurves({ asked, key })
}

function curvesAsked(): CurvesAsked | null {
  if (!answer) return null
  const { report, number } = answer
  const ply = report.states[number]
  const { given, find } = report.question
  const twistKind = given['strand_twist'] !== undefined ? 'strand_twist' : 'pretwist'
  const twist = ply ? (twistKind === 'pretwist' ? ply.pretwist : ply.strand_twist) : (given[twistKind] ?? 0)
  const [force, moment] = [ply?.force ?? given['force'] ?? 0, ply?.moment ?? given['moment'] ?? 0]
  const of = { report, ply, twist }
  const windows = { pretwist: windowOf('pretwist', of), force: windowOf('force', of), moment: windowOf('moment', of) }
  return {
    strands: report.strands, ratio: report.stiffness_ratio, balance: report.balance ?? 'contact', twistKind, twist, pretwist: ply?.pretwist ?? twist, force, moment,
    core: report.core_radius ?? null, supported: find === 'supported_states', windows,
  }
}

function happenings(walk: Walk, at: number | null): Happened[] {
  const words: Readonly<Record<string, string>> = { separation: 'strands part', fold: 'states end', contact_change: 'contacts change', straight: 'straight', most_turns: 'no more turns fit in', buckling: 'strands buckle' }
  return walk.events.filter((event) => words[event.event]).map((event) => ({
    force: event.force, moment: event.moment, pretwist: event.twist, from: event.angle, words: words[event.event]!,
    to: event.jump === null ? null : event.jump === 'none' ? at : event.jump,
  }))
}

// ---- what is shown

function redraw(): void {
  const state = history.now
  showAddress()
  byId<HTMLButtonElement>('undo').disabled = !history.canUndo
  byId<HTMLButtonElement>('redo').disabled = !history.canRedo
  showLook(state)
  showPanel()
  if (!answer || !shape) return
  const { report, number } = answer
  const ply = report.states[number]
  byId('title').textContent = report.title ?? `${report.strands} strands`
  document.title = `nply: ${report.title ?? `${report.strands} strands`}`
  byId('version').textContent = `nply ${report.version}.`
  showStates(report, number, (at) => choose(at))
  showNumbers(ply ?? straight(report, number), state.look.reading, lengthUnit(report, answer.data))
  showBalances(answer, ply)
  showNotes(report)
  showPly()
  showFigures()
}

/** What can be said of straight strands. */
function straight(report: Report, number: number): PlyState | undefined {
  if (number !== STRAIGHT || report.straight_holds !== true) return undefined
  const { given } = report.question
  return { helical_angle_deg: 0, radius_ratio: shape?.radiusRatio, ...given } as unknown as PlyState
}

/** The link follows a little behind: browsers bear no more than some changes of it a second. */
let addressing = 0
function showAddress(): void {
  clearTimeout(addressing)
  addressing = window.setTimeout(() => window.history.replaceState(null, '', toHash(history.now)), 120)
}

/** Another state under the same data. */
function choose(at: number): void {
  const state = { ...history.now, at }
  history.change(state, 'choose', performance.now())
  solve({ state, of: 'choose' })
}

function showPanel(): void {
  if (!panel || !answer) return
  panel.show({ state: history.now, report: answer.report, ply: answer.report.states[answer.number], data: answer.data, refusal })
}

function showNotes(report: Report): void {
  byId('notes').querySelector('ul')?.replaceChildren(...report.notes.map((note) => el('li', {}, note)))
  byId('notes').hidden = report.notes.length === 0
}

function showLook(state: State): void {
  const { look } = state
  byId<HTMLInputElement>('cut').value = String(look.cut)
  byId<HTMLInputElement>('paint').checked = look.paint === 'pressure'
  byId<HTMLInputElement>('inside').checked = look.inside
  if (document.activeElement !== byId('stripes')) byId<HTMLInputElement>('stripes').value = String(look.stripes)
  byId('units').setAttribute('aria-pressed', String(look.reading === 'units'))
  byId('radii').setAttribute('aria-pressed', String(look.reading === 'radii'))
  const along = document.getElementById('along')
  if (along instanceof HTMLSelectElement) along.value = look.along
}

function showPly(): void {
  if (!shape || !answer) return
  const { look } = history.now
  const ply = answer.report.states[answer.number]
  const words = description(answer.report, answer.number)
  drawShape(shape)
  const low = -heightOf(shape) / 2
  byId('section').replaceChildren(section(shape, low + heightOf(shape) * (0.04 + 0.96 * look.cut), `The cut across the ply. ${words}`))
  ;(scene?.canvas ?? flat)?.setAttribute('aria-label', words)
  announce(words)
  showLegend(ply?.interstrand_pressure)
}

/** Said to those who listen, once the ply has come to rest. */
let announcing = 0
function announce(words: string): void {
  clearTimeout(announcing)
  announcing = window.setTimeout(() => {
    if (byId('said').textContent !== words) byId('said').textContent = words
  }, 700)
}

function drawShape(drawn: Shape): void {
  scene?.show(drawn, history.now.look)
  if (flat) drawPly(flat, drawn, history.now.look)
}

function description(report: Report, number: number): string {
  const ply = report.states[number]
  if (!ply) return `${report.strands} straight strands side by side.`
  const hand = ply.handedness > 0 ? 'right-handed' : 'left-handed'
  return `${report.strands} strands, ${hand}, lay angle ${digits(ply.helical_angle_deg, 4)} degrees, ${verdict(ply).words}.`
}

function showLegend(pressure: number | undefined): void {
  const place = byId('legend')
  const { look } = history.now
  const strands = answer?.report.strands ?? 0
  const many = strands > MOST_DRAWN ? `${MOST_DRAWN} of ${strands} strands are drawn` : ''
  if (look.paint !== 'pressure' || pressure === undefined || !answer) {
    place.textContent = many
    return
  }
  const { factor, unit } = scaleOf(answer.report, 'pressure', look.reading, Math.abs(pressure) || 1)
  const patch = el('i', { className: 'patch' })
  patch.style.backgroundColor = pressureColour(pressure)
  place.replaceChildren(patch, `p₁ ${digits(pressure * factor, 4)} ${unit}${pressure < 0 ? ', would have to pull' : ''} ${many}`)
}

function showFigures(): void {
  if (!answer || !curves) return
  const { report, number } = answer
  const asked = curvesAsked()
  const context: Context = { state: history.now, report, ply: report.states[number], curves, twist: asked?.twist ?? 0, happened }
  for (const figure of figures) figure.show(context)
}

// ---- documents from elsewhere

async function open(name: string, text: string): Promise<void> {
  const read = await solver.ask('open', { name, text })
  if (isRefusal(read)) {
    refusal = { ...read.error, key: null } // of that document, and not of the fields on show
    showPanel()
    return
  }
  forget()
  panel?.begun(null, `Opened: ${name}.`)
  change({ ...history.now, data: read.data, at: null }, 'preset')
  if (read.study) say(`${name} also says what changes ([[path]], [map] or [sweep]): that is for nply trace, nply map and nply sweep, and is left out here.`)
}

async function preset(name: string): Promise<void> {
  const found = hello?.presets.find((one) => one.name === name)
  if (!found) return
  const read = await solver.ask('open', { name, text: found.text })
  if (isRefusal(read)) return
  const { data, said } = begin(found, read.data)
  forget()
  panel?.begun(name, said)
  change({ ...history.now, data, at: null }, 'preset')
}

// ---- hands on the page

function listen(story: Story): void {
  const look = (of: string, changes: () => Partial<State['look']>) => () => change(withLook(history.now, changes()), of)
  byId('cut').addEventListener('input', look('cut', () => ({ cut: Number(byId<HTMLInputElement>('cut').value) })))
  byId('paint').addEventListener('change', look('paint', () => ({ paint: byId<HTMLInputElement>('paint').checked ? 'pressure' : 'strands' })))
  byId('inside').addEventListener('change', look('inside', () => ({ inside: byId<HTMLInputElement>('inside').checked })))
  byId('stripes').addEventListener('input', () => {
    const stripes = Number(byId<HTMLInputElement>('stripes').value)
    if (Number.isInteger(stripes) && stripes >= 0 && stripes <= MOST_STRIPES) change(withLook(history.now, { stripes }), 'stripes')
  })
  byId('units').addEventListener('click', look('reading', () => ({ reading: 'units' })))
  byId('radii').addEventListener('click', look('reading', () => ({ reading: 'radii' })))
  byId('home').addEventListener('click', () => scene?.home())
  byId('undo').addEventListener('click', () => go(history.undo()))
  byId('redo').addEventListener('click', () => go(history.redo()))
  byId('story-open').addEventListener('click', () => story.begin())
  byId('link').addEventListener('click', async () => {
    const button = byId('link')
    try {
      await navigator.clipboard.writeText(new URL(toHash(history.now), location.href).href)
      button.textContent = 'Copied'
    } catch {
      button.textContent = 'See the address'
    }
    setTimeout(() => (button.textContent = 'Copy link'), 1600)
  })
  byId('theme').addEventListener('click', () => {
    document.documentElement.dataset['theme'] = isDark() ? 'light' : 'dark'
    redraw()
  })
  byId('panel').addEventListener('submit', (event) => event.preventDefault())
  addEventListener('keydown', (event) => {
    const typing = event.target instanceof HTMLInputElement && event.target.type === 'text'
    if (event.key === 'Escape' && story.open) story.end()
    if (!(event.ctrlKey || event.metaKey) || typing) return
    const key = event.key.toLowerCase()
    if (key === 'z' && !event.shiftKey) go(history.undo())
    else if (key === 'y' || (key === 'z' && event.shiftKey)) go(history.redo())
    else return
    event.preventDefault()
  })
  addEventListener('hashchange', () => {
    const state = fromHash(location.hash)
    if (state && toHash(state) !== toHash(history.now)) {
      history.change(state, '', performance.now())
      go(state)
    }
  })
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw)
}

async function begun(): Promise<void> {
  hello = await solver.ask('hello', {})
  panel = new Panel(hello.keys, hello.presets, { change, preset: (name) => void preset(name) })
  const story = new Story({
    solver,
    shape: drawShape,
    set: (data, at, of) => change({ ...history.now, data, at }, of),
    say: (sentence) => say(sentence, 'strong'),
    cover: (left) => scene?.aside(left > 0 ? (left - byId('cut-panel').offsetWidth) / 2 : 0),
  })
  listen(story)
  solve({ state: history.now, of: 'history' })
  const first = new Promise<void>((resolve) => (numbersShown = resolve))
  const take = takeAway({
    solver,
    data: () => history.now.data,
    number: () => answer?.number ?? 0,
    stripes: () => history.now.look.stripes,
    picture: () => (scene ? scene.png() : new Promise((resolve) => (flat ? flat.toBlob(resolve) : resolve(null)))),
    open: (name, text) => void open(name, text),
  })
  byId('take').addEventListener('click', take)
  takeDrops((name, text) => void open(name, text))
  // numbers first; what is heavier comes after them
  await first
  await Promise.all([withScene(), withFigures()])
}

async function withScene(): Promise<void> {
  const place = byId('view')
  try {
    if (!document.createElement('canvas').getContext('webgl2')) throw new Error('no WebGL')
    const { Scene } = await import('./view/scene.ts')
    scene = new Scene(place)
    scene.canvas.tabIndex = 0
    scene.canvas.setAttribute('aria-description', 'Arrow keys turn it, plus and minus come nearer and go away, Home begins anew.')
    scene.onDraw(() => (document.body.dataset['drawn'] = 'yes'))
    byId('view-said').remove()
  } catch {
    flat = el('canvas', { className: 'still' })
    place.replaceChildren(flat)
    byId('home').hidden = true
    new ResizeObserver(() => shape && flat && drawPly(flat, shape, history.now.look)).observe(place)
    document.body.dataset['drawn'] = 'flat'
  }
  const canvas = scene?.canvas ?? flat
  canvas?.setAttribute('role', 'img')
  canvas?.setAttribute('aria-label', 'The ply')
  showPly()
}

async function withFigures(): Promise<void> {
  const [{ Figure }, kinds, { plane }] = await Promise.all([import('./figures/figure.ts'), import('./figures/kinds.ts'), import('./figures/plane.ts')])
  const along = (datum: Along): void => change(withLook(history.now, { along: datum }), 'along')
  const load = (force: number, moment: number, of: string): void => {
    if (!answer) return
    const state = loaded(history.now, force, moment, answer.report.states[answer.number], answer.report)
    change({ ...state, at: answered?.at ?? state.at }, of)
  }
  figures = [plane({ load }), kinds.angle, kinds.pressures(along), kinds.pull, kinds.turn, kinds.contact].map((kind) => new Figure(kind))
  const sign = (kind: string, words: string): HTMLElement => el('span', {}, el('i', { className: `line ${kind}` }), words)
  const key = el('p', { className: 'key' }, sign('Z', 'right-handed (Z)'), sign('S', 'left-handed (S)'), sign('pulls', 'would have to pull'))
  byId('figures').replaceChildren(key, ...figures.map((figure) => figure.element))
  showLook(history.now)
  showFigures()
}

begun().catch((error: unknown) => {
  const place = byId('refusal')
  place.hidden = false
  place.textContent = `This page could not be set up: ${String(error)}`
})
