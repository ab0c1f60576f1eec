#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --dry-run --threads 2
expect_status 0
expect_stdout "work units"
expect_stdout "on 2 threads"
expect_nothing_written
# A method's size has one row, for both scenes: 6 faces of 4 patches with 64 rays in each.
[ "$(grep -c "^sobol " "$folder/stdout")" -eq 1 ] || fail "expected one row for both scenes"
expect_stdout "scenes"
grep -Eq "^sobol .* 2 +20 +$((2 * 6 * 4 * 64)) " "$folder/stdout" || fail "expected the rays of both scenes"
ffstudy sr_vs_pdm --dry-run
expect_status 0
expect_stdout "SR sobol"
expect_nothing_written
! grep -q "scenes" "$folder/stdout" || fail "expected nothing of scenes where there is one"
