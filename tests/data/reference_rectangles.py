#!/usr/bin/env python3
"""Form factors of rectangles from contour integrals, independent of the corner sums in core/formulas/rectangle_formulas.cpp.

    python3 tests/data/reference_rectangles.py > tests/data/reference_rectangles.csv     (needs python3-mpmath)

By Stokes' theorem A_1 F_12 is 1/(2 pi) times the integral of ln r over both contours. Here the inner integral is
elementary and the outer one tanh-sinh quadrature with 30 digits. Rows that carry a printed value (from 18-digit
evaluations of Howell's catalogue of configuration factors) keep it; the script fails if the integral disagrees.
"""

from mpmath import atan, log, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 30


class Rectangle:
    """An interval along each axis, "low:high", of length 0 along the normal, and the normal: "0:1 0:1 0:0 +z"."""

    def __init__(self, text):
        *intervals, normal = text.split()
        self.extent = [[mpf(end) for end in interval.split(":")] for interval in intervals]
        self.axis = "xyz".index(normal[1])
        self.side = 1 if normal[0] == "+" else -1

    def area(self):
        product = mpf(1)
        for axis, (low, high) in enumerate(self.extent):
            if axis != self.axis:
                product *= high - low
        return product

    def contour(self):
        """Directed edges, counterclockwise about the normal."""
        first, second = (self.axis + 1) % 3, (self.axis + 2) % 3
        corners = []
        for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))[:: self.side]:
            corner = [low for low, _ in self.extent]
            corner[first], corner[second] = self.extent[first][i], self.extent[second][j]
            corners.append(corner)
        return list(zip(corners, corners[1:] + corners[:1]))


def integral_of_log_distance(edge, other):
    """The integral of ln r dr.dr' over two directed edges along the axes."""
    directions = [[end - begin for begin, end in zip(*e)] for e in (edge, other)]
    product = sum(d * e for d, e in zip(*directions))
    if product == 0:
        return mpf(0)
    along = next(axis for axis in range(3) if directions[0][axis] != 0)
    apart = sqrt(sum((edge[0][axis] - other[0][axis]) ** 2 for axis in range(3) if axis != along))

    def antiderivative(x):  # of ln sqrt(x^2 + apart^2)
        if apart == 0:
            return x * log(abs(x)) - x if x != 0 else mpf(0)
        return x * log(apart**2 + x**2) / 2 - x + apart * atan(x / apart)

    low, high = sorted(point[along] for point in edge)
    other_low, other_high = sorted(point[along] for point in other)
    pieces = [low] + sorted(x for x in (other_low, other_high) if low < x < high) + [high]
    value = quad(lambda x: antiderivative(other_high - x) - antiderivative(other_low - x), pieces)
    return value if product > 0 else -value


def exchange_area(source, target):
    return sum(integral_of_log_distance(e, f) for e in source.contour() for f in target.contour()) / (2 * pi)


def row(name, description, source, target, printed=None, front=None):
    """`front`: the parts of source and target in front of each other, where that is not all of them."""
    parts = [Rectangle(text) for text in front or (source, target)]
    factor = exchange_area(*parts) / Rectangle(source).area()
    if printed:
        assert abs(mpf(printed) - factor) < mpf(10) ** -17, (name, factor)
    print(f"{name},{description},{source},{target},{printed or nstr(factor, 17)}")


print("id,description,from,to,form_factor")
row("R01", "opposite faces of a cube", "0:1 0:1 0:0 +z", "0:1 0:1 1:1 -z", "0.199824895698387383")
row("R02", "adjacent faces of a cube", "0:1 0:1 0:0 +z", "0:1 0:0 0:1 +y", "0.200043776075403154")
row("R03", "parallel; 2 x 1; gap 1", "0:2 0:1 0:0 +z", "0:2 0:1 1:1 -z", "0.285875384850714718")
row("R04", "parallel squares; gap a tenth of the side", "0:10 0:10 0:0 +z", "0:10 0:10 1:1 -z", "0.826994522397256578")
row("R05", "parallel squares; gap ten sides", "0:1 0:1 0:0 +z", "0:1 0:1 10:10 -z", "0.00316205683875760163")
row("R07", "common edge; unequal", "0:1 0:0.5 0:0 +z", "0:1 0:0 0:2 +y", "0.314601082023923048")
row("L01", "walls of an L-shaped room; unobstructed", "0:3 0:0 0:3 +y", "0:1 3:3 0:3 -y", "0.0638614906349356924")
row("P01", "parallel; partly overlapping", "0:2 0:1.5 0:0 +z", "0.5:3 -1:0.75 0.25:0.25 -z")
row("P02", "parallel; shifted aside", "-2:-2 0:1 0:1 +x", "0.5:0.5 3:4.5 -2:-1.5 -x")
row("P03", "parallel; close; only corners face each other", "0:1 0:0 0:1 +y", "1:2 0.125:0.125 1:2 -y")
row("Q01", "perpendicular; nothing in common", "0:1 0.5:1.5 0:0 +z", "0.25:2 0:0 0.5:1 +y")
row("Q02", "perpendicular; a corner in common", "0:1 0:1 0:0 +z", "1:2.5 0:0 0:1 +y")
row("Q03", "perpendicular; part of an edge in common", "0:1 0:1 0:0 +z", "0.25:3 0:0 0:2 +y")
row("Q04", "perpendicular; far; shifted along the edge", "0:0.25 0.125:0.25 0:0 +z", "5:5.5 0:0 1:1.25 +y")
row("Q05", "perpendicular; other planes and sides", "2:2 0:1 0:3 -x", "-1:1.5 0:1 3:3 -z")
row("S01", "T-junction: the source straddles the target's plane", "0:1 -1:0.5 0:0 +z", "0.25:0.75 0:0 0:1 +y",
    front=("0:1 0:0.5 0:0 +z", "0.25:0.75 0:0 0:1 +y"))
row("S02", "each straddles the other's plane", "0:1 -1:2 0:0 -z", "0:2 0.5:0.5 -0.75:1 -y",
    front=("0:1 -1:0.5 0:0 -z", "0:2 0.5:0.5 -0.75:0 -y"))
