"""Three strands, twisted by -1 and let go: at which angle do they rest? Two roads, and nothing of nply on either.

Lengths in strand radii, stiffnesses in B. Python alone is needed.
"""
from math import cos, degrees, pi, radians, sin

N, GAMMA, PRETWIST = 3, 0.75, -1.0  # strands, C/B, pretwist; the ply is right-handed


def bisect(f, low, high):
    """The place between low and high where f changes its sign."""
    rising = f(high) > 0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if (f(middle) > 0) == rising else (middle, high)
    return (low + high) / 2


def touching(theta):
    """Shift x and radius R at which neighbours touch: the least distance (4) is 2, its slope (5) is 0."""
    s, c = sin(theta), cos(theta)
    x = bisect(lambda x: x * c * c + s * sin(x * s - 2 * pi / N), 0, 2 * pi / (N * s))
    return x, 2 / (2 + (x * c) ** 2 - 2 * cos(x * s - 2 * pi / N)) ** 0.5


def energy(theta):
    """Bending and twisting of a strand, per length."""
    R = touching(theta)[1]
    return sin(theta) ** 4 / (2 * R**2) + GAMMA / 2 * (PRETWIST + sin(theta) * cos(theta) / R) ** 2


def unbalance(theta, crossing):
    """What is left of the radial balance of moments (25) in a ply without loads.

    A plane across the ply is crossed by strands and, if crossing is 1, by contact forces: those of the stretch x R
    of contact between each two neighbours. Each is p1 (r1 - r2)/2, with an axial part and a moment about the axis.
    """
    s, c = sin(theta), cos(theta)
    x, R = touching(theta)
    beta = x * s - 2 * pi / N
    twist = PRETWIST + s * c / R
    axial_moment = s**3 / R + GAMMA * twist * c              # of the strand itself, (23)
    force = crossing * x * R * x * R * c / 2                 # per p1, axial: the stretch times its share
    moment = crossing * x * R * R * R * sin(-beta) / 2       # per p1, about the axis
    # (35): axial_moment + R hoop + moment p1 = 0;   (31), (30): hoop s/R = R p1 (1 - cos beta)
    p1 = -axial_moment / (R * R**2 * (1 - cos(beta)) / s + moment)
    hoop = R**2 * p1 * (1 - cos(beta)) / s
    axial = force * p1                                       # (34): strands pull as hard as contacts push
    return s**3 * c / R**2 - GAMMA * twist * s * s / R - hoop * c + axial * s


if __name__ == "__main__":
    h = 1e-5
    roads = {
        "least energy of touching strands": lambda t: energy(t + h) - energy(t - h),
        "forces, those of crossing contacts counted": lambda t: unbalance(t, 1),
        "forces, those of crossing contacts left out": lambda t: unbalance(t, 0),
    }
    for name, road in roads.items():
        print(f"{name:45}{degrees(bisect(road, radians(1), radians(44))):8.4f} deg")
