import { get } from 'node:http'
import { gunzipSync } from 'node:zlib'
import { expect, test } from 'vitest'
import { agrees, picture, shown, visit, withFigures } from './visit.ts'

interface File {
  readonly address: string
  /** Bytes on the way. */
  readonly size: number
  readonly plain: Buffer
}

/** A file as a browser gets it. */
async function compressed(address: string): Promise<File> {
  const bytes = await new Promise<Buffer>((resolve, reject) => {
    get(address, { headers: { 'accept-encoding': 'gzip, deflate, br' } }, (response) => {
      expect(response.headers['content-encoding']).toBe('gzip')
      const pieces: Buffer[] = []
      response.on('data', (piece: Buffer) => pieces.push(piece)).on('end', () => resolve(Buffer.concat(pieces))).on('error', reject)
    }).on('error', reject)
  })
  return { address, size: bytes.length, plain: gunzipSync(bytes) }
}

test('it loads without a complaint, asks nobody else for anything, and shows what the command prints', async () => {
  await visit('', async ({ page, requests }) => {
    const { states, number } = await agrees(page)
    expect(states).toBeGreaterThan(0)
    expect(number).toBeGreaterThanOrEqual(0)
    await withFigures(page)
    await page.waitForFunction(() => document.body.dataset['drawn'] === 'yes')
    await picture(page, 'first')
    expect(requests.length).toBeGreaterThan(3)
  })
})

test('what is fetched before the third dimension is under 1 MB, compressed', async () => {
  await visit('', async ({ page, requests }) => {
    await withFigures(page)
    await page.waitForFunction(() => document.body.dataset['drawn'] === 'yes')
    const addresses = new Set(requests.map((request) => request.url().replace(/#.*/, '')).filter((address) => address.startsWith('http')))
    const files = await Promise.all([...addresses].map(compressed))
    const isOfThree = (file: File): boolean => file.plain.includes('WebGLRenderer')
    expect(files.filter(isOfThree).length).toBe(1)
    expect(files.filter((file) => file.address.endsWith('.wasm')).length).toBe(1)
    const size = files.filter((file) => !isOfThree(file)).reduce((sum, file) => sum + file.size, 0)
    expect(size).toBeGreaterThan(100_000)
    expect(size).toBeLessThan(1_000_000)
  })
})

test('nothing of the page leans on what its policy forbids', async () => {
  const before = `window.broken = []; document.addEventListener('securitypolicyviolation', (event) => window.broken.push(event.violatedDirective + ' ' + event.blockedURI))`
  await visit('', async ({ page }) => {
    await withFigures(page)
    expect(await page.evaluate(() => (window as unknown as { broken: string[] }).broken)).toEqual([])
    // and the policy is in force: a script that somebody slips in does not run
    await page.evaluate(() => {
      const slipped = document.createElement('script')
      slipped.textContent = 'window.slipped = true'
      document.body.append(slipped)
    })
    expect(await page.evaluate(() => 'slipped' in window)).toBe(false)
    expect(await page.evaluate(() => (window as unknown as { broken: string[] }).broken.length)).toBeGreaterThan(0)
  }, { before, bears: /inline script/ })
})

test('without a name for a ply it begins with one that says something', async () => {
  await visit('', async ({ page }) => {
    const { numbers } = await shown(page)
    expect(Number(numbers['helical_angle_deg'])).toBeCloseTo(30.613, 3)
    expect(Number(numbers['interstrand_pressure'])).toBeGreaterThan(0)
  })
})
