// The panel: what is known of the ply, in the words of those who make them.

import type { PlyState, Refusal, Report, Written } from '../answer.ts'
import type { Key } from '../document.ts'
import { byId, el } from '../element.ts'
import type { Preset } from '../solver/messages.ts'
import type { State } from '../state.ts'
import { withData } from '../state.ts'
import { CORES, endsOf, given, holdEnds, knowLay, knowTwist, LAYS, LENGTHS, SIZES, TURNED, TWISTS, withCore } from './choice.ts'
import type { Ends } from './choice.ts'
import { Field } from './field.ts'
import { presetList } from './presets.ts'
import { rangeOf } from './range.ts'

export interface PanelEvents {
  /** Another state; `of` names what was moved. */
  readonly change: (state: State, of: string) => void
  readonly preset: (name: string) => void
}

/** What is shown: the state, and the last answer to stand on. */
export interface PanelView {
  readonly state: State
  readonly report: Report
  readonly ply: PlyState | undefined
  readonly data: readonly Written[]
  readonly refusal: Refusal | null
}

const LABELS: Readonly<Record<string, string>> = {
  strands: 'Strands', 'stiffness-ratio': 'Stiffness ratio C/B', diameter: 'Strand diameter', radius: 'Strand radius', 'linear-density': 'Titre of a strand',
  pretwist: 'Pretwist', 'surface-angle': 'Surface angle', 'turns-per-length': 'Turns per length', turns: 'Turns', 'end-rotation': 'End rotation', 'strand-twist': 'Strand twist in the ply',
  'helical-angle': 'Lay angle', 'lay-angle': 'Lay angle', 'pitch-angle': 'Pitch angle', 'lay-length': 'Lay length', 'lay-ratio': 'Lay ratio', 'ply-turns-per-length': 'Ply turns per length',
  'radius-ratio': 'Helix radius R/r', 'helix-radius': 'Helix radius R', force: 'Force, tension +', moment: 'Moment, Z +', 'ply-turns-per-strand-length': 'Ply turned by, per strand length',
  'ply-turns': 'Ply turned by', 'ply-rotation': 'Ply turned by', 'length-ratio': 'Ply length / strand length', 'ply-length': 'Ply length', 'support-core-radius': 'Core radius', 'support-core-diameter': 'Core diameter',
}

/** Twists and lays that are offered; others are kept where a document has them. */
const OFFERED_TWISTS = ['pretwist', 'surface-angle', 'turns-per-length', 'strand-twist']
const OFFERED_LAYS = ['helical-angle', 'pitch-angle', 'lay-length', 'lay-ratio', 'ply-turns-per-length', 'radius-ratio']

export class Panel {
  readonly #keys: ReadonlyMap<string, Key>
  readonly #events: PanelEvents
  readonly #fields = new Map<string, Field>()
  readonly #preset: HTMLSelectElement
  readonly #about = el('p', { className: 'about', id: 'preset-about' })
  readonly #know: HTMLSelectElement
  readonly #twist: HTMLSelectElement
  readonly #lay: HTMLSelectElement
  readonly #hand: HTMLSelectElement
  readonly #ends: HTMLSelectElement
  readonly #core = el('input', { type: 'checkbox', id: 'core-on' })
  readonly #balance: HTMLSelectElement
  readonly #places: Record<'ply' | 'strand' | 'twist' | 'ends' | 'core' | 'more', HTMLElement>
  readonly #add: HTMLSelectElement
  #view: PanelView | null = null

  constructor(keys: readonly Key[], presets: readonly Preset[], events: PanelEvents) {
    this.#keys = new Map(keys.map((key) => [key.flag, key]))
    this.#events = events
    this.#preset = el('select', { id: 'preset' }, ...presetList(presets))
    this.#preset.setAttribute('aria-describedby', 'preset-about')
    this.#preset.addEventListener('change', () => events.preset(this.#preset.value))
    this.#know = select('know', [['twist', 'the twist put in'], ['lay', 'the lay']])
    this.#twist = select('twist-way', OFFERED_TWISTS.map((flag) => [flag, LABELS[flag]!]))
    this.#lay = select('lay-way', OFFERED_LAYS.map((flag) => [flag, LABELS[flag]!]))
    this.#hand = select('hand', [['right', 'right-handed (Z)'], ['left', 'left-handed (S)'], ['', 'both']])
    this.#ends = select('ends', [['loads', 'free, under loads'], ['turned', 'kept from turning'], ['length', 'held at a length']])
    this.#balance = select('balance', [['contact', 'contact (touching)'], ['radial', 'radial (published)']])
    this.#add = el('select', { id: 'more-add' })
    this.#places = {
      ply: el('div'), strand: el('div'), twist: el('div'), ends: el('div'), core: el('div'), more: el('div', { className: 'more' }),
    }
    this.#listen()
    byId('panel').replaceChildren(
      group('Ply', labelled('Start from', this.#preset), this.#about, this.#places.ply),
      group('Twist and lay', labelled('Known is', this.#know), labelled('said as', this.#twist, 'by-twist'), labelled('said as', this.#lay, 'by-lay'), labelled('hand', this.#hand, 'by-lay'), this.#places.twist),
      group('Ends', labelled('They are', this.#ends, 'by-twist'), this.#places.ends),
      group('Strand', this.#places.strand),
      group('Core', el('label', { className: 'tick' }, this.#core, 'a core that strands may lie on or lift off'), this.#places.core),
      group('Balance of forces', labelled('Counted as', this.#balance)),
      group('Everything else', this.#places.more, labelled('Add', this.#add)),
    )
  }

  #listen(): void {
    const act = (of: string, change: (view: PanelView) => State) => () => {
      if (this.#view) this.#events.change(change(this.#view), of)
    }
    this.#know.addEventListener('change', act('know', ({ state, ply, report }) =>
      this.#know.value === 'lay' ? knowLay(state, 'helical-angle', ply, report) : knowTwist(state, 'pretwist', ply, report)))
    this.#twist.addEventListener('change', act('twist-way', ({ state, ply, report }) => knowTwist(state, this.#twist.value, ply, report)))
    this.#lay.addEventListener('change', act('lay-way', ({ state, ply, report }) => knowLay(state, this.#lay.value, ply, report)))
    this.#hand.addEventListener('change', act('hand', ({ state }) => withData(state, { hand: this.#hand.value || undefined })))
    this.#ends.addEventListener('change', act('ends', ({ state, ply, report }) => holdEnds(state, this.#ends.value as Ends, ply, report)))
    this.#core.addEventListener('change', act('core', ({ state, ply, report }) => withCore(state, this.#core.checked, ply, report)))
    this.#balance.addEventListener('change', act('balance', ({ state }) => withData(state, { balance: this.#balance.value === 'radial' ? 'radial' : undefined })))
    this.#add.addEventListener('change', () => {
      const view = this.#view
      const flag = this.#add.value
      if (!view || flag === '') return
      const key = this.#keys.get(flag)
      const r = view.report.strand_radius_m
      // as of a solid strand of a soft polymer, E = 1 GPa: an example that suits the size
      const example = flag === 'bending-stiffness' && r ? `${((Math.PI / 4) * 1e9 * r ** 4).toExponential(2)} N m^2` : null
      const first = example ?? (key?.kind === 'switch' ? 'true' : (/such as "?([^",]+?)"?(?:,| or |$)/.exec(key?.wanted ?? '')?.[1] ?? '1'))
      this.#events.change(withData(view.state, { [flag]: first }), `add ${flag}`)
    })
  }

  /** A preset that is begun with, and what is said of it. */
  begun(name: string | null, said: string): void {
    this.#preset.value = name ?? ''
    this.#about.textContent = said
  }

  show(view: PanelView): void {
    this.#view = view
    const { state, report } = view
    const lay = given(state, LAYS)
    const twist = given(state, TWISTS)
    const known = lay !== undefined ? 'lay' : 'twist'
    this.#know.value = known
    byId('panel').dataset['known'] = known
    this.#twist.value = OFFERED_TWISTS.includes(twist ?? '') ? twist! : ''
    this.#lay.value = lay === 'lay-angle' ? 'helical-angle' : OFFERED_LAYS.includes(lay ?? '') ? lay! : ''
    this.#hand.value = /^(l|s)/i.test(state.data['hand'] ?? '') ? 'left' : state.data['hand'] ? 'right' : ''
    this.#hand.disabled = lay === 'ply-turns-per-length'
    const ends = endsOf(state)
    this.#ends.value = ends
    const core = given(state, CORES)
    this.#core.checked = core !== undefined
    this.#core.disabled = known === 'lay'
    this.#balance.value = state.data['balance'] === 'radial' ? 'radial' : 'contact'
    this.#balance.disabled = core !== undefined

    const { ply, strand, twist: twistPlace, ends: endsPlace, core: corePlace } = this.#places
    const size = given(state, SIZES)
    const shown = new Set<string>(['title', 'balance', 'hand'])
    const put = (place: HTMLElement, flags: readonly (string | undefined)[]): void => {
      const wanted = flags.filter((flag) => flag !== undefined)
      const elements = wanted.map((flag) => {
        shown.add(flag)
        return this.#field(flag, view).element
      })
      if (elements.length !== place.children.length || elements.some((element, i) => place.children[i] !== element)) place.replaceChildren(...elements)
    }
    put(ply, ['strands'])
    put(strand, [state.data['stiffness-ratio'] !== undefined || !given(state, ['torsional-stiffness', 'poissons-ratio', 'shear-modulus', 'twist-persistence-length']) ? 'stiffness-ratio' : undefined, size ?? 'diameter'])
    put(twistPlace, [lay, twist])
    if (known === 'lay') put(endsPlace, [twist && state.data['moment'] !== undefined ? undefined : 'force', twist && state.data['force'] !== undefined ? undefined : 'moment'])
    else put(endsPlace, ends === 'turned' ? [given(state, TURNED), 'force'] : ends === 'length' ? [given(state, LENGTHS), 'moment'] : ['force', 'moment'])
    put(corePlace, [core])
    this.#more(view, shown)
    this.#refuse(view.refusal)
    void report
  }

  #field(flag: string, view: PanelView): Field {
    let field = this.#fields.get(flag)
    if (!field) {
      const key = this.#keys.get(flag)
      field = new Field(flag, LABELS[flag] ?? plain(flag), key?.help ?? '', {
        change: (of, text, moving) => {
          const now = this.#view
          if (!now) return
          const blank = text === '' && of !== 'strands'
          this.#events.change(withData(now.state, { [of]: blank ? undefined : text }), moving ? of : '')
        },
      })
      this.#fields.set(flag, field)
    }
    const text = view.state.data[flag] ?? (flag === 'force' || flag === 'moment' ? '0' : '')
    const unit = flag === 'force' || flag === 'moment' ? zeroUnit(flag, view.report) : undefined
    const datum = view.data.find((one) => one.flag === flag) ?? (text === '0' ? { flag, text, number: 0, ...unit } : undefined)
    field.show(text, datum, rangeOf(flag, view.report, datum))
    return field
  }

  /** Whatever else the document says, and what it could say. */
  #more(view: PanelView, shown: ReadonlySet<string>): void {
    const rest = Object.keys(view.state.data).filter((flag) => !shown.has(flag))
    const rows = rest.map((flag) => {
      const field = this.#field(flag, view)
      if (!field.element.querySelector('button')) {
        const take = el('button', { type: 'button', className: 'quiet', aria: { label: `remove ${plain(flag)}` } }, '×')
        take.addEventListener('click', () => this.#view && this.#events.change(withData(this.#view.state, { [flag]: undefined }), `remove ${flag}`))
        field.element.querySelector('.line')?.append(take)
      }
      return field.element
    })
    this.#places.more.replaceChildren(...rows)
    const could = [...this.#keys.values()].filter((key) => view.state.data[key.flag] === undefined && key.flag !== 'strands')
    const tables = Map.groupBy(could, (key) => key.table)
    const options = [...tables].map(([table, keys]) => {
      const made = el('optgroup', { label: `[${table}]` })
      made.append(...keys.map((key) => el('option', { value: key.flag, title: key.help }, key.name)))
      return made
    })
    this.#add.replaceChildren(el('option', { value: '' }, 'a datum …'), ...options)
  }

  /** The sentence stands at the field it is about, and above the panel. */
  #refuse(refusal: Refusal | null): void {
    const place = byId('refusal')
    place.hidden = refusal === null
    const said = refusal?.sentence ?? ''
    // said once, however often it is drawn
    if (place.dataset['said'] === said) return this.#atFields(refusal)
    place.dataset['said'] = said
    place.replaceChildren(...(refusal ? [el('strong', {}, 'No answer. '), refusal.sentence] : []))
    this.#atFields(refusal)
  }

  #atFields(refusal: Refusal | null): void {
    for (const field of this.#fields.values()) {
      const about = refusal && this.#keys.get(field.flag)?.name === refusal.key && field.element.isConnected
      field.refuse(about ? (refusal.message ?? refusal.sentence) : null)
    }
  }
}

function zeroUnit(flag: 'force' | 'moment', report: Report): { unit?: string; factor?: number } {
  const [r, B] = [report.strand_radius_m, report.bending_stiffness_N_m2]
  if (!r || !B) return {}
  if (flag === 'force') return B / r ** 2 < 1e-9 ? { unit: 'pN', factor: 1e-12 } : { unit: 'N', factor: 1 }
  return B / r < 1e-15 ? { unit: 'pN nm', factor: 1e-21 } : { unit: 'N m', factor: 1 }
}

const plain = (flag: string): string => (flag[0]?.toUpperCase() ?? '') + flag.slice(1).replaceAll('-', ' ')

function select(id: string, options: readonly (readonly [string, string])[]): HTMLSelectElement {
  return el('select', { id }, ...options.map(([value, label]) => el('option', { value }, label)))
}

function labelled(label: string, control: HTMLElement, className = ''): HTMLElement {
  return el('div', { className: `choice ${className}` }, el('label', { for: control.id }, label), control)
}

function group(title: string, ...children: HTMLElement[]): HTMLElement {
  const heading = el('h2', {}, title)
  return el('section', { className: 'group' }, heading, ...children)
}
