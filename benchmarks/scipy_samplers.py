#!/usr/bin/env python3
"""Time per 4-D point of the samplers of numpy and scipy.stats.qmc, to compare with benchmarks/samplers.cpp.

Processor time of one thread, the best of several sets of 65536 points, randomisation included."""
import time

import numpy as np
from scipy.stats import qmc

POINTS = 65536

SAMPLERS = {
    "random (PCG64)": lambda: np.random.default_rng(1).random((POINTS, 4)),
    "random_mt": lambda: np.random.Generator(np.random.MT19937(1)).random((POINTS, 4)),
    "sobol_lms": lambda: qmc.Sobol(4, scramble=True, seed=1).random(POINTS),
    "sobol_raw": lambda: qmc.Sobol(4, scramble=False).random(POINTS),
    "halton": lambda: qmc.Halton(4, scramble=True, seed=1).random(POINTS),
    "latin_hypercube": lambda: qmc.LatinHypercube(4, seed=1).random(POINTS),
}

for name, fill in SAMPLERS.items():
    best = float("inf")
    for _ in range(5):
        start = time.process_time()
        fill()
        best = min(best, time.process_time() - start)
    print(f"{name:16} {1e9 * best / POINTS:7.1f} ns a point")
