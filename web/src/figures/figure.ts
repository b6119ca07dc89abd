// A figure: a picture of curves with the state of now marked on it, hover values, and its numbers as a file.

import * as Plot from '@observablehq/plot'
import { csv, rastered, save, standalone } from '../download.ts'
import { el } from '../element.ts'
import type { Context } from './context.ts'

export interface Drawing {
  readonly options: Plot.PlotOptions
  /** What the picture says, in a sentence, for those who do not see it. */
  readonly says: string
  readonly columns: readonly string[]
  readonly rows: () => readonly (readonly (string | number)[])[]
}

export interface FigureKind {
  readonly id: string
  readonly title: string
  readonly about: string
  readonly draw: (context: Context) => Drawing
  /** Beside the title. */
  readonly tools?: () => HTMLElement
  /** After each drawing: to make it answer to a hand. */
  readonly attach?: (picture: SVGSVGElement & { scale: (name: string) => Plot.Scale | undefined }, context: Context) => void
  readonly height?: number
}

export class Figure {
  readonly element: HTMLElement
  readonly #kind: FigureKind
  readonly #place = el('div', { className: 'plot-place' })
  #context: Context | null = null
  #drawn: Context | null = null
  #drawing: Drawing | null = null
  #seen = false
  #width = 0

  constructor(kind: FigureKind) {
    this.#kind = kind
    const button = (words: string, label: string, act: () => void): HTMLButtonElement => {
      const made = el('button', { type: 'button', className: 'quiet', aria: { label } }, words)
      made.addEventListener('click', act)
      return made
    }
    const tools = el('div', { className: 'tools' },
      kind.tools?.() ?? null,
      button('CSV', `${kind.title}: numbers as CSV`, () => this.#csv()),
      button('SVG', `${kind.title}: picture as SVG`, () => this.#svg()),
      button('PNG', `${kind.title}: picture as PNG`, () => void this.#png()),
    )
    this.element = el('figure', { id: `figure-${kind.id}`, className: 'figure' }, el('div', { className: 'head' }, el('h2', {}, kind.title), tools), this.#place, el('figcaption', {}, kind.about))
    new IntersectionObserver(([entry]) => {
      this.#seen = entry?.isIntersecting ?? false
      this.#draw()
    }, { rootMargin: '200px' }).observe(this.element)
    new ResizeObserver(() => this.#draw()).observe(this.#place)
  }

  show(context: Context): void {
    this.#context = context
    this.#draw()
  }

  /** As it must be, whether or not it is in sight. */
  #draw(anyway = false): void {
    const context = this.#context
    const width = Math.floor(this.#place.clientWidth)
    if (!context || (!anyway && (!this.#seen || width < 40))) return
    if (this.#drawn === context && this.#width === width) return
    this.#drawn = context
    this.#width = width
    const drawing = this.#kind.draw(context)
    this.#drawing = drawing
    const picture = Plot.plot({
      width, height: this.#kind.height ?? Math.round(Math.min(300, Math.max(230, width * 0.62))), marginLeft: 46, marginRight: 14, marginTop: 22, marginBottom: 36,
      className: 'plot', ...drawing.options,
    }) as SVGSVGElement & { scale: (name: string) => Plot.Scale | undefined }
    // its style sheet is the page's own (a page that forbids styles within keeps to it)
    for (const style of picture.querySelectorAll('style')) style.remove()
    // read as one picture, with one sentence
    picture.setAttribute('aria-hidden', 'true')
    this.#place.setAttribute('role', 'img')
    this.#place.setAttribute('aria-label', `${this.#kind.title}. ${drawing.says}`)
    this.#place.replaceChildren(picture)
    this.#kind.attach?.(picture, context)
  }

  #csv(): void {
    this.#draw(true)
    if (this.#drawing) save(`${this.#kind.id}.csv`, csv(this.#drawing.columns, this.#drawing.rows()), 'text/csv')
  }

  #picture(): SVGElement | null {
    this.#draw(true)
    return this.#place.querySelector('svg')
  }

  #svg(): void {
    const picture = this.#picture()
    if (picture) save(`${this.#kind.id}.svg`, standalone(picture), 'image/svg+xml')
  }

  async #png(): Promise<void> {
    const picture = this.#picture()
    const pixels = picture && (await rastered(picture))
    if (pixels) save(`${this.#kind.id}.png`, pixels)
  }
}
