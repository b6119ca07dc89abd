// One datum: its name, a slider where it has bounds, and its number with the unit, typed as one says it.

import { el } from '../element.ts'
import type { Written } from '../answer.ts'
import { written } from './range.ts'
import type { Range } from './range.ts'

export interface FieldEvents {
  /** Another text; `moving` while a slider is held. */
  readonly change: (flag: string, text: string, moving: boolean) => void
}

export class Field {
  readonly element: HTMLElement
  readonly flag: string
  readonly #slider = el('input', { type: 'range' })
  readonly #text: HTMLInputElement
  readonly #said: HTMLElement
  #unit: string | undefined
  #step = 1

  constructor(flag: string, label: string, help: string, events: FieldEvents, extra?: Node) {
    this.flag = flag
    const id = `field-${flag}`
    this.#text = el('input', { id, type: 'text', className: 'number', autocomplete: 'off', spellcheck: false })
    this.#text.setAttribute('aria-describedby', `${id}-said`)
    this.#said = el('p', { id: `${id}-said`, className: 'said' })
    this.#slider.setAttribute('aria-label', `${label}, slider`)
    this.#slider.addEventListener('input', () => {
      const text = written(Number(this.#slider.value), this.#step, this.#unit)
      this.#text.value = text
      events.change(flag, text, true)
    })
    this.#text.addEventListener('change', () => events.change(flag, this.#text.value.trim(), false))
    this.#text.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#text.blur()
    })
    const name = el('label', { for: id, title: help }, label)
    this.element = el('div', { className: 'field', data: { flag } }, el('div', { className: 'line' }, name, extra ?? null, this.#text), this.#slider, this.#said)
  }

  show(text: string, datum: Written | undefined, range: Range | null): void {
    if (document.activeElement !== this.#text) this.#text.value = text
    this.#unit = datum?.unit
    this.#slider.hidden = range === null
    if (range && datum?.number !== undefined) {
      const signed = text.trim().endsWith('S') ? -Math.abs(datum.number) : datum.number
      this.#step = range.step
      this.#slider.min = String(Math.min(range.low, signed))
      this.#slider.max = String(Math.max(range.high, signed))
      this.#slider.step = String(range.step)
      if (document.activeElement !== this.#slider || Math.abs(Number(this.#slider.value) - signed) > range.step) this.#slider.value = String(signed)
      this.#slider.setAttribute('aria-valuetext', text)
    }
  }

  refuse(sentence: string | null): void {
    this.#said.textContent = sentence ?? ''
    this.element.classList.toggle('refused', sentence !== null)
    this.#text.toggleAttribute('aria-invalid', sentence !== null)
    if (sentence !== null) this.#text.setAttribute('aria-invalid', 'true')
  }
}
