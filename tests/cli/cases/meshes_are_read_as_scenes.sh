#!/usr/bin/env bash
# STL, PLY, OFF, glTF, VTK, gmsh and EnergyPlus's input are scenes: a room in each has the exact factors of the box.
source "$(dirname "$0")/../harness.sh"

/usr/bin/python3 - <<'PYTHON'
import base64, json, struct
size = (4, 3, 2.5)
corners = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
places = [tuple(a * b for a, b in zip(corner, size)) for corner in corners]
walls = {"floor": (0, 1, 2, 3), "roof": (4, 7, 6, 5), "south": (0, 4, 5, 1), "east": (1, 5, 6, 2),
         "north": (2, 6, 7, 3), "west": (3, 7, 4, 0)}
triangles = {name: [q[:3], (q[0], q[2], q[3])] for name, q in walls.items()}
with open("room.stl", "w") as file:
    for name, two in triangles.items():
        facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % places[i] for i in t) +
                         "endloop\nendfacet\n" for t in two)
        file.write(f"solid {name}\n{facets}endsolid {name}\n")
with open("binary.stl", "wb") as file:
    every = [t for two in triangles.values() for t in two]
    file.write(bytes(80) + struct.pack("<I", len(every)))
    for t in every:
        file.write(bytes(12) + b"".join(struct.pack("<3f", *places[i]) for i in t) + bytes(2))
listed = "".join("%g %g %g\n" % p for p in places) + "".join("4 %d %d %d %d\n" % q for q in walls.values())
open("room.off", "w").write("OFF\n8 6 0\n" + listed)
open("room.ply", "w").write("ply\nformat ascii 1.0\nelement vertex 8\n" +
                            "".join(f"property float {c}\n" for c in "xyz") +
                            "element face 6\nproperty list uchar int vertex_indices\nend_header\n" + listed)
# EnergyPlus: seen from outside, in two zones, with a degree sign in Latin-1.
def outward(zone, name, quad):
    return f"BuildingSurface:Detailed,{name},Wall,Brick,{zone},Outdoors,,,,,4," + ", ".join(
        "%g,%g,%g" % places[i] for i in reversed(quad)) + ";\n"
open("room.IDF", "w", encoding="latin-1").write(
    "Version,9.5; ! 20 \xb0C\nGlobalGeometryRules,ULC,CCW,Relative;\nZone,Living room;\nZone,Attic;\n" +
    "".join(outward("Living Room", name, q) + outward("attic", f"{name} above", q) for name, q in walls.items()))
json.dump({"GlobalGeometryRules": {"1": {"vertex_entry_direction": "Clockwise", "coordinate_system": "World"}},
           "Zone": {"Living room": {}}, "BuildingSurface:Detailed": {name: {
               "zone_name": "Living room", "vertices": [{f"vertex_{a}_coordinate": x for a, x in zip("xyz", places[i])}
                                                        for i in q]} for name, q in walls.items()}},
          open("room.epJSON", "w"))
numbered = list(enumerate(walls.values()))
open("room.vtk", "wb").write(
    b"# vtk DataFile Version 3.0\nroom\nBINARY\nDATASET POLYDATA\nPOINTS 8 double\n" +
    b"".join(struct.pack(">3d", *p) for p in places) + b"\nPOLYGONS 6 30\n" +
    b"".join(struct.pack(">5i", 4, *q) for q in walls.values()) +
    b"\nCELL_DATA 6\nSCALARS wall int 1\nLOOKUP_TABLE default\n" + struct.pack(">6i", *range(6)))
open("room.vtu", "w").write(
    '<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"><UnstructuredGrid>'
    '<Piece NumberOfPoints="8" NumberOfCells="7"><Points><DataArray type="Float64" NumberOfComponents="3">' +
    " ".join("%g %g %g" % p for p in places) + '</DataArray></Points><Cells>'
    '<DataArray type="Int32" Name="connectivity">' + " ".join("%d %d %d %d" % q for q in walls.values()) +
    ' 0 1 2 3 4 5 6 7</DataArray><DataArray type="Int32" Name="offsets">4 8 12 16 20 24 32</DataArray>'
    '<DataArray type="UInt8" Name="types">9 9 9 9 9 9 12</DataArray></Cells><CellData>'
    '<DataArray type="Int32" Name="wall">0 1 2 3 4 5 9</DataArray></CellData></Piece></UnstructuredGrid></VTKFile>')
open("room.msh", "w").write(
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n6\n" +
    "".join(f'2 {k + 1} "{name}"\n' for k, name in enumerate(walls)) + "$EndPhysicalNames\n$Nodes\n8\n" +
    "".join("%d %g %g %g\n" % (k + 1, *p) for k, p in enumerate(places)) + "$EndNodes\n$Elements\n6\n" +
    "".join("%d 3 2 %d 1 %d %d %d %d\n" % (k + 1, k + 1, *(i + 1 for i in q)) for k, q in numbered) + "$EndElements\n")
# A node for each wall of a unit cube, whose scale makes it the room; one is mirrored, with its corners turned round.
data, views, accessors, meshes, nodes = b"", [], [], [], []
for name, quad in walls.items():
    scale = [-s if name == "east" and k == 1 else s for k, s in enumerate(size)]
    points = [[p / s for p, s in zip(places[i], scale)] for i in quad]
    order = (0, 2, 1, 0, 3, 2) if name == "east" else (0, 1, 2, 0, 2, 3)
    for bytes_, kind, count, type_ in ((b"".join(struct.pack("<3f", *p) for p in points), 5126, 4, "VEC3"),
                                       (struct.pack("<6H", *order), 5123, 6, "SCALAR")):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(bytes_)})
        accessors.append({"bufferView": len(views) - 1, "componentType": kind, "count": count, "type": type_})
        data += bytes_
    accessors[-2] |= {"min": [min(c) for c in zip(*points)], "max": [max(c) for c in zip(*points)]}
    meshes.append({"primitives": [{"attributes": {"POSITION": len(accessors) - 2}, "indices": len(accessors) - 1,
                                   "material": 0 if name in ("floor", "roof") else 1}]})
    nodes.append({"name": name, "mesh": len(meshes) - 1, "scale": scale})
open("the places.bin", "wb").write(data)
within = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
for file, uri in ("room.gltf", within), ("room_beside.gltf", "the%20places.bin"):
    json.dump({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(6))}], "nodes": nodes,
               "meshes": meshes, "materials": [{"name": "red brick"}, {"name": "steel"}], "accessors": accessors,
               "bufferViews": views, "buffers": [{"byteLength": len(data), "uri": uri}]}, open(file, "w"))
PYTHON

ffstudy form-factors box:4x3x2.5 --out box --quiet
expect_status 0
# expect_box FOLDER: the factors are those of the box, whose faces are in another order.
expect_box() {
    /usr/bin/python3 - "$1" <<'PYTHON' || fail "expected the factors of the box in $1"
import sys
from arrays import load
order = [0, 5, 1, 3, 2, 4]  # of the box, as floor, roof, south, east, north, west; opposite walls are alike
areas, factors = load("box/areas.npy"), load("box/form_factors.npy")
found_areas, found = load(f"{sys.argv[1]}/areas.npy"), load(f"{sys.argv[1]}/form_factors.npy")
for i, a in enumerate(order):
    assert abs(found_areas[i] - areas[a]) < 1e-12
    for j, b in enumerate(order):
        assert abs(found[i][j] - factors[a][b]) < 1e-12, found
PYTHON
}
for file in room.stl room.gltf room_beside.gltf; do
    ffstudy form-factors $file --closed --out of_$file
    expect_status 0
    expect_stdout "F from           to floor            to roof           to south            to east"
    expect_box of_$file
done
ffstudy form-factors binary.stl --closed
expect_status 0
expect_stdout "1 face of 12 surfaces, joined to 6"
for file in room.ply room.off; do
    ffstudy form-factors $file --closed --faces polygon --out of_$file
    expect_status 0
    expect_box of_$file
done

for file in room.vtk room.vtu room.msh; do
    ffstudy form-factors $file --closed --out of_$file
    expect_status 0
    expect_box of_$file
done
expect_stdout "F from           to floor            to roof           to south            to east"
ffstudy form-factors room.vtu --closed
expect_stderr "1 volume cell is left out"
head -c 300 room.msh >"$folder/cut.msh"

# A zone is chosen; what is handed back has its name and those of its surfaces.
ffstudy form-factors room.epJSON --out of_epjson --format energyplus
expect_status 0
expect_box of_epjson
grep -qx "  Living room,  !- Zone or ZoneList or Space or SpaceList Name" of_epjson/energyplus.idf || fail "expected the zone's name"
ffstudy form-factors room.IDF --zone attic --out of_idf --format energyplus
expect_status 0
expect_box of_idf
grep -q "^  floor above, roof above, 0" of_idf/energyplus.idf || fail "expected the names of surfaces"
ffstudy form-factors --load of_idf
expect_stdout "room.IDF zone:Attic: 6 faces"
ffstudy explain "room.IDF zone:living room"
expect_status 0
expect_stdout "roof: area 12"

# Materials are faces, and names in a materials file; the store needs the mesh no longer.
ffstudy form-factors room.gltf --closed --faces material --out materials
expect_status 0
expect_stdout "red_brick"
printf '[materials]\nred_brick = { emissivity = 0.9, temperature = 300 }\nsteel = { emissivity = 0.3, temperature = 400 }\n' >m.toml
ffstudy heat room.gltf --closed --materials m.toml
expect_status 0
expect_stdout "floor"
rm room.gltf
ffstudy form-factors --load materials
expect_status 0

# A study has meshes, too.
mv room.stl room.IDF "$folder" && rm -r ./*
ffstudy explain "$folder/room.stl"
expect_status 0
expect_stdout "roof: area 12"

echo "solid nothing" >"$folder/bad.stl"
ffstudy form-factors "$folder/bad.stl" --out out
expect_refused 2 "bad.stl:2: solid nothing: it ends here, and more has to follow (it was cut off)"
ffstudy form-factors "$folder/cut.msh" --out out
expect_refused 2 "cut.msh:29: \$Elements: it ends here, and more has to follow (it was cut off). Write it again."
ffstudy form-factors "$folder/room.IDF" --out out
expect_refused 2 "2 zones (an enclosure is one of them): 'Living room', 'Attic'. Choose by --zone"
ffstudy form-factors cube --zone attic
expect_refused 2 "'cube' is no input file of EnergyPlus"
ffstudy form-factors missing.glb --out out
expect_refused 3 "missing.glb: cannot be read (No such file or directory)"
ffstudy form-factors cube --faces material
expect_refused 2 "neither an OBJ file nor a mesh"
