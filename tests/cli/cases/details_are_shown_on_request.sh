#!/usr/bin/env bash
# With -v a run says what is planned, and every command which files it has written.
source "$(dirname "$0")/../harness.sh"

small_study 3 >"$folder/study.toml"
ffstudy run "$folder/study.toml" --out out -v
expect_status 0
expect_stderr "work units"
! grep -q 'x0a' "$folder/stderr" || fail "expected lines"
for file in report.html summary.csv results.json context.json; do expect_stderr "wrote out/$file"; done
ffstudy report out --format csv --out again
expect_status 0
! grep -q wrote "$folder/stderr" || fail "expected files to be named with -v only"
ffstudy report out --format csv --out again --verbose
expect_stderr "wrote again/summary.csv"
ffstudy report out --format csv --out none --pictures convergence
expect_status 2
expect_stderr "--pictures (says which are drawn by --format svg or pdf)"
[ ! -e none ] || fail "expected nothing written"
