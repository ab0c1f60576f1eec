#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

# Every sampler climbs at sizes of its own, and the output says which.
ladder=(--sampler faure,stratified --samples "2^6..700" --trials 8)
ffstudy convergence "${ladder[@]}" --dry-run
expect_status 0
for size in 125 625 81 256; do expect_stdout "1 × $size rays"; done
expect_nothing_written

ffstudy convergence "${ladder[@]}" --seed 5 --save-study mine.toml
expect_status 0
expect_stdout "81 … 625 (3)"
expect_in_file results/convergence/slopes.csv "convergence,cube,stratified,adjacent,,,median_abs_error,"
expect_in_file results/convergence/report.md "## Convergence"
expect_in_file results/convergence/context.json "ffstudy convergence --scene cube --sampler faure,stratified"

# The saved study file gives the same results, and so does another number of threads.
ffstudy run mine.toml --out again --threads 1
expect_status 0
expect_equal_files results/convergence/slopes.csv again/slopes.csv
expect_equal_files results/convergence/results.json again/results.json

ffstudy convergence --sampler sobol --estimator area_kernel --samples 16,32,64 --trials 8 --out kernel
expect_status 0
expect_stdout "infinite variance, no RMSE"

rm -r results again kernel mine.toml
ffstudy convergence
expect_refused 2 "--sampler is missing"
ffstudy convergence --sampler sobl
expect_refused 2 'Did you mean "sobol"?'
ffstudy convergence --sampler gauss_legendre --estimator area_kernel
expect_refused 2 "gauss_legendre (it has nodes instead of sizes"
ffstudy convergence --sampler faure --samples 130..600
expect_refused 2 "no size that faure is made for lies in this range"
ffstudy convergence --sampler sobol --samples 2^6..
expect_refused 2 "'' is not a number of points"
ffstudy convergence --sampler sobol --estimator shooting
expect_refused 2 "estimator = 'shooting' is unknown"
ffstudy convergence --sampler sobol --trials 1 --save-study mine.toml
expect_refused 2 "trials"

# A file that is not a study file is not overwritten.
echo precious >data.csv
ffstudy convergence --sampler sobol --save-study data.csv --dry-run
expect_status 2
expect_stderr "--save-study data.csv: study files end in .toml."
[ "$(cat data.csv)" = precious ] || fail "expected the file to be left alone"
