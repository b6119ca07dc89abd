// What happens on the way, in sentences.

import type { Report, Walk, WalkEvent } from './answer.ts'
import { byId, el } from './element.ts'
import { digits, scaleOf } from './reading.ts'
import type { Reading } from './state.ts'

const MOST = 4

export function say(sentence: string, kind: 'plain' | 'strong' = 'plain'): void {
  const place = byId('events')
  if (place.firstElementChild?.textContent === sentence) return
  place.prepend(el('p', { className: kind }, sentence))
  while (place.children.length > MOST) place.lastElementChild?.remove()
}

export function forget(): void {
  byId('events').replaceChildren()
}

export function tell(walk: Walk, report: Report, reading: Reading): void {
  for (const event of walk.events) {
    const sentence = sentenceOf(event, report, reading)
    if (sentence) say(sentence, event.event === 'diagonal' ? 'plain' : 'strong')
  }
  if (!walk.arrived && walk.events.every((event) => event.jump !== 'none')) {
    const why: Readonly<Record<string, string>> = {
      left_window: 'Behind a fold the branch leads back: these data are not reached along it.',
      flat_rings: 'The strands come to lie as flat rings before these data are reached.',
      apart: 'Free strands open without bound before these data are reached.',
    }
    say(`${why[walk.end] ?? 'The branch could not be followed to these data.'} The state nearest in angle is shown.`, 'strong')
  }
}

const hand = (angle: number): string => `${angle < 0 ? 'S' : 'Z'} ${digits(Math.abs(angle), 4)}°`

function sentenceOf(event: WalkEvent, report: Report, reading: Reading): string | null {
  const force = scaleOf(report, 'force', reading, Math.abs(event.force) || 1)
  const moment = scaleOf(report, 'moment', reading, Math.abs(event.moment) || 1)
  const at = `At ${digits(event.force * force.factor, 4)} ${force.unit} and ${digits(event.moment * moment.factor, 4)} ${moment.unit} (${hand(event.angle)})`
  const jump =
    event.jump === null ? ''
    : event.jump === 'none' ? ' No stable uniform ply is left under these data: it runs away. The state nearest in angle is shown.'
    : ` The ply jumps to ${hand(event.jump)}.`
  switch (event.event) {
    case 'separation': return `${at} the separation locus is crossed: p₁ = 0. On the far side touching strands would have to pull on each other.${jump}`
    case 'fold': return `${at} its states end: two meet in a fold.${jump}`
    case 'contact_change':
      return `${at} contacts ${event.carried_by === 'none' ? 'open: nothing carries the strands' : `change: ${event.carried_by === 'both' ? 'neighbours and core carry' : event.carried_by === 'core' ? 'the core carries' : 'neighbours carry'}`}.${jump}`
    case 'straight': return `${at} the strands lie straight, and the hand changes.${jump}`
    case 'most_turns': return `${at} no more turns fit in.`
    case 'buckling': return `${at} straight strands come under a thrust, under which each buckles by itself.${jump}`
    case 'diagonal': return null
    default: return jump ? `${at}: ${event.event.replaceAll('_', ' ')}.${jump}` : null
  }
}
