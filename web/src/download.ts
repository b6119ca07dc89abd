// Files for the reader, made in the page.

import { el } from './element.ts'

export function save(name: string, content: string | Uint8Array | Blob, type = 'text/plain'): void {
  const blob = content instanceof Blob ? content : new Blob([content as BlobPart], { type })
  const address = URL.createObjectURL(blob)
  const link = el('a', { href: address, download: name })
  document.body.append(link)
  link.click()
  link.remove()
  setTimeout(() => URL.revokeObjectURL(address), 10_000)
}

/** Rows as CSV; numbers to the last digit. */
export function csv(columns: readonly string[], rows: readonly (readonly (string | number)[])[]): string {
  const cell = (value: string | number): string => {
    const text = typeof value === 'number' ? (Number.isFinite(value) ? String(value) : '') : value
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
  }
  return [columns, ...rows].map((row) => row.map(cell).join(',')).join('\n') + '\n'
}

const KEPT = ['fill', 'stroke', 'stroke-width', 'stroke-dasharray', 'stroke-linecap', 'stroke-linejoin', 'opacity', 'fill-opacity', 'stroke-opacity', 'font-size', 'font-family', 'font-weight', 'text-anchor', 'paint-order'] as const

/** A picture of the page as a file of its own: the style sheet's share written into it. */
export function standalone(picture: SVGElement): string {
  const copy = picture.cloneNode(true) as SVGElement
  const [from, to] = [picture.querySelectorAll('*'), copy.querySelectorAll('*')]
  const box = picture.getBoundingClientRect()
  const write = (source: Element, target: Element): void => {
    const style = getComputedStyle(source)
    for (const name of KEPT) {
      const value = style.getPropertyValue(name)
      if (value && value !== 'none 0px') target.setAttribute(name, value)
    }
    target.removeAttribute('class')
    target.removeAttribute('style')
  }
  from.forEach((source, i) => write(source, to[i]!))
  write(picture, copy)
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg')
  copy.setAttribute('width', String(Math.round(box.width)))
  copy.setAttribute('height', String(Math.round(box.height)))
  const ground = document.createElementNS('http://www.w3.org/2000/svg', 'rect')
  const view = (copy.getAttribute('viewBox') ?? `0 0 ${box.width} ${box.height}`).split(/[ ,]+/)
  for (const [name, value] of [['x', view[0]], ['y', view[1]], ['width', view[2]], ['height', view[3]]] as const) ground.setAttribute(name, value ?? '0')
  ground.setAttribute('fill', getComputedStyle(document.body).backgroundColor)
  copy.prepend(ground)
  return new XMLSerializer().serializeToString(copy)
}

/** The same in pixels. */
export async function rastered(picture: SVGElement, zoom = 2): Promise<Blob | null> {
  const box = picture.getBoundingClientRect()
  const image = new Image()
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(standalone(picture))}`
  await image.decode()
  const canvas = el('canvas', { width: Math.round(box.width * zoom), height: Math.round(box.height * zoom) })
  canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height)
  return new Promise((resolve) => canvas.toBlob(resolve, 'image/png'))
}
