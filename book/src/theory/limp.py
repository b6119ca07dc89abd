"""Three limp strings under the end force 1: which moment holds them twisted?

By the work of the ends; by the strings' forces alone; by these over 1 - q.
"""
from math import cos, radians, sin, tan

from two_roads import touching

print("angle   work of the ends   R tan(angle)   the same over 1 - q")
for angle in (10, 20, 30, 40, 45, 50):
    t, h = radians(angle), 1e-5
    turned = sin(t + h) / touching(t + h)[1] - sin(t - h) / touching(t - h)[1]
    shorter = cos(t - h) - cos(t + h)
    x, R = touching(t)
    q = (x * R / 2) ** 2
    flat = R * tan(t)
    print(f"{angle:3} deg {shorter / turned:16.4f} {flat:14.4f} {flat / (1 - q):21.4f}")
