// The document: TOML that `nply solve` reads, made of the data of a state.

import type { Data } from './state.ts'

/** What the solver says of a key. */
export interface Key {
  readonly flag: string
  readonly table: string
  readonly name: string
  readonly kind: 'text' | 'switch' | 'count' | 'number' | 'balance' | 'hand' | 'quantity'
  readonly wanted: string
  readonly help: string
}

/** The name by which a document goes, in messages and as a file. */
export const NAME = 'ply.toml'

const BARE = /^[+-]?(?:0|[1-9]\d*)(?:\.\d+)?(?:e[+-]?\d+)?$/i

/** Tables in the order in which keys have them; what is no key is written as it stands, so that the solver can say so. */
export function toToml(data: Data, keys: readonly Key[]): string {
  const known = new Map(keys.map((key) => [key.flag, key]))
  const tables = new Map<string, string[]>(keys.map((key) => [key.table, []]))
  const loose: string[] = []
  for (const [flag, text] of Object.entries(data)) {
    const key = known.get(flag)
    if (key) tables.get(key.table)?.push(`${key.name} = ${value(key, text)}`)
    else loose.push(`${bareName(flag)} = ${quoted(text)}`)
  }
  const parts = [...tables].filter(([, lines]) => lines.length > 0).map(([table, lines]) => `[${table}]\n${lines.join('\n')}\n`)
  return [...(loose.length > 0 ? [loose.join('\n') + '\n'] : []), ...parts].join('\n')
}

function value(key: Key, text: string): string {
  const trimmed = text.trim()
  if (key.kind === 'switch' && (trimmed === 'true' || trimmed === 'false')) return trimmed
  if (key.kind !== 'text' && BARE.test(trimmed)) return trimmed
  return quoted(key.kind === 'text' ? text : trimmed)
}

function bareName(name: string): string {
  return /^[A-Za-z0-9_-]+$/.test(name) ? name : quoted(name)
}

/** A basic string: JSON's escapes are among TOML's, but for the one it leaves bare. */
function quoted(text: string): string {
  return JSON.stringify(text).replace(/\u007f/g, '\\u007F')
}
