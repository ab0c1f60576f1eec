#!/usr/bin/env bash
# A study that version 0.1.0 ran (tests/data/store_of_0.1.0) is reported, compared with the same study run anew, and grows.
source "$(dirname "$0")/../harness.sh"

kept=$data/store_of_0.1.0
mkdir kept
cp "$kept/results.sqlite" kept/

ffstudy report kept --quiet
expect_status 0
expect_stderr "kept/results.sqlite: written by an earlier version of ffstudy"
expect_in_file kept/report.md "Kept since version 0.1.0"

# The same study file gives the same trials today.
ffstudy run "$kept/study.toml" --out new --quiet
expect_status 0
ffstudy compare kept new
expect_status 0
expect_stdout "the same random numbers, equal in all 12 trials"

# It grows, and has checksums then.
sed 's/^trials = 12$/trials = 20/' "$kept/study.toml" >more.toml
ffstudy run more.toml --out kept
expect_status 0
expect_stderr "74 of 122 trials are there already"
ffstudy report kept --quiet
expect_status 0
expect_no_stderr
