"""Form factors of convex faces with nothing in between, and the errors that SciPy claims of them.

python3 quadrature.py SCENE.obj TOLERANCE prints from,to,estimate,error: double contour integrals of ln r by adaptive
quadrature, each edge of one face with each edge of the other. The claim is the sum of what scipy.integrate.quad says.
"""

import sys
import warnings

import numpy as np
from scipy.integrate import IntegrationWarning, quad


def read(file):
    """The corners of each face, which is one polygon."""
    vertices, faces, group = [], {}, "1"
    for words in map(str.split, open(file)):
        if words[:1] == ["v"]:
            vertices.append(np.array([float(x) for x in words[1:4]]))
        elif words[:1] == ["g"]:
            group = words[1]
        elif words[:1] == ["f"]:
            faces[group] = [vertices[i if i < 0 else i - 1] for i in map(int, words[1:])]
    return faces


def area(corners):
    return np.linalg.norm(sum(np.cross(a, b) for a, b in zip(corners, corners[1:] + corners[:1]))) / 2


def of_edges(a, b, c, d, tolerance):
    """The integral of ln r over both edges, times the cosine between them, and its claimed error."""
    weight = (b - a) @ (d - c)
    if abs(weight) < 1e-12:
        return 0.0, 0.0
    claimed = 0.0

    def inner(s):
        nonlocal claimed
        x = a + s * (b - a)
        value, error = quad(lambda t: np.log(np.linalg.norm(c + t * (d - c) - x) + 1e-300), 0, 1, epsabs=tolerance)
        claimed = max(claimed, error)
        return value

    value, error = quad(inner, 0, 1, epsabs=tolerance)
    return weight * value, abs(weight) * (error + claimed)


warnings.simplefilter("ignore", IntegrationWarning)
faces = read(sys.argv[1])
print("from,to,estimate,error")
for one, corners in faces.items():
    for other, theirs in faces.items():
        if one == other:
            continue
        edges = zip(corners, corners[1:] + corners[:1])
        parts = [
            of_edges(a, b, c, d, float(sys.argv[2])) for a, b in edges for c, d in zip(theirs, theirs[1:] + theirs[:1])
        ]
        value, error = np.sum(parts, axis=0) / (2 * np.pi * area(corners))
        print(f"{one},{other},{value!r},{error!r}")
