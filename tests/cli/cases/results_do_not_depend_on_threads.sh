#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --threads 1 --out one
expect_status 0
expect_stdout "Results: one/report.html"
ffstudy run "$folder/study.toml" --threads 2 --out two
expect_status 0
ffstudy run "$folder/study.toml" --threads 3 --quiet --out three
expect_status 0
expect_no_stdout
expect_no_stderr
expect_same_results one two
expect_same_results one three

ffstudy run "$folder/study.toml" --seed 2 --out other
expect_status 0
! cmp -s one/trials.csv other/trials.csv || fail "expected another seed to give other trials"
