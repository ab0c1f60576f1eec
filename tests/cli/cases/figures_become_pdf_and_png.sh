#!/usr/bin/env bash
# A figure as PDF and as PNG.
# Needs rsvg-convert.
source "$(dirname "$0")/../harness.sh"

ffstudy convergence --sampler random,sobol --samples 64,128,256 --trials 6 --out out --quiet
expect_status 0
for format in pdf png; do
    ffstudy figure out convergence --pairs adjacent --width 84mm --height 60mm --out fig.$format
    expect_status 0
done
[ "$(head -c 5 fig.pdf)" = %PDF- ] || fail "fig.pdf is no PDF"
[ "$(head -c 4 fig.png | tail -c 3)" = PNG ] || fail "fig.png is no PNG"
[ -z "$(find . -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"
