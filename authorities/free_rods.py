"""n free elastic rods in contact: what `simulate.py` runs. Nothing here knows of helices, of their contact or of their balance.

Rods. Round, radius 1, bending stiffness 1, torsional stiffness gamma; they do not shear. The centreline of each is a cubic B-spline with N spans in a cell
of strand length L; every control point is free in space.

Cell. It goes on: what follows is the cell again, moved by h along z and turned by phi about z, both unknown. Dead loads: the force works on h, the
moment on phi. The unknowns are kept less their share of that screw motion, point i turned back by phi i/N, which is a choice of coordinates only.

Twist. Both ends of a strand are turned against each other by pretwist * L and glued: the frame at the end of the cell is the one at its start, turned by
phi with the cell and by pretwist * L about the strand. A round rod without friction twists evenly, so one number per strand says its
twist: Tw = pretwist * L + phi - (area on the sphere between the tangent and z), the last being what a frame carried along without twist has turned by
(Calugareanu, Fuller); and its energy is gamma Tw^2 / 2L. It needs tangents
that do not turn back against z: `seen` tells how far the steepest is from z.

Contact. A spring against the overlap 2 - d. d is the distance from a point of one strand (two Gauss points a span) to the nearest
point of another's spline; where there are several minima, each counts. Strands may stretch against a spring too. Both springs are stiff, and the limit is taken outside.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("XLA_FLAGS", "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1")

import jax
import jax.numpy as jnp
import numpy as np
import scipy.linalg

jax.config.update("jax_enable_x64", True)

GAUSS_3 = (np.array([0.5 - np.sqrt(0.15), 0.5, 0.5 + np.sqrt(0.15)]), np.array([5.0, 8.0, 5.0]) / 18.0)
GAUSS_2 = (np.array([0.5 - np.sqrt(1.0 / 12.0), 0.5 + np.sqrt(1.0 / 12.0)]), np.array([0.5, 0.5]))


# ---------------------------------------------------------------- splines


def basis(u):
    """What four control points weigh in a uniform cubic B-spline at u in [0, 1), with the first two derivatives in u; times six."""
    v = 1.0 - u
    value = [v**3, 3 * u**3 - 6 * u**2 + 4, -3 * u**3 + 3 * u**2 + 3 * u + 1, u**3]
    first = [-3 * v**2, 9 * u**2 - 12 * u, -9 * u**2 + 6 * u + 3, 3 * u**2]
    second = [6 * v, 18 * u - 12, -18 * u + 6, 6 * u]
    return value, first, second


def weights(u):
    """The basis at one place, for JAX to differentiate."""
    return tuple(jnp.stack([jnp.asarray(w, dtype=float) for w in row]) / 6.0 for row in basis(u))


def weights_at(u):
    """The basis at an array of places."""
    return tuple(np.stack(row, axis=-1) / 6.0 for row in basis(u))


def screwed(points, along, h, phi):
    """Points moved on by `along` cells: turned by along * phi about z and shifted by along * h."""
    c, s = jnp.cos(along * phi), jnp.sin(along * phi)
    x, y, z = points[..., 0], points[..., 1], points[..., 2]
    return jnp.stack([c * x - s * y, s * x + c * y, z + along * h], axis=-1)


# ---------------------------------------------------------------- energies of a span, and of a point of contact


def span(dofs, spans, length, stretching):
    """Bending and stretching energy of one span, and the area on the sphere between its tangents and z."""
    control, h, phi = dofs[:12].reshape(4, 3), dofs[12], dofs[13]
    control = screwed(control, jnp.arange(4.0) / spans, h, phi)
    step = length / spans
    bending = area = arc = 0.0
    for u, w in zip(*GAUSS_3):
        _, first, second = weights(u)
        d1, d2 = first @ control, second @ control
        speed = jnp.sqrt(d1 @ d1)
        turn = jnp.cross(d1, d2)
        bending += 0.5 * w * (turn @ turn) / speed**5
        area += w * turn[2] / (speed * (speed + d1[2]))
        arc += w * speed
    return jnp.stack([bending + 0.5 * stretching * step * (arc / step - 1.0) ** 2, area])


def between(dofs, u, v, apart, spans):
    """Distance from the point u of one span to the nearest point, near v, of another that starts `apart` spans further on."""
    one, other, h, phi = dofs[:12].reshape(4, 3), dofs[12:24].reshape(4, 3), dofs[24], dofs[25]
    point = weights(u)[0] @ screwed(one, jnp.arange(4.0) / spans, h, phi)
    other = screwed(other, (apart + jnp.arange(4.0)) / spans, h, phi)
    # v is where the distance is least already; this step only lets it move along when the rods do
    value, first, second = (w @ other for w in weights(v))
    off = point - value
    v = v + (off @ first) / (first @ first - off @ second)
    off = point - weights(v)[0] @ other
    return jnp.sqrt(off @ off)


def contact(dofs, u, v, apart, weight, spans, stiffness):
    overlap = jnp.maximum(2.0 - between(dofs, u, v, apart, spans), 0.0)
    return 0.5 * stiffness * weight * overlap**2


def on_core(dofs, u, weight, spans, stiffness, core):
    """The same against a rigid cylinder of radius `core` about z."""
    control, h, phi = dofs[:12].reshape(4, 3), dofs[12], dofs[13]
    point = weights(u)[0] @ screwed(control, jnp.arange(4.0) / spans, h, phi)
    overlap = jnp.maximum(1.0 + core - jnp.sqrt(point[0] ** 2 + point[1] ** 2), 0.0)
    return 0.5 * stiffness * weight * overlap**2


def with_slopes(f, constants, vector=False):
    """f and its first two derivatives, over many elements at once; the last `constants` arguments are shared."""

    def all_three(dofs, *rest):
        return f(dofs, *rest), (jax.jacrev(f) if vector else jax.grad(f))(dofs, *rest), jax.hessian(f)(dofs, *rest)

    arguments = f.__code__.co_argcount
    axes = tuple(0 if i < arguments - constants else None for i in range(arguments))
    return jax.jit(jax.vmap(all_three, in_axes=axes))


SPAN = with_slopes(span, 3, vector=True)
CONTACT = with_slopes(contact, 2)
CORE = with_slopes(on_core, 3)


# ---------------------------------------------------------------- the ply


class Cell:
    """A cell of the ply. Its unknowns: control points less the screw motion's share, (n, N, 3); then h and phi."""

    def __init__(self, case, spans, length, stiffness):
        self.case, self.n, self.spans, self.length = case, case["n"], spans, length
        self.contact_stiffness, self.stretching = stiffness, 10.0 * stiffness
        self.size = 3 * self.n * spans + 2
        strand, first = (a.ravel() for a in np.meshgrid(np.arange(self.n), np.arange(spans), indexing="ij"))
        self.span_strand, self.span_dofs = strand, self.dofs_of(strand, first)
        ends = np.full((len(strand), 2), [self.size - 2, self.size - 1])
        self.span_dofs = np.concatenate([self.span_dofs, ends], axis=1)

    def dofs_of(self, strand, first):
        """Where the twelve numbers of the span that starts at `first` stand among the unknowns."""
        node = (np.asarray(first)[:, None] + np.arange(4)) % self.spans
        start = 3 * (np.asarray(strand)[:, None] * self.spans + node)
        return (start[:, :, None] + np.arange(3)).reshape(len(start), 12)

    def control(self, x, strand, first):
        """Control points of spans that may lie in any cell, where they are in space, (…, 4, 3)."""
        along = (np.asarray(first)[..., None] + np.arange(4)) / self.spans
        node = (np.asarray(first)[..., None] + np.arange(4)) % self.spans
        q = x[:-2].reshape(self.n, self.spans, 3)[np.asarray(strand)[..., None], node]
        c, s = np.cos(along * x[-1]), np.sin(along * x[-1])
        return np.stack(
            [c * q[..., 0] - s * q[..., 1], s * q[..., 0] + c * q[..., 1], q[..., 2] + along * x[-2]], axis=-1
        )

    def points(self, x, strand, place):
        """Points, first and second derivatives by span, at places counted in spans from the start of the cell."""
        first = np.floor(place).astype(int)
        w = weights_at(place - first)
        control = self.control(x, strand, first)
        return tuple(np.einsum("...a,...ac->...c", one, control) for one in w)

    def touching(self, x, reach=2.5):
        """Pairs of places at which one strand is near another and the distance is least: (strand, place, other, place there)."""
        u, _ = GAUSS_2
        own = (np.arange(self.spans)[:, None] + u).ravel()
        per = 3
        far = np.arange(-self.spans * per, 2 * self.spans * per) / per
        found = []
        for k in range(self.n):
            here = self.points(x, np.full(own.shape, k), own)[0]
            for j in range(self.n):
                if j == k:
                    continue
                there = self.points(x, np.full(far.shape, j), far)[0]
                d2 = ((here[:, None] - there[None]) ** 2).sum(axis=2)
                least = (d2[:, 1:-1] <= d2[:, :-2]) & (d2[:, 1:-1] < d2[:, 2:]) & (d2[:, 1:-1] < reach**2)
                at, to = np.nonzero(least)
                found.append(np.stack([np.full(len(at), k), own[at], np.full(len(at), j), far[to + 1]], axis=1))
        found = np.concatenate(found)
        k, s, j, t = found[:, 0].astype(int), found[:, 1], found[:, 2].astype(int), found[:, 3]
        here = self.points(x, k, s)[0]
        for _ in range(30):
            value, first, second = self.points(x, j, t)
            off = here - value
            slope = (off * first).sum(axis=1)
            curve = (first * first).sum(axis=1) - (off * second).sum(axis=1)
            step = np.where(curve > 0, slope / np.where(curve > 0, curve, 1.0), np.sign(slope) * 0.1)
            t = t + np.clip(step, -0.3, 0.3)
        # minima that two neighbouring samples lead to count once; what did not settle is a distance without a minimum
        settled = (np.abs(step) < 1e-9) & (curve > 0)
        key = np.stack([k, np.round(s, 6), j, np.round(t, 6)], axis=1)[settled]
        keep = np.nonzero(settled)[0][np.unique(key, axis=0, return_index=True)[1]]
        distance = np.sqrt(((here - self.points(x, j, t)[0]) ** 2).sum(axis=1))
        return k[keep], s[keep], j[keep], t[keep], distance[keep]

    def energy(self, x):
        """Energy of the cell and its loads, with its gradient and Hessian."""
        case, size = self.case, self.size
        total, gradient, hessian = 0.0, np.zeros(size), np.zeros((size, size))

        def add(values, first, second, dofs):
            nonlocal total
            total += values.sum()
            np.add.at(gradient, dofs, first)
            np.add.at(hessian, (dofs[:, :, None], dofs[:, None, :]), second)

        values, first, second = self.padded(SPAN, x[self.span_dofs], (), self.spans, self.length, self.stretching)
        add(values[:, 0], first[:, 0], second[:, 0], self.span_dofs)

        # twist: even along each strand, C Tw²/2L
        for k in range(self.n):
            mine = self.span_strand == k
            twist = case["pretwist"] * self.length + x[-1] - values[mine, 1].sum()
            slope = np.zeros(size)
            np.add.at(slope, self.span_dofs[mine], -first[mine, 1])
            slope[-1] += 1.0
            stiffness = case["gamma"] / self.length
            total += 0.5 * stiffness * twist**2
            gradient += stiffness * twist * slope
            hessian += stiffness * np.outer(slope, slope)
            dofs = self.span_dofs[mine]
            np.add.at(hessian, (dofs[:, :, None], dofs[:, None, :]), -stiffness * twist * second[mine, 1])

        # contact: each pair is met twice, once from each strand, with half the spring
        k, s, j, t, distance = self.touching(x)
        near = distance < 2.0
        k, s, j, t = k[near], s[near], j[near], t[near]
        if len(k):
            i, to = np.floor(s).astype(int), np.floor(t).astype(int)
            ends = np.full((len(k), 2), [size - 2, size - 1])
            dofs = np.concatenate([self.dofs_of(k, i), self.dofs_of(j, to), ends], axis=1)
            weight = np.full(len(k), 0.5 * 0.5 * self.length / self.spans)
            add(
                *self.padded(
                    CONTACT,
                    x[dofs],
                    (s - i, t - to, (to - i).astype(float), weight),
                    self.spans,
                    self.contact_stiffness,
                ),
                dofs,
            )
        if case["core"] is not None:
            u, w = GAUSS_2
            for at, share in zip(u, w):
                count = len(self.span_dofs)
                weight = np.full(count, share * self.length / self.spans)
                shared = (self.spans, self.contact_stiffness, case["core"])
                add(*self.padded(CORE, x[self.span_dofs], (np.full(count, at), weight), *shared), self.span_dofs)

        total -= case["force"] * x[-2] + case["moment"] * x[-1]
        gradient[-2] -= case["force"]
        gradient[-1] -= case["moment"]
        return total, gradient, hessian

    @staticmethod
    def padded(f, dofs, constants, *shared):
        """f over as many elements as there are, filled up to a size it was compiled for."""
        count = len(dofs)
        fill = -count % 256
        pad = lambda a: np.concatenate([a, np.repeat(a[:1], fill, axis=0)]) if fill else a
        return tuple(np.asarray(a)[:count] for a in f(pad(dofs), *(pad(c) for c in constants), *shared))

    # ------------------------------------------------------------ what a state is

    def start(self, angle, noise, seed):
        """Strands apart on a circle at some angle to z, each then bent at random, whatever the number of spans."""
        random = np.random.default_rng(seed)
        radius = 1.1 * (1.0 if self.n == 2 else 1.0 / np.sin(np.pi / self.n))
        if self.case["core"] is not None:
            radius = max(radius, 1.1 * (1.0 + self.case["core"]))
        azimuth = 2.0 * np.pi * np.arange(self.n) / self.n
        q = np.zeros((self.n, self.spans, 3))
        q[:, :, 0], q[:, :, 1] = radius * np.cos(azimuth)[:, None], radius * np.sin(azimuth)[:, None]
        along = 2.0 * np.pi * np.arange(self.spans) / self.spans
        for mode in range(1, 6):
            for wave in (np.cos(mode * along), np.sin(mode * along)):
                q += noise / mode * random.standard_normal((self.n, 1, 3)) * wave[None, :, None]
        angle = np.radians(angle)
        return np.concatenate([q.ravel(), [self.length * np.cos(angle), self.length * np.sin(angle) / radius]])

    def seen(self, x):
        """What the state looks like: angle, how even it is, radius, contact."""
        place = (np.arange(self.spans)[:, None] + GAUSS_3[0]).ravel()
        strand = np.repeat(np.arange(self.n), len(place))
        point, tangent, _ = self.points(x, strand, np.tile(place, self.n))
        speed = np.sqrt((tangent**2).sum(axis=1))
        arc = (speed.reshape(self.n, self.spans, 3) @ GAUSS_3[1]).sum(axis=1)
        local = np.degrees(np.arctan2(np.hypot(tangent[:, 0], tangent[:, 1]), tangent[:, 2]))
        theta = np.degrees(np.arccos(x[-2] / arc.mean()))
        radius = np.hypot(point[:, 0], point[:, 1])
        distance = self.touching(x)[-1]
        near = distance < 2.0
        force = self.contact_stiffness * (2.0 - distance[near])
        total = 0.5 * 0.5 * force.sum() * self.length / self.spans
        return {
            "theta": theta,
            "uneven": np.abs(local - theta).max(),
            "steepest": local.max(),
            "radius": radius.mean(),
            "extension": x[-2] / self.length,
            "rotation": x[-1] / self.length,
            "contact_force": total / (self.n * self.length),
            "touching": int(near.sum()),
        }


# ---------------------------------------------------------------- down to the least energy


def least(cell, x, tolerance=1e-9, most=400):
    """Newton steps, damped so that each one lowers the energy, until the gradient is nothing."""
    damping = 1.0
    energy, gradient, hessian = cell.energy(x)
    for turn in range(most):
        if np.abs(gradient).max() < tolerance:
            break
        while True:
            try:
                factor = scipy.linalg.cho_factor(hessian + damping * np.eye(cell.size))
                step = -scipy.linalg.cho_solve(factor, gradient)
                if np.abs(step).max() < 0.5:
                    break
            except np.linalg.LinAlgError:
                pass
            damping *= 4.0
        promised = -(gradient @ step + 0.5 * step @ hessian @ step)
        after = cell.energy(x + step)
        gained = energy - after[0]
        # where the gain drowns in rounding, a smaller gradient tells
        if gained > 0.05 * promised or (abs(promised) < 1e-10 and np.abs(after[1]).max() < np.abs(gradient).max()):
            x = x + step
            energy, gradient, hessian = after
            damping = max(damping * (0.2 if gained > 0.5 * promised or abs(promised) < 1e-10 else 1.0), 1e-8)
        else:
            damping *= 5.0
            if damping > 1e12:
                break
    return x, np.abs(gradient).max(), turn
