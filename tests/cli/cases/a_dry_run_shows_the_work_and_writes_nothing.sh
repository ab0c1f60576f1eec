#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --dry-run --threads 2
expect_status 0
expect_stdout "work units"
expect_stdout "on 2 threads"
expect_nothing_written
ffstudy sr_vs_pdm --dry-run
expect_status 0
expect_stdout "SR sobol"
expect_nothing_written
