// The ply in three dimensions. One strand is one grid of points; where they lie is worked out on the card from (10), so that a change of the
// ply changes some numbers and no geometry. The other strands are the same grid, turned.

import * as THREE from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import type { Look } from '../state.ts'
import { isDark, isStill, pressureColour, STRANDS } from '../theme.ts'
import { heightOf, MOST_DRAWN, thickness, turnAt } from './shape.ts'
import type { Shape } from './shape.ts'

const ALONG = 420
const AROUND = 40

/** Numbers of the ply that the card needs; shared by all of its materials. */
function numbers() {
  return {
    uRadius: { value: 1 }, uSin: { value: 0 }, uCos: { value: 1 }, uEps: { value: 1 }, uLow: { value: -1 }, uHigh: { value: 1 }, uBody: { value: 1 },
    uPretwist: { value: 0 }, uStripes: { value: 3 }, uSides: { value: new THREE.Vector2() }, uTouch: { value: 0 }, uOnCore: { value: 0 },
    uPress: { value: new THREE.Color() }, uPaint: { value: 0 }, uGlass: { value: 0 },
  }
}

const SURFACE = /* glsl */ `
uniform float uRadius, uSin, uCos, uEps, uLow, uHigh, uBody, uPretwist;
varying float vHeight, vAlpha, vMaterial;
// (10): the surface of strand 0 at arclength s and angle alpha, alpha = pi/2 towards the axis
vec3 strand(float s, float alpha, float body, out vec3 away) {
  float psi = uEps * s * uSin / uRadius;
  float sp = sin(psi), cp = cos(psi), sa = sin(alpha), ca = cos(alpha);
  away = vec3(uEps * (-sa * sp - ca * uCos * cp), uEps * (-ca * uCos * sp + sa * cp), uEps * ca * uSin);
  return vec3(uEps * uRadius * sp, -uEps * uRadius * cp, s * uCos) + body * away;
}`

const PLACE = /* glsl */ `
float reach = uSin * uBody;
float s = mix(uLow - reach, uHigh + reach, position.x) / uCos;
vec3 away;
vec3 placed = strand(s, position.y, uBody, away);
vHeight = placed.z; vAlpha = position.y; vMaterial = position.y + uPretwist * s;
vec3 objectNormal = away;`

const PAINT = /* glsl */ `
uniform float uLow, uHigh, uStripes, uTouch, uOnCore, uPaint;
uniform vec2 uSides; uniform vec3 uPress;
varying float vHeight, vAlpha, vMaterial;
float near(float a, float b) { float d = mod(a - b + 3.14159265, 6.2831853) - 3.14159265; return exp(-d * d / 0.55); }`

const COLOUR = /* glsl */ `
if (vHeight < uLow || vHeight > uHigh) discard;
float turn = vMaterial / 6.2831853 * max(uStripes, 1.0);
float edge = fwidth(turn);
float into = fract(turn);
float stripe = uStripes > 0.0 ? smoothstep(0.0, edge, into) - smoothstep(0.26 - edge, 0.26, into) : 0.0;
stripe *= 1.0 - smoothstep(0.25, 0.8, edge);
diffuseColor.rgb = mix(diffuseColor.rgb, vec3(0.30), uPaint * 0.85);
diffuseColor.rgb = mix(diffuseColor.rgb, mix(diffuseColor.rgb, vec3(1.0), 0.62), stripe * (1.0 - 0.6 * uPaint));
float touch = uTouch * max(near(vAlpha, uSides.x), near(vAlpha, uSides.y));
touch = max(touch, uOnCore * near(vAlpha, 1.5707963));
diffuseColor.rgb = mix(diffuseColor.rgb, uPress, touch * uPaint);`

export class Scene {
  readonly canvas: HTMLCanvasElement
  readonly #renderer: THREE.WebGLRenderer
  readonly #scene = new THREE.Scene()
  readonly #camera = new THREE.PerspectiveCamera(26, 1, 0.1, 500)
  readonly #controls: OrbitControls
  readonly #numbers = numbers()
  readonly #strand: THREE.InstancedMesh
  readonly #lids: [THREE.InstancedMesh, THREE.InstancedMesh]
  readonly #lines: THREE.InstancedMesh
  readonly #core: THREE.Mesh
  readonly #ply = new THREE.Group()
  readonly #material: THREE.MeshStandardMaterial
  #asked = false
  #shape: Shape | null = null
  #look: Look | null = null
  #moves: (() => void)[] = []
  #right = 0

  /** Throws where there is no WebGL. */
  constructor(place: HTMLElement) {
    this.#renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true })
    this.#renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    this.canvas = this.#renderer.domElement
    place.append(this.canvas)
    this.canvas.tabIndex = 0

    this.#material = new THREE.MeshStandardMaterial({ roughness: 0.55, metalness: 0 })
    this.#material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.#numbers)
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', `#include <common>\n${SURFACE}`)
        .replace('#include <beginnormal_vertex>', PLACE)
        .replace('#include <begin_vertex>', 'vec3 transformed = placed;')
      shader.fragmentShader = shader.fragmentShader
        .replace('#include <common>', `#include <common>\n${PAINT}`)
        .replace('#include <color_fragment>', `#include <color_fragment>\n${COLOUR}`)
    }
    this.#strand = new THREE.InstancedMesh(grid(), this.#material, MOST_DRAWN)
    const lid = () => new THREE.InstancedMesh(new THREE.BufferGeometry(), new THREE.MeshStandardMaterial({ roughness: 0.8, side: THREE.DoubleSide }), MOST_DRAWN)
    this.#lids = [lid(), lid()]
    this.#lines = new THREE.InstancedMesh(new THREE.BufferGeometry(), new THREE.MeshBasicMaterial({ color: 0x111111 }), MOST_DRAWN)
    this.#core = new THREE.Mesh(new THREE.CylinderGeometry(1, 1, 1, 64).rotateX(Math.PI / 2), new THREE.MeshStandardMaterial({ color: 0x999999, roughness: 0.7 }))
    for (const mesh of [this.#strand, ...this.#lids, this.#lines, this.#core]) {
      mesh.frustumCulled = false
      this.#ply.add(mesh)
    }
    this.#ply.rotation.x = -Math.PI / 2 // the axis stands upright
    this.#scene.add(this.#ply)

    const sky = new THREE.HemisphereLight(0xffffff, 0x8a8478, 1.5)
    const sun = new THREE.DirectionalLight(0xffffff, 2.2)
    sun.position.set(-4, 6, 7)
    const rim = new THREE.DirectionalLight(0xcfe3ff, 0.7)
    rim.position.set(6, 1, -4)
    this.#camera.add(sun, rim)
    this.#scene.add(sky, this.#camera)

    this.#controls = new OrbitControls(this.#camera, this.canvas)
    this.#controls.enablePan = false
    this.#controls.enableDamping = !isStill()
    this.#controls.minDistance = 12
    this.#controls.maxDistance = 110
    this.#controls.addEventListener('change', () => this.draw())
    this.#controls.touches.ONE = THREE.TOUCH.ROTATE
    this.home()
    this.canvas.addEventListener('keydown', (event) => this.#key(event))
    new ResizeObserver(() => this.#resize(place)).observe(place)
    this.#resize(place)
  }

  show(shape: Shape, look: Look): void {
    const before = this.#shape
    const rebuilt = before?.outline !== shape.outline || before.strands !== shape.strands
    this.#shape = shape
    this.#look = look
    const height = heightOf(shape)
    const low = -height / 2
    const high = low + height * (0.04 + 0.96 * look.cut)
    const n = Math.min(shape.strands, MOST_DRAWN)
    const u = this.#numbers
    u.uRadius.value = shape.radiusRatio
    u.uSin.value = Math.sin(shape.theta)
    u.uCos.value = Math.cos(shape.theta)
    u.uEps.value = shape.hand
    u.uLow.value = low
    u.uHigh.value = high
    u.uPretwist.value = shape.pretwist
    u.uStripes.value = look.stripes
    u.uSides.value.set(shape.sides[0] ?? 0, shape.sides[1] ?? 0)
    u.uTouch.value = shape.touching ? 1 : 0
    u.uOnCore.value = shape.corePressure > 0 ? 1 : 0
    u.uPress.value.set(pressureColour(shape.corePressure > 0 ? shape.corePressure : shape.pressure))
    u.uPaint.value = look.paint === 'pressure' ? 1 : 0

    this.#material.transparent = look.inside
    this.#material.opacity = look.inside ? 0.22 : 1
    this.#material.depthWrite = !look.inside
    this.#material.side = look.inside ? THREE.DoubleSide : THREE.FrontSide

    if (rebuilt) for (const lid of this.#lids) replace(lid, lidOf(shape.outline))
    this.#turn(this.#strand, n, shape.strands, 0, 0, 0)
    this.#turn(this.#lids[0], n, shape.strands, turnAt(shape, low), low, 0.25)
    this.#turn(this.#lids[1], n, shape.strands, turnAt(shape, high), high, 0.25)
    for (const lid of this.#lids) {
      const paper = lid.material as THREE.MeshStandardMaterial
      paper.transparent = look.inside
      paper.opacity = look.inside ? 0.55 : 1
      lid.visible = shape.theta < 1.45
    }

    this.#core.visible = shape.core !== null
    if (shape.core !== null) {
      this.#core.scale.set(shape.core, shape.core, high - low)
      this.#core.position.z = (high + low) / 2
    }
    this.#contactLines(shape, low, high, n)
    const size = 1 / thickness(shape)
    this.#ply.scale.setScalar(size)
    this.#ply.position.y = 0
    this.draw()
  }

  /** Instances one beside the other, each turned by its share. */
  #turn(mesh: THREE.InstancedMesh, n: number, total: number, azimuth: number, z: number, pale: number): void {
    const [matrix, colour] = [new THREE.Matrix4(), new THREE.Color()]
    mesh.count = n
    for (let i = 0; i < n; i++) {
      matrix.makeRotationZ(azimuth + (2 * Math.PI * i) / total).setPosition(0, 0, z)
      mesh.setMatrixAt(i, matrix)
      colour.set(STRANDS[i % STRANDS.length]!)
      if (pale > 0) colour.lerp(new THREE.Color(0xffffff), pale)
      if (this.#look?.paint === 'pressure' && pale > 0) colour.lerp(new THREE.Color(0xbbbbbb), 0.8)
      mesh.setColorAt(i, colour)
    }
    mesh.instanceMatrix.needsUpdate = true
    if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true
  }

  /** Helices of the contact line's radius, drawn as thin tubes. */
  #contactLines(shape: Shape, low: number, high: number, n: number): void {
    const [, , radius = 0, azimuth = 0] = shape.sides
    this.#lines.visible = shape.touching && shape.sides.length === 4
    if (!this.#lines.visible) return
    const [points, round, thick] = [200, 6, 0.07]
    const [position, index]: [number[], number[]] = [[], []]
    for (let i = 0; i <= points; i++) {
      const z = low + ((high - low) * i) / points
      const at = azimuth + turnAt(shape, z)
      for (let j = 0; j < round; j++) {
        const beta = (2 * Math.PI * j) / round
        const across = shape.theta < 0.8
        const out = radius + thick * Math.cos(beta)
        const off = thick * Math.sin(beta)
        position.push(out * Math.cos(at) - (across ? off * Math.sin(at) : 0), out * Math.sin(at) + (across ? off * Math.cos(at) : 0), z + (across ? 0 : off))
        if (i < points) {
          const [a, b] = [i * round + j, i * round + ((j + 1) % round)]
          index.push(a, b, a + round, b, b + round, a + round)
        }
      }
    }
    const geometry = new THREE.BufferGeometry()
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(position, 3))
    geometry.setIndex(index)
    replace(this.#lines, geometry)
    const dark = isDark()
    const paper = this.#lines.material as THREE.MeshBasicMaterial
    paper.color.set(this.#look?.paint === 'pressure' ? pressureColour(shape.pressure) : dark ? 0xffffff : 0x111111)
    const count = radius < 1e-9 ? 1 : n
    this.#lines.count = count
    const matrix = new THREE.Matrix4()
    for (let i = 0; i < count; i++) this.#lines.setMatrixAt(i, matrix.makeRotationZ((2 * Math.PI * i) / shape.strands))
    this.#lines.instanceMatrix.needsUpdate = true
  }

  /** Stands so many pixels to the right of the middle. */
  aside(right: number): void {
    this.#right = right
    this.#frame()
    this.draw()
  }

  #frame(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas
    if (this.#right !== 0 && width > 0) this.#camera.setViewOffset(width, height, -this.#right, 0, width, height)
    else this.#camera.clearViewOffset()
  }

  /** Back to where one begins to look. */
  home(): void {
    this.#camera.position.set(0, 12, 36)
    this.#controls.target.set(0, 0, 0)
    this.#controls.update()
    this.draw()
  }

  orbit(left: number, up: number): void {
    const sphere = new THREE.Spherical().setFromVector3(this.#camera.position)
    sphere.theta -= left
    sphere.phi = Math.min(Math.PI - 0.05, Math.max(0.05, sphere.phi - up))
    this.#camera.position.setFromSpherical(sphere)
    this.#controls.update()
    this.draw()
  }

  zoom(factor: number): void {
    const distance = Math.min(110, Math.max(12, this.#camera.position.length() / factor))
    this.#camera.position.setLength(distance)
    this.#controls.update()
    this.draw()
  }

  #key(event: KeyboardEvent): void {
    const step = 0.12
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.orbit(-step, 0), ArrowRight: () => this.orbit(step, 0), ArrowUp: () => this.orbit(0, step), ArrowDown: () => this.orbit(0, -step),
      '+': () => this.zoom(1.15), '=': () => this.zoom(1.15), '-': () => this.zoom(1 / 1.15), Home: () => this.home(), '0': () => this.home(),
    }
    const move = moves[event.key]
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return
    event.preventDefault()
    move()
  }

  #resize(place: HTMLElement): void {
    const { clientWidth: width, clientHeight: height } = place
    if (width === 0 || height === 0) return
    this.#renderer.setSize(width, height)
    this.#camera.aspect = width / height
    // narrow places show as much of the ply as wide ones
    this.#camera.fov = width / height < 0.62 ? 26 * (0.62 / (width / height)) : 26
    this.#frame()
    this.#camera.updateProjectionMatrix()
    this.#renderer.render(this.#scene, this.#camera) // at once: a new size wipes the picture
  }

  /** Once for each frame, however often it is asked for. */
  draw(): void {
    if (this.#asked) return
    this.#asked = true
    requestAnimationFrame(() => {
      this.#asked = false
      const moving = this.#controls.update()
      this.#renderer.render(this.#scene, this.#camera)
      for (const move of this.#moves) move()
      if (moving) this.draw()
    })
  }

  /** Called after each frame. */
  onDraw(move: () => void): void {
    this.#moves.push(move)
  }

  /** The picture as it stands. */
  png(): Promise<Blob | null> {
    this.#renderer.render(this.#scene, this.#camera)
    return new Promise((resolve) => this.canvas.toBlob(resolve, 'image/png'))
  }
}

/** A grid of shares along and angles round. */
function grid(): THREE.BufferGeometry {
  const position = new Float32Array((ALONG + 1) * (AROUND + 1) * 3)
  const index: number[] = []
  let at = 0
  for (let i = 0; i <= ALONG; i++) {
    for (let j = 0; j <= AROUND; j++) {
      position[at++] = i / ALONG
      position[at++] = (2 * Math.PI * j) / AROUND
      position[at++] = 0
      if (i < ALONG && j < AROUND) {
        const a = i * (AROUND + 1) + j
        index.push(a, a + AROUND + 1, a + 1, a + 1, a + AROUND + 1, a + AROUND + 2)
      }
    }
  }
  const geometry = new THREE.BufferGeometry()
  geometry.setAttribute('position', new THREE.BufferAttribute(position, 3))
  geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(position.length).fill(1), 3))
  geometry.setIndex(index)
  return geometry
}

function lidOf(outline: Float64Array): THREE.BufferGeometry {
  const points: THREE.Vector2[] = []
  for (let i = 0; i < outline.length; i += 2) points.push(new THREE.Vector2(outline[i], outline[i + 1]))
  return new THREE.ShapeGeometry(new THREE.Shape(points))
}

function replace(mesh: THREE.Mesh, geometry: THREE.BufferGeometry): void {
  mesh.geometry.dispose()
  mesh.geometry = geometry
}
