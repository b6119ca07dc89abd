// One browser and one server for all tests.

import { spawn } from 'node:child_process'
import { chromium } from 'playwright-core'
import type { TestProject } from 'vitest/node'

declare module 'vitest' {
  interface ProvidedContext {
    readonly address: string
    readonly browser: string
    readonly command: string
  }
}

/** Chromium as it runs on a machine without a graphics card, and with nothing to say to anybody. */
const FLAGS = [
  '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
]

export default async function setup({ provide }: TestProject): Promise<() => Promise<void>> {
  const command = process.env['NPLY_BIN'] ?? new URL('../../target/debug/nply', import.meta.url).pathname
  const served = spawn(command, ['explore', '--port', '0'], { stdio: ['ignore', 'pipe', 'inherit'] })
  const address = await new Promise<string>((resolve, reject) => {
    served.once('error', reject)
    served.once('exit', (code) => reject(new Error(`${command} explore ended with ${code}`)))
    served.stdout.once('data', (line: Buffer) => resolve(line.toString().trim()))
  })
  const browser = await chromium.launchServer({ executablePath: process.env['CHROMIUM'] ?? '/usr/bin/chromium', headless: true, args: FLAGS })
  provide('address', address)
  provide('command', command)
  provide('browser', browser.wsEndpoint())
  return async () => {
    await browser.close()
    served.kill('SIGINT')
  }
}
