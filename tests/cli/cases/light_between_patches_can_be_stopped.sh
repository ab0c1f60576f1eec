#!/usr/bin/env bash
# A signal while systems between patches are evaluated: no trial is lost, reports say what is missing, `report` does it.
source "$(dirname "$0")/../harness.sh"

cat >lit.toml <<'END'
[study]
name = "lit"
scene = "cube"
trials = 60
seed = 1
[[method]]
name = "rays"
sampler = "random"
estimator = "ray_shooting"
patches_per_face = 36
samples_per_patch = 20
[radiosity]
reflectance = [0.5, 0.9, 0.99]
patch_trials = 60
solver_trials = 0
END
command_line="ffstudy run (to be stopped)" status=0
"$program" run lit.toml --out lit >"$folder/stdout" 2>"$folder/stderr" </dev/null &
process=$!
# The context is noted when all trials are saved, before they are evaluated.
until /usr/bin/python3 - <<'END'
import sqlite3, sys
try:
    found = sqlite3.connect("file:lit/results.sqlite?mode=ro", uri=True).execute("SELECT count(*) FROM context").fetchone()
    sys.exit(found[0] == 0)
except sqlite3.Error:
    sys.exit(1)
END
do
    kill -0 $process || fail "the study was over before it could be stopped"
    sleep 0.05
done
sleep 0.2  # the store is sealed in between, where a signal ends the program at once
kill -INT $process
wait $process || status=$?
expect_status 130
expect_stderr "of 60 trials put into systems between patches. All trials are saved: 'ffstudy report' on the folder does the rest."
expect_in_file lit/report.md "Stopped early: systems between patches are evaluated for "
expect_in_file lit/report.md "What the errors do to the light"
ffstudy report lit
expect_status 0
! grep -q "Stopped early" lit/report.md || fail "the report still lacks systems"
cut -d, -f 2-10 lit/matrices.csv | grep -q ",patches," || fail "no systems between patches"

# What was asked for between patches is written for other programs, and only that.
ffstudy report lit --format patch_systems --out files
expect_status 0
/usr/bin/python3 - <<'END' || fail "the system between patches is not I - P F"
import array, pathlib
def npy(name):
    data = pathlib.Path("files/matrices/cell_0/" + name).read_bytes()
    length = int.from_bytes(data[8:10], "little")
    return array.array("d", data[10 + length:])
factors, system = npy("patch_form_factors.npy"), npy("patch_system_1.npy")
assert len(factors) == len(system) == 216 ** 2
assert all(s == (i // 216 == i % 216) - 0.9 * f for i, (f, s) in enumerate(zip(factors, system)))
END
[ -s files/matrices/cell_0/patch_system_2.mtx ] || fail "no MatrixMarket file"
small_study 4 | sed 's/^patches_per_face.*/patches_per_face = 1/' >faces.toml
ffstudy run faces.toml --out faces
ffstudy report faces --format patch_systems --out none
expect_status 2
expect_stderr "no system between patches"
