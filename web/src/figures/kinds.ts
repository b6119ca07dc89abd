// The figures: what stands on which axis.

import * as Plot from '@observablehq/plot'
import type { PlyState } from '../answer.ts'
import { digits, scaleOf } from '../reading.ts'
import type { Along } from '../state.ts'
import { points, windowOf } from './context.ts'
import type { Context, Point, Window } from './context.ts'
import type { Drawing, FigureKind } from './figure.ts'

const HANDS = { 1: 'right (Z)', [-1]: 'left (S)' } as const
const INK = { 1: 'var(--right)', [-1]: 'var(--left)' } as const
const RULE = { stroke: 'var(--rule)' }

/** How the datum that runs is said on an axis. */
function axis(along: Along, context: Context, window: Window): { factor: number; label: string } {
  if (along === 'pretwist') return { factor: 1, label: 'pretwist' }
  const { factor, unit } = scaleOf(context.report, along, context.state.look.reading, window[1])
  return { factor, label: `${along} (${unit})` }
}

interface Spot {
  x: number
  y: number
}

/** Curves of states: drawn where strands press, dashed where they would have to pull. */
function curvesOf(found: readonly Point[], x: (point: Point) => number, y: (point: Point) => number): Plot.Markish[] {
  const line = (pulls: boolean) =>
    Plot.line(found.filter((point) => point.pulls === pulls), {
      x, y, z: 'curve', stroke: (point: Point) => INK[point.hand], strokeWidth: pulls ? 1.2 : 2.2, clip: true,
      ...(pulls ? { strokeDasharray: '4 3', strokeOpacity: 0.75 } : {}),
    })
  return [line(true), line(false)]
}

function mark(spot: Spot | null, hand: 1 | -1): Plot.Markish[] {
  if (!spot || !Number.isFinite(spot.x) || !Number.isFinite(spot.y)) return []
  return [
    Plot.ruleX([spot.x], { stroke: 'var(--now)', strokeOpacity: 0.35 }),
    Plot.dot([spot], { x: 'x', y: 'y', r: 5.5, fill: INK[hand], stroke: 'var(--ground)', strokeWidth: 2, className: 'now' }),
  ]
}

function tips(found: readonly Point[], x: (point: Point) => number, y: (point: Point) => number, words: (point: Point) => string): Plot.Markish {
  return Plot.tip(found, Plot.pointer({ x, y, title: words, maxRadius: 30, fontSize: 12, lineHeight: 1.3 }))
}

const said = (point: Point): string => `${HANDS[point.hand]} ${digits(point.angle, 4)}°${point.pulls ? ', would have to pull' : ''}`

const columns = ['handedness', 'helical_angle_deg', 'datum', 'interstrand_pressure', 'extension', 'rotation', 'separated'] as const
const rowsOf = (found: readonly Point[]) => found.map((point) => [point.hand, point.angle, point.datum, point.pressure, point.extension, point.rotation, String(point.pulls)])

function course(along: Along, context: Context, y: (point: Point) => number, here: (ply: PlyState) => number, label: string, options: Plot.PlotOptions, extra: (window: Window, factor: number) => Plot.Markish[] = () => []): Drawing {
  const window = windowOf(along, context)
  const { factor, label: below } = axis(along, context, window)
  const found = points(context.curves[along], window).filter((point) => point.datum >= window[0] * 1.5 && point.datum <= window[1] * 1.5)
  const x = (point: Point): number => point.datum * factor
  const { ply } = context
  const spot = ply ? { x: (ply[along] as number) * factor, y: here(ply) } : null
  const marks = [
    Plot.ruleX([0], RULE),
    ...curvesOf(found, x, y), ...extra(window, factor), ...mark(spot, ply?.handedness ?? 1),
    tips(found.filter((point) => point.datum >= window[0] && point.datum <= window[1]), x, y, (point) => `${said(point)}\n${below.replace(/ \(.*/, '')} ${digits(x(point), 4)}\n${label.replace(/ \(.*/, '')} ${digits(y(point), 4)}`),
  ]
  return {
    options: { x: { domain: [window[0] * factor, window[1] * factor], label: below, labelAnchor: 'center', nice: false }, y: { label, grid: true, nice: true }, ...options, marks },
    says: ply ? `${label} against ${below}: at the state on show ${digits(spot!.y, 5)} at ${digits(spot!.x, 5)}.` : `${label} against ${below}.`,
    columns: columns.map((name) => (name === 'datum' ? along : name)),
    rows: () => rowsOf(found),
  }
}

export const angle: FigureKind = {
  id: 'angle-pretwist',
  title: 'Angle against pretwist',
  about: 'Every state these strands can take as the twist put into them runs, at the loads of now. Dashed: touching strands would have to pull on each other.',
  draw: (context) => course('pretwist', context, (point) => point.angle, (ply) => ply.helical_angle_deg, 'lay angle (°)', { y: { domain: [0, 90], label: 'lay angle (°)', grid: true, ticks: [0, 15, 30, 45, 60, 75, 90] } }, (_, factor) => [...cored(context, 'pretwist', factor, 2), ...jumps(context, 'pretwist', factor, Math.abs)]),
}

export const pull: FigureKind = {
  id: 'force-extension',
  title: 'Force and extension',
  about: 'The length of the ply over that of its strands as the pull runs, ends free to turn under the moment of now.',
  draw: (context) => course('force', context, (point) => point.extension, (ply) => Math.cos(ply.helical_angle), 'ply length / strand length', { y: { domain: [0, 1], label: 'ply length / strand length', grid: true } }, (_, factor) => [...cored(context, 'force', factor, 6), ...jumps(context, 'force', factor, (angle) => Math.cos((angle * Math.PI) / 180))]),
}

export const turn: FigureKind = {
  id: 'torque-rotation',
  title: 'Torque and rotation',
  about: 'How far the ply is turned, in turns per strand length (right-handed +), as the moment runs under the pull of now.',
  draw: (context) => {
    const { factor, unit } = scaleOf(context.report, 'turns', context.state.look.reading, 0.05)
    const label = unit ? `turns (${unit} of strand)` : 'turns per r of strand'
    const per = unit ? factor : 1 / (2 * Math.PI)
    return course('moment', context, (point) => point.rotation * per, (ply) => ((ply.handedness * Math.sin(ply.helical_angle)) / ply.radius_ratio) * per, label, { y: { label, grid: true }, marginLeft: 56 }, (_, along) => cored(context, 'moment', along, 7, per))
  },
}

/** Where it jumped when it was last followed, and where it went. */
function jumps(context: Context, along: Along, factor: number, y: (angle: number) => number): Plot.Markish[] {
  const found = context.happened.flatMap(({ from, to, ...data }) => (to === null ? [] : [{ x: data[along] * factor, from: y(from), to: y(to) }]))
  return found.length === 0 ? [] : [Plot.arrow(found, { x1: 'x', x2: 'x', y1: 'from', y2: 'to', stroke: 'var(--now)', strokeWidth: 1.6, strokeDasharray: '2 2', headLength: 9, clip: true })]
}

/** States with a core, or parted: what else the ply can do as the datum runs. */
function cored(context: Context, along: Along, factor: number, column: number, scale = 1): Plot.Markish[] {
  const rows = context.curves.supported[along]
  const found: Spot[] = []
  for (let at = 0; at < rows.length; at += 8) if (rows[at + 3] !== 0) found.push({ x: rows[at]! * factor, y: rows[at + column]! * scale })
  return found.length === 0 ? [] : [Plot.dot(found, { x: 'x', y: 'y', r: 1.6, fill: 'var(--core-ink)', clip: true })]
}

/** How hard the core presses in the state on show. */
function coreNow({ ply }: Context, along: Along, factor: number, scale: number): Plot.Markish[] {
  const pressure = ply?.core_pressure
  if (!ply || typeof pressure !== 'number' || pressure <= 0) return []
  return [Plot.dot([{ x: (ply[along] as number) * factor, y: pressure * scale }], { x: 'x', y: 'y', r: 5, fill: 'var(--core-ink)', stroke: 'var(--ground)', strokeWidth: 2 })]
}

export function pressures(choose: (along: Along) => void): FigureKind {
  return {
    id: 'pressure',
    title: 'Pressures',
    about: 'How hard neighbours press on each other (p₁), as one datum runs. Below 0 they would have to pull: there the strands part. Grey dots: pressure from a core.',
    tools: () => {
      const made = document.createElement('select')
      made.setAttribute('aria-label', 'What runs')
      for (const along of ['force', 'moment', 'pretwist'] as const) {
        const option = document.createElement('option')
        option.value = along
        option.textContent = `over ${along}`
        made.append(option)
      }
      made.addEventListener('change', () => choose(made.value as Along))
      made.id = 'along'
      return made
    },
    draw: (context) => {
      const along = context.state.look.along
      const window = windowOf(along, context)
      const inside = points(context.curves[along], window).filter((point) => point.datum >= window[0] && point.datum <= window[1])
      const pressing = inside.map((point) => point.pressure).filter((pressure) => pressure > 0)
      const now = Math.max(Math.abs(context.ply?.interstrand_pressure ?? 0), context.ply?.core_pressure ?? 0)
      const most = Math.max(0.02, 1.4 * Math.abs(now), ...pressing.map((pressure) => Math.min(pressure, 3)))
      const { factor, unit } = scaleOf(context.report, 'pressure', context.state.look.reading, most)
      const label = `p₁ (${unit})`
      const drawing = course(along, context, (point) => point.pressure * factor, (ply) => ply.interstrand_pressure * factor, label, { y: { domain: [Math.min(-0.6 * most, 1.25 * (context.ply?.interstrand_pressure ?? 0)) * factor, most * factor], label, grid: true }, marginLeft: 56 }, (_, x) => [Plot.ruleY([0], { stroke: 'var(--ink-2)' }), ...cored(context, along, x, 5, factor), ...coreNow(context, along, x, factor)])
      return drawing
    },
  }
}

export const contact: FigureKind = {
  id: 'contact',
  title: 'How strands touch',
  about: 'The arclength shift x between touching sections at every angle (equation 5). Blue: the contact that strands take. Pale: other solutions, on which tubes would pass through each other.',
  draw: (context) => {
    const rows = context.curves.contact
    interface Branch { branch: number; kind: number; angle: number; x: number; ratio: number }
    const found: Branch[] = []
    for (let at = 0; at < rows.length; at += 5) found.push({ branch: rows[at]!, kind: rows[at + 1]!, angle: rows[at + 2]!, x: rows[at + 3]!, ratio: rows[at + 4]! })
    const most = 12
    const window: [number, number] = context.report.strands === 2 ? [-6, most] : [-4, most]
    const inside = found.filter((point) => Math.abs(point.x) < 3 * most)
    const { ply } = context
    const shift = ply && typeof ply['arclength_shift'] === 'number' ? ply['arclength_shift'] : null
    return {
      options: {
        x: { domain: [0, 90], ticks: [0, 15, 30, 45, 60, 75, 90], label: 'lay angle (°)', labelAnchor: 'center' }, y: { domain: window, label: 'x', grid: true },
        marks: [
          Plot.ruleY([0], RULE),
          Plot.line(inside.filter((point) => point.kind === 2), { x: 'angle', y: 'x', z: 'branch', stroke: 'var(--ink-3)', strokeWidth: 1.1, clip: true }),
          Plot.line(inside.filter((point) => point.kind === 1), { x: 'angle', y: 'x', stroke: 'var(--ink-3)', strokeDasharray: '3 3', clip: true }),
          Plot.line(inside.filter((point) => point.kind === 0), { x: 'angle', y: 'x', z: 'branch', stroke: 'var(--right)', strokeWidth: 2.4, clip: true }),
          ...(ply && shift !== null ? mark({ x: ply.helical_angle_deg, y: shift }, ply.handedness) : []),
          Plot.tip(inside.filter((point) => point.x > window[0] && point.x < window[1]), Plot.pointer({ x: 'angle', y: 'x', maxRadius: 30, fontSize: 12, lineHeight: 1.3, title: (point: Branch) => `${['main branch', 'trivial branch', 'satellite: tubes would overlap'][point.kind]}\nangle ${digits(point.angle, 4)}°\nx ${digits(point.x, 4)}\nR/r ${digits(point.ratio, 4)}` })),
        ],
      },
      says: ply ? `At the state on show the lay angle is ${digits(ply.helical_angle_deg, 5)}° and x is ${shift === null ? 'not defined' : digits(shift, 5)}.` : 'The contact diagram.',
      columns: ['branch', 'kind', 'helical_angle_deg', 'arclength_shift', 'radius_ratio'],
      rows: () => found.map((point) => [point.branch, ['main', 'trivial', 'satellite'][point.kind]!, point.angle, point.x, point.ratio]),
    }
  },
}
