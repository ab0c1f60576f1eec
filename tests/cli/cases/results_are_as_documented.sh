#!/usr/bin/env bash
# docs/results.schema.json describes what the program writes, and tells other files apart; docs/results.md lists all columns
# of tables, and no others.
# Needs jsonschema.
here=$(cd "$(dirname "$0")/.." && pwd)
source "$(dirname "$0")/../harness.sh"

validate() { /usr/bin/python3 "$here/validate_results" "$1" >"$folder/stdout" 2>"$folder/stderr"; }
expect_valid() { validate "$1" || fail "expected $1 to follow the schema"; }
expect_invalid() { ! validate "$1" || fail "expected $1 to break the schema: $2"; }

small_study 40 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out small
expect_status 0
expect_valid small/results.json
ffstudy sr_vs_pdm --trials 2 --out paper
expect_status 0
expect_valid paper/results.json
# Faces that see themselves, and a method that claims its errors.
cat >"$folder/other.toml" <<END
[study]
name = "other"
scene = ["hemisphere", "cube"]
trials = 20
seed = 1
inapplicable = "skip"

[[method]]
name = "rays"
sampler = "sobol"
estimator = "ray_shooting"
samples_per_patch = [16, 64, 256]

[[method]]
name = "adaptive"
estimator = "adaptive_contour"
samples_per_patch = [60, 90]
END
ffstudy run "$folder/other.toml" --out other
expect_status 0
expect_valid other/results.json
# Light, between faces and between the patches of grids.
cat >room.toml <<END
closed = true
surface = [
    {face = "floor", shape = "parallelogram", corner = [0, 0, 0], edge_u = [2, 0, 0], edge_v = [0, 1, 0], grid = [2, 1]},
    {face = "roof", shape = "parallelogram", corner = [0, 0, 1], edge_u = [0, 1, 0], edge_v = [2, 0, 0], grid = [1, 3]},
    {face = "south", shape = "parallelogram", corner = [0, 0, 0], edge_u = [0, 0, 1], edge_v = [2, 0, 0]},
    {face = "north", shape = "parallelogram", corner = [0, 1, 0], edge_u = [2, 0, 0], edge_v = [0, 0, 1]},
    {face = "west", shape = "parallelogram", corner = [0, 0, 0], edge_u = [0, 1, 0], edge_v = [0, 0, 1]},
    {face = "east", shape = "parallelogram", corner = [2, 0, 0], edge_u = [0, 0, 1], edge_v = [0, 1, 0]},
]
END
for scene in cube room.toml; do
    for patch_trials in 0 2; do
        small_study 20 | sed "s/^scene = .*/scene = \"$scene\"/" >lit.toml
        printf '[radiosity]\nreflectance = [0.5, 0.95]\nemission = [0, 0, 0, 0, 0, 1]\npatch_trials = %s\n' $patch_trials >>lit.toml
        ffstudy run lit.toml --out "lit_$scene$patch_trials"
        expect_status 0
        expect_valid "lit_$scene$patch_trials/results.json"
    done
done
# Columns of all tables.
{ small_study 64 && printf '[coverage]\nreplicates = [4, 16]\n'; } >covered.toml
ffstudy run covered.toml --out covered
expect_status 0
columns_are_listed() { /usr/bin/python3 "$here/validate_columns" "$@" >"$folder/stdout" 2>"$folder/stderr"; }
columns_are_listed small other covered lit_cube2 || fail "expected docs/results.md to list all columns"
mkdir renamed
sed '1s/,bias_se,/,bias_error,/' small/summary.csv >renamed/summary.csv
! columns_are_listed other covered lit_cube2 renamed || fail "expected a column to be missed in docs/results.md"
! columns_are_listed small other lit_cube2 || fail "expected columns of docs/results.md to be missed in files"
# A shard that lacks whole cells.
ffstudy run "$folder/study.toml" --shard 1/7 --out part
ffstudy report part
expect_valid part/results.json

# change PYTHON: the results of the small study with one thing changed.
change() {
    /usr/bin/python3 -c "import json; r = json.load(open('small/results.json')); cell = r['cells'][0]; $1
json.dump(r, open('changed.json', 'w'))"
}
for change in "r['more'] = 1" "del r['seed']" "r['schema'] = 'ffstudy.results/2'" "cell['trials'] = -1" \
    "cell['summaries'][0]['mean'] = 'much'" "del cell['bias_test']['alpha']" "cell['trials'] = 1.5" \
    "cell['summaries'][0]['bias_interval']['low'] = None" "cell['summaries'][0]['mean'] = float('nan')" \
    "cell['summaries'][0]['mean'] = float('inf')" "r['contests'][0]['equal'] = 'processor_time'" \
    "r['contests'][0]['ratios'][0]['ratio'] = 0.5" "del r['claimed_errors'][0]['held']"; do
    change "$change"
    expect_invalid changed.json "$change"
done
change ""
expect_valid changed.json
