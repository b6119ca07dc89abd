// The plane of force and moment. A click or a drag moves the load, and the ply follows along its branch.

import * as Plot from '@observablehq/plot'
import { digits, scaleOf } from '../reading.ts'
import { windowOf } from './context.ts'
import type { Happened, Window } from './context.ts'
import type { FigureKind } from './figure.ts'


interface Locus {
  hand: 1 | -1
  angle: number
  force: number
  moment: number
}

export interface PlaneEvents {
  /** `of` names the drag, so that it is undone as a whole. */
  readonly load: (force: number, moment: number, of: string) => void
}

export function plane(events: PlaneEvents): FigureKind {
  /** While a load is held the plane keeps still. */
  let held: { force: Window; moment: Window } | null = null
  let dragging = false
  let drag = ''
  let drags = 0
  let here: { place: HTMLElement; forces: Window; moments: Window; at: (event: PointerEvent) => [number, number] } | null = null
  const listening = new WeakSet<HTMLElement>()

  /** Before the picture's own hover values hear of it. */
  const listen = (place: HTMLElement): void => {
    if (listening.has(place)) return
    listening.add(place)
    const end = (event: PointerEvent): void => {
      if (!dragging || !here) return
      const there = here.at(event)
      dragging = false
      held = null
      events.load(...there, drag)
    }
    place.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !here) return
      event.preventDefault()
      event.stopPropagation()
      place.focus({ preventScroll: true })
      place.setPointerCapture(event.pointerId)
      held = { force: here.forces, moment: here.moments }
      dragging = true
      drag = `drag ${++drags}`
      events.load(...here.at(event), drag)
    }, true)
    place.addEventListener('pointermove', (event) => {
      if (!dragging || !here) return
      event.stopPropagation()
      events.load(...here.at(event), drag)
    }, true)
    place.addEventListener('pointerup', end, true)
    place.addEventListener('pointercancel', end, true)
  }

  return {
    id: 'force-moment',
    title: 'Force and moment',
    about: 'Thick: the separation locus, on which touching strands just stop pressing. Thin: loads that hold one angle, drawn where strands press. Click, drag, or focus it and use the arrow keys: the ply follows along its branch.',
    height: 330,
    draw: (context) => {
      const forces = held?.force ?? windowOf('force', context)
      const moments = held?.moment ?? windowOf('moment', context)
      const { reading } = context.state.look
      const f = scaleOf(context.report, 'force', reading, forces[1])
      const m = scaleOf(context.report, 'moment', reading, moments[1])
      const rows = context.curves.locus
      const found: Locus[] = []
      for (let at = 0; at < rows.length; at += 4) found.push({ hand: rows[at] as 1 | -1, angle: rows[at + 1]!, force: rows[at + 2]! * f.factor, moment: rows[at + 3]! * m.factor })
      const far = 3 * (forces[1] + moments[1])
      const rays = context.curves.lines.map(({ hand, degrees, points }) => {
        const [f0 = 0, m0 = 0, f1 = 0, m1 = 0] = points
        const length = Math.hypot(f1 - f0, m1 - m0) || 1
        const [df, dm] = [(f1 - f0) / length, (m1 - m0) / length]
        return { hand, degrees, x1: f0 * f.factor, y1: m0 * m.factor, x2: (f0 + far * df) * f.factor, y2: (m0 + far * dm) * m.factor }
      })
      const { ply } = context
      const ink = (row: { hand: 1 | -1 }): string => (row.hand > 0 ? 'var(--right)' : 'var(--left)')
      const inside = found.filter((row) => row.force / f.factor >= forces[0] && row.force / f.factor <= forces[1] && row.moment / m.factor >= moments[0] && row.moment / m.factor <= moments[1])
      const now = ply ? [{ force: ply.force * f.factor, moment: ply.moment * m.factor }] : []
      return {
        options: {
          marginLeft: 56,
          x: { domain: [forces[0] * f.factor, forces[1] * f.factor], label: `force (${f.unit})`, labelAnchor: 'center' },
          y: { domain: [moments[0] * m.factor, moments[1] * m.factor], label: `moment (${m.unit})` },
          marks: [
            Plot.ruleX([0], { stroke: 'var(--rule)' }), Plot.ruleY([0], { stroke: 'var(--rule)' }),
            Plot.link(rays, { x1: 'x1', y1: 'y1', x2: 'x2', y2: 'y2', stroke: ink, strokeWidth: 0.9, strokeOpacity: 0.5, clip: true }),
            Plot.line(found, { x: 'force', y: 'moment', z: 'hand', stroke: ink, strokeWidth: 2.4, clip: true }),
            ...(ply ? [Plot.ruleX(now, { x: 'force', stroke: 'var(--now)', strokeOpacity: 0.3 }), Plot.ruleY(now, { y: 'moment', stroke: 'var(--now)', strokeOpacity: 0.3 })] : []),
            Plot.dot(context.happened, { x: (event: Happened) => event.force * f.factor, y: (event: Happened) => event.moment * m.factor, symbol: 'diamond', r: 5, fill: 'var(--ground)', stroke: 'var(--now)', strokeWidth: 1.8, clip: true }),
            Plot.text(context.happened, { x: (event: Happened) => event.force * f.factor, y: (event: Happened) => event.moment * m.factor, text: 'words', dy: -13, fill: 'var(--ink)', stroke: 'var(--card)', strokeWidth: 4, clip: true }),
            ...(context.curves.supported.force.length > 0 ? [Plot.text(['lines of touching strands, without a core'], { frameAnchor: 'bottom-left', dx: 4, dy: -4, fill: 'var(--ink-2)' })] : []),
            Plot.dot(now, { x: 'force', y: 'moment', r: 8, fill: ply ? ink({ hand: ply.handedness }) : 'none', stroke: 'var(--ground)', strokeWidth: 2.5 }),
            ...(dragging ? [] : [Plot.tip(inside, Plot.pointer({ x: 'force', y: 'moment', maxRadius: 14, fontSize: 12, lineHeight: 1.3, title: (row: Locus) => `strands part: ${row.hand > 0 ? 'Z' : 'S'} ${digits(row.angle, 4)}°\nforce ${digits(row.force, 4)}\nmoment ${digits(row.moment, 4)}` }))]),
          ],
        },
        says: ply ? `The load is ${digits(ply.force * f.factor, 5)} ${f.unit} and ${digits(ply.moment * m.factor, 5)} ${m.unit}. Use the arrow keys to move it.` : 'The plane of force and moment.',
        columns: ['handedness', 'helical_angle_deg', 'force', 'moment'],
        rows: () => found.map((row) => [row.hand, row.angle, row.force / f.factor, row.moment / m.factor]),
      }
    },
    attach: (picture, context) => {
      const forces = held?.force ?? windowOf('force', context)
      const moments = held?.moment ?? windowOf('moment', context)
      const { reading } = context.state.look
      const f = scaleOf(context.report, 'force', reading, forces[1])
      const m = scaleOf(context.report, 'moment', reading, moments[1])
      const [x, y] = [picture.scale('x'), picture.scale('y')]
      const place = picture.parentElement
      if (!x?.invert || !y?.invert || !place) return
      place.tabIndex = 0
      place.classList.add('plane')
      place.setAttribute('role', 'application')
      const within = (value: number, [low, high]: Window): number => Math.min(high, Math.max(low, value))
      const at = (event: PointerEvent): [number, number] => {
        const box = (place.querySelector('svg') ?? picture).getBoundingClientRect()
        const across = (x.invert!(event.clientX - box.left) as number) / f.factor
        const up = (y.invert!(event.clientY - box.top) as number) / m.factor
        return [nice(within(across, forces), forces), nice(within(up, moments), moments)]
      }
      here = { place, forces, moments, at }
      listen(place)
      place.onkeydown = (event) => {
        const { ply } = context
        const step = event.shiftKey ? 10 : 1
        const move: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }
        const way = move[event.key]
        if (!way || !ply || event.ctrlKey || event.metaKey || event.altKey) return
        event.preventDefault()
        const by = (window: Window): number => (window[1] - window[0]) / 100
        events.load(nice(ply.force + way[0] * step * by(forces), forces), nice(ply.moment + way[1] * step * by(moments), moments), 'load')
      }
    },
  }
}

/** No more digits than the eye can place. */
function nice(value: number, window: Window): number {
  const step = 10 ** Math.floor(Math.log10((window[1] - window[0]) / 400))
  return Number((Math.round(value / step) * step).toPrecision(8))
}
