#!/usr/bin/env python3
"""Time per 4-D point of the samplers of numpy, scipy.stats.qmc and, where it is installed, OpenTURNS, to compare with
benchmarks/samplers.cpp.

Processor time of one thread, the best of several sets of 65536 points, randomisation included. OpenTURNS does not
randomise, and its base is the number of coordinates: time is per four of them."""
import time

import numpy as np
from scipy.stats import qmc

try:
    import openturns
except ImportError:
    openturns = None

POINTS = 65536

SAMPLERS = {
    "random (PCG64)": lambda: np.random.default_rng(1).random((POINTS, 4)),
    "random_mt": lambda: np.random.Generator(np.random.MT19937(1)).random((POINTS, 4)),
    "sobol_lms": lambda: qmc.Sobol(4, scramble=True, seed=1).random(POINTS),
    "sobol_raw": lambda: qmc.Sobol(4, scramble=False).random(POINTS),
    "halton": lambda: qmc.Halton(4, scramble=True, seed=1).random(POINTS),
    "latin_hypercube": lambda: qmc.LatinHypercube(4, seed=1).random(POINTS),
}
ALPHAS = 1.16730397826141868426 ** -np.arange(1.0, 5.0)
LATTICE = np.array([1, 6906571, 12751639, 4408903])
SAMPLERS["r_sequence (numpy)"] = lambda: (np.random.default_rng(1).random(4) + np.outer(np.arange(POINTS), ALPHAS)) % 1
SAMPLERS["lattice (numpy)"] = lambda: (np.random.default_rng(1).random(4) + np.outer(np.arange(POINTS) / POINTS, LATTICE)) % 1
if openturns is not None:
    for base in (5, 7, 11, 13):
        SAMPLERS[f"faure_{base} (OpenTURNS)"] = lambda base=base: openturns.FaureSequence(base).generate(POINTS * 4 // base)

for name, fill in SAMPLERS.items():
    best = float("inf")
    for _ in range(5):
        start = time.process_time()
        fill()
        best = min(best, time.process_time() - start)
    print(f"{name:21} {1e9 * best / POINTS:7.1f} ns a point")
