// Colours that people of every colour vision can tell apart (Okabe and Ito), for light and dark ground.

export const STRANDS = [0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9] as const

export const isDark = (): boolean => {
  const said = document.documentElement.dataset['theme']
  return said ? said === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches
}

export const isStill = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches

/** A colour of the style sheet. */
export function ink(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim()
}

export function hex(colour: number): string {
  return '#' + colour.toString(16).padStart(6, '0')
}

/** How hard contacts press: from pale to strong as p₁ r³/B grows; another colour where they would have to pull. */
export function pressureColour(pressure: number): string {
  const strength = Math.min(1, Math.sqrt(Math.abs(pressure) / 0.3))
  const [from, to] = pressure < 0 ? [[0xf3, 0xc9, 0xb4], [0xb9, 0x2d, 0x00]] : [[0xb5, 0xdc, 0xcf], [0x00, 0x7a, 0x55]]
  const mix = from!.map((value, i) => Math.round(value + (to![i]! - value) * strength))
  return '#' + mix.map((value) => value.toString(16).padStart(2, '0')).join('')
}
