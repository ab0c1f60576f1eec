#!/usr/bin/env python3
"""Published form factors beside those of ffstudy and of formulas and quadratures that share no code with it.

Usage: compare.py FFSTUDY [VALUES.csv]

Prints the tables of docs/beside-others.md. Exit code 1: an interval of ffstudy and the independent value exclude each
other, or an output of View3D is further from ffstudy than it should be. values.csv has the published values, `within`
is the accuracy that they are given with, and `by` says what is computed here; `rays` are of docs/examples/shoot.py, with
three standard errors. view3d.csv is what View3D prints of its four examples, openviewfactor.csv the expected values of
OpenViewFactor that need no scene."""
import csv
import math
import pathlib
import subprocess
import sys
import tempfile
from math import acos, asin, atan, cos, log, pi, sin, sqrt

HERE = pathlib.Path(__file__).resolve().parent
TOLERANCES = {"urban.obj": "1e-3", "sphere_to_disc.toml": "1e-4", "two_spheres.toml": "1e-4", "spheres_1.toml": "1e-4",
              "spheres_1_5.toml": "1e-4", "spheres_2.toml": "1e-4"}
VIEW3D = {"cube.vs3": 1e-6, "squares.vs3": 1e-5, "l_room_shapes.vs3": 5e-5, "l_room.vs3": 2e-4}  # largest difference


def legendre(n):
    """Nodes and weights of Gauss and Legendre's rule on [0, 1], by Newton's iteration."""
    rule = []
    for k in range(n):
        x = cos(pi * (k + 0.75) / (n + 0.5))
        for _ in range(100):
            p, before = 1.0, 0.0
            for j in range(n):
                p, before = ((2 * j + 1) * x * p - j * before) / (j + 1), p
            slope = n * (x * p - before) / (x * x - 1)
            step = p / slope
            x -= step
            if abs(step) < 1e-15:
                break
        rule.append((0.5 * (1 + x), 1 / ((1 - x * x) * slope * slope)))
    return rule


def mean(f, low, high, n=24):
    return sum(weight * f(low + (high - low) * node) for node, weight in legendre(n))


def parallel_plates(width, length, gap):
    x, y = width / gap, length / gap
    p, q = sqrt(1 + x * x), sqrt(1 + y * y)
    return 2 / (pi * x * y) * (log(p * q / sqrt(1 + x * x + y * y)) + x * q * atan(x / q) + y * p * atan(y / p)
                               - x * atan(x) - y * atan(y))


def common_edge(edge, a, b):
    """Area times form factor of rectangles a and b deep, at right angles along a common edge."""
    if a == 0 or b == 0:
        return 0.0
    w, h = a / edge, b / edge
    s, ww, hh = w * w + h * h, w * w, h * h
    logs = log((1 + ww) * (1 + hh) / (1 + s)) + ww * log(ww * (1 + s) / ((1 + ww) * s)) + hh * log(hh * (1 + s) / ((1 + hh) * s))
    return edge * edge / pi * (w * atan(1 / w) + h * atan(1 / h) - sqrt(s) * atan(1 / sqrt(s)) + logs / 4)


def perpendicular(width, a0, a1, b0, b1):
    """From a0 to a1 away from the line in which two planes meet at right angles, to b0 to b1 in the other."""
    flow = (common_edge(width, a1, b1) + common_edge(width, a0, b0) - common_edge(width, a0, b1)
            - common_edge(width, a1, b0))
    return flow / (width * (a1 - a0))


def concentric_spheres(inner, outer):
    return (inner / outer) ** 2


def around(inner, outer):
    """From a sphere to one around it."""
    return 1.0 if inner < outer else 0.0


def disc_to_disc(first, second, gap):
    s = 1 + (gap * gap + second * second) / (first * first)
    return (s - sqrt(s * s - 4 * (second / first) ** 2)) / 2


def coaxial_cylinders(inner, outer, height):
    """From the outside of the inner one to the inside of the outer one, of equal height."""
    r, h = outer / inner, height / inner
    a, b = h * h + r * r - 1, h * h - r * r + 1
    return 1 - (acos(b / a) - (sqrt((a + 2) ** 2 - 4 * r * r) * acos(b / (r * a)) + b * asin(1 / r) - pi * a / 2) / (2 * h)) / pi


def past_a_cylinder(inner, outer, height):
    """From the inner one to all that is not hidden by the outer one."""
    return 1 - coaxial_cylinders(inner, outer, height)


def sphere_to_disc(radius, distance):
    return (1 - 1 / sqrt(1 + (radius / distance) ** 2)) / 2


def corner(a, b, gap):
    """From an element below the corner of a rectangle parallel to it."""
    a, b = a / gap, b / gap
    p, q = sqrt(1 + a * a), sqrt(1 + b * b)
    return (a / p * atan(b / p) + b / q * atan(a / q)) / (2 * pi)


def past_the_screen():
    """From (x, y) the screen hides of the far square what lies within 1 - x and 1 - y of a corner."""
    def seen(x, y):
        whole = corner(x, y, 1) + corner(1 - x, y, 1) + corner(x, 1 - y, 1) + corner(1 - x, 1 - y, 1)

        def part(u, v):  # a corner on the other side of the element counts negatively
            return math.copysign(1, u) * math.copysign(1, v) * corner(abs(u), abs(v), 1)
        return whole - (part(1 - 2 * x, 1 - 2 * y) + part(1 - 2 * x, y) + part(x, 1 - 2 * y) + part(x, y))
    return mean(lambda x: mean(lambda y: seen(x, y), 0, 1), 0, 1)


def contour(first, second, area):
    """Stokes' double contour integral of ln r, from the first polygon of this area to the second."""
    total, rule = 0.0, legendre(24)
    for p, q in zip(first, first[1:] + first[:1]):
        for r, s in zip(second, second[1:] + second[:1]):
            along = sum((b - a) * (d - e) for a, b, e, d in zip(p, q, r, s))
            for t, wt in rule if along else ():
                for u, wu in rule:
                    gap = math.dist([a + t * (b - a) for a, b in zip(p, q)], [a + u * (b - a) for a, b in zip(r, s)])
                    total += wt * wu * along * log(gap)
    return total / (2 * pi * area)


def at_45_degrees():
    c = sqrt(0.5)
    return contour([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)],
                   [(c, 0, c), (c, 1, c), (2 * c, 1, 2 * c), (2 * c, 0, 2 * c)], 1)


def triangles():
    return contour([(1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 1), (1, 1, 1), (1, 0, 1)], 0.5)


def rectangle_to_disc():
    """The factor from an element to a parallel disc, over a quarter of the rectangle."""
    gap, radius = 0.2, 0.1

    def element(x, y):
        a2, h2, r2 = x * x + y * y, gap * gap, radius * radius
        z = a2 + h2 + r2
        return (1 - (z - 2 * r2) / sqrt(z * z - 4 * r2 * a2)) / 2
    return mean(lambda x: mean(lambda y: element(x, y), 0, 0.1), 0, 0.05)


def two_spheres(small, large, distance):
    """The factor from an element of the small sphere to the large one, wholly or partly above its horizon."""
    def element(polar):
        across, along = small * sin(polar), distance - small * cos(polar)
        d = math.hypot(across, along)
        h, tilt = d / large, acos(max(-1.0, min(1.0, (along * cos(polar) - across * sin(polar)) / d)))
        if tilt + asin(1 / h) <= pi / 2:
            return cos(tilt) / (h * h)
        if tilt - asin(1 / h) >= pi / 2:
            return 0.0
        root = sqrt(h * h - 1)
        return (0.5 - asin(root / (h * sin(tilt))) / pi
                + (cos(tilt) * acos(-root / math.tan(tilt)) - root * sqrt(1 - (h * cos(tilt)) ** 2)) / (pi * h * h))
    top = math.acos((small + large) / distance)     # an element further round sees nothing of the large sphere
    whole = math.acos((small - large) / distance)
    cut = sorted((0.0, top, whole, pi))
    return sum((b - a) / 2 * mean(lambda t: element(t) * sin(t), a, b, 60) for a, b in zip(cut, cut[1:]))


def plate_to_cylinder():
    """Strips of the cylinder that an element of the plate sees; the ends lie in the planes of the plate's edges."""
    radius, axis = 0.05, 0.1

    def strip(x, angle, y):
        """An element at (x, y), and a line on the cylinder: per unit of angle."""
        px, pz = radius * sin(angle), axis - radius * cos(angle)
        dx, r2 = px - x, (px - x) ** 2 + pz * pz
        r = sqrt(r2)
        facing = -(dx * sin(angle) - pz * cos(angle))

        def primitive(l):
            return l / (2 * r2 * (r2 + l * l)) + atan(l / r) / (2 * r2 * r)
        return radius * pz * facing / pi * (primitive(0.5 - y) - primitive(-0.5 - y))

    def element(x, y):
        middle, half = math.atan2(x, axis), acos(radius / math.hypot(x, axis))
        return 2 * half * mean(lambda angle: strip(x, angle, y), middle - half, middle + half)
    return mean(lambda x: mean(lambda y: element(x, y), -0.5, 0.5), 0, 0.25)


def formula(text):
    """The value of `name(number; number)`."""
    name, numbers = text.rstrip(")").split("(")
    return globals()[name](*map(float, filter(None, numbers.split(";"))))


def independent(row):
    """The value and its error."""
    if row["by"] == "rays":
        return float(row["independent"]), float(row["error"])
    return formula(row["by"]), 1e-8


def run(program, *arguments):
    done = subprocess.run([program, *arguments, "--quiet"], stderr=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(f"{' '.join(arguments)}: exit code {done.returncode}\n{done.stderr}")


def factors(program, scene, folder):
    """(from, to): factor, low, high."""
    out = folder / scene
    run(program, "form_factors", str(HERE / scene), "--tolerance", TOLERANCES.get(scene, "1e-5"), "--out", str(out))
    with open(out / "matrix.csv") as file:
        return {(r["from"], r["to"]): tuple(float(r[k]) for k in ("factor", "low", "high")) for r in csv.DictReader(file)}


def exchange(program, scene, folder):
    """(from, to): script-F, low, high, at the emissivities of the file. Temperatures do not matter."""
    (folder / "materials.toml").write_text('[materials]\n"*" = { temperature = 300 }\n')
    run(program, "heat", str(HERE / scene), "--materials", str(folder / "materials.toml"), "--tolerance", "1e-5",
        "--gebhart", "--out", str(folder / scene))
    with open(folder / scene / "gebhart.csv") as file:
        limits = {(r["from"], r["to"]): (float(r["script_f_low"]), float(r["script_f_high"])) for r in csv.DictReader(file)}
    return {pair: ((low + high) / 2, low, high) for pair, (low, high) in limits.items()}


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve()) if "/" in sys.argv[1] else sys.argv[1]
    failed = []
    with open(sys.argv[2] if len(sys.argv) > 2 else HERE / "values.csv") as file:
        rows = list(csv.DictReader(file))
    with open(HERE / "view3d.csv") as file:
        printed = list(csv.DictReader(file))
    with open(HERE / "openviewfactor.csv") as file:
        expected = [(r["by"], abs(formula(r["by"]) - float(r["published"]))) for r in csv.DictReader(file)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        found = {scene: factors(program, scene, folder) for scene in dict.fromkeys(row["scene"] for row in rows)}
        emitting = exchange(program, "l_room.vs3", folder)
    for source in dict.fromkeys(row["source"] for row in rows):
        print(f"{source}\n\n| scene | factor | published | ffstudy: interval | independent | published is off by |\n|---|---|--:|---|--:|--:|")
        for row in (row for row in rows if row["source"] == source):
            value, error = independent(row)
            published = float(row["published"])
            factor, low, high = found[row["scene"]][row["from"], row["to"]]
            if value + error < low or value - error > high:
                failed.append(f"{row['scene']}: {row['from']} to {row['to']}")
            off = published - (value if row["by"] != "rays" else factor)
            said = f"{off:+.1e}, {100 * off / factor:+.1f} %" if abs(off) > float(row["within"]) else "agrees"
            shown = f"{value:.7f}" if row["by"] != "rays" else f"{value:.5f} ± {error:.2g}"
            digits = min(12, max(6, 1 - math.floor(math.log10(max(high - low, 1e-12)))))
            print(f"| {row['scene']} | {row['from']} to {row['to']} | {row['published']} | {low:.{digits}f} … {high:.{digits}f} "
                  f"| {shown} | {said} |")
        print()
    print("View3D, all that it prints\n\n| scene | values | largest difference |\n|---|--:|--:|")
    for scene, allowed in VIEW3D.items():
        ours = emitting if scene == "l_room.vs3" else found[scene]
        differences = [abs(float(r["printed"]) - ours.get((r["from"], r["to"]), (0.0,))[0]) for r in printed if r["scene"] == scene]
        print(f"| {scene} | {len(differences)} | {max(differences):.1e} |")
        if max(differences) > allowed:
            failed.append(f"{scene}: View3D differs by {max(differences):.1e}")
    print(f"\nOpenViewFactor, without scenes: {len(expected)} expected values, largest difference {max(off for _, off in expected):.1e}")
    failed += [f"{by}: the expected value differs by {off:.1e}" for by, off in expected if off > 1e-12]
    for what in failed:
        print(f"differs: {what}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
