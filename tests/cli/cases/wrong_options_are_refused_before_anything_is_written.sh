#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ffstudy sr_vs_pdm --trials 0
expect_refused 2 "--trials 0 (nothing would be run). Try 64."
ffstudy sr_vs_pdm --trials 1
expect_refused 2 "--trials 1 (a confidence interval needs at least 2). Try 64."
ffstudy sr_vs_pdm --trials -5
expect_refused 2 "--trials"
ffstudy sr_vs_pdm --threads 0
expect_refused 2 "--threads 0 (1 to"
ffstudy sr_vs_pdm --seed -1
expect_refused 2 "--seed"
ffstudy sr_vs_pdm --seed 9223372036854775808
expect_refused 2 "--seed 9223372036854775808 (at most 9223372036854775807)"
ffstudy sr_vs_pmd
expect_refused 2 "sr_vs_pmd"
ffstudy run sr_vs_pmd
expect_refused 2 "Did you mean 'sr_vs_pdm'?"
ffstudy run nothing_like_it
expect_refused 2 "neither a study file nor a built-in study. See 'ffstudy list studies'."
ffstudy run
expect_refused 2 "STUDY is required"
ffstudy
expect_refused 2 "is required"
ffstudy list sampler
expect_refused 2 "Did you mean 'samplers'?"
ffstudy explain sobool
expect_refused 2 "Did you mean 'sobol'?"
