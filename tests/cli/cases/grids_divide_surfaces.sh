#!/usr/bin/env bash
# A room whose walls have grids of their own, in a study with everything: what is reported, shared out and resumed
# is as in any other scene. The example of docs/scenes.md is what the program prints.
page=$(cd "$(dirname "$0")/../../.." && pwd)/docs/scenes.md
source "$(dirname "$0")/../harness.sh"

for file in strip light; do blocks "toml $file" "$page" >$file.toml; done
promised() { blocks "" "$page" | sed "0,/^\\$ ffstudy $1\$/d; /^\\$ /,\$d"; }
for command in "explain strip.toml" "run light.toml"; do
    # shellcheck disable=SC2086  # two words
    ffstudy $command
    expect_status 0
    promised "$command" >"$folder/promised"
    # What methods do at equal processor time, below, differs from run to run.
    head -n "$(wc -l <"$folder/promised")" "$folder/stdout" >"$folder/shown"
    expect_equal_files "$folder/promised" "$folder/shown"
done

# wall FACE CORNER EDGE_U EDGE_V GRID [LINE]
wall() {
    printf '[[surface]]\nface = "%s"\nshape = "parallelogram"\ncorner = [%s]\nedge_u = [%s]\nedge_v = [%s]\ngrid = [%s]\n%s\n' \
        "$1" "$2" "$3" "$4" "$5" "${6:-}"
}
{
    echo "closed = true"
    wall floor 0,0,0 1,0,0 0,1,0 1,2
    wall south 0,0,0 4,0,0 0,0,2 4,2 "flip = true"
    wall north 0,1,0 4,0,0 0,0,2 1,1
    wall west 0,0,0 0,1,0 0,0,2 1,2
    wall east 4,0,0 0,1,0 0,0,2 1,1 "flip = true"
    wall roof 0,0,2 4,0,0 0,1,0 4,1 "flip = true"
    wall floor 1,0,0 3,0,0 0,1,0 3,1
} >room.toml
small_study 20 | sed 's/^scene = .*/scene = "room.toml"/' >study.toml
printf '[radiosity]\nreflectance = [0.5, 0.9]\npatch_trials = 2\n' >>study.toml

ffstudy explain room.toml
expect_stdout "floor: area 4, 2 surfaces, grids 1 × 2, 3 × 1"
expect_stdout "north: area 8, grid 1 × 1"

# 21 patches: 81 rays from each, and from each of 84.
ffstudy run study.toml --dry-run
expect_status 0
[ "$(awk '$1 == "SR" {print $(NF - 2)}' "$folder/stdout" | tr '\n' ' ')" = "1701 6804 " ] ||
    fail "expected 21 and 84 times 81 rays"

ffstudy run study.toml --out whole --threads 2
expect_status 0
ffstudy report whole --format latex --out more
expect_status 0
/usr/bin/python3 - whole <<'END' || fail "the patches are not those of the grids"
import csv, pathlib, sys
folder = pathlib.Path(sys.argv[1])
rows = [r for r in csv.DictReader(open(folder / "exitance.csv"))
        if r["between"] == "patches" and r["method"] == "SR" and r["patches_per_face"] == "1"
        and r["treatment"] == "direct" and r["reflectance"] == "0.5" and r["row"]]
found = sorted((r["face"], int(r["row"]), int(r["column"])) for r in rows)
grids = [("floor", 1, 2), ("floor", 3, 1), ("south", 4, 2), ("north", 1, 1), ("west", 1, 2), ("east", 1, 1), ("roof", 4, 1)]
wanted = sorted((face, row + 1, column + 1) for face, p, q in grids for row in range(q) for column in range(p))
assert found == wanted, found
END

for i in 1 2; do ffstudy run study.toml --shard $i/2 --out part$i; done
ffstudy merge part2 part1 --out merged
expect_status 0
expect_same_results whole merged

# Stopped again and again, it resumes until it is done.
milliseconds=1 stops=0
while
    ffstudy run study.toml --out stopped --threads 1 --max-time "$(printf '%d.%03d' $((milliseconds / 1000)) $((milliseconds % 1000)))"
    [ "$status" -eq 130 ] || [ $stops -eq 0 ]
do
    if [ "$status" -eq 130 ]; then
        stops=$((stops + 1)) milliseconds=$((4 * milliseconds))
    else
        rm -r stopped
        try_again "the study was done before its time was over"
    fi
done
expect_status 0
expect_same_results whole stopped

# A grid of one part is the same as no grid.
sed -i 's/^grid = .*/grid = [1, 1]/' room.toml
ffstudy run study.toml --out ones
expect_status 0
sed -i '/^grid = /d' room.toml
ffstudy run study.toml --out none
for file in trials summary exitance; do expect_equal_files ones/$file.csv none/$file.csv; done
ffstudy explain room.toml
! grep -q grid "$folder/stdout" || fail "expected nothing of grids"
