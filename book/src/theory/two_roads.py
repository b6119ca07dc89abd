"""Three strands, twisted by -1 and let go: at which angle do they rest?

Two roads lead there, and nothing of nply is on either. Lengths are in strand
radii, stiffnesses in B; numbers in brackets are equations of the paper.
"""
from math import cos, degrees, pi, radians, sin

N, GAMMA, PRETWIST = 3, 0.75, -1.0  # strands, C/B; the ply is right-handed


def bisect(f, low, high):
    """The place between low and high where f changes its sign."""
    rising = f(high) > 0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if (f(middle) > 0) == rising else (middle, high)
    return (low + high) / 2


def touching(theta):
    """Shift x and radius R: the least distance (4), of slope 0 (5), is 2."""
    s, c, turn = sin(theta), cos(theta), 2 * pi / N
    x = bisect(lambda x: x * c * c + s * sin(x * s - turn), 0, turn / s)
    return x, 2 / (2 + (x * c) ** 2 - 2 * cos(x * s - turn)) ** 0.5


def energy(theta):
    """Bending and twisting of a strand, per length (52), (53)."""
    s, c, R = sin(theta), cos(theta), touching(theta)[1]
    return s**4 / (2 * R**2) + GAMMA / 2 * (PRETWIST + s * c / R) ** 2


def unbalance(theta, crossing):
    """What is left of the radial balance of moments (25), without end loads.

    A plane across the ply is crossed by strands and, if crossing is 1, by the
    contact forces of the stretch x R of contact between each two neighbours:
    each p1 (r1 - r2)/2, with a part along the axis and a moment about it.
    """
    s, c = sin(theta), cos(theta)
    x, R = touching(theta)
    beta = x * s - 2 * pi / N
    twist = PRETWIST + s * c / R                         # (45)
    axial_moment = s**3 / R + GAMMA * twist * c          # of the strand (23)
    push = crossing * x * R * x * R * c / 2              # along the axis, per p1
    moment = crossing * x * R * R * R * sin(-beta) / 2   # about it, per p1
    # (31) with (30):  hoop = p1 arch
    # (35) and contacts:  axial_moment + R hoop + p1 moment = 0
    # (34) and contacts:  axial = p1 push
    arch = R**2 * (1 - cos(beta)) / s
    p1 = -axial_moment / (R * arch + moment)
    hoop, axial = p1 * arch, p1 * push
    return s**3 * c / R**2 - GAMMA * twist * s * s / R - hoop * c + axial * s


if __name__ == "__main__":
    h = 1e-5
    roads = {
        "least energy of touching strands": lambda t: energy(t + h) - energy(t - h),
        "forces, crossing contacts counted": lambda t: unbalance(t, 1),
        "forces, crossing contacts left out": lambda t: unbalance(t, 0),
    }
    for name, road in roads.items():
        print(f"{name:36}{degrees(bisect(road, radians(1), radians(44))):8.4f} deg")
