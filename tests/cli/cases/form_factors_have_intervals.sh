#!/usr/bin/env bash
# All form factors of a scene, each with an interval: what is printed and written, and what is refused.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

# The furnace of the documents gives what they show.
blocks obj "$root/docs/scenes.md" >furnace.obj
blocks "" "$root/docs/form-factors.md" 1 | sed '1d' >"$folder/promised"
[ "$(wc -l <"$folder/promised")" -gt 15 ] || fail "docs/form-factors.md does not show the furnace"
ffstudy form-factors furnace.obj --repair --out results/furnace
expect_status 0
expect_no_stderr
expect_equal_files "$folder/promised" "$folder/stdout"

# The files hold the same, those of rows where factors are not zero too. (NumPy: matrices_are_loaded_with_numpy.sh.)
/usr/bin/python3 - <<'END' || fail "the files are not as documented"
import csv, json
from arrays import dense, load
rows = list(csv.DictReader(open("results/furnace/matrix.csv")))
factors, widths, repaired = (load(f"results/furnace/{name}.npy") for name in ("form_factors", "half_widths", "repaired"))
about = json.load(open("results/furnace/form_factors.json"))
names = [face["face"] for face in about["faces"]]
assert len(rows) == 42 and about["missed"] == 0 and about["warnings"] == []
for row in rows:
    i, j = names.index(row["from"]), names.index(row["to"])
    value = float(row["factor"])
    assert value == factors[i][j] and float(row["half_width"]) == widths[i][j]
    assert float(row["low"]) <= value <= float(row["high"]) and widths[i][j] <= 1e-5
assert all(abs(sum(row) - 1) < 1e-12 for row in repaired)
for name, whole in (("form_factors", factors), ("half_widths", widths)):
    sparse = load(f"results/furnace/{name}.npz")
    assert sparse["format"] == b"csr" and sparse["shape"] == [7, 7]
    assert dense(sparse, 7) == whole and len(sparse["data"]) == 42
END

# Every column and key that is written is explained.
for word in $(head -n 1 results/furnace/matrix.csv | tr , ' ') \
    $(grep -oE '"[a-z_]+":' results/furnace/form_factors.json | cut -d'"' -f2 | sort -u); do
    grep -Fq "\`$word\`" "$root/docs/form-factors.md" || fail "docs/form-factors.md does not explain $word"
done

# A budget that is too small: the pairs are named, the intervals are wide, and the exit code says so.
ffstudy form-factors discs_blocked --max-samples 1000000
expect_status 4
expect_stdout "1 of 3 pairs of faces is NOT within 1e-05: 1-2 (±"
ffstudy form-factors discs_blocked --tolerance 2e-6 --max-time 0.1
expect_status 4
expect_stdout "NOT within 2e-06: 1-"

# Far from the origin, and huge: the same as at home. Surfaces over each other are not trusted.
can() {
    printf '[[surface]]\nface = "wall"\nshape = "cylinder"\nbase = [%s, %s, 0]\naxis = [0, 0, 2%s]\nradius = 1%s\nfacing = "inward"\n' "$1" "$1" "$2" "$2"
    printf '[[surface]]\nface = "base"\nshape = "disc"\ncentre = [%s, %s, 0]\nnormal = [0, 0, 1]\nradius = 1%s\n' "$1" "$1" "$2"
    printf '[[surface]]\nface = "top"\nshape = "disc"\ncentre = [%s, %s, 2%s]\nnormal = [0, 0, -1]\nradius = 1%s\n' "$1" "$1" "$2" "$2"
}
for place in "0 " "4600000 " "0 e20" "0 e-20"; do
    read -r at size <<<"$place" || true
    can "$at" "$size" >can.toml
    ffstudy form-factors can.toml --tolerance 1e-3 --out can
    expect_status 0
    awk -F, '$1 == "base" && $2 == "top" && ($4 > 0.1715729 || $5 < 0.1715728) { exit 1 }' can/matrix.csv ||
        fail "the base of a can at $at, size 1$size sees $(grep base,top can/matrix.csv)"
done
printf '[[surface]]\nface = "picture"\nshape = "disc"\ncentre = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 0.3\n' >>can.toml
can 0 "" >over.toml
tail -n 6 can.toml >>over.toml
ffstudy form-factors over.toml --tolerance 1e-2
expect_status 4
expect_stderr "faces 'base' and 'picture' lie over each other in one plane"
rm -r can

# A closed scene with a hole, and without one where closure is asked for.
sed '/^g roof/,/^g south/{/^f/d;/^g roof/d}' furnace.obj >open.obj
ffstudy form-factors open.obj --tolerance 1e-3
expect_status 4
expect_stderr "is said to be closed, but the rows of"
expect_stdout "NOT to be trusted (see the warnings)"

rm -r results ./*.obj ./*.toml
ffstudy form-factors cube --tolerance 1e-15
expect_refused 2 "--tolerance 1e-15"
ffstudy form-factors cube --level 1
expect_refused 2 "--level 1"
ffstudy form-factors discs_blocked --tolerance 1e-8 --out out
expect_refused 2 "have to be sampled by rays"
ffstudy form-factors squares_blocked --repair --out out
expect_refused 2 "is not said to be closed"
ffstudy form-factors discs_blocked --max-samples 1000
expect_refused 2 "--max-samples 1000 (the smallest rounds of this scene take"
ffstudy form-factors kube
expect_refused 2 "kube"
ffstudy form-factors missing.obj
expect_refused 3 "missing.obj"

# A point that sees nothing leaves no line in the table, and is named instead.
ffstudy form-factors box:4x3x2.5 --from point:2,1.5,0,0,0,-1
expect_status 4
expect_stderr "warning: the factors from point 1 add up to 0 in a closed scene"
expect_stderr "note: no face is seen from point 1"
printf 'x,y,z,nx,ny,nz\n2,1.5,1,0,0,1\n2,1.5,0,0,0,-1\n2,1,0,0,0,-1\n' >sensors.csv
ffstudy form-factors box:4x3x2.5 --from sensors.csv
expect_stderr "note: no face is seen from 2 of 3 points (the first is point 2)"

# Columns are found by their names, whatever stands between them.
printf 'id,NX,NY,NZ,X,Y,Z,room\n7,0,0,1,2,1.5,1,hall\n' >named.csv
ffstudy form-factors box:4x3x2.5 --from named.csv
expect_status 0
expect_stderr "note: named.csv: 2 other columns left out: only x, y, z, nx, ny, nz are read"
cp "$folder/stdout" named
ffstudy form-factors box:4x3x2.5 --from point:2,1.5,1,0,0,1
expect_equal_files "$folder/stdout" named
