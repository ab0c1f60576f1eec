#!/usr/bin/env bash
# Files for other programs hold the matrix to the last digit, read as those programs read them.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

cat >"$folder/read.py" <<'PYTHON'
"""Reads every format by its own rules, and compares with the matrix that the program keeps."""
import csv, json, re, sys
from arrays import dense, load
folder, matrix, closed = sys.argv[1], sys.argv[2], sys.argv[3] == "closed"
expected = load(f"{folder}/{matrix}.npy")
areas = load(f"{folder}/areas.npy")
n = len(areas)
text = lambda name: open(f"{folder}/{name}").read()
rows = list(csv.DictReader(open(f"{folder}/intervals.csv")))
names = {int(r["row"]): r["from"] for r in rows}
names = [names[i + 1] for i in range(n)]

def empty():
    return [[0.0] * n for _ in range(n)]

def same(what, found):
    assert found == expected, f"{what}\n{found}\n{expected}"

# View3D: its reader takes the first line, then numbers in any layout.
head, rest = text("view3d.txt").split("\n", 1)
assert head.split()[0] == "View3D" and [int(x) for x in head.split()[2:]] == [0, int(closed), 0, n] and len(head) >= 30
numbers = [float(word) for word in rest.split()]
assert numbers[:n] == areas and len(numbers) == n * (n + 2)
same("view3d", [numbers[n * i:n * (i + 1)] for i in range(1, n + 1)])

# EnergyPlus: fields between commas, comments from "!"; the same object as JSON.
fields = [f.strip() for f in re.sub("!.*", "", text("energyplus.idf")).strip().rstrip(";").split(",")]
kind, zone, triples = fields[0], fields[1], fields[2:]
assert len(triples) == 3 * n * n == 3 * len(set(zip(triples[::3], triples[1::3])))
found = empty()
for a, b, f in zip(triples[::3], triples[1::3], triples[2::3]):
    found[names.index(a)][names.index(b)] = float(f)
same("idf", found)
objects = json.loads(text("energyplus.epJSON"))[kind]
(one,) = objects.values()
assert one["zone_or_zonelist_or_space_or_spacelist_name"] == zone == "furnace"
assert len({(f["from_surface"], f["to_surface"]) for f in one["view_factors"]}) == n * n
found = empty()
for f in one["view_factors"]:
    found[names.index(f["from_surface"])][names.index(f["to_surface"])] = f["view_factor"]
same("epJSON", found)

# MOOSE: a list of lists between quotes, rows parted by semicolons.
if closed:
    moose = {key: word or words for key, word, words in re.findall(r"(\w+) = (?:([^'\s]+)|'([^']*)')", text("moose.i"))}
    assert moose["type"] == "ConstantViewFactorSurfaceRadiation" and moose["boundary"].split() == names
    same("moose", [[float(f) for f in row.split()] for row in moose["view_factors"].split(";")])

# OpenFOAM: lists of lists, "3(a b c)", behind a header.
def lists(name, kind):
    head, body = re.fullmatch(r"FoamFile\s*\{(.*?)\}\s*(.*)", text(f"openfoam/{name}"), re.S).groups()
    assert dict(re.findall(r"(\w+)\s+(\S+);", head)) == {"version": "2.0", "format": "ascii", "class": kind,
                                                         "location": '"constant"', "object": name}
    count, body = re.fullmatch(r"(\d+)\s*\((.*)\)\s*", body, re.S).groups()
    found = [(int(k), inside.split()) for k, inside in re.findall(r"(\d+)\(([^()]*)\)", body)]
    assert len(found) == int(count) and all(k == len(inside) for k, inside in found)
    return [inside for _, inside in found]
found = empty()
for i, (faces, factors) in enumerate(zip(lists("globalFaceFaces", "labelListList"), lists("F", "scalarListList"))):
    assert len(faces) == len(factors)
    for k, f in zip(faces, factors):
        found[i][int(k)] = float(f)
same("openfoam", found)

# Elmer: a count for each element, then as many lines of row, column, factor.
words = iter(text("ViewFactors.dat").split())
found = empty()
for i in range(n):
    for _ in range(int(next(words))):
        row, column, factor = int(next(words)), int(next(words)), float(next(words))
        assert row == i + 1
        found[row - 1][column - 1] = factor
assert next(words, None) is None
same("elmer", found)

# SciPy, and the intervals.
same("npz", dense(load(f"{folder}/{matrix}.npz"), n))
found = empty()
for r in rows:
    found[int(r["row"]) - 1][int(r["column"]) - 1] = float(r["factor"])
    assert float(r["low"]) <= float(r["high"])
    if matrix == "form_factors":
        assert float(r["low"]) <= float(r["factor"]) <= float(r["high"]), r
same("intervals", found)
PYTHON

all=view3d,energyplus,moose,openfoam,elmer
blocks obj "$root/docs/scenes.md" 1 >furnace.obj
ffstudy form-factors furnace.obj --tolerance 1e-3 --out plain --format $all
expect_status 0
/usr/bin/python3 "$folder/read.py" plain form_factors closed || fail "the estimates are not what was handed on"
cp -r plain broken && sed -i '$d' broken/ViewFactors.dat
! /usr/bin/python3 "$folder/read.py" broken form_factors closed 2>/dev/null || fail "a lost line was not noticed"
# Later, and repaired.
ffstudy form-factors --load plain --repair --out repaired --format $all --quiet
expect_status 0
/usr/bin/python3 "$folder/read.py" repaired repaired closed || fail "the repaired matrix is not what was handed on"
# An open scene.
mkdir open && sed "/closed/d" furnace.obj >open/furnace.obj
ffstudy form-factors open/furnace.obj --tolerance 1e-3 --out of_open --format view3d,energyplus,openfoam,elmer
expect_status 0
/usr/bin/python3 "$folder/read.py" of_open form_factors open || fail "the open scene is not what was handed on"

# What a format cannot say is refused before anything is computed.
mv open "$folder" && rm -r ./*
ffstudy form-factors "$folder/open/furnace.obj" --format moose --out out
expect_refused 2 "is open (rows have to add up to 1 there)"
sed 's/south/FLOOR/' "$folder/open/furnace.obj" >"$folder/twice.obj"
ffstudy form-factors "$folder/twice.obj" --format energyplus --out out
expect_refused 2 "two faces are 'FLOOR' in capitals"
sed 's/south/a;b/' "$folder/open/furnace.obj" >"$folder/mark.obj"
ffstudy form-factors "$folder/mark.obj" --format energyplus --out out
expect_refused 2 "face 'a;b'"
ffstudy form-factors cube --format energyplu --out out
expect_refused 2 "Did you mean 'energyplus'?"
ffstudy form-factors cube --format elmer
expect_refused 2 "--out"
