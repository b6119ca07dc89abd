// Plies to start from, trade by trade; those whose document is of another kind (layered wire strands) are for the command.

import { el } from '../element.ts'
import type { Preset } from '../solver/messages.ts'
import type { Data } from '../state.ts'
import { given, SIZES, TWISTS } from './choice.ts'

const TRADES: readonly (readonly [string, readonly string[]])[] = [
  ['Yarn and cord', ['three-ply-yarn', 'tyre-cord-840d-2', 'tyre-cord-1260d-2', 'tyre-cord-1680d-2']],
  ['Rope', ['zero-twist-rope']],
  ['DNA', ['dna-plectoneme', 'dna-braid']],
  ['Proteins', ['collagen', 'coiled-coil-2', 'coiled-coil-3', 'coiled-coil-4', 'coiled-coil-5', 'coiled-coil-6', 'coiled-coil-7']],
  ['Machines', ['twisted-string-actuator']],
  ['From the paper', ['rubber-rods']],
]

/** Loads that make a state of what is published as a shape alone. */
const CHOSEN: Readonly<Record<string, { data: Data; said: string }>> = {
  'zero-twist-rope': { data: { 'strand-twist': '0', force: '3' }, said: 'A pull of 3 B/r² on strands that hold no twist is chosen here: the moment that keeps this lay is found.' },
}

export function presetList(presets: readonly Preset[]): HTMLElement[] {
  const named = new Map(presets.map((preset) => [preset.name, preset]))
  const groups = TRADES.map(([trade, names]) => {
    const made = el('optgroup', { label: trade })
    made.append(...names.filter((name) => named.has(name)).map((name) => el('option', { value: name }, titleOf(named.get(name)!))))
    return made
  })
  return [el('option', { value: '' }, '– own data –'), ...groups]
}

function titleOf(preset: Preset): string {
  return /^title = "(.*)"$/m.exec(preset.text)?.[1] ?? preset.name
}

/** The data of a preset as the page takes them, and what had to be added so that they say enough for a state. */
export function begin(preset: Preset, read: Data): { data: Data; said: string } {
  const data: Record<string, string> = { ...read }
  const added: string[] = []
  const stiff = given({ data } as never, ['stiffness-ratio', 'torsional-stiffness', 'poissons-ratio', 'shear-modulus', 'twist-persistence-length'])
  if (!stiff) {
    data['stiffness-ratio'] = '0.75'
    added.push('The stiffness ratio 0.75 is added here, that of a solid round rod; the shape does not depend on it.')
  }
  if (preset.command === 'actuator') {
    const bending = given({ data } as never, ['bending-stiffness', 'youngs-modulus', 'bending-persistence-length'])
    if (!given({ data } as never, TWISTS)) data['strand-twist'] = '0'
    if (!bending && data['force'] !== undefined) {
      data['force'] = '20'
      added.push('Limp strings have no stiffness to measure a force by: here it is 20 B/r², nearly limp. Strands swivel, so that they hold no twist.')
    }
    const turns = '0.05'
    data['ply-turns-per-strand-length'] = given({ data } as never, SIZES) ? turnsOf(data, 0.05) : turns
    added.push('The turns are chosen.')
  }
  const more = CHOSEN[preset.name]
  if (more) {
    Object.assign(data, more.data)
    added.push(more.said)
  }
  return { data, said: [preset.about, `Source: ${preset.source}`, ...added].join(' ') }
}

/** Turns per strand radius in the unit of the size. */
function turnsOf(data: Data, perRadius: number): string {
  const size = /^([\d.]+)\s*(\S+)$/.exec(data['radius'] ?? data['diameter'] ?? '')
  if (!size) return String(perRadius)
  const radius = Number(size[1]) / (data['radius'] === undefined ? 2 : 1)
  return `${Number((perRadius / radius).toPrecision(4))} turns/${size[2]}`
}
