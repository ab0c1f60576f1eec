#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ladder=(convergence --sampler sobol --samples 256 --trials 2000)

ffstudy "${ladder[@]}" --until ci=5e-3 --level 0.99 --out ci
expect_status 0
expect_stdout "every pair's interval of level 0.99 is at most ±0.005 wide"
expect_stdout "Reached by 1 of 1 methods and sizes."
expect_in_file ci/summary.csv stein_two_stage
expect_in_file ci/results.json '"goal": "ci"'
expect_in_file ci/context.json "--until ci=5e-3 --level 0.99"

# With another number of threads, and resumed: nothing changes.
ffstudy "${ladder[@]}" --until ci=5e-3 --level 0.99 --out again --threads 1
expect_status 0
expect_equal_files ci/results.json again/results.json
ffstudy "${ladder[@]}" --until ci=5e-3 --level 0.99 --out ci
expect_status 0
expect_equal_files ci/results.json again/results.json

# The rule is part of the study, and of another rule only the pilot is reused.
ffstudy "${ladder[@]}" --until ci=4e-3 --level 0.99 --out ci
expect_status 2
expect_stderr "holds another study"

# It cannot get there: the end is clear, and results are there.
ffstudy convergence --sampler sobol --samples 256 --until rmse=1e-6 --trials 50 --out far
expect_status 4
expect_stdout "NOT reached"
expect_file far/report.md
ffstudy convergence --sampler random --estimator area_kernel --samples 64 --trials 40 --until rmse=1e-2 --out kernel
expect_status 4
expect_stdout "24 pairs have infinite variance"

rm -r ci again far kernel
ffstudy "${ladder[@]}" --until speed=1
expect_refused 2 "--until speed=1 (the goals are rmse and ci)"
ffstudy "${ladder[@]}" --until rmse=0
expect_refused 2 "--until rmse=0 (not a number above 0)"
ffstudy "${ladder[@]}" --until rmse=1e-3 --level 1
expect_refused 2 "--level 1 (above 0.5, at most 1 - 1e-9)"
ffstudy convergence --sampler sobol --samples 256 --trials 4 --until rmse=1e-3
expect_refused 2 "--trials 4 (the pilot of an adaptive study has at least 5)"
