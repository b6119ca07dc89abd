import { readFileSync } from 'node:fs'
import type { Download, Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { agrees, expected, flags, kept, nply, shown, solve, visit, withFigures } from './visit.ts'

const YARN = '#title=A+yarn&strands=3&diameter=0.275+mm&stiffness-ratio=0.75&turns-per-length=470+turns/m+Z'

async function taken(page: Page, act: () => Promise<void>): Promise<{ name: string; bytes: Buffer }> {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]) as [Download, void]
  const name = download.suggestedFilename()
  const path = kept('', name)
  await download.saveAs(path)
  return { name, bytes: readFileSync(path) }
}

const fromDialog = (page: Page, name: string) => () => page.locator('#take-away').getByRole('button', { name, exact: true }).click()

test('the document is one that nply solve reads, and says the same', async () => {
  await visit(YARN, async ({ page }) => {
    const seen = await agrees(page)
    await page.locator('#take').click()
    const { name, bytes } = await taken(page, fromDialog(page, 'ply.toml'))
    expect(name).toBe('ply.toml')
    const report = JSON.parse(nply('solve', '--json', kept(bytes, name))) as { states: Record<string, unknown>[]; title: string }
    expect(report.title).toBe('A yarn')
    expect(report.states.map((state) => state['helical_angle_deg'])).toEqual(solve(...flags(page)).states.map((state) => state['helical_angle_deg']))
    expect(String(report.states[seen.number]?.['interstrand_pressure'])).toBe(seen.numbers['interstrand_pressure'])
  })
})

test('the report is the command’s, word for word, as text, CSV and JSON', async () => {
  await visit(YARN, async ({ page }) => {
    await agrees(page)
    await page.locator('#take').click()
    const toml = kept((await taken(page, fromDialog(page, 'ply.toml'))).bytes, 'ply.toml')
    for (const [name, format] of [['ply.txt', 'table'], ['ply.csv', 'csv'], ['ply.json', 'json']] as const) {
      const { bytes } = await taken(page, fromDialog(page, name))
      expect(bytes.toString(), name).toBe(nply('solve', '--format', format, toml))
    }
  })
})

test('shapes are closed bodies of the size on show', async () => {
  await visit(YARN, async ({ page }) => {
    const { numbers } = await agrees(page)
    await page.locator('#take').click()
    const stl = (await taken(page, fromDialog(page, 'ply.stl'))).bytes
    const count = stl.readUInt32LE(80)
    expect(stl.length).toBe(84 + 50 * count)
    // each edge is gone along as often one way as the other, and nothing sticks out of the outer diameter
    const edges = new Map<string, number>()
    let widest = 0
    for (let i = 0; i < count; i++) {
      const corners = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => stl.readFloatLE(84 + 50 * i + 12 + 12 * k + 4 * axis)))
      for (const [x, y] of corners) widest = Math.max(widest, Math.hypot(x!, y!))
      corners.forEach((from, k) => {
        const to = corners[(k + 1) % 3]!
        const [a, b] = [from.join(), to.join()]
        const [key, way] = a < b ? [`${a}|${b}`, 1] : [`${b}|${a}`, -1]
        edges.set(key, (edges.get(key) ?? 0) + way)
      })
    }
    expect([...edges.values()].filter((way) => way !== 0).length).toBe(0)
    const radius = 0.1375 // mm
    expect(widest / radius).toBeCloseTo(Number(numbers['outer_diameter']) / 2, 2)

    const glb = (await taken(page, fromDialog(page, 'ply.glb'))).bytes
    expect(glb.toString('latin1', 0, 4)).toBe('glTF')
    expect(glb.readUInt32LE(8)).toBe(glb.length)
    const json = JSON.parse(glb.toString('utf8', 20, 20 + glb.readUInt32LE(12))) as { asset: { version: string }; meshes: unknown[] }
    expect(json.asset.version).toBe('2.0')
    expect(json.meshes.length).toBeGreaterThan(0)
  })
})

test('pictures are pictures', async () => {
  await visit(YARN, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    await page.waitForFunction(() => document.body.dataset['drawn'] === 'yes')
    await page.locator('#take').click()
    for (const name of ['ply.png', 'section.png']) isPng((await taken(page, fromDialog(page, name))).bytes)
    await isSvg(page, (await taken(page, fromDialog(page, 'section.svg'))).bytes)
  })
})

test('of every figure its numbers and its picture are taken away', async () => {
  await visit(YARN, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    const figures = page.locator('#figures figure')
    const count = await figures.count()
    expect(count).toBeGreaterThanOrEqual(6)
    for (let i = 0; i < count; i++) {
      const figure = figures.nth(i)
      const id = ((await figure.getAttribute('id')) ?? '').replace('figure-', '')
      const of = (format: string) => async () => figure.getByRole('button', { name: new RegExp(`${format}$`) }).click()
      const csv = await taken(page, of('CSV'))
      expect(csv.name).toBe(`${id}.csv`)
      const rows = csv.bytes.toString().trimEnd().split('\n').map((line) => line.split(','))
      expect(rows.length, id).toBeGreaterThan(50)
      expect(rows[0]!.every((name) => /^[a-z_0-9]+$/.test(name)), `${id}: ${rows[0]}`).toBe(true)
      for (const row of rows) expect(row.length, id).toBe(rows[0]!.length)
      expect(csv.bytes.toString(), id).not.toMatch(/NaN|undefined|Infinity/)
      const svg = await taken(page, of('SVG'))
      expect(svg.name).toBe(`${id}.svg`)
      await isSvg(page, svg.bytes)
      const png = await taken(page, of('PNG'))
      expect(png.name).toBe(`${id}.png`)
      isPng(png.bytes)
    }
  })
})

test('the curve of pressures is what the command prints, load by load', async () => {
  await visit(YARN, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    const button = page.locator('#figure-angle-pretwist').getByRole('button', { name: /CSV$/ })
    const csv = (await taken(page, () => button.click())).bytes.toString()
    const [header, ...rows] = csv.trimEnd().split('\n').map((line) => line.split(','))
    const column = (name: string): number => header!.indexOf(name)
    const few = rows.filter((row) => Number(row[column('interstrand_pressure')]) > 0).filter((_, i) => i % 60 === 10)
    expect(few.length).toBeGreaterThan(2)
    for (const row of few) {
      const { states } = solve('--strands=3', '--stiffness-ratio=0.75', `--pretwist=${row[column('pretwist')]}`)
      const nearest = Math.min(...states.map((state) => Math.abs((state['handedness'] as number) * (state['helical_angle_deg'] as number) - Number(row[column('handedness')]) * Number(row[column('helical_angle_deg')]))))
      expect(nearest).toBeLessThan(1e-6)
    }
  })
})

test('a document is opened by dropping it on the page', async () => {
  const text = '[ply]\ntitle = "Dropped"\nstrands = 4\n\n[strand]\nstiffness_ratio = 0.8\ndiameter = "1.5 mm"\n\n[twist]\npretwist = 0.7\n\n[load]\nforce = 0.2\n'
  await visit('', async ({ page }) => {
    await agrees(page)
    await drop(page, 'mine.toml', text)
    await expect.poll(() => page.locator('#title').textContent()).toBe('Dropped')
    const seen = await agrees(page)
    const { states } = JSON.parse(nply('solve', '--json', kept(Buffer.from(text), 'mine.toml'))) as { states: Record<string, unknown>[] }
    expect(seen.numbers['helical_angle_deg']).toBe(String(states[seen.number]?.['helical_angle_deg']))
    expect(seen.numbers).toEqual(expected(page, await shown(page)))
  })
})

test('a document is opened by choosing it, and a study’s changes are said to be left out', async () => {
  await visit('', async ({ page }) => {
    await agrees(page)
    await page.locator('#take').click()
    await page.locator('#open-file').setInputFiles(new URL('../../examples/letting-go.toml', import.meta.url).pathname)
    await expect.poll(() => page.locator('#events').textContent()).toMatch(/nply trace/)
    await expect.poll(() => flags(page)).toContain('--strands=3')
  })
})

async function drop(page: Page, name: string, text: string): Promise<void> {
  await page.evaluate(
    ([name, text]) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([text!], name!, { type: 'application/toml' }))
      for (const kind of ['dragover', 'drop']) document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: transfer, bubbles: true, cancelable: true }))
    },
    [name, text],
  )
}

function isPng(bytes: Buffer): void {
  expect(bytes.subarray(0, 8)).toEqual(Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]))
  expect(bytes.readUInt32BE(16)).toBeGreaterThan(100)
  expect(bytes.readUInt32BE(20)).toBeGreaterThan(100)
  expect(bytes.length).toBeGreaterThan(2000) // something is on it
}

/** XML that a reader without this page's style sheet draws alike: no class and no variable is left in it. */
async function isSvg(page: Page, bytes: Buffer): Promise<void> {
  const text = bytes.toString()
  expect(text).not.toMatch(/var\(--|class=|NaN/)
  const root = await page.evaluate((svg) => {
    const parsed = new DOMParser().parseFromString(svg, 'image/svg+xml')
    return [parsed.documentElement.nodeName, parsed.querySelectorAll('parsererror').length, parsed.querySelectorAll('path').length] as const
  }, text)
  expect([root[0], root[1]]).toEqual(['svg', 0])
  expect(root[2]).toBeGreaterThan(0)
}
