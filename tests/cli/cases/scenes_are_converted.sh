#!/usr/bin/env bash
# A scene is the same in every format that can hold it; round surfaces become polygons on request only.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

blocks obj "$root/docs/scenes.md" >furnace.obj
ffstudy form-factors furnace.obj --tolerance 1e-3 --out 0 --quiet
expect_status 0
before=furnace.obj
for next in 1.vs3 2.toml 3.obj; do
    ffstudy convert $before $next
    expect_status 0
    expect_stdout "$next: 7 faces of 18 surfaces"
    ffstudy form-factors $next --tolerance 1e-3 --out $next.out --quiet
    expect_status 0
    expect_equal_files 0/matrix.csv $next.out/matrix.csv
    before=$next
done

# A unit sphere in a larger one, with 64 facets around each: all radiation of the inner one reaches the outer one.
cat >spheres.toml <<'END'
closed = true
[[surface]]
face = "inner sphere"
shape = "sphere"
centre = [0, 0, 0]
radius = 1
facing = "outward"
[[surface]]
face = "outer"
shape = "sphere"
centre = [0, 0, 0]
radius = 2
facing = "inward"
END
ffstudy convert spheres.toml spheres.obj
expect_status 2
expect_stderr "has curved surfaces"
expect_stderr "Add --facets 32"
[ ! -e spheres.obj ] || fail "expected no file"
ffstudy convert spheres.toml spheres.obj --facets 12
expect_status 0
expect_stderr "2 curved surfaces became polygons that are off by at most 0.136"
expect_stderr "1 name was changed, since blanks"
ffstudy form-factors spheres.obj --tolerance 1e-2 --out spheres --quiet
expect_status 0
awk -F, '$1 == "inner_sphere" && $2 == "outer" {found = $3 > 0.99 && $3 < 1.01} END {exit !found}' spheres/matrix.csv ||
    fail "unexpected: $(cat spheres/matrix.csv)"
ffstudy convert spheres.toml spheres.png
expect_status 2
expect_stderr "names no format that scenes are written in"
ffstudy convert spheres.toml spheres.obj --facets 2
expect_status 2
expect_stderr "--facets 2"

# Lengths in millimetres, and an axis that points up as in Blender and Maya: the same factors, in another place.
ffstudy convert furnace.obj upright.obj --up y --scale 0.001
expect_status 0
expect_stderr "its lengths are multiplied by 0.001"
expect_stderr "its y axis, which points up, becomes the z axis"
ffstudy form-factors upright.obj --tolerance 1e-3 --out upright --quiet
expect_status 0
ffstudy form-factors furnace.obj --up y --scale 0.001 --tolerance 1e-3 --out option --quiet
expect_status 0
for folder in option upright; do awk 'FNR > 2 {printf "%.9e\n", $NF}' $folder/areas.mtx >$folder.areas; done
expect_equal_files option.areas upright.areas
for folder in option upright; do
    awk -F, 'NR == FNR {v[$1 FS $2] = $3; next} FNR > 1 && ($3 - v[$1 FS $2])^2 > 4e-6 {exit 1}' \
        0/matrix.csv $folder/matrix.csv || fail "expected the factors of furnace.obj"
done
ffstudy convert 1.vs3 x.obj --up y
expect_status 2
expect_stderr "--up y: '1.vs3' is neither an OBJ file nor a mesh"
ffstudy convert furnace.obj x.obj --scale 0
expect_status 2
expect_stderr "--scale 0 (1e-9 to 1e9)"
