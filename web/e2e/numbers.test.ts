import { expect, test } from 'vitest'
import type { Page } from 'playwright-core'
import { agrees, flags, FLAT, nply, RODS, shown, visit } from './visit.ts'

/** Moves a slider as arrow keys do, which a screen reader's user has too. */
async function slide(page: Page, flag: string, keys: string, times: number): Promise<void> {
  const slider = page.locator(`.field[data-flag="${flag}"] input[type=range]`)
  await slider.focus()
  for (let i = 0; i < times; i++) await slider.press(keys)
}

async function type(page: Page, flag: string, text: string): Promise<void> {
  const field = page.locator(`#field-${flag}`)
  await field.fill(text)
  await field.press('Enter')
}

test('a slider changes the numbers to what the command prints for that ply', async () => {
  await visit(RODS, async ({ page }) => {
    const before = await agrees(page)
    await slide(page, 'pretwist', 'ArrowLeft', 7)
    await expect.poll(() => flags(page)).not.toContain('--pretwist=-1')
    const after = await agrees(page)
    expect(after.numbers['helical_angle_deg']).not.toBe(before.numbers['helical_angle_deg'])
    await slide(page, 'force', 'ArrowRight', 5)
    await expect.poll(() => flags(page).some((flag) => flag.startsWith('--force='))).toBe(true)
    const pulled = await agrees(page)
    expect(Number(pulled.numbers['force'])).toBeGreaterThan(0)
    expect(Number(pulled.numbers['helical_angle_deg'])).toBeLessThan(Number(after.numbers['helical_angle_deg']))
    await slide(page, 'strands', 'ArrowRight', 2)
    await agrees(page, '--strands=5')
  }, FLAT)
})

test('a number is typed as one says it, and is what the command reads', async () => {
  await visit('#strands=3&stiffness-ratio=0.75&turns-per-length=470+turns/m+Z&diameter=0.275+mm&bending-stiffness=2+mN+mm^2', async ({ page }) => {
    await agrees(page)
    await type(page, 'diameter', '0.3 mm')
    await agrees(page, '--diameter=0.3 mm')
    await type(page, 'force', '20 mN')
    const { numbers } = await agrees(page, '--force=20 mN')
    expect(Number(numbers['force'])).toBeGreaterThan(0)
  }, FLAT)
})

test('every ply it offers is shown as the command works it out', async () => {
  await visit(RODS, async ({ page }) => {
    const names = await page.locator('#preset option').evaluateAll((options) => options.map((option) => (option as HTMLOptionElement).value).filter(Boolean))
    expect(names.length).toBeGreaterThan(10)
    for (const trade of ['three-ply-yarn', 'zero-twist-rope', 'tyre-cord-840d-2', 'dna-plectoneme', 'collagen', 'coiled-coil-2', 'twisted-string-actuator', 'rubber-rods']) expect(names).toContain(trade)
    for (const name of names) {
      await page.selectOption('#preset', name)
      const [title] = /^title = "(.*)"$/m.exec(nply('preset', name)) ?? []
      if (title) await expect.poll(() => page.locator('#title').textContent(), { message: name }).toBe(title.slice('title = "'.length, -1))
      const refusal = await page.locator('#refusal').textContent()
      expect(refusal, name).toBe('')
      await agrees(page)
    }
  }, FLAT)
})

test('the other states of a ply are one click away', async () => {
  await visit('#strands=3&stiffness-ratio=0.75&pretwist=0.406', async ({ page }) => {
    const { states } = await agrees(page)
    expect(states).toBe(3)
    const seen = new Set<string>()
    for (let i = 0; i < states; i++) {
      await page.locator('#states [role=radio]').nth(i).click()
      await expect.poll(async () => (await shown(page)).number).toBe(i)
      seen.add((await agrees(page)).numbers['helical_angle_deg'] ?? '')
    }
    expect(seen.size).toBe(3)
  }, FLAT)
})

test('both balances are given with their difference', async () => {
  await visit(RODS, async ({ page }) => {
    const contact = Number((await agrees(page)).numbers['helical_angle_deg'])
    const words = (await page.locator('#balances').textContent()) ?? ''
    expect(words).toMatch(/Contact balance 30\.613°.*radial.*difference/)
    await page.selectOption('#balance', 'radial')
    const radial = Number((await agrees(page, '--balance=radial')).numbers['helical_angle_deg'])
    const difference = Number(/difference [+−]([\d.]+)°/.exec(words)?.[1])
    expect(difference).toBeCloseTo(Math.abs(radial - contact), 2)
  }, FLAT)
})

test('units are switched without a number changing', async () => {
  await visit('#strands=3&stiffness-ratio=0.75&pretwist=-1&diameter=2+mm&bending-stiffness=3+N+mm^2&force=0.5+N', async ({ page }) => {
    const before = await agrees(page)
    const force = page.locator('#readout dd[data-name="force"]')
    expect(await force.textContent()).toBe('500 mN')
    await page.locator('#radii').click()
    expect(await force.textContent()).toMatch(/B\/r²$/)
    expect((await shown(page)).numbers).toEqual(before.numbers)
  }, FLAT)
})
