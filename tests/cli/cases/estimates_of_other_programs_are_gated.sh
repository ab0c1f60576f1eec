#!/usr/bin/env bash
# What docs/gating-your-code.md shows works, and files that cannot be judged are refused.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

document=$root/docs/gating-your-code.md
# The last gate of the page is on means with errors (reported_means_are_gated.sh).
blocks toml "$document" | awk '/^\[\[gate\]\]$/ {gate = $0; next} gate != "" {if (/flux/) exit; print gate; gate = ""} 1' >bands.toml
blocks python "$document" >example.py
blocks cpp "$document" >example.cpp

python3 example.py
ffstudy check bands.toml --estimates estimates.csv
expect_status 0
expect_file results/bands/verdicts.csv
ffstudy check bands.toml --estimates estimates.csv --dry-run
expect_status 0
expect_stdout "100 in the file"
c++ -std=c++20 -O1 example.cpp -o example
./example >from_cpp.csv
ffstudy check bands.toml --estimates from_cpp.csv --quiet
expect_status 0

# A program that is wrong by a tenth.
awk -F, -v OFS=, 'NR > 1 {$3 *= 1.1} 1' from_cpp.csv >biased.csv
ffstudy check bands.toml --estimates biased.csv
expect_status 1

# Trials that are too few to tell: never a pass.
head -n 13 from_cpp.csv >few.csv
ffstudy check bands.toml --estimates few.csv
expect_status 4

# refused TEXT: estimates.csv as the last line of `bad.csv` is refused with this text, and nothing is written.
rm -rf results
refused() {
    ffstudy check bands.toml --estimates bad.csv
    expect_status 2
    expect_stderr "$1"
    expect_no_stdout
    [ ! -e results ] || fail "expected no results"
}
{ cat from_cpp.csv && echo "100,F16,"; } >bad.csv
refused "bad.csv:102:9: no estimate (an empty cell)"
{ cat from_cpp.csv && echo "100,F16,nan"; } >bad.csv
refused "bad.csv:102:9: estimate = 'nan' (not a finite number"
{ cat from_cpp.csv && echo "7,F16,0.2"; } >bad.csv
refused "bad.csv:102:1: trial 7 gives 'F16' again (line 9 has it"
head -n 4 from_cpp.csv >bad.csv
refused "'F16' has 3 row(s)"
awk -F, -v OFS=, 'NR > 1 {$3 = 0.2} 1' from_cpp.csv >bad.csv
refused "are all 0.2"
awk -F, -v OFS=, 'NR > 1 {if (NR < 52) {x[NR] = $3} else {$3 = x[NR - 50]}} 1' from_cpp.csv >bad.csv
refused "bad.csv:52:1: the estimates of 'F16' repeat from here on those from line 2 on"
sed 's/F16/F61/' from_cpp.csv >bad.csv
refused "quantity = \"F16\" (bad.csv has no such estimates). Did you mean 'F61'?"

sed 's/^band = 1e-3/reference_se = 1e-3\nband = 1e-3/' bands.toml >uncertain.toml
ffstudy check uncertain.toml --estimates from_cpp.csv
expect_status 2
expect_stderr "no number of trials can decide"
ffstudy check bands.toml
expect_status 2
expect_stderr "Add --estimates FILE.csv"
ffstudy check bands.toml --estimates missing.csv
expect_status 3
ffstudy check "$root/tests/gates/push.toml" --estimates from_cpp.csv
expect_status 2
expect_stderr "no gate of"
