// What a reader takes along.

import { isRefusal } from './answer.ts'
import { rastered, save, standalone } from './download.ts'
import { byId, el } from './element.ts'
import type { Solver } from './solver/client.ts'
import type { Data } from './state.ts'

export interface Taking {
  readonly solver: Solver
  readonly data: () => Data
  /** The state on show, from 0. */
  readonly number: () => number
  readonly stripes: () => number
  readonly picture: () => Promise<Blob | null>
  readonly open: (name: string, text: string) => void
}

export function takeAway(taking: Taking): () => void {
  const dialog = byId<HTMLDialogElement>('take-away')
  const said = el('p', { className: 'quiet-words', role: 'status' })

  const button = (words: string, about: string, act: () => void | Promise<void>): HTMLElement => {
    const made = el('button', { type: 'button' }, words)
    made.addEventListener('click', () => {
      said.textContent = ''
      void act()
    })
    return el('li', {}, made, el('span', {}, about))
  }
  const report = (format: 'text' | 'csv' | 'json' | 'toml', name: string, type: string) => async () => {
    const made = await taking.solver.ask('report', { data: taking.data(), format })
    if (isRefusal(made)) said.textContent = made.error.sentence
    else save(name, made.text, type)
  }
  const mesh = (format: 'stl' | 'glb', type: string) => async () => {
    const made = await taking.solver.ask('mesh', { data: taking.data(), number: taking.number(), format, stripes: format === 'glb' ? taking.stripes() : 0 })
    if (made.length === 0) said.textContent = 'There is no such shape: straight strands, or no state in equilibrium.'
    else save(`ply.${format}`, made, type)
  }
  const section = (): SVGElement | null => byId('section').querySelector('svg')

  const file = el('input', { type: 'file', accept: '.toml,text/plain', id: 'open-file' })
  file.addEventListener('change', async () => {
    const chosen = file.files?.[0]
    file.value = ''
    if (!chosen) return
    dialog.close()
    taking.open(chosen.name, await chosen.text())
  })

  const close = el('button', { type: 'button', className: 'quiet', aria: { label: 'Close' } }, '×')
  close.addEventListener('click', () => dialog.close())
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close()
  })
  dialog.replaceChildren(
    el('div', { className: 'sheet' },
      el('div', { className: 'head' }, el('h2', { id: 'take-title' }, 'Take away'), close),
      el('ul', {},
        button('ply.toml', 'the document, for nply solve', report('toml', 'ply.toml', 'application/toml')),
        button('ply.txt', 'the report, as nply solve prints it', report('text', 'ply.txt', 'text/plain')),
        button('ply.json', 'every number, to the last digit', report('json', 'ply.json', 'application/json')),
        button('ply.csv', 'one row a state', report('csv', 'ply.csv', 'text/csv')),
        button('ply.glb', 'the ply with its colours, for viewers', mesh('glb', 'model/gltf-binary')),
        button('ply.stl', 'the ply, for printing', mesh('stl', 'model/stl')),
        button('ply.png', 'the picture as it stands', async () => {
          const picture = await taking.picture()
          if (picture) save('ply.png', picture)
        }),
        button('section.svg', 'the true cut', () => {
          const drawn = section()
          if (drawn) save('section.svg', standalone(drawn), 'image/svg+xml')
        }),
        button('section.png', 'the same in pixels', async () => {
          const drawn = section()
          const pixels = drawn && (await rastered(drawn, 4))
          if (pixels) save('section.png', pixels)
        }),
      ),
      el('p', { className: 'quiet-words' }, 'Curves: CSV, SVG and PNG stand beside each figure.'),
      said,
      el('div', { className: 'open' }, el('label', { for: 'open-file' }, 'Open a document'), file, el('span', { className: 'quiet-words' }, 'or drop it anywhere on the page')),
    ),
  )
  return () => {
    said.textContent = ''
    dialog.showModal()
  }
}

/** A file that is dropped anywhere is opened. */
export function takeDrops(open: (name: string, text: string) => void): void {
  const shade = byId('drop')
  const hasFile = (event: DragEvent): boolean => [...(event.dataTransfer?.types ?? [])].includes('Files')
  addEventListener('dragover', (event) => {
    if (!hasFile(event)) return
    event.preventDefault()
    shade.hidden = false
  })
  addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) shade.hidden = true
  })
  addEventListener('drop', async (event) => {
    if (!hasFile(event)) return
    event.preventDefault()
    shade.hidden = true
    const file = event.dataTransfer?.files[0]
    if (file) open(file.name, await file.text())
  })
}
