#!/usr/bin/env bash
# Every kind of geometry that cannot be computed with, in each format that can hold it: file, line and object, exit code 2.
source "$(dirname "$0")/../harness.sh"

study() {
    printf '[study]\nname = "t"\nscene = "%s"\ntrials = 2\nseed = 1\n%s\n[[method]]\nname = "a"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = 10\n' \
        "$1" "${2:-}" >"$folder/study.toml"
}
# refuse FILE TEXT < SCENE
refuse() {
    cat >"$folder/$1"
    study "$1"
    ffstudy run "$folder/study.toml" --out out
    expect_refused 2 "$2"
}
square='v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0'

refuse a.obj "no face" <<<"$square
v 2 0 0
g flat
f 1 2 5"
refuse a.obj "a.obj:7: edges of a surface of face 'crossed' cross or touch each other" <<<"$square
v 0.2 0.7 0
g crossed
f 1 3 5 2"
for number in nan inf 1e999 1x; do
    refuse a.obj "a.obj:1: a vertex needs three finite coordinates" <<<"v 0 0 $number"
done
refuse a.obj "a.obj:6: corner 3 is vertex 9 (the file has 4)" <<<"$square
g a
f 1 2 9"
refuse a.obj "a.obj:9: a surface of face 'b' is the same as a surface of face 'a' of line 6" <<<"$square
g a
f 1 2 3
f 1 3 4
g b
f 2 3 1"
refuse a.obj "no face" <<<"$square"

refuse a.toml "a.toml:2:10: radius = 0" <<<'[[surface]]
radius = 0
face = "a"
shape = "disc"
centre = [0, 0, 0]
normal = [0, 0, 1]'
refuse a.toml "a.toml:5:" <<<'[[surface]]
face = "a"
shape = "disc"
radius = 1
centre = [0, nan, 0]
normal = [0, 0, 1]'
refuse a.toml "a.toml:1: a surface of face 'a' has no area" <<<'[[surface]]
face = "a"
shape = "triangle"
a = [0, 0, 0]
b = [1, 0, 0]
c = [2, 0, 0]'
for grid in "[0, 1]" "[-1, 1]" "[1.5, 1]" "[1, 2, 3]" "[2000000, 1]" 3 '"2"'; do
    refuse a.toml "a.toml:6:8: grid = " <<<"[[surface]]
face = \"a\"
shape = \"disc\"
centre = [0, 0, 0]
normal = [0, 0, 1]
grid = $grid
radius = 1"
done
refuse a.vs3 "a.vs3:5: vertex 9 is not defined" <<<'F 3
V 1 0 0 0
V 2 1 0 0
V 3 1 1 0
S 1 1 2 9 0 0 0 0.5 a'

# Normals that face the wrong way are doubted with the evidence, and the study runs: an outward cube, said to be closed.
cat >"$folder/cube.obj" <<'END'
# closed
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
g floor
f 4 3 2 1
g roof
f 5 6 7 8
g south
f 1 2 6 5
g north
f 3 4 8 7
g east
f 2 3 7 6
g west
f 4 1 5 8
END
study cube.obj
ffstudy run "$folder/study.toml" --out wrong
expect_status 0
expect_stderr "faces seem to face outwards (no ray from a radiating side meets another"
ffstudy form-factors "$folder/cube.obj" --tolerance 1e-3
expect_status 4
expect_stderr "faces seem to face outwards"
expect_stdout "NOT to be trusted (see the warnings)"
sed 's/^f 5 6 7 8$/f 8 7 6 5/; s/^f 4 3 2 1$/f 1 2 3 4/' "$folder/cube.obj" >"$folder/mixed.obj"
study mixed.obj
ffstudy run "$folder/study.toml" --out mixed
expect_status 0
expect_stderr "faces 'south', 'north', 'east' and 1 more seem to face the wrong way"

# An open scene where closure is asked for.
rm -rf -- *
sed '1d; /^g west/,$d' "$folder/cube.obj" >"$folder/open.obj"
study open.obj '[radiosity]
reflectance = [0.5]'
ffstudy run "$folder/study.toml" --out open
expect_refused 2 "[radiosity]: scene 'open.obj' is open"
