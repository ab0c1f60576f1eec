#!/usr/bin/env python3
"""Prints the expected values of area_kernel.cpp: the patch-to-patch integral of cos cos / (pi r^2) over the unit cube
by tensor Gauss-Legendre points, summed as it is defined. All patches of a face are summed at once, which is the same as
patch by patch. Columns: m, nodes on source and target patch, F parallel, F adjacent, row sum."""
import numpy as np


def face_rule(m, nodes):
    """Points and weights on [0,1]^2 cut into m x m patches."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    x = ((np.arange(m)[:, None] + (1 + x) / 2) / m).ravel()
    w = np.tile(w / 2 / m, m)
    a, b = np.meshgrid(x, x)
    return a.ravel(), b.ravel(), np.outer(w, w).ravel()


def form_factor(points, weights, normal, targets, target_weights, target_normal):
    total = 0.0
    for point, weight in zip(points, weights):
        d = targets - point
        cosines = np.maximum(d @ normal, 0) * np.maximum(-(d @ target_normal), 0)
        total += weight * (target_weights * cosines / (np.pi * (d * d).sum(1) ** 2)).sum()
    return total


x, y, z = np.eye(3)
for m, source_nodes, target_nodes in [(6, 5, 5), (9, 5, 5), (13, 5, 5), (6, 5, 6), (6, 5, 2)]:
    a, b, w = face_rule(m, source_nodes)
    c, d, v = face_rule(m, target_nodes)
    floor = np.c_[a, b, 0 * a]
    parallel = form_factor(floor, w, z, np.c_[c, d, 0 * c + 1], v, -z)
    adjacent = form_factor(floor, w, z, np.c_[c, 0 * c, d], v, y)
    print(m, source_nodes, target_nodes, f"{parallel:.9f} {adjacent:.9f} {parallel + 4 * adjacent:.9f}")
