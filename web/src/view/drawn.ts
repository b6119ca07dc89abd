// The ply drawn on a flat canvas, where the page has no card to draw it with: piece by piece, from the back to the front.

import type { Look } from '../state.ts'
import { pressureColour, STRANDS } from '../theme.ts'
import { heightOf, MOST_DRAWN, thickness, turnAt } from './shape.ts'
import type { Shape } from './shape.ts'

const PIECES = 220

interface Piece {
  readonly depth: number
  readonly strand: number
  readonly from: readonly [number, number]
  readonly to: readonly [number, number]
}

export function drawPly(canvas: HTMLCanvasElement, shape: Shape, look: Look): void {
  const paper = canvas.getContext('2d')
  if (!paper) return
  const zoom = Math.min(devicePixelRatio || 1, 2)
  const { clientWidth: width, clientHeight: height } = canvas
  canvas.width = Math.max(1, Math.round(width * zoom))
  canvas.height = Math.max(1, Math.round(height * zoom))
  const whole = heightOf(shape)
  const low = -whole / 2
  const high = low + whole * (0.04 + 0.96 * look.cut)
  // lengths in strand radii from here on, up is up
  const unit = Math.min((height * 0.8) / whole, (width * 0.8) / (7.5 * thickness(shape)))
  paper.setTransform(unit * zoom, 0, 0, -unit * zoom, canvas.width / 2, canvas.height / 2)
  // seen square to the axis, so that both ends are straight lines
  paper.beginPath()
  paper.rect(-1e3, low, 2e3, high - low)
  paper.clip()

  const over = 2 * Math.sin(shape.theta)
  const pieces: Piece[] = []
  for (let strand = 0; strand < Math.min(shape.strands, MOST_DRAWN); strand++) {
    let last: readonly [number, number, number] | null = null
    for (let i = 0; i <= PIECES; i++) {
      const z = low - over + ((high - low + 2 * over) * i) / PIECES
      const psi = turnAt(shape, z) + (2 * Math.PI * strand) / shape.strands
      const here = [shape.hand * shape.radiusRatio * Math.sin(psi), z, shape.hand * shape.radiusRatio * Math.cos(psi)] as const
      if (last) pieces.push({ depth: (here[2] + last[2]) / 2, strand, from: [last[0], last[1]], to: [here[0], here[1]] })
      last = here
    }
  }
  if (shape.core !== null) pieces.push({ depth: 0, strand: -1, from: [0, low], to: [0, high] })
  pieces.sort((a, b) => a.depth - b.depth)
  paper.globalAlpha = look.inside ? 0.35 : 1
  for (const { strand, from, to } of pieces) {
    const colour = strand < 0 ? '#999999' : look.paint === 'pressure' ? pressureColour(shape.corePressure || shape.pressure) : css(STRANDS[strand % STRANDS.length]!)
    const radius = strand < 0 ? shape.core! : 1
    stroke(paper, from, to, 2.08 * radius, mixed(colour, '#000000', 0.5))
    stroke(paper, from, to, 1.9 * radius, mixed(colour, '#000000', 0.12))
    // lit from the left: across the piece, so that no neighbour covers it
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1
    const [across, up] = [-(to[1] - from[1]) / length, (to[0] - from[0]) / length]
    const lit = (off: number, width: number, share: number): void => {
      const [x, y] = [across * off * radius, up * off * radius]
      stroke(paper, [from[0] + x, from[1] + y], [to[0] + x, to[1] + y], width * radius, mixed(colour, '#ffffff', share))
    }
    lit(0.2, 1.05, 0.1)
    lit(0.3, 0.4, 0.28)
  }
}

function stroke(paper: CanvasRenderingContext2D, from: readonly [number, number], to: readonly [number, number], width: number, colour: string): void {
  paper.lineWidth = width
  paper.strokeStyle = colour
  paper.beginPath()
  // a little longer than the piece, so that no seam is seen
  const [dx, dy] = [0.35 * (to[0] - from[0]), 0.35 * (to[1] - from[1])]
  paper.moveTo(from[0] - dx, from[1] - dy)
  paper.lineTo(to[0] + dx, to[1] + dy)
  paper.stroke()
}

const css = (colour: number): string => '#' + colour.toString(16).padStart(6, '0')

function mixed(a: string, b: string, share: number): string {
  const part = (text: string, at: number): number => parseInt(text.slice(at, at + 2), 16)
  return '#' + [1, 3, 5].map((at) => Math.round(part(a, at) + share * (part(b, at) - part(a, at))).toString(16).padStart(2, '0')).join('')
}
