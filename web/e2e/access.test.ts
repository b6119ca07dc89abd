import { readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { agrees, FLAT, flags, picture, RODS, settled, shown, visit, withFigures } from './visit.ts'

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

interface Violation {
  readonly id: string
  readonly help: string
  readonly nodes: readonly { readonly html: string; readonly failureSummary?: string }[]
}

/** What axe finds against WCAG 2.2, A and AA, and against good practice. */
async function violations(page: Page): Promise<string[]> {
  await page.evaluate(AXE)
  const found = await page.evaluate(async () => {
    const { axe } = window as unknown as { axe: { run: (options: object) => Promise<{ violations: Violation[] }> } }
    return (await axe.run({ runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'] })).violations
  })
  return found.map(({ id, help, nodes }) => `${id}: ${help}\n${nodes.map((node) => `  ${node.html}\n  ${node.failureSummary ?? ''}`).join('\n')}`)
}

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [where, viewport] of [['a table', { width: 1280, height: 860 }], ['a hand', { width: 390, height: 844 }]] as const) {
    test(`axe finds nothing: ${colorScheme}, on ${where}`, async () => {
      await visit(RODS, async ({ page }) => {
        await withFigures(page)
        await agrees(page)
        await picture(page, `${colorScheme}-${viewport.width}`)
        expect(await violations(page)).toEqual([])
        await page.locator('#take').click()
        await picture(page, `take-${colorScheme}-${viewport.width}`)
        expect(await violations(page)).toEqual([])
        await page.keyboard.press('Escape')
        await page.locator('#story-open').click()
        await page.locator('#story h2').waitFor()
        expect(await violations(page)).toEqual([])
        await page.keyboard.press('Escape')
        const field = page.locator('#field-pretwist')
        await field.fill('a lot')
        await field.press('Enter')
        await page.locator('#refusal').waitFor({ state: 'visible' })
        await picture(page, `refused-${colorScheme}-${viewport.width}`)
        expect(await violations(page)).toEqual([])
      }, { colorScheme, viewport, reducedMotion: 'reduce' })
    })
  }
}

test('everything is reached by the keyboard, is named, and shows where the focus is', async () => {
  await visit(RODS, async ({ page }) => {
    await withFigures(page)
    await page.evaluate(() => (document.activeElement as HTMLElement | null)?.blur())
    const reached = new Set<string>()
    const bare: string[] = []
    for (let i = 0; i < 160; i++) {
      await page.keyboard.press('Tab')
      const here = await page.evaluate(() => {
        const at = document.activeElement as HTMLElement | null
        if (!at || at === document.body) return null
        const style = getComputedStyle(at)
        const visible = style.outlineStyle !== 'none' || style.boxShadow !== 'none'
        return { name: at.id || at.getAttribute('aria-label') || (at.closest('[id]')?.id ?? '') + '/' + (at.textContent ?? ''), tag: at.tagName, visible }
      })
      if (!here) break
      reached.add(here.name)
      if (!here.visible) bare.push(here.name)
    }
    for (const wanted of ['story-open', 'link', 'take', 'theme', 'preset', 'field-strands', 'field-pretwist', 'field-force', 'balance', 'cut', 'paint', 'inside', 'stripes', 'home']) expect([...reached]).toContain(wanted)
    expect([...reached].some((name) => name.includes('numbers as CSV'))).toBe(true)
    expect(bare).toEqual([])
  })
})

test('states are chosen by the arrow keys', async () => {
  await visit('#strands=3&stiffness-ratio=0.75&pretwist=0.406', async ({ page }) => {
    const before = await agrees(page)
    await page.locator('#states [aria-checked=true]').focus()
    await page.keyboard.press('ArrowRight')
    await expect.poll(async () => (await shown(page)).number).not.toBe(before.number)
    expect(await page.evaluate(() => document.activeElement?.getAttribute('aria-checked'))).toBe('true')
    await agrees(page)
  })
})

test('on a phone everything is there, and nothing sticks out', async () => {
  for (const width of [320, 375, 430]) {
    await visit(RODS, async ({ page }) => {
      await withFigures(page)
      await agrees(page)
      const wide = await page.evaluate(() => document.documentElement.scrollWidth)
      expect(wide).toBeLessThanOrEqual(width)
      for (const id of ['view', 'readout', 'panel', 'figures']) expect(await page.locator(`#${id}`).isVisible(), id).toBe(true)
      await picture(page, `phone-${width}`)
      // a finger moves the load too
      const place = page.locator('#figure-force-moment .plot-place')
      await place.scrollIntoViewIfNeeded()
      const box = (await place.boundingBox())!
      await page.touchscreen.tap(box.x + box.width * 0.75, box.y + box.height * 0.45)
      await expect.poll(() => flags(page).some((flag) => flag.startsWith('--force='))).toBe(true)
      await agrees(page)
    }, { viewport: { width, height: 780 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 })
  }
})

test('where there is no WebGL a flat picture stands in its place', async () => {
  await visit(RODS, async ({ page }) => {
    await agrees(page)
    await page.waitForFunction(() => document.body.dataset['drawn'] !== undefined)
    const painted = await page.locator('#view').screenshot()
    expect(painted.length).toBeGreaterThan(5000)
    await picture(page, 'no-webgl')
    const field = page.locator('#field-pretwist')
    await field.fill('-1.5')
    await field.press('Enter')
    await agrees(page, '--pretwist=-1.5')
    await page.waitForTimeout(500)
    expect((await page.locator('#view').screenshot()).equals(painted)).toBe(false)
  }, FLAT)
})

test('the ply is drawn, in the colours of its strands', async () => {
  await visit(RODS, async ({ page }) => {
    await page.waitForFunction(() => document.body.dataset['drawn'] === 'yes')
    const colours = await page.evaluate(() => {
      const from = document.querySelector<HTMLCanvasElement>('#view canvas')!
      const copy = document.createElement('canvas')
      copy.width = from.width
      copy.height = from.height
      const pen = copy.getContext('2d')!
      pen.drawImage(from, 0, 0)
      const { data } = pen.getImageData(0, 0, copy.width, copy.height)
      const seen = new Set<number>()
      for (let at = 0; at < data.length; at += 4) if (data[at + 3]! > 200) seen.add((data[at]! << 16) | (data[at + 1]! << 8) | data[at + 2]!)
      return seen.size
    })
    expect(colours).toBeGreaterThan(300)
    await page.locator('#paint').check()
    await page.locator('#inside').check()
    await page.locator('#cut').fill('0.6')
    await page.waitForTimeout(500)
    await picture(page, 'inside')
  })
})

test('the experiment is told to its end, and leaves the page at its last ply', async () => {
  await visit('', async ({ page }) => {
    await agrees(page)
    await page.locator('#story-open').click()
    const heading = page.locator('#story h2')
    for (let step = 1; step <= 6; step++) {
      await expect.poll(() => heading.textContent()).toMatch(new RegExp(`^${step} of 6`))
      await page.waitForTimeout(400)
      await picture(page, `story-${step}`)
      if (step < 6) await page.locator('#story').getByRole('button', { name: 'Next' }).click()
    }
    await page.locator('#story').getByRole('button', { name: 'Explore from here' }).click()
    await page.locator('#story').waitFor({ state: 'hidden' })
    await settled(page)
    await agrees(page)
  }, { reducedMotion: 'reduce' })
})
