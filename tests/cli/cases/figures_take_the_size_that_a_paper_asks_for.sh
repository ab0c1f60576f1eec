#!/usr/bin/env bash
# One picture of a study in the size that a paper asks for, letters included. (As PDF and PNG: figures_become_pdf_and_png.sh.)
# Needs Node.js.
source "$(dirname "$0")/../harness.sh"

ffstudy convergence --sampler random,sobol,halton --samples 64,128,256 --trials 6 --out out --quiet
expect_status 0
ffstudy figure out
expect_status 0
expect_stdout "Error against evaluations, adjacent pairs."

ffstudy figure out convergence --pairs adjacent --methods random,sobol --width 84mm --height 60mm --out fig.svg
expect_status 0
expect_file fig.svg
xmllint --noout fig.svg || fail "the figure is malformed"
expect_in_file fig.svg 'width="84.000mm" height="60'
expect_in_file fig.svg '>sobol<'
! grep -q halton fig.svg || fail "expected the methods that were asked for and no other"
[ -z "$(find . -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"

ffstudy figure out answer --font "Latin Modern Roman" --font-size 9 --out answer.svg
expect_in_file answer.svg 'font-family="Latin Modern Roman"'

# What is not meant is said before anything is drawn.
refuses() {
    local problem=$1
    shift
    ffstudy figure out "$@"
    expect_status 2
    expect_stderr "$problem"
}
refuses "that can be 2 pictures: convergence-parallel-pairs, convergence-adjacent-pairs" convergence
refuses "there is no such picture" convergenc
refuses "Did you mean 'sobol'?" convergence --pairs adjacent --methods sobl
refuses "a length from 20 to 2000 mm" answer --width 5
refuses "from 4 to 40 points" answer --font-size 50
refuses "a figure ends in .pdf, .svg or .png" answer --out fig.jpg
refuses "that of answer follows from what it shows" answer --height 50mm --out fig.svg
