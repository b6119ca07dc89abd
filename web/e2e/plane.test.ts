import { expect, test } from 'vitest'
import type { Page } from 'playwright-core'
import { agrees, flags, FLAT, picture, RODS, shown, solve, visit, withFigures } from './visit.ts'

/** Where a load stands on the screen, from two ticks of each axis. */
async function places(page: Page): Promise<(force: number, moment: number) => [number, number]> {
  const place = page.locator('#figure-force-moment .plot-place')
  await place.scrollIntoViewIfNeeded()
  const ticks = await place.locator('svg').evaluate((svg) => {
    const read = (label: string, side: 'x' | 'y'): [number, number][] =>
      [...svg.querySelectorAll<SVGTextElement>(`g[aria-label="${label}"] text`)].flatMap((text) => {
        const value = Number((text.textContent ?? '').replace('−', '-'))
        const box = text.getBoundingClientRect()
        return text.textContent === '' || Number.isNaN(value) ? [] : [[value, side === 'x' ? box.left + box.width / 2 : box.top + box.height / 2]]
      })
    return { x: read('x-axis tick label', 'x'), y: read('y-axis tick label', 'y') }
  })
  const line = (pairs: [number, number][]) => {
    const [[a, p], [b, q]] = [pairs[0]!, pairs.at(-1)!]
    return (value: number): number => p + ((value - a) / (b - a)) * (q - p)
  }
  const [x, y] = [line(ticks.x), line(ticks.y)]
  return (force, moment) => [x(force), y(moment)]
}

async function drag(page: Page, from: readonly [number, number], to: readonly [number, number], steps = 24): Promise<void> {
  const at = await places(page)
  await page.mouse.move(...at(...from))
  await page.mouse.down()
  const [[x, y], [X, Y]] = [at(...from), at(...to)]
  for (let i = 1; i <= steps; i++) {
    await page.mouse.move(x + ((X - x) * i) / steps, y + ((Y - y) * i) / steps)
    await page.waitForTimeout(20)
  }
  await page.mouse.up()
}

test('a load that is dragged over the locus of separation says that the strands part, and where', async () => {
  await visit('#strands=3&stiffness-ratio=0.75&pretwist=0.406051', async ({ page }) => {
    await withFigures(page)
    const before = await agrees(page)
    expect(Number(before.numbers['interstrand_pressure'])).toBeGreaterThan(0)
    // by the command: under which thrust this yarn opens
    const limit = solve(...flags(page)).states[before.number]!['margins'] as { force: { below: { change: number; cause: string } } }
    const { change, cause } = limit.force.below
    expect([cause, change.toFixed(3)]).toEqual(['separation', '-0.402'])
    await picture(page, 'plane-before')
    await drag(page, [0, 0], [1.6 * change, 0])
    const events = page.locator('#events')
    await expect.poll(() => events.textContent(), { timeout: 15_000 }).toMatch(/separation locus is crossed/)
    const said = /At (−[\d.]+) B\/r² and .*?\(S ([\d.]+)°\) the separation locus/.exec((await events.textContent()) ?? '')
    expect(Number(said?.[1]?.replace('−', '-'))).toBeCloseTo(change, 2)
    const after = await agrees(page)
    expect(Number(after.numbers['interstrand_pressure'])).toBeLessThan(0)
    expect(await page.locator('#states [aria-checked=true]').textContent()).toContain('would have to pull')
    await picture(page, 'plane-after')
  }, FLAT)
})

test('a load that is dragged past a fold says that the ply jumps, and where to', async () => {
  await visit(RODS, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    await drag(page, [0, 0], [-1.4, 0])
    await expect.poll(() => page.locator('#events').textContent(), { timeout: 15_000 }).toMatch(/At −1\.28\d* B\/r².*two meet in a fold.*(jumps to|No stable uniform ply is left)/)
    await agrees(page)
    await picture(page, 'plane-fold')
  }, FLAT)
})

test('a click moves the load there, and the ply follows', async () => {
  await visit(RODS, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    await page.mouse.click(...(await places(page))(0.5, 0.2))
    await expect.poll(() => flags(page).some((flag) => flag.startsWith('--force='))).toBe(true)
    const { numbers } = await agrees(page)
    expect(Number(numbers['force'])).toBeCloseTo(0.5, 1)
    expect(Number(numbers['moment'])).toBeCloseTo(0.2, 1)
  }, FLAT)
})

test('the load moves by the keyboard too', async () => {
  await visit(RODS, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    await page.locator('#figure-force-moment .plot-place').focus()
    for (let i = 0; i < 4; i++) {
      await page.keyboard.press('ArrowRight')
      await page.waitForTimeout(120)
    }
    await expect.poll(async () => Number((await shown(page)).numbers['force'])).toBeGreaterThan(0.05)
    await agrees(page)
  }, FLAT)
})

test('the state of now is marked on every figure, and moves with it', async () => {
  await visit(RODS, async ({ page }) => {
    await withFigures(page)
    await agrees(page)
    const figures = await page.locator('#figures figure').evaluateAll((all) => all.map((figure) => figure.id))
    expect(figures.length).toBeGreaterThanOrEqual(6)
    /** What each says, and whether a mark stands in its frame. */
    const said = async (): Promise<Record<string, string>> => {
      const found: Record<string, string> = {}
      for (const id of figures) {
        const svg = page.locator(`#${id} svg`)
        await page.locator(`#${id}`).scrollIntoViewIfNeeded()
        await svg.waitFor()
        // a figure that comes into sight is drawn anew: what was asked for a moment ago may be gone
        const inside = async (): Promise<boolean> => {
          const [mark, frame] = [await page.locator(`#${id} svg g[aria-label=dot] circle`).last().boundingBox(), await svg.boundingBox()]
          return !!mark && !!frame && mark.x > frame.x && mark.x < frame.x + frame.width && mark.y > frame.y && mark.y < frame.y + frame.height
        }
        await expect.poll(inside, { message: id, timeout: 10_000 }).toBe(true)
        found[id] = (await page.locator(`#${id} .plot-place`).getAttribute('aria-label')) ?? ''
      }
      return found
    }
    const before = await said()
    const field = page.locator('#field-pretwist')
    await field.fill('-1.4')
    await field.press('Enter')
    await agrees(page, '--pretwist=-1.4')
    await page.waitForTimeout(300)
    const after = await said()
    // the load stands, and the ply moved: all but the plane of loads
    for (const id of figures) if (id !== 'figure-force-moment') expect(after[id], id).not.toBe(before[id])
  }, FLAT)
})

test('hovering a curve says what stands there', async () => {
  await visit(RODS, async ({ page }) => {
    await withFigures(page)
    const figure = page.locator('#figure-angle-pretwist')
    await figure.scrollIntoViewIfNeeded()
    const curve = figure.locator('svg g[aria-label=line] path').last()
    const [x, y] = await curve.evaluate((path) => {
      const found = path as SVGPathElement
      const point = found.getPointAtLength(found.getTotalLength() * 0.4).matrixTransform(found.getScreenCTM()!)
      return [point.x, point.y] as const
    })
    await page.mouse.move(x + 1, y + 1)
    await expect.poll(() => figure.locator('svg g[aria-label=tip]').textContent()).toMatch(/°/)
    await picture(page, 'hover')
  }, FLAT)
})
