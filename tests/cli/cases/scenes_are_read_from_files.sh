#!/usr/bin/env bash
# Scene files as docs/scenes.md shows them.
page=$(cd "$(dirname "$0")/../../.." && pwd)/docs/scenes.md
source "$(dirname "$0")/../harness.sh"

blocks obj "$page" >furnace.obj
blocks "toml study" "$page" >furnace.toml
ffstudy run furnace.toml
expect_status 0
blocks "" "$page" | sed '0,/^\$ ffstudy run furnace.toml$/d; /^\$ /,$d' >"$folder/promised"
expect_equal_files "$folder/promised" "$folder/stdout"

# What leaves a face of the closed furnace arrives, and every pair keeps reciprocity within its errors: with 21 pairs,
# |z| above 5 has a chance of 1e-5 when all is well.
python3 - results/furnace/summary.csv <<'END' || fail "closure or reciprocity is broken"
import csv, math, sys
area = dict(floor=11, roof=12, south=10, north=10, east=7.5, west=7.5, block=7)
rows = list(csv.DictReader(open(sys.argv[1])))
sums = [float(r["mean"]) for r in rows if r["to_face"] == "sum"]
assert len(sums) == 7 and all(abs(s - 1) < 1e-12 for s in sums), sums
pairs = {(r["from_face"], r["to_face"]): (float(r["mean"]), float(r["std"] or 0) / math.sqrt(float(r["trials"])))
         for r in rows if r["from_face"] in area and r["to_face"] in area}
for (i, j), (f, e) in pairs.items():
    if i < j and (f or pairs[j, i][0]):
        g, d = pairs[j, i]
        z = (area[i] * f - area[j] * g) / math.hypot(area[i] * e, area[j] * d)
        assert abs(z) < 5, (i, j, z)
END

# The store needs the file no more; a changed file is another study.
mv furnace.obj gone
cp results/furnace/summary.csv kept.csv
ffstudy report results/furnace
expect_status 0
expect_equal_files kept.csv results/furnace/summary.csv
sed 's/2\.5$/2.6/' gone >furnace.obj
ffstudy run furnace.toml
expect_status 2
expect_stderr "holds another study"

# Every shape of the page, and what is doubted of it when it is said to be closed.
blocks "toml scene" "$page" >shapes.toml
sed 's/furnace.obj/shapes.toml/; s/"furnace"/"shapes"/; s/trials = 100/trials = 2/' furnace.toml >shapes_study.toml
ffstudy run shapes_study.toml
expect_status 0
sed -i '1i closed = true' shapes.toml
ffstudy run shapes_study.toml --out closed
expect_status 0
expect_stderr "rays meet nothing, though the scene is said to be closed (a hole, as seen from faces 'window'"

rm -rf -- *
# refuse FILE TEXT < SCENE
refuse() {
    cat >"$folder/$1"
    printf '[study]\nname = "t"\nscene = "%s"\ntrials = 2\nseed = 1\n[[method]]\nname = "a"\nsampler = "random"\nestimator = "%s"\nsamples_per_patch = 10\n' \
        "$1" "${3:-ray_shooting}" >"$folder/study.toml"
    ffstudy run "$folder/study.toml" --out out
    expect_refused 2 "$2"
}
refuse a.obj "a.obj:4: corner 3 is vertex 9 (the file has 2). Correct the index." <<<'v 0 0 0
v 1 0 0
g a
f 1 2 9'
refuse a.vs3 "a.vs3:2: no line of a View3D file begins with 'Q'." <<<'F 3
Q'
refuse a.toml "a.toml:1:12: shape: missing" <<<'surface = [{ face = "a" }]'
refuse b.toml "point_to_polygon cannot be used in scene 'b.toml' (not all of its surfaces are parallelograms)" point_to_polygon <<<'
surface = [{ face = "a", shape = "disc", centre = [0, 0, 0], normal = [0, 0, 1], radius = 1 }]'
