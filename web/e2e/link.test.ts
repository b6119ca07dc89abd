import { expect, test } from 'vitest'
import { agrees, FLAT, RODS, settled, shown, visit, withFigures } from './visit.ts'

test('a link carries everything that is on show', async () => {
  let [address, numbers]: [string, Readonly<Record<string, string>>] = ['', {}]
  await visit('', async ({ page }) => {
    await withFigures(page)
    const preset = page.locator('#preset')
    await preset.selectOption('collagen')
    await expect.poll(() => page.locator('#title').textContent()).toMatch(/[Cc]ollagen/)
    await agrees(page)
    await page.locator('#states [role=radio]').last().click()
    await page.locator('#cut').fill('0.4')
    await page.locator('#paint').check()
    await page.locator('#inside').check()
    await page.locator('#stripes').fill('5')
    await page.locator('#radii').click()
    await page.selectOption('#along', 'moment')
    await expect.poll(() => page.url()).toMatch(/along=moment/)
    numbers = (await agrees(page)).numbers
    address = page.url()
  }, FLAT)
  await visit(new URL(address).hash, async ({ page }) => {
    await withFigures(page)
    expect((await agrees(page)).numbers).toEqual(numbers)
    expect(page.url()).toBe(address)
    const look = await page.evaluate(() => {
      const of = (id: string): HTMLInputElement => document.getElementById(id) as HTMLInputElement
      return [of('cut').value, of('paint').checked, of('inside').checked, of('stripes').value, of('radii').getAttribute('aria-pressed'), of('along').value]
    })
    expect(look).toEqual(['0.4', true, true, '5', 'true', 'moment'])
  }, FLAT)
})

test('an address that is changed by hand is followed', async () => {
  await visit(RODS, async ({ page }) => {
    await agrees(page)
    await page.evaluate(() => (location.hash = '#strands=6&stiffness-ratio=0.9&helical-angle=25+deg&hand=left'))
    await expect.poll(async () => Number((await shown(page)).numbers['helical_angle_deg'])).toBeCloseTo(25, 9)
    await agrees(page, '--strands=6')
  }, FLAT)
})

test('whatever stands in an address, the page stands too', async () => {
  for (const hash of ['#', '#&&==&', '#strands', '#strands=3&at=Q7&cut=9&stripes=-1&along=x&paint=', '#__proto__=1&constructor=2', `#title=${'x'.repeat(4000)}&strands=3&stiffness-ratio=1&pretwist=1`]) {
    await visit(hash, async ({ page }) => {
      await settled(page)
      const refusal = (await page.locator('#refusal').textContent()) ?? ''
      expect((await shown(page)).states > 0 || refusal.length > 10, hash).toBe(true)
      expect(refusal, hash).not.toMatch(/set up|undefined|\[object/)
    }, FLAT)
  }
  // half a character, which a browser will not be sent to from outside
  await visit(RODS, async ({ page }) => {
    await page.evaluate(() => (location.hash = '#title=%E0%A4%A&strands=3&stiffness-ratio=1&pretwist=1'))
    await expect.poll(() => page.locator('#title').textContent()).toBe('%E0%A4%A')
  }, FLAT)
})

test('a title of markup stays a title', async () => {
  await visit('#title=%3Cimg+src%3Dx+onerror%3Dwindow.hit%3D1%3E&strands=3&stiffness-ratio=1&pretwist=1', async ({ page }) => {
    await agrees(page)
    expect(await page.locator('#title').textContent()).toBe('<img src=x onerror=window.hit=1>')
    expect(await page.evaluate(() => 'hit' in window)).toBe(false)
  }, FLAT)
})

test('what was done is undone and done again', async () => {
  await visit(RODS, async ({ page }) => {
    const first = await agrees(page)
    expect(await page.locator('#undo').isDisabled()).toBe(true)
    const field = page.locator('#field-pretwist')
    await field.fill('-1.5')
    await field.press('Enter')
    const second = await agrees(page, '--pretwist=-1.5')
    await page.locator('#undo').click()
    await expect.poll(async () => (await shown(page)).numbers).toEqual(first.numbers)
    await page.locator('body').press('Control+Shift+Z')
    await expect.poll(async () => (await shown(page)).numbers).toEqual(second.numbers)
    await page.locator('body').press('Control+Z')
    await expect.poll(async () => (await shown(page)).numbers).toEqual(first.numbers)
    await agrees(page)
  }, FLAT)
})
