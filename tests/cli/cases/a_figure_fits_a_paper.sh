#!/usr/bin/env bash
# One picture of a study in the size, the letters and the format that a paper asks for.
source "$(dirname "$0")/../harness.sh"

needs() { command -v "$1" >/dev/null || { echo "$1 is missing: apt-get install $2" >&2 && exit 1; }; }
needs rsvg-convert librsvg2-bin
needs node nodejs
needs xmllint libxml2-utils

ffstudy convergence --sampler random,sobol,halton --samples 64,128,256 --trials 6 --out out --quiet
expect_status 0
ffstudy figure out
expect_status 0
expect_stdout "Error against evaluations, adjacent pairs."

for format in svg pdf png pgf; do
    ffstudy figure out convergence --pairs adjacent --methods random,sobol --width 84mm --height 60mm --out fig.$format
    expect_status 0
    expect_file fig.$format
done
xmllint --noout fig.svg || fail "the figure is malformed"
expect_in_file fig.svg 'width="84.000mm" height="60'
expect_in_file fig.svg '>sobol<'
! grep -q halton fig.svg fig.pgf || fail "expected the methods that were asked for and no other"
[ "$(head -c 5 fig.pdf)" = %PDF- ] || fail "fig.pdf is no PDF"
[ "$(head -c 4 fig.png | tail -c 3)" = PNG ] || fail "fig.png is no PNG"
[ -z "$(find . -name '.ffstudy-part*')" ] || fail "expected nothing left of what was on its way"

ffstudy figure out answer --font "Latin Modern Roman" --font-size 9 --out answer.svg
expect_in_file answer.svg 'font-family="Latin Modern Roman"'

# LaTeX takes the .pgf, where it has the package.
if command -v pdflatex >/dev/null && kpsewhich pgf.sty >/dev/null; then
    echo '\documentclass{article}\usepackage{pgf}\usepgflibrary{svg.path}\begin{document}\input{fig.pgf}\end{document}' >paper.tex
    pdflatex -halt-on-error -interaction=nonstopmode paper.tex >"$folder/stdout" 2>&1 </dev/null || fail "pdflatex refuses the figure"
fi

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
refuses "a figure ends in .pdf, .svg, .png or .pgf" answer --out fig.jpg
refuses "that of answer follows from what it shows" answer --height 50mm
refuses "a scale of colours has no PGF" bias-map-0-random-1-64-rays --out fig.pgf
