#!/usr/bin/env python3
"""The study as one would write it with numpy: cosine-distributed rays from 13 x 13 patches on each of the six faces of
a cube of side 6, 625 a patch, counted by the face they reach. Prints the processor seconds of one trial (the median of
several) and, so that one sees that it does the job, the two form factors averaged over faces and trials."""
import sys
import time

import numpy as np

EDGE, M, RAYS = 6.0, 13, 625


def hits_by_wall(rng, dtype):
    """Shoots all rays of one face; returns counts for (opposite, u = 0, u = EDGE, v = 0, v = EDGE)."""
    x = rng.random((M * M, RAYS, 4), dtype=dtype)
    row, column = np.divmod(np.arange(M * M), M)
    u = (column[:, None] + x[..., 0]) * dtype(EDGE / M)
    v = (row[:, None] + x[..., 1]) * dtype(EDGE / M)
    radius, azimuth = np.sqrt(x[..., 2]), dtype(2 * np.pi) * x[..., 3]
    du, dv, dn = radius * np.cos(azimuth), radius * np.sin(azimuth), np.sqrt(1 - x[..., 2])
    with np.errstate(divide="ignore"):
        to_u = np.where(du > 0, EDGE - u, u) / np.abs(du)
        to_v = np.where(dv > 0, EDGE - v, v) / np.abs(dv)
        to_opposite = EDGE / dn
    opposite = (to_opposite <= to_u) & (to_opposite <= to_v)
    across_u = ~opposite & (to_u < to_v)
    across_v = ~opposite & ~across_u
    return [np.count_nonzero(hits) for hits in (opposite, across_u & (du < 0), across_u & (du > 0),
                                                across_v & (dv < 0), across_v & (dv > 0))]


def trial(seed, dtype):
    """Form factors from each face to (opposite, four neighbours)."""
    rng = np.random.default_rng(seed)
    return np.array([hits_by_wall(rng, dtype) for _ in range(6)]) / (M * M * RAYS)


def main():
    trials = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    for dtype in (np.float64, np.float32):
        trial(0, dtype)
        seconds, factors = [], []
        for seed in range(1, trials + 1):
            start = time.process_time()
            factors.append(trial(seed, dtype))
            seconds.append(time.process_time() - start)
        mean = np.mean(factors, axis=(0, 1))
        print(f"{dtype.__name__} {np.median(seconds):.6f} parallel {mean[0]:.6f} adjacent {mean[1:].mean():.6f}")


if __name__ == "__main__":
    main()
