#!/usr/bin/env bash
# Mirrors and round rooms in studies: rays are traced, and compared with exact factors; light is sent through both.
page=$(cd "$(dirname "$0")/../../.." && pwd)/docs/radiosity.md
source "$(dirname "$0")/../harness.sh"

# The page shows a room with a mirror, and what the program prints of it.
blocks "toml study" "$page" >mirror_room.toml
ffstudy run mirror_room.toml
expect_status 0
blocks "" "$page" | sed '0,/^\$ ffstudy run mirror_room.toml$/d; /^\$ /,$d' >"$folder/promised"
expect_equal_files "$folder/promised" "$folder/stdout"

# study SCENE-LINES METHOD-LINES RADIOSITY-LINES
study() {
    printf '[study]\nname = "room"\n%s\ntrials = 200\nseed = 5\n[[method]]\nname = "rays"\n%s\n%s\n' "$1" "$2" "$3"
}
rays='sampler = "random"
estimator = "ray_shooting"
patches_per_face = 4
samples_per_patch = 100'
light='[radiosity]
reflectance = [0.5, 0.9]
patch_trials = 2'

study 'scene = "cube"
mirrors = ["6"]' "$rays" "$light" >mirrored.toml
ffstudy run mirrored.toml --out mirrored
expect_status 0
expect_stdout "none found"
expect_stdout "Between the 20 patches of "
/usr/bin/python3 - <<'END' || fail "the mirrored floor does not see itself as half a box of twice the height does"
import csv
rows = {(r["from_face"], r["to_face"]): r for r in csv.DictReader(open("mirrored/summary.csv"))}
exact = float(rows["1", "1"]["reference"])
assert abs(exact - 0.0686) < 5e-4, exact  # C-11 with X = Y = 1/2
assert float(rows["1", "sum"]["mean"]) == 1 and rows["1", "1"]["pair_class"] == "self" and rows["1", "1"]["std"]
assert ("6", "1") not in rows
END

# The same by the scene's name, beside the room without; the same random numbers.
study 'scene = ["cube mirrors:6", "cube"]' "$rays" "$light" >both.toml
ffstudy run both.toml --out both
expect_status 0
grep "^room,cube mirrors:6," both/summary.csv | cut -d, -f 4-17 >"$folder/one"
grep "^room,cube mirrors:6," mirrored/summary.csv | cut -d, -f 4-17 >"$folder/other"
expect_equal_files "$folder/one" "$folder/other"

# Self-views of a wall and of a cone, closed by discs.
cat >silo.toml <<'END'
closed = true
[[surface]]
face = "floor"
shape = "disc"
centre = [0, 0, 0]
normal = [0, 0, 1]
radius = 1
[[surface]]
face = "wall"
shape = "cylinder"
base = [0, 0, 0]
axis = [0, 0, 2]
radius = 1
facing = "inward"
[[surface]]
face = "roof"
shape = "cone"
base = [0, 0, 2]
axis = [0, 0, 1]
base_radius = 1
top_radius = 0
facing = "inward"
END
round='sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 400'
study 'scene = "silo.toml"' "$round" '[radiosity]
reflectance = [0.5, 0.9]' >round.toml
ffstudy run round.toml --out round
expect_status 0
expect_stdout "none found"
/usr/bin/python3 - <<'END' || fail "the silo's factors are not exact"
import csv, math
rows = {(r["from_face"], r["to_face"]): r for r in csv.DictReader(open("round/summary.csv"))}
assert abs(float(rows["roof", "roof"]["reference"]) - (1 - 1 / math.sqrt(2))) < 1e-14
assert abs(float(rows["wall", "wall"]["reference"]) - (2 - math.sqrt(2))) < 1e-14
END

refused() {
    ffstudy run "$1" --out refused
    expect_status 2
    expect_stderr "$2"
    [ ! -e refused ] || fail "something was written for $1"
}
study 'scene = "cube"
mirrors = ["7"]' "$rays" "" >seventh.toml
refused seventh.toml "has no face '7'"
study 'scene = "silo.toml"
mirrors = ["wall"]' "$round" "" >bent.toml
refused bent.toml "face 'wall' of scene 'silo.toml' is curved"
kernels='sampler = "random"
estimator = "area_kernel"
samples_per_patch = 10'
study 'scene = "cube"
mirrors = ["6"]' "$kernels" "" >kernels.toml
refused kernels.toml "area_kernel cannot be used in scene 'cube mirrors:6' with mirrors"
study 'scene = "cube"
mirrors = ["1", "6"]' "$rays" "$light" >opposite.toml
refused opposite.toml "images in opposite mirrors are without end"
study 'scene = "silo.toml"' "$rays" "$light" >pieces.toml
refused pieces.toml "patch_trials in scene 'silo.toml'"
study 'scene = "l_shaped_room"' "$round" '[radiosity]' >corner.toml
refused corner.toml "its faces may be occluded from each other"
ffstudy form-factors "cube mirrors:6"
expect_status 2
expect_stderr "does not follow reflected light"
