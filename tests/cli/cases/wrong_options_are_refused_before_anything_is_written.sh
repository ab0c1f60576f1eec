#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

ffstudy sr_vs_pdm --trials 0
expect_refused 2 "--trials 0 (nothing would be run). Try 64."
ffstudy sr_vs_pdm --trials 1
expect_refused 2 "--trials 1 (a confidence interval needs at least 2). Try 64."
ffstudy sr_vs_pdm --trials -5
expect_refused 2 "ffstudy: --trials -5 (not a whole number from 0 to 2^64 - 1). Write it like 1000."
ffstudy sr_vs_pdm --trials 1e3
expect_refused 2 "ffstudy: --trials 1e3 (not a whole number from 0 to 2^64 - 1). Write it like 1000."
ffstudy sr_vs_pdm --trials
expect_refused 2 "ffstudy: --trials needs one value. Give it once. See 'ffstudy sr_vs_pdm --help'."
ffstudy sr_vs_pdm --trails 5
expect_refused 2 "ffstudy: unknown option '--trails'. Did you mean '--trials'? See 'ffstudy sr_vs_pdm --help'."
ffstudy sr_vs_pdm --out ""
expect_refused 2 "ffstudy: --out is empty (it would silently mean the default). Give a value, or leave the option out."
ffstudy report ""
expect_refused 2 "is empty"
ffstudy sr_vs_pdm --threads 0
expect_refused 2 "--threads 0 (1 to"
ffstudy sr_vs_pdm --seed -1
expect_refused 2 "--seed -1 (not a whole number"
ffstudy sr_vs_pdm --seed 9223372036854775808
expect_refused 2 "--seed 9223372036854775808 (at most 9223372036854775807)"
ffstudy sr_vs_pmd
expect_refused 2 "ffstudy: unknown command 'sr_vs_pmd'. Did you mean 'sr_vs_pdm'? See 'ffstudy --help'."
ffstudy sr_vs_pmd --trials 5
expect_refused 2 "ffstudy: unknown command 'sr_vs_pmd'. Did you mean 'sr_vs_pdm'? See 'ffstudy --help'."
ffstudy run sr_vs_pmd
expect_refused 2 "Did you mean 'sr_vs_pdm'?"
ffstudy run nothing_like_it
expect_refused 2 "neither a study file nor a built-in study. See 'ffstudy list studies'."
ffstudy run
expect_refused 2 "ffstudy: STUDY is missing. See 'ffstudy run --help'."
ffstudy run sr_vs_pdm another
expect_refused 2 "ffstudy: 'another' is one argument too many. See 'ffstudy run --help'."
ffstudy help sr_vs_pmd
expect_refused 2 "ffstudy: unknown command 'sr_vs_pmd'. Did you mean 'sr_vs_pdm'? See 'ffstudy --help'."
ffstudy list sampler
expect_refused 2 "Did you mean 'samplers'?"
ffstudy explain sobool
expect_refused 2 "Did you mean 'sobol'?"
