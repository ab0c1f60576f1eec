#!/usr/bin/env bash
# STL, PLY, OFF and glTF: sound, cut off, with elements that mean nothing here, with an absurd count; and glTF that the
# library which reads it would take for something else. (readers_tests has more about each format.)
source "$(dirname "$0")/../harness.sh"

/usr/bin/python3 - <<'PYTHON'
import base64, json, struct
places = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
lines = "".join("%d %d %d\n" % place for place in places)
def ply(vertices=4, faces=1, more="", end="4 0 1 2 3\n"):
    return (f"ply\nformat ascii 1.0\nelement vertex {vertices}\n" + "".join(f"property float {c}\n" for c in "xyz") +
            f"element face {faces}\nproperty list uchar int vertex_indices\n{more}end_header\n" + lines + end)
def off(vertices=4, faces=1):
    return f"OFF\n{vertices} {faces} 0\n{lines}4 0 1 2 3\n"
def facet(a, b, c):
    return "facet normal 0 0 1\nouter loop\n" + "".join("vertex %d %d %d\n" % places[i] for i in (a, b, c)) + "endloop\nendfacet\n"
stl = f"solid a\n{facet(0, 1, 2)}{facet(0, 2, 3)}endsolid a\n"
def binary_stl(triangles=2):
    return bytes(80) + struct.pack("<I", triangles) + b"".join(
        bytes(12) + b"".join(struct.pack("<3f", *places[i]) for i in t) + bytes(2) for t in ((0, 1, 2), (0, 2, 3)))
data = b"".join(struct.pack("<3f", *place) for place in places) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
def gltf(indices=6, vertices=4, node={}, mesh={}, places={}, **more):
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, **node}],
        "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": vertices, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0], **places},
                      {"bufferView": 1, "componentType": 5123, "count": indices, "type": "SCALAR"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}], **mesh}], **more})
huge = 4000000000
files = {
    "sound.ply": ply(), "sound.off": off(), "sound.stl": stl, "sound_binary.stl": binary_stl(), "sound.gltf": gltf(),
    "sound_unknown.ply": ply(more="element colour 1\nproperty float red\n", end="4 0 1 2 3\n0.5\n"),
    "sound_unknown.gltf": gltf(animals=[1], extensionsUsed=["MINE_unknown"]),
    "sound_unknown.stl": stl.replace("endloop", "endloop "), "sound_comment.off": "OFF # squares\n# of four\n" + off()[4:],
    "sound_materials.gltf": gltf(extensionsRequired=["KHR_materials_unlit"], extensionsUsed=["KHR_materials_unlit"]),
    "broken_skin.gltf": gltf(node={"skin": 0}, skins=[{"joints": [0]}]),
    "broken_header.ply": "ply\nformat ascii 1.0\nelement vertex 8\nprop",
    "broken_required.gltf": gltf(extensionsRequired=["XYZ_nonsense"]),
    "broken_quantised.gltf": gltf(places={"componentType": 5122, "normalized": True}),
    "broken_instances.gltf": gltf(node={"extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0}}}}),
    "broken_morph.gltf": gltf(mesh={"weights": [1.0]}), "broken_morph_node.gltf": gltf(node={"weights": [0.25]}),
    "broken_cut.ply": ply()[:-30], "broken_cut.off": off()[:-14], "broken_cut.stl": stl[:90],
    "broken_cut_binary.stl": binary_stl()[:-30], "broken_cut.gltf": gltf()[:300],
    "broken_vertices.ply": ply(huge), "broken_faces.ply": ply(4, huge), "broken_vertices.off": off(huge),
    "broken_faces.off": off(4, huge), "broken_count.stl": binary_stl(huge), "broken_indices.gltf": gltf(huge),
    "broken_vertices.gltf": gltf(6, huge)}
for name, content in files.items():
    open(name, "wb").write(content if isinstance(content, bytes) else content.encode())
PYTHON

for file in sound*; do
    ffstudy explain $file
    expect_status 0
    expect_stdout ": area 1"
done
# An absurd count takes no memory (in KiB); sanitizers reserve terabytes.
ldd "$program" | grep -E 'lib[at]san' >/dev/null || ulimit -v 4000000
for file in broken*; do
    ffstudy explain $file
    expect_status 2
    expect_stderr "ffstudy: $file"
done
