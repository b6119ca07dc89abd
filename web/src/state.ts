// What the page shows is a function of one value: the document (what `nply solve` would read), the state that is looked at, and how it
// is looked at. It is the link's hash, word for word.

/** Data as they are written, by flag: `strands` → `3`, `diameter` → `0.5 mm`. */
export type Data = Readonly<Record<string, string>>

/** A state of the answer: the one nearest to this angle, in degrees; its sign is the hand's. */
export type Place = number

export type Paint = 'strands' | 'pressure'
export type Reading = 'units' | 'radii'

export interface Look {
  /** Where the ply is cut across, from 0 (bottom) to 1 (top). */
  readonly cut: number
  readonly paint: Paint
  /** Lines painted along each strand. */
  readonly stripes: number
  /** Strands as glass, so that contact lines, hole and core are seen. */
  readonly inside: boolean
  readonly reading: Reading
  /** What runs in the figure of pressures. */
  readonly along: Along
}

export type Along = 'pretwist' | 'force' | 'moment'

export interface State {
  readonly data: Data
  readonly at: Place | null
  readonly look: Look
}

export const FIRST_LOOK: Look = {
  cut: 1,
  paint: 'strands',
  stripes: 3,
  inside: false,
  reading: 'units',
  along: 'force',
}

/** The three rubber rods of the paper, a little more twisted. */
export const FIRST: State = {
  data: { title: 'Three rubber rods', strands: '3', 'stiffness-ratio': '0.75', pretwist: '-1' },
  at: null,
  look: FIRST_LOOK,
}

export const MOST_STRIPES = 12

/** With other data, or without some: an undefined value takes one away. New ones go to the end. */
export function withData(state: State, changes: Readonly<Record<string, string | undefined>>): State {
  const data: Record<string, string> = { ...state.data }
  for (const [flag, text] of Object.entries(changes)) {
    if (text === undefined) delete data[flag]
    else data[flag] = text
  }
  return { ...state, data }
}

export function withLook(state: State, look: Partial<Look>): State {
  return { ...state, look: { ...state.look, ...look } }
}

/** Whether two states ask the same of the solver. */
export function sameData(a: State, b: State): boolean {
  const [x, y] = [Object.entries(a.data), Object.entries(b.data)]
  return x.length === y.length && x.every(([flag, text]) => b.data[flag] === text)
}

/** Names in the hash that are no flags. */
const OWN = ['at', 'cut', 'paint', 'stripes', 'inside', 'reading', 'along'] as const

export function toHash(state: State): string {
  const pairs: [string, string][] = Object.entries(state.data)
  const { look } = state
  if (state.at !== null) pairs.push(['at', `${state.at < 0 ? 'S' : 'Z'}${trimmed(Math.abs(state.at))}`])
  if (trimmed(look.cut) !== trimmed(FIRST_LOOK.cut)) pairs.push(['cut', trimmed(look.cut)])
  if (look.paint !== FIRST_LOOK.paint) pairs.push(['paint', look.paint])
  if (look.stripes !== FIRST_LOOK.stripes) pairs.push(['stripes', String(look.stripes)])
  if (look.inside) pairs.push(['inside', 'yes'])
  if (look.reading !== FIRST_LOOK.reading) pairs.push(['reading', look.reading])
  if (look.along !== FIRST_LOOK.along) pairs.push(['along', look.along])
  return '#' + pairs.map(([name, text]) => `${encode(name)}=${encode(text)}`).join('&')
}

/** What a hash says; null where it says nothing. Names are not judged here: the solver knows them. */
export function fromHash(hash: string): State | null {
  const said = hash.replace(/^#/, '')
  if (said === '') return null
  const data: Record<string, string> = {}
  // a link may name what every object has; here it is a name as any other
  const put = (key: string, value: string) =>
    Object.defineProperty(data, key, { value, enumerable: true, configurable: true, writable: true })
  const own: Partial<Record<(typeof OWN)[number], string>> = {}
  for (const pair of said.split('&')) {
    const [name = '', ...rest] = pair.split('=')
    const [key, text] = [decode(name), decode(rest.join('='))]
    if (key === '') continue
    if ((OWN as readonly string[]).includes(key)) own[key as (typeof OWN)[number]] = text
    else put(key, text)
  }
  const cut = number(own.cut) ?? FIRST_LOOK.cut
  const stripes = number(own.stripes) ?? FIRST_LOOK.stripes
  return {
    data,
    at: place(own.at),
    look: {
      cut: cut <= 1 ? cut : FIRST_LOOK.cut,
      paint: own.paint === 'pressure' ? 'pressure' : 'strands',
      stripes: Number.isInteger(stripes) && stripes <= MOST_STRIPES ? stripes : FIRST_LOOK.stripes,
      inside: own.inside === 'yes',
      reading: own.reading === 'radii' ? 'radii' : 'units',
      along: own.along === 'pretwist' || own.along === 'moment' ? own.along : 'force',
    },
  }
}

function place(text: string | undefined): Place | null {
  const angle = number(text?.slice(1))
  if (angle === null || angle > 90) return null
  if (text?.startsWith('Z')) return angle
  // a straight ply has no hand
  return text?.startsWith('S') ? (angle === 0 ? 0 : -angle) : null
}

/** A number in digits, as links have them; null for anything else that JavaScript would take for one. */
function number(text: string | undefined): number | null {
  return /^\d+(?:\.\d+)?$/.test(text ?? '') ? Number(text) : null
}

/** As few digits as tell a place from its neighbours. */
function trimmed(value: number): string {
  return String(Number(value.toFixed(4)))
}

/** Readable where a link allows it. */
function encode(text: string): string {
  return encodeURIComponent(wellFormed(text)).replace(/%20/g, '+').replace(/%2F/g, '/').replace(/%3A/g, ':').replace(/%2C/g, ',')
}

function decode(text: string): string {
  try {
    return wellFormed(decodeURIComponent(text.replace(/\+/g, ' ')))
  } catch {
    return wellFormed(text)
  }
}

/** Half a pair of surrogates is no letter, and no link can carry it. */
function wellFormed(text: string): string {
  return text.replace(/\p{Surrogate}/gu, '\uFFFD')
}
