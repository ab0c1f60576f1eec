#!/usr/bin/env bash
# What README.md and docs/ show is what the program does.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

# The README's study runs, and prints what the README says it prints.
blocks toml "$root/README.md" >shallow_box.toml
promised_after() { blocks "" "$root/README.md" | sed "0,/^\\$ $1\$/d" | sed '/^\$ /,$d'; }
promised_after "ffstudy run shallow_box.toml" >"$folder/promised"
ffstudy run shallow_box.toml
expect_status 0
expect_equal_files "$folder/promised" "$folder/stdout"
sed 's/"sobol"/"halton"/' shallow_box.toml >halton.toml
ffstudy run halton.toml --out results/halton --quiet
promised_in_manual() { blocks "" "$root/docs/command-line.md" | sed "0,/^\\$ $1\$/d" | sed '/^\$ /,$d'; }
promised_in_manual "ffstudy compare results\/halton results\/shallow_box" >"$folder/promised"
ffstudy compare results/halton results/shallow_box
expect_status 1
expect_equal_files "$folder/promised" "$folder/stdout"

# So does the study of the paper: with two trials all lines but the verdicts of sampled methods and claims are the
# same, and these begin as they do with a thousand.
ffstudy sr_vs_pdm --trials 2 --out two_trials
expect_status 0
blocks "" "$root/docs/sr-vs-pdm.md" | sed -n '/^sr_vs_pdm:/,/^\$ /p' | sed '$d' >"$folder/promised"
[ "$(wc -l <"$folder/promised")" -gt 30 ] || fail "docs/sr-vs-pdm.md does not show the study"
sed -Ei 's/ +/ /g' "$folder/promised" "$folder/stdout"
while IFS= read -r line; do
    [[ ! $line =~ (none found|supported,|of sampled methods|errs) ]] || line=${line:0:16}
    expect_stdout "$line"
done <"$folder/promised"

# The catalogue is shown as it is.
blocks "" "$root/docs/command-line.md" | sed -n '/^\$ ffstudy list samplers$/,/^gauss_legendre /p' | sed 1d >"$folder/promised"
ffstudy list samplers
expect_equal_files "$folder/promised" "$folder/stdout"

# So are the configurations, with the digits that are computed.
blocks "" "$root/docs/catalogue.md" | sed -n '/^\$ ffstudy list configurations | head -8$/,/^\$ /p' | sed '1d; $d' >"$folder/promised"
ffstudy list configurations
head -8 "$folder/stdout" >"$folder/begin"
expect_equal_files "$folder/promised" "$folder/begin"
blocks "" "$root/docs/catalogue.md" | sed -n '/^\$ ffstudy explain wedge$/,/^Against/p' | sed '1d; $d' >"$folder/promised"
ffstudy explain wedge
expect_equal_files "$folder/promised" "$folder/stdout"

# The study of the catalogue has a row for each pair and method, and none is biased. Those that the page shows are among
# them, with their exact values. (Estimates may differ in the last digits where Embree has other code for a CPU.)
rows() { sed -nE 's/^([a-z_0-9]+) +(.*, ([0-9]+ × [0-9²]+ [a-z]+|exact)) .* (0\.[0-9]{12}) .*$/\1 \2 \4/p'; }
ffstudy run catalogue --trials 10 --out catalogue
expect_status 0
! grep -q BIASED "$folder/stdout" || fail "the study of the catalogue finds a bias"
for text in "$folder/stdout" "$root/docs/catalogue.md"; do
    ! grep -E '  –  .*agrees' "$text" >&2 || fail "an estimate without an interval agrees with anything"
done
[ "$(grep -cE '  –  .*no test: infinite variance' "$folder/stdout")" -eq 7 ] || fail "expected 7 pairs without an interval"
rows <"$folder/stdout" >"$folder/shown"
rows <"$root/docs/catalogue.md" >"$folder/promised"
[ "$(wc -l <"$folder/shown")" -eq 259 ] || fail "the study of the catalogue does not have 259 rows"
[ "$(wc -l <"$folder/promised")" -eq 7 ] || fail "docs/catalogue.md does not show 7 rows of the study"
! grep -Fxvf "$folder/shown" "$folder/promised" >&2 || fail "docs/catalogue.md shows other rows than the study has"

# So does the example of docs/gates.md.
blocks toml "$root/docs/gates.md" >bands.toml
blocks "" "$root/docs/gates.md" | sed '0,/^\$ ffstudy check bands.toml$/d; /^ffstudy check/,$d' >"$folder/promised"
ffstudy check bands.toml
expect_status 0
expect_equal_files "$folder/promised" "$folder/stdout"

# Every column and key that is written is explained.
{
    head -qn 1 results/shallow_box/summary.csv | tr , '\n'
    grep -ohE '"[a-z_0-9]+":' results/shallow_box/{results,context}.json | cut -d'"' -f2
    grep -oE 'CREATE TABLE [a-z]+' "$root/studies/store/store.cpp" | cut -d' ' -f3
} | sort -u >"$folder/written"
grep -oE '`[a-z_0-9]+`' "$root/docs/results.md" | tr -d '`' >"$folder/explained"
! grep -Fxvf "$folder/explained" "$folder/written" >&2 || fail "docs/results.md does not explain these"

# The example of the study file has the 12 cells that its text counts.
blocks toml "$root/docs/study-files.md" | sed '/^sizes = \[/,$d' >example.toml
ffstudy run example.toml --dry-run
expect_status 0
[ "$(awk '/ s$/ {cells += $(NF - 4)} END {print cells}' "$folder/stdout")" -eq 12 ] || fail "expected 12 cells"

# Every command that the documents name is there, and so is every file that they link to.
documents=("$root"/README.md "$root"/docs/*.md)
commands=$(sed -nE 's/.*(`|[$] )ffstudy ([a-z0-9_-]+).*/\2/p' "${documents[@]}" | sort -u)
[ -n "$commands" ] || fail "no command found in the documents"
ffstudy --help
for command in $commands; do
    grep -Eq "^  $command " "$folder/stdout" || fail "the documents name a command $command"
done
for document in "${documents[@]}"; do
    for link in $(grep -oP '\]\(\K[^)#:]+(?=[)#])' "$document"); do
        [ -e "${document%/*}/$link" ] || fail "$document links to $link, which is not there"
    done
    for script in $(grep -oE '(^|`)scripts/[a-z.]+' "$document" | tr -d '`'); do
        [ -e "$root/$script" ] || fail "$document names $script, which is not there"
    done
done
