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
# stopped: a run that a signal ended while systems were evaluated. It may be over before, or be at its reports.
stopped() {
    rm -rf lit
    begin run lit.toml --out lit
    wait_until is_over_or evaluates
    kill -INT "$process" 2>/dev/null || true
    finish
    grep -q "put into systems between patches" "$folder/stderr"
}
# The context is noted when all trials are saved, before they are evaluated.
evaluates() { [ "$(saved context lit)" -gt 0 ]; }
until stopped; do try_again "the study was over before it could be stopped"; done
expect_status 130
expect_stderr "of 60 trials put into systems between patches. All trials are saved: 'ffstudy report' on the folder does the rest."
expect_in_file lit/report.md "Stopped early: systems between patches are evaluated for "
expect_in_file lit/report.md "What the errors do to the light"
ffstudy report lit
expect_status 0
! grep -q "Stopped early" lit/report.md || fail "the report still lacks systems"
cut -d, -f 2-10 lit/matrices.csv | grep ",patches," >/dev/null || fail "no systems between patches"

# A report that is stopped leaves a complete one as it is. It may be over before the signal arrives.
cp -r lit complete
report_stopped() {
    begin report lit --verbose
    wait_until is_over_or solves
    kill -INT "$process" 2>/dev/null || true
    finish
    [ "$status" = 130 ] && grep "No report is written." "$folder/stderr" >/dev/null
}
solves() { grep "Solving the systems between patches" "$folder/stderr" >/dev/null; }
until report_stopped; do try_again "the report was written before it could be stopped"; done
cmp lit/report.html complete/report.html || fail "the complete report is gone"

# What was asked for between patches is written for other programs, and only that.
ffstudy report lit --format patch_systems --out files
expect_status 0
/usr/bin/python3 - <<'END' || fail "the system between patches is not I - P F"
from arrays import load
factors, system = (load(f"files/matrices/cell_0/patch_{name}.npy") for name in ("form_factors", "system_1"))
assert len(factors) == len(system) == 216
for i in range(216):
    assert all(system[i][j] == (i == j) - 0.9 * factors[i][j] for j in range(216))
END
[ -s files/matrices/cell_0/patch_system_2.mtx ] || fail "no MatrixMarket file"
small_study 4 | sed 's/^patches_per_face.*/patches_per_face = 1/' >faces.toml
ffstudy run faces.toml --out faces
ffstudy report faces --format patch_systems --out none
expect_status 2
expect_stderr "no system between patches"
