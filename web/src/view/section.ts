// The true cut across the ply, drawn as it is.

import { hex, STRANDS } from '../theme.ts'
import { svg } from '../element.ts'
import { MOST_DRAWN, turnAt } from './shape.ts'
import type { Shape } from './shape.ts'

export function section(shape: Shape, height: number, label: string): SVGElement {
  const { outline, strands, radiusRatio } = shape
  const reach = radiusRatio + 1.25
  const path = outlinePath(outline)
  const turn = (turnAt(shape, height) * 180) / Math.PI
  const cuts = Array.from({ length: Math.min(strands, MOST_DRAWN) }, (_, i) => {
    const degrees = turn + (360 * i) / strands
    return svg('path', { d: path, transform: `rotate(${degrees.toFixed(4)})`, fill: hex(STRANDS[i % STRANDS.length]!), class: 'cut' })
  })
  const hole = radiusRatio - 1
  const parts: Node[] = [svg('circle', { r: radiusRatio + 1, class: 'outer' }), ...cuts]
  if (shape.core !== null) parts.push(svg('circle', { r: shape.core, class: 'core' }))
  else if (hole > 0.01) parts.push(svg('circle', { r: hole, class: 'hole' }))
  if (shape.sides.length === 4) {
    const [, , radius = 0, azimuth = 0] = shape.sides
    for (let i = 0; i < (radius < 1e-9 ? 1 : Math.min(strands, MOST_DRAWN)); i++) {
      const at = azimuth + turnAt(shape, height) + (2 * Math.PI * i) / strands
      parts.push(svg('circle', { cx: radius * Math.cos(at), cy: radius * Math.sin(at), r: 0.025 * reach, class: 'touch' }))
    }
  }
  const drawn = svg('g', { transform: 'scale(1 -1)' }, ...parts)
  return svg('svg', { viewBox: `${-reach} ${-reach} ${2 * reach} ${2 * reach}`, class: 'section', role: 'img', 'aria-label': label }, drawn)
}

function outlinePath(outline: Float64Array): string {
  let path = ''
  for (let i = 0; i < outline.length; i += 2) path += `${i === 0 ? 'M' : 'L'}${outline[i]!.toFixed(4)} ${outline[i + 1]!.toFixed(4)}`
  return path + 'Z'
}
