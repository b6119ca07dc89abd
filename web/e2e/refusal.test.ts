import { expect, test } from 'vitest'
import { agrees, expected, FLAT, kept, refused, RODS, settled, shown, visit } from './visit.ts'

/** Wrong input: the flag, what is typed, and the document that says the same. */
const WRONG: readonly (readonly [flag: string, typed: string, document: string])[] = [
  ['pretwist', 'a lot', '[ply]\nstrands = 3\n\n[strand]\nstiffness_ratio = 0.75\n\n[twist]\npretwist = "a lot"\n'],
  ['pretwist', '3 furlongs', '[ply]\nstrands = 3\n\n[strand]\nstiffness_ratio = 0.75\n\n[twist]\npretwist = "3 furlongs"\n'],
  ['strands', '1', '[ply]\nstrands = 1\n\n[strand]\nstiffness_ratio = 0.75\n\n[twist]\npretwist = -1\n'],
  ['strands', '2.5', '[ply]\nstrands = 2.5\n\n[strand]\nstiffness_ratio = 0.75\n\n[twist]\npretwist = -1\n'],
  ['stiffness-ratio', '-1', '[ply]\nstrands = 3\n\n[strand]\nstiffness_ratio = -1\n\n[twist]\npretwist = -1\n'],
  ['force', '3 N', '[ply]\nstrands = 3\n\n[strand]\nstiffness_ratio = 0.75\n\n[twist]\npretwist = -1\n\n[load]\nforce = "3 N"\n'],
  ['diameter', '-2 mm', '[ply]\nstrands = 3\n\n[strand]\nstiffness_ratio = 0.75\ndiameter = "-2 mm"\n\n[twist]\npretwist = -1\n'],
]

test('wrong input is refused in the command’s own words, at its field, and right input is taken again', async () => {
  for (const [flag, typed, document] of WRONG) {
    await visit('#strands=3&stiffness-ratio=0.75&pretwist=-1', async ({ page }) => {
      const before = await agrees(page)
      const field = page.locator(`#field-${flag}`)
      const was = await field.inputValue()
      await field.fill(typed)
      await field.press('Enter')
      const refusal = page.locator('#refusal')
      await refusal.waitFor({ state: 'visible' })
      // error: SENTENCE, the line shown, and = help: WHAT TO DO
      const { code, said } = refused(['solve', kept(document, 'ply.toml')])
      expect([1, 2]).toContain(code)
      const sentence = /^error: (.*)$/m.exec(said)?.[1] ?? '?'
      const help = [...said.matchAll(/= help: (.*)$/gm)].map((found) => found[1]!)
      const words = (await refusal.textContent()) ?? ''
      expect(words, said).toContain(sentence)
      for (const hint of help) expect(words).toContain(hint)
      // at the field, for those who listen too
      expect(await field.getAttribute('aria-invalid')).toBe('true')
      expect(await page.locator(`#field-${flag}-said`).textContent()).toContain(sentence.replace(/^`[^`]*`: /, ''))
      await field.fill(was)
      await field.press('Enter')
      await refusal.waitFor({ state: 'hidden' })
      expect((await agrees(page)).numbers).toEqual(before.numbers)
    }, FLAT)
  }
})

test('a document that is wrong is refused with its line, and the page stays as it was', async () => {
  const text = 'ply.strands = 3\nply.strnds = 4\n'
  await visit(RODS, async ({ page }) => {
    const before = await agrees(page)
    await page.evaluate((text) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([text], 'bad.toml'))
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }))
    }, text)
    const refusal = page.locator('#refusal')
    await refusal.waitFor({ state: 'visible' })
    const { said } = refused(['solve', '-'], text)
    expect(await refusal.textContent()).toContain(/^error: (.*)$/m.exec(said)?.[1])
    expect(await refusal.textContent()).toContain('bad.toml:2:')
    expect((await shown(page)).numbers).toEqual(before.numbers)
  }, FLAT)
})

test('an address that says too little is refused, and what is missing is said', async () => {
  await visit('#strands=3&stiffness-ratio=0.75', async ({ page }) => {
    await settled(page)
    const { code, said } = refused(['solve', '--strands=3', '--stiffness-ratio=0.75'])
    if (code === 0) return void (await agrees(page)) // nothing is missing after all
    const words = (await page.locator('#refusal').textContent()) ?? ''
    // a command's flags are a document's keys; what is missing is the same
    const missing = /^error: (?:--[a-z-]+: )?(.*? is missing)/m.exec(said)?.[1] ?? said
    expect(words).toContain(missing)
  }, FLAT)
})

test('no state in equilibrium is an answer', async () => {
  await visit('#strands=3&stiffness-ratio=0.75&pretwist=0.1&force=-5&moment=0', async ({ page }) => {
    await settled(page)
    const seen = await shown(page)
    expect((await page.locator('#refusal').textContent()) ?? '').toBe('')
    if (seen.number >= 0 && Object.keys(seen.numbers).length > 0) expect(seen.numbers).toEqual(expected(page, seen))
    else expect(await page.locator('#states').textContent()).toMatch(/No state is in equilibrium|straight/)
  }, FLAT)
})
