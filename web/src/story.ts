// The paper's experiment in six steps: take three rods, twist each, join them, let go, pull, push.

import { byId, el } from './element.ts'
import { digits } from './reading.ts'
import type { Solver } from './solver/client.ts'
import type { Outline } from './solver/messages.ts'
import type { Data, Place } from './state.ts'
import { isStill } from './theme.ts'
import type { Shape } from './view/shape.ts'

const [N, GAMMA, TWIST] = [3, 0.75, -1]
/** The moment that keeps strands straight which hold a twist: each of them n-th of it. */
const HOLDS = N * GAMMA * TWIST

interface Step {
  readonly title: string
  readonly words: string
  readonly from: readonly [twist: number, force: number, moment: number]
  readonly to: readonly [twist: number, force: number, moment: number]
  /** Where the leg begins; `null`: the strands stay straight. */
  readonly place: Place | null
}

const STEPS: readonly Step[] = [
  {
    title: 'Take three rods',
    words: 'Three rubber rods lie side by side, lightly stretched between two clamps. The stripes along them are straight: nothing is twisted yet.',
    from: [0, 0.5, 0], to: [0, 0.5, 0], place: null,
  },
  {
    title: 'Twist each by itself',
    words: 'Each rod is turned to the left about its own axis, until its surface has sheared by 45°: pretwist −1. The clamps now hold a moment of −2.25 B/r, or the rods would spin back.',
    from: [0, 0.5, 0], to: [TWIST, 0.5, HOLDS], place: null,
  },
  {
    title: 'Join their ends',
    words: 'The ends are clipped together, and the pull is taken away. From now on no rod can untwist alone: what was put in is kept as link, the sum of twist and writhe.',
    from: [TWIST, 0.5, HOLDS], to: [TWIST, 0, HOLDS], place: null,
  },
  {
    title: 'Let go',
    words: 'The clamp gives way, slowly. The rods coil round each other to the right, against the twist they hold: bending costs less than the torsion it saves. At 30.6° bending and torsion balance, and the contacts press.',
    from: [TWIST, 0, HOLDS], to: [TWIST, 0, 0], place: 0,
  },
  {
    title: 'Pull',
    words: 'A pull of 1.5 B/r² straightens the ply. It lengthens, untwists a little, and its strands press harder: rope tightens under load.',
    from: [TWIST, 0, 0], to: [TWIST, 1.5, 0], place: 30.613,
  },
  {
    title: 'Push',
    words: 'Now the load is reversed. The ply winds up past 45°, takes no more turns, and at −1.29 B/r² its states end in a fold: no uniform stable ply is left, it runs away.',
    from: [TWIST, 1.5, 0], to: [TWIST, -1.4, 0], place: 15,
  },
]

export interface Telling {
  readonly solver: Solver
  /** Shows a shape for a moment, and no numbers. */
  readonly shape: (shape: Shape) => void
  /** What a step ends with. */
  readonly set: (data: Data, at: Place, of: string) => void
  readonly say: (sentence: string) => void
  /** So much of the view is covered from the left, in pixels. */
  readonly cover: (left: number) => void
}

export class Story {
  readonly #telling: Telling
  readonly #place = byId('story')
  #step = 0
  #run = 0

  constructor(telling: Telling) {
    this.#telling = telling
  }

  get open(): boolean {
    return !this.#place.hidden
  }

  begin(): void {
    this.#place.hidden = false
    this.#cover()
    void this.#go(0)
  }

  end(): void {
    this.#run += 1
    this.#place.hidden = true
    this.#cover()
    byId('story-open').focus()
  }

  #cover(): void {
    const beside = matchMedia('(min-width: 720px)').matches && this.open
    this.#telling.cover(beside ? this.#place.offsetWidth : 0)
  }

  async #go(number: number): Promise<void> {
    this.#step = number
    const run = ++this.#run
    this.#draw()
    const step = STEPS[number]!
    await this.#play(step, () => run === this.#run)
  }

  #draw(): void {
    const step = STEPS[this.#step]!
    const button = (words: string, act: () => void, disabled = false): HTMLButtonElement => {
      const made = el('button', { type: 'button', disabled }, words)
      made.addEventListener('click', act)
      return made
    }
    const last = this.#step === STEPS.length - 1
    const heading = el('h2', { tabIndex: -1 }, `${this.#step + 1} of ${STEPS.length} · ${step.title}`)
    this.#place.replaceChildren(
      heading,
      el('p', {}, step.words),
      el('div', { className: 'tools' },
        button('Back', () => void this.#go(this.#step - 1), this.#step === 0),
        button('Again', () => void this.#go(this.#step)),
        button(last ? 'Explore from here' : 'Next', () => (last ? this.end() : void this.#go(this.#step + 1))),
        button('Leave', () => this.end())),
    )
    heading.focus({ preventScroll: true })
  }

  async #play(step: Step, current: () => boolean): Promise<void> {
    const { solver } = this.#telling
    const outlines = (angle: number, ratio: number, hand: number): Promise<Outline> => solver.ask('outline', { strands: N, angle, ratio, hand })
    const flat = await outlines(0, 1 / Math.sin(Math.PI / N), 1)
    const shape = (theta: number, radiusRatio: number, hand: 1 | -1, pretwist: number, pressure: number, outline: Outline): Shape => ({
      strands: N, theta, radiusRatio, hand, pretwist, pressure, corePressure: 0, core: null, touching: true, ...outline,
    })
    const between = (share: number, i: 0 | 1 | 2): number => step.from[i] + share * (step.to[i] - step.from[i])
    let at: Place = 0
    if (step.place === null) {
      await this.#frames(step.from === step.to ? 1 : 90, current, (share) => {
        this.#telling.shape(shape(0, 1 / Math.sin(Math.PI / N), 1, between(share, 0), 0, flat))
      })
    } else {
      const walk = await solver.ask('leg', { strands: N, ratio: GAMMA, from: step.from, to: step.to, place: step.place })
      const stations = walk?.stations ?? []
      const count = stations.length / 6
      if (count > 0) {
        await this.#frames(Math.min(150, Math.max(60, count)), current, async (share) => {
          const k = Math.min(count - 1, Math.round(share * (count - 1))) * 6
          const [hand = 1, degrees = 0, ratio = 1, , , pressure = 0] = stations.slice(k, k + 6)
          const theta = (degrees * Math.PI) / 180
          this.#telling.shape(shape(theta, ratio, hand < 0 ? -1 : 1, TWIST, pressure, await outlines(theta, ratio, hand)))
        })
        at = stations[stations.length - 6]! * stations[stations.length - 5]!
        const fold = walk?.events.find((event) => event.jump !== null)
        if (fold && current()) this.#telling.say(`At ${digits(fold.force, 4)} B/r² its states end: two meet in a fold at ${digits(Math.abs(fold.angle), 4)}°. No stable uniform ply is left.`)
        if (fold && current()) return this.#set(step, at, fold.force)
      }
    }
    if (current()) this.#set(step, at, step.to[1])
  }

  /** The numbers of the page are those of the step's end. */
  #set(step: Step, at: Place, force: number): void {
    const [twist, , moment] = step.to
    // a hair before a fold there is a state to show
    const shown = force < 0 ? Math.ceil(force * 1000) / 1000 : force
    const data: Record<string, string> = { title: 'Three rubber rods', strands: String(N), 'stiffness-ratio': String(GAMMA), pretwist: String(twist) }
    if (shown !== 0) data['force'] = String(shown)
    if (moment !== 0) data['moment'] = String(moment)
    this.#telling.set(data, at, 'story')
  }

  /** Frame by frame; where motion is not wanted, the last one alone. */
  async #frames(count: number, current: () => boolean, show: (share: number) => void | Promise<void>): Promise<void> {
    if (isStill() || count <= 1) {
      await show(1)
      return
    }
    const lasts = count * 22
    const begun = performance.now()
    for (;;) {
      const now = await new Promise<number>((resolve) => requestAnimationFrame(resolve))
      if (!current()) return
      const share = Math.min(1, (now - begun) / lasts)
      await show(share)
      if (share >= 1) return
    }
  }
}
