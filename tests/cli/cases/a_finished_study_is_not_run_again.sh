#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out out
expect_status 0
cp -r out before
ffstudy run "$folder/study.toml" --threads 2 --out out
expect_status 0
for file in summary.csv trials.csv results.json report.md context.json; do expect_equal_files before/$file out/$file; done

cp -r out kept
ffstudy run "$folder/study.toml" --seed 2 --out out
expect_status 2
expect_stderr "holds another study (differs in [study]: 'seed = 1' there, 'seed = 2' here)"
for file in summary.csv trials.csv results.json report.md results.sqlite; do expect_equal_files kept/$file out/$file; done
