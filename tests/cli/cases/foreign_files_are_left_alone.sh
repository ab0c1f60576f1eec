#!/usr/bin/env bash
# Files that lie where results would, and that ffstudy has not written or has written for another study, are named and
# neither replaced nor removed.
source "$(dirname "$0")/../harness.sh"

small_study 4 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out whole
expect_status 0

# refused FILE ARGUMENTS...: a file of this name ends the command before it has written anything, and stays.
refused() {
    local out=${*: -1}
    mkdir -p "$out/$(dirname "$1")"
    echo "the user's own" >"$out/$1"
    ffstudy "${@:2}"
    expect_status 3
    expect_stderr "$out/$1: not replaced (ffstudy has not written it). Move it away, or choose another --out."
    [ "$(cat "$out/$1")" = "the user's own" ] || fail "expected $1 to be left alone"
    [ ! -e "$out/results.sqlite" ] || fail "expected no store"
    [ -z "$(find "$out" -name '.ffstudy*')" ] || fail "expected nothing else to be left in $out"
    rm -r "$out"
}
for file in report.html report.md answer.svg audit.md summary.csv slopes.csv coverage.csv trials.csv results.json context.json \
    matrices.csv systems.csv exitance.csv solvers.csv residuals.csv; do
    refused $file run "$folder/study.toml" --shard 1/2 --out mine
done
refused summary.csv run "$folder/study.toml" --out mine
refused summary.csv merge whole --out mine
refused summary.csv report whole --format csv --out mine
refused tables/methods.tex report whole --format latex --out mine
refused matrices/cell_0/areas.npy report whole --format matrices --out mine
for file in form_factors.sqlite matrix.csv form_factors.mtx form_factors.npz areas.npy form_factors.json context.json; do
    refused $file form_factors cube --out mine
done
refused enclosure.md enclosure cylinder:1x2 --out mine
cat >"$folder/bands.toml" <<'END'
[gates]
alpha = 1e-3

[[gate]]
name = "random"
kind = "bias"
scene = "cube"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 64
band = 0.05
END
for file in verdicts.csv verdicts.json junit.xml summary.md summary.html context.json; do
    refused $file check "$folder/bands.toml" --out mine
done

# Other names are nobody's business, those of earlier temporary files included.
mkdir mine
for file in report.html.part notes.txt results.csv; do echo "the user's own" >mine/$file; done
ffstudy run "$folder/study.toml" --out mine
expect_status 0
for file in report.html.part notes.txt results.csv; do
    [ "$(cat mine/$file)" = "the user's own" ] || fail "expected $file to be left alone"
done

# Again into its own folder, whatever wrote the reports there.
for arguments in "run $folder/study.toml --out mine" "report mine" "report whole --out mine" "merge whole --out mine" \
    "report mine --format latex,matrices" "report mine --format latex,matrices"; do
    # shellcheck disable=SC2086
    ffstudy $arguments
    expect_status 0
done
for _ in 1 2; do
    ffstudy form-factors cube --out matrix
    expect_status 0
    ffstudy check "$folder/bands.toml" --out gates
    expect_status 0
    ffstudy enclosure cylinder:1x2 --out enclosure
    expect_status 0
done

# Reports of one study are not those of another.
small_study 5 >"$folder/other.toml"
ffstudy run "$folder/other.toml" --out other
expect_status 0
cp whole/report.md "$folder/report.md"
ffstudy report other --format markdown --out whole
expect_status 3
expect_stderr "whole/report.md: not replaced (it is of another study). Move it away, or choose another --out."
expect_equal_files "$folder/report.md" whole/report.md
ffstudy check "$folder/bands.toml" --out whole
expect_status 3
expect_stderr "whole/context.json: not replaced (it is of another study)."

# A folder of an earlier version, which has no list of what was written, works as before.
for folder_of in whole matrix gates enclosure; do rm $folder_of/.ffstudy.files; done
rm gates/summary.*
for arguments in "report whole" "run $folder/study.toml --out whole" "form_factors cube --out matrix" \
    "check $folder/bands.toml --out gates" "enclosure cylinder:1x2 --out enclosure"; do
    # shellcheck disable=SC2086
    ffstudy $arguments
    expect_status 0
done
# So does one with a shard that was interrupted there.
ffstudy run "$folder/study.toml" --shard 1/2 --out shard
expect_status 0
cp whole/report.md whole/summary.csv shard
ffstudy run "$folder/study.toml" --shard 1/2 --out shard
expect_status 0
[ "$(ls shard)" = results.sqlite ] || fail "expected the reports of the interrupted shard to be removed"
