"""Form factors of an OBJ scene by ray shooting: python3 shoot.py SCENE RAYS SEED prints from,to,estimate."""

import sys

import numpy as np


def read(file):
    """Triangles (n, 3, 3), and the face of each. Faces are groups; the group "occluder" is in the way and is none."""
    vertices, triangles, owners, group = [], [], [], "1"
    for words in map(str.split, open(file)):
        if words[:1] == ["v"]:
            vertices.append([float(x) for x in words[1:4]])
        elif words[:1] == ["g"]:
            group = words[1]
        elif words[:1] == ["f"]:
            corners = [vertices[i if i < 0 else i - 1] for i in map(int, words[1:])]
            for b, c in zip(corners[1:], corners[2:]):
                triangles.append([corners[0], b, c])
                owners.append(group)
    return np.array(triangles), np.array(owners)


def shoot(triangles, rays, rng):
    """Origins and directions from random points of these triangles, cosine-distributed about their normals."""
    a, u, v = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    normals = np.cross(u, v)
    areas = np.linalg.norm(normals, axis=1)
    at = rng.choice(len(areas), rays, p=areas / areas.sum())
    s, t = rng.random((2, rays))
    s, t = np.where(s + t > 1, [1 - s, 1 - t], [s, t])
    origins = a[at] + s[:, None] * u[at] + t[:, None] * v[at]
    up = normals[at] / areas[at][:, None]
    along = u[at] / np.linalg.norm(u[at], axis=1)[:, None]
    radius, turn = np.sqrt(rng.random(rays)), 2 * np.pi * rng.random(rays)
    plane = np.cos(turn)[:, None] * along + np.sin(turn)[:, None] * np.cross(up, along)
    return origins, radius[:, None] * plane + np.sqrt(1 - radius**2)[:, None] * up


def first_hits(origins, directions, triangles):
    """The triangle that each ray meets first, -1 where there is none, and whether on the side that it radiates to."""
    nearest = np.full(len(origins), np.inf)
    hit = np.full(len(origins), -1)
    front = np.zeros(len(origins), bool)
    for number, (a, b, c) in enumerate(triangles):
        u, v = b - a, c - a
        p = np.cross(directions, v)
        with np.errstate(divide="ignore", invalid="ignore"):
            scale = 1 / (p @ u)
            s = np.einsum("ij,ij->i", origins - a, p) * scale
            q = np.cross(origins - a, u)
            t = np.einsum("ij,ij->i", directions, q) * scale
            distance = q @ v * scale
            meets = (s >= 0) & (t >= 0) & (s + t <= 1) & (distance > 1e-9) & (distance < nearest)
        nearest[meets], hit[meets] = distance[meets], number
        front[meets] = scale[meets] > 0
    return hit, front


triangles, owners = read(sys.argv[1])
rng = np.random.default_rng(int(sys.argv[3]))
faces = [name for name in dict.fromkeys(owners.tolist()) if name != "occluder"]
print("from,to,estimate")
for face in faces:
    rays = int(sys.argv[2])
    hit, front = first_hits(*shoot(triangles[owners == face], rays, rng), triangles)
    seen = owners[hit[(hit >= 0) & front]]
    for other in faces:
        print(f"{face},{other},{np.count_nonzero(seen == other) / rays!r}")
