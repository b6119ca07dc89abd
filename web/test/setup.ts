// The solver in Node, and the files that all doors are tried with.

import { readdirSync, readFileSync } from 'node:fs'
import { initSync } from '../src/wasm/nply_wasm.js'
import { doors } from '../src/solver/doors.ts'
import type { Key } from '../src/document.ts'

export const root = new URL('../../', import.meta.url)

export const text = (path: string): string => readFileSync(new URL(path, root), 'utf8')

/** TOML documents of a folder, with their paths from the root. */
export const documents = (folder: string): { name: string; text: string }[] =>
  readdirSync(new URL(folder, root)).filter((file) => file.endsWith('.toml')).sort().map((file) => ({ name: `${folder}/${file}`, text: text(`${folder}/${file}`) }))

/** A golden table: rows by column. */
export function table(path: string): Record<string, string>[] {
  const [head = '', ...rows] = text(path).trim().split('\n')
  const columns = head.split(',')
  return rows.map((row) => Object.fromEntries(row.split(',').map((cell, i) => [columns[i]!, cell])))
}

let keys: readonly Key[] | null = null

/** Sets the solver up, once. */
export function solver(): { keys: readonly Key[] } {
  if (!keys) {
    initSync({ module: readFileSync(new URL('web/src/wasm/nply_wasm_bg.wasm', root)) })
    keys = doors.hello({}).keys
  }
  return { keys }
}
