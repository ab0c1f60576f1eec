#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

small_study 1000 >"$folder/study.toml"
command_line="ffstudy run (interrupted)" status=0
"$program" run "$folder/study.toml" --threads 2 --out out >"$folder/stdout" 2>"$folder/stderr" </dev/null &
process=$!
until [ -n "$(find out -name results.sqlite-wal -size +0 2>/dev/null)" ]; do
    kill -0 $process || fail "the study was over before it could be interrupted"
    sleep 0.01
done
kill -INT $process
status=0
wait $process || status=$?
expect_status 130
expect_stderr "Run the same command again to resume."
expect_in_file out/report.md "Partial result"

ffstudy run "$folder/study.toml" --threads 2 --out out
expect_status 0
ffstudy run "$folder/study.toml" --threads 1 --out whole
expect_status 0
for file in summary.csv trials.csv results.json; do expect_equal_files whole/$file out/$file; done
