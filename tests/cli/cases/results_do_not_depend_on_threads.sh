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
for out in two three; do
    for file in summary.csv trials.csv results.json audit.md; do
        [ $file = audit.md ] && [ ! -e one/$file ] && continue
        expect_equal_files one/$file $out/$file
    done
    without_circumstances one/report.md >a
    without_circumstances $out/report.md >b
    expect_equal_files a b
    expect_file $out/context.json
done
expect_in_file one/report.md "circumstances"

ffstudy run "$folder/study.toml" --seed 2 --out other
expect_status 0
! cmp -s one/trials.csv other/trials.csv || fail "expected another seed to give other trials"
