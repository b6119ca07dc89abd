// Elements in one line.

type Child = Node | string | null | undefined
type Properties<T extends keyof HTMLElementTagNameMap> = Partial<Omit<HTMLElementTagNameMap[T], 'style' | 'dataset'>> & {
  readonly aria?: Readonly<Record<string, string>>
  readonly data?: Readonly<Record<string, string>>
  readonly role?: string
  readonly for?: string
}

export function el<T extends keyof HTMLElementTagNameMap>(tag: T, properties: Properties<T> = {}, ...children: Child[]): HTMLElementTagNameMap[T] {
  const made = document.createElement(tag)
  const { aria, data, role, for: target, ...rest } = properties
  Object.assign(made, rest)
  for (const [name, value] of Object.entries(aria ?? {})) made.setAttribute(`aria-${name}`, value)
  for (const [name, value] of Object.entries(data ?? {})) made.dataset[name] = value
  if (role !== undefined) made.setAttribute('role', role)
  if (target !== undefined) made.setAttribute('for', target)
  made.append(...children.filter((child) => child !== null && child !== undefined))
  return made
}

export function svg(tag: string, attributes: Readonly<Record<string, string | number>> = {}, ...children: Node[]): SVGElement {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag)
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value))
  made.append(...children)
  return made
}

/** The element of this id, which the page has. */
export function byId<E extends HTMLElement = HTMLElement>(id: string): E {
  const found = document.getElementById(id)
  if (!found) throw new Error(`the page has no #${id}`)
  return found as E
}
