#!/usr/bin/env bash
# A body on a floor that is not cut out beneath it: what it covers is left out, however the model describes it.
source "$(dirname "$0")/../harness.sh"

# room FLOOR...: a closed room of 4 x 4 x 3 with these lines for its floor, and a box of 1 x 1 x 1 in it.
room() {
    printf '%s\n' '# closed' 'v 0 0 0' 'v 4 0 0' 'v 4 4 0' 'v 0 4 0' 'v 0 0 3' 'v 4 0 3' 'v 4 4 3' 'v 0 4 3' \
        'v 1 1 0' 'v 2 1 0' 'v 2 2 0' 'v 1 2 0' 'v 1 1 1' 'v 2 1 1' 'v 2 2 1' 'v 1 2 1' \
        'v 1 0 0' 'v 2 0 0' 'v 1 4 0' 'v 2 4 0' 'g floor' 'usemtl wood' "$@" \
        'g walls' 'usemtl plaster' 'f 8 7 6 5' 'f 1 5 6 2' 'f 2 6 7 3' 'f 3 7 8 4' 'f 4 8 5 1' \
        'g box' 'usemtl steel' 'f 13 14 15 16' 'f 9 10 14 13' 'f 10 11 15 14' 'f 11 12 16 15' 'f 12 9 13 16'
}
bottom=('g bottom' 'usemtl rust' 'f 12 11 10 9')
room 'f 1 17 19 4' 'f 17 18 10 9' 'f 12 11 20 19' 'f 18 2 3 20' >cut.obj
room 'f 1 2 3 4' >without_bottom.obj
{ room 'f 1 2 3 4' && printf '%s\n' "${bottom[@]}"; } >with_bottom.obj

for scene in cut without_bottom with_bottom; do
    ffstudy form-factors $scene.obj --tolerance 1e-3 --out $scene
    expect_status 0
    expect_stdout "All 6 pairs of faces are within 0.001."
done
expect_stderr "note: scene 'with_bottom.obj': all of face 'bottom' is covered"
expect_stderr "6.25 % of face 'floor' is covered, by a body that stands on it"
python3 - <<'END' || fail "expected the factors of the floor that is cut out"
import csv
def factors(folder):
    return {(row["from"], row["to"]): float(row["factor"]) for row in csv.DictReader(open(f"{folder}/matrix.csv"))}
cut = factors("cut")
for folder in ("without_bottom", "with_bottom"):
    found = factors(folder)
    assert found.keys() == cut.keys(), folder
    assert all(abs(found[pair] - cut[pair]) < 2e-3 for pair in cut), folder
END

# Faces keep their materials where one is left out; powers are those of what is left.
cat >materials.toml <<'END'
[materials]
wood = { emissivity = 0.8, temperature = 300 }
plaster = { emissivity = 0.9, temperature = 300 }
steel = { emissivity = 0.3, temperature = 400 }
END
for scene in cut with_bottom; do
    ffstudy heat $scene.obj --materials materials.toml --tolerance 1e-3
    expect_status 0
    awk '$1 ~ /^(floor|walls|box)$/ {print $1, $NF, $2, $5}' "$folder/stdout" >$scene.txt  # area, power, temperature
done
paste -d ' ' cut.txt with_bottom.txt | awk '
    {away = $3 - $7; wrong += $1 != $5 || $2 != $6 || away > 0.1 || away < -0.1 || $4 != $8}
    END {exit wrong || NR != 3}' || fail "expected the heat flows of the floor that is cut out"

# A round body is not understood: that is said, and nothing is trusted.
cat >can.toml <<'END'
closed = true
[[surface]]
face = "floor"
shape = "disc"
centre = [0, 0, 0]
radius = 2
normal = [0, 0, 1]
END
printf '%s\n' '[[surface]]' 'face = "wall"' 'shape = "cylinder"' 'base = [0, 0, 0]' 'axis = [0, 0, 2]' 'radius = 2' \
    'facing = "inward"' '[[surface]]' 'face = "lid"' 'shape = "disc"' 'centre = [0, 0, 2]' 'radius = 2' 'normal = [0, 0, -1]' \
    '[[surface]]' 'face = "can"' 'shape = "cylinder"' 'base = [0, 0, 0]' 'axis = [0, 0, 1]' 'radius = 1' 'facing = "outward"' \
    '[[surface]]' 'face = "can"' 'shape = "disc"' 'centre = [0, 0, 1]' 'radius = 1' 'normal = [0, 0, 1]' >>can.toml
ffstudy form-factors can.toml --tolerance 1e-2
expect_status 4
expect_stderr "a body that stands on the face may cover part of it"
