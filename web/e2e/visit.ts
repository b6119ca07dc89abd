// A look at the page, and what the command says of the same ply.

import { execFileSync, spawnSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { chromium } from 'playwright-core'
import type { BrowserContextOptions, Page, Request } from 'playwright-core'
import { expect, inject } from 'vitest'

export interface Visit {
  readonly page: Page
  /** Everything that was asked for, from anywhere. */
  readonly requests: readonly Request[]
}

export interface Circumstances extends BrowserContextOptions {
  /** Runs in the page before anything of it does. */
  readonly before?: string
  /** What the browser may complain of here. */
  readonly bears?: RegExp
}

/** Opens the page at a hash, does something, and holds it to having nothing to complain of and nobody else to speak to. */
export async function visit(hash: string, act: (visit: Visit) => Promise<void>, { before, bears, ...options }: Circumstances = {}): Promise<void> {
  const browser = await chromium.connect(inject('browser'))
  const context = await browser.newContext({ viewport: { width: 1280, height: 860 }, acceptDownloads: true, ...options })
  if (before) await context.addInitScript(before)
  const page = await context.newPage()
  const complaints: string[] = []
  const requests: Request[] = []
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type()) && !isOfTheCard(message.text())) complaints.push(`${message.type()}: ${message.text()}`)
  })
  page.on('pageerror', (error) => complaints.push(String(error)))
  page.on('requestfailed', (request) => complaints.push(`not loaded: ${request.url()}`))
  context.on('request', (request) => requests.push(request))
  try {
    await page.goto(inject('address') + hash)
    await settled(page)
    await act({ page, requests })
  } finally {
    await context.close()
    await browser.close()
  }
  expect(complaints.filter((complaint) => !bears?.test(complaint))).toEqual([])
  const ours = new URL(inject('address')).origin
  expect(requests.map((request) => new URL(request.url())).filter((url) => url.origin !== ours && !['data:', 'blob:'].includes(url.protocol))).toEqual([])
}

/** Without the third dimension, which a machine without a card draws slowly: for what has nothing to do with it. */
export const FLAT: Circumstances = {
  before: `const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return /webgl/.test(kind) ? null : get.call(this, kind, ...rest) }`,
  bears: /WebGL/,
}

/** What software that draws without a card says of itself. */
const isOfTheCard = (text: string): boolean => /GPU stall due to ReadPixels|GL Driver Message/.test(text)

/** First numbers stand, and what comes after them. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(() => document.body.dataset['ready'] === 'yes')
}

/** The figures are there, which come after the numbers. */
export async function withFigures(page: Page): Promise<void> {
  // each is drawn when it comes into sight
  await page.locator('#figures figure').first().scrollIntoViewIfNeeded()
  await page.locator('#figures figure svg').first().waitFor()
}

/** Names of the hash that are the page's own and no flags of the command. */
const OWN = ['at', 'cut', 'paint', 'stripes', 'inside', 'reading', 'along']

/** The hash as flags of the command. */
export function flags(page: Page): string[] {
  const hash = new URL(page.url()).hash.slice(1)
  return [...new URLSearchParams(hash)].filter(([name]) => !OWN.includes(name)).map(([name, text]) => `--${name}=${text}`)
}

export function nply(...args: string[]): string {
  return execFileSync(inject('command'), args, { encoding: 'utf8' })
}

/** A file for the command to read. */
export function kept(bytes: Buffer | string, name: string): string {
  const path = join(mkdtempSync(join(tmpdir(), 'nply-taken-')), name)
  writeFileSync(path, bytes)
  return path
}

/** A call that may be refused. */
export function refused(args: string[], input?: string): { code: number | null; said: string } {
  const { status, stderr } = spawnSync(inject('command'), args, { encoding: 'utf8', ...(input === undefined ? {} : { input }) })
  return { code: status, said: stderr }
}

export interface Report {
  readonly states: readonly Readonly<Record<string, unknown>>[]
  readonly strands: number
  readonly [name: string]: unknown
}

export const solve = (...args: string[]): Report => JSON.parse(nply('solve', '--json', ...args)) as Report

export interface Shown {
  /** Which state is looked at. */
  readonly number: number
  readonly states: number
  readonly numbers: Readonly<Record<string, string>>
}

/** What the page says. */
export async function shown(page: Page): Promise<Shown> {
  return page.evaluate(() => {
    const states = [...document.querySelectorAll('#states [role=radio]')]
    const rows = [...document.querySelectorAll<HTMLElement>('#readout dd[data-name]')]
    return {
      number: states.findIndex((state) => state.getAttribute('aria-checked') === 'true'),
      states: states.length,
      numbers: Object.fromEntries(rows.map((row) => [row.dataset['name'] ?? '', row.dataset['value'] ?? ''])),
    }
  })
}

/** What it should say, by the command, of the ply that stands in its address: to the last digit. */
export function expected(page: Page, { number, numbers }: Shown): Readonly<Record<string, string>> {
  const state = solve(...flags(page)).states[number]
  return Object.fromEntries(Object.keys(numbers).map((name) => [name, String(state?.[name])]))
}

/** The page says what the command says, as soon as it has worked it out: of these data, where some are named (its address follows a little behind). */
export async function agrees(page: Page, ...having: readonly string[]): Promise<Shown> {
  let last: Shown | undefined
  await page.waitForTimeout(250)
  await expect
    .poll(
      async () => {
        expect(flags(page)).toEqual(expect.arrayContaining([...having]))
        last = await shown(page)
        expect(Object.keys(last.numbers).length).toBeGreaterThan(8)
        expect(last.numbers).toEqual(expected(page, last))
        return true
      },
      { timeout: 60_000, interval: 100 },
    )
    .toBe(true)
  return last!
}

/** A picture for the eye. */
export async function picture(page: Page, name: string): Promise<void> {
  const folder = new URL('shots/', import.meta.url).pathname
  mkdirSync(folder, { recursive: true })
  await page.screenshot({ path: `${folder}${name}.png` })
}

export const RODS = '#title=Three+rubber+rods&strands=3&stiffness-ratio=0.75&pretwist=-1'
