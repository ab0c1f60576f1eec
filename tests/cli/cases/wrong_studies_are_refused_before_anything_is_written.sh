#!/usr/bin/env bash
source "$(dirname "$0")/../harness.sh"

# refuse PLACE PROBLEM < STUDY: every message names place, problem and a way out.
refuse() {
    cat >"$folder/study.toml"
    ffstudy run "$folder/study.toml" --out out
    expect_refused 2 "study.toml:$1: "
    expect_stderr "$2"
}

study='[study]
name = "t"
scene = "cube"
seed = 1'
rays='[[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 100'

refuse 5:10 "trials = 0 (nothing would be run). Try 64." <<<"$study
trials = 0
$rays"
refuse 5:10 "trials = 1 (a confidence interval needs at least 2). Try 64." <<<"$study
trials = 1
$rays"
refuse 5:1 "unknown key 'trails' (it would be ignored). Did you mean 'trials'?" <<<"$study
trails = 9
$rays"
refuse 8:11 "Did you mean \"random\"?" <<<"$study
trials = 9
${rays/\"random\"/\"randon\"}"
refuse 10:21 "100 points (stratified puts one point into each of k^4 cells). Nearest: 81 = 3^4 or 256 = 4^4." <<<"$study
trials = 9
${rays/\"random\"/\"stratified\"}"
refuse 8:11 "unequal weights" <<<"$study
trials = 9
${rays/\"random\"/\"gauss_legendre\"}"
refuse 11:20 "Try 9 or 16." <<<"$study
trials = 9
$rays
patches_per_face = 10"
refuse 3:9 "an edge needs a finite, positive length" <<<"${study/cube/box:1x-2x3}
trials = 9
$rays"
refuse 4:8 "seed = -1 (not a whole number from 0 up)" <<<"${study/seed = 1/seed = -1}
trials = 9
$rays"
refuse 2:1 "trials: missing. Add the key with a whole number." <<<"# a comment
$study
$rays"
refuse 2:8 "the byte 0xe9 is not UTF-8 (no other encoding is read). Save the file as UTF-8." <<<"${study/\"t\"/$'\xe9'}"
refuse 5:10 "docs/study-files.md" <<<"$study
trials = = 9"
