#!/usr/bin/env bash
# Means with standard errors, as codes report them, are judged bin by bin; what cannot be compared is refused.
source "$(dirname "$0")/../harness.sh"

# means SEED SHIFT [ERROR_FACTOR] [RUNS]: 200 bins of true mean 1 and error 0.001, bin 17 shifted by SHIFT errors.
means() {
    python3 - "$@" <<'END'
import random, sys
seed, shift = int(sys.argv[1]), float(sys.argv[2])
factor = float(sys.argv[3]) if len(sys.argv) > 3 else 1
runs = int(sys.argv[4]) if len(sys.argv) > 4 else 0
rng = random.Random(seed)
print("quantity,bin,mean,standard_error,n" + (",run" if runs else ""))
for run in range(max(1, runs)):
    for bin in range(200):
        mean = rng.gauss(1 + (shift * 1e-3 if bin == 17 else 0), 1e-3)
        print(f"flux,{bin},{mean!r},{factor * 1e-3!r},1000" + (f",{run}" if runs else ""))
END
}
# gate LINES...: bands.toml with one gate on the flux.
gate() { printf '%s\n' '[[gate]]' 'name = "flux"' 'quantity = "flux"' "$@" >bands.toml; }

means 1 0 >new.csv
means 2 0 >old.csv
means 3 30 >shifted.csv

# Two files: pass, inconclusive with a band that is too narrow, fail, with the worst bin named.
gate 'kind = "equal"' 'band = 0.02'
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_status 0
expect_stdout "200 bins: 0 outside (Holm), 0 undecided"
expect_stdout "trusts the standard errors that are stated"
expect_file results/bands/verdicts.json
gate 'kind = "equal"' 'band = 1e-4'
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_status 4
ffstudy check bands.toml --estimates shifted.csv --against old.csv
expect_status 1
expect_stdout "worst 17 (+"
gate 'kind = "equal"' 'band = 1e-4' 'combine = "cauchy"'
ffstudy check bands.toml --estimates shifted.csv --against old.csv
expect_status 1
expect_stdout "(cauchy)"
gate 'kind = "equal"' 'band = 1e-4' 'combine = "simes"'
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_status 4

# All bins together, by a covariance that is known: here of bins that do not vary together.
python3 -c 'print("bin,other_bin,covariance")
for i in range(200):
    for j in range(i + 1): print(f"{i},{j},{1e-6 if i == j else 0}")' >covariance.csv
gate 'kind = "bias"' 'reference = 1' 'band = 1e-4' 'combine = "chi_squared"' 'covariance = "covariance.csv"'
ffstudy check bands.toml --estimates new.csv
expect_status 4
ffstudy check bands.toml --estimates shifted.csv
expect_status 1
expect_stdout "(chi_squared)"
sed -i 's/^3,3,1e-06/3,3,1e-03/' covariance.csv
ffstudy check bands.toml --estimates new.csv
expect_status 2
expect_stderr "bin '3' has the variance 0.001 here"

# Exact values, one for each bin or one for all, in absolute or relative bands.
{ echo "quantity,bin,mean" && for bin in $(seq 0 199); do echo "flux,$bin,1"; done; } >exact.csv
gate 'kind = "bias"' 'band = 0.02' 'relative = true'
ffstudy check bands.toml --estimates new.csv --against exact.csv
expect_status 0
ffstudy check bands.toml --estimates shifted.csv --against exact.csv
expect_status 1
gate 'kind = "bias"' 'reference = 1' 'band = 0.02'
ffstudy check bands.toml --estimates new.csv
expect_status 0
gate 'kind = "equal"' 'band = 0.02'
ffstudy check bands.toml --estimates new.csv --against exact.csv
expect_status 2
expect_stderr "needs the column 'standard_error' of exact.csv"

# Are stated errors right? Several runs tell; single samples' deviations, squares and sums are recognised.
gate 'kind = "std_error"' 'band = 1.5'
means 4 0 1 40 >runs.csv
ffstudy check bands.toml --estimates runs.csv
expect_status 0
expect_stdout "where 95 % should"
means 4 0 31.6 40 >runs.csv
ffstudy check bands.toml --estimates runs.csv
expect_status 1
expect_stdout "standard deviations of single samples, probably"
means 4 0 1000 40 >runs.csv
ffstudy check bands.toml --estimates runs.csv
expect_status 1
expect_stdout "errors of sums rather than of means, probably"
means 4 0 0.001 40 >runs.csv
ffstudy check bands.toml --estimates runs.csv
expect_status 1
expect_stdout "variances, probably"
ffstudy check bands.toml --estimates new.csv
expect_status 2
expect_stderr "needs at least 5 runs"

# Spread behind the error, and efficiency.
gate 'kind = "std"' 'reference = 0.0316' 'band = 0.5'
ffstudy check bands.toml --estimates new.csv
expect_status 4
expect_stdout "add kurtosis = 3"
gate 'kind = "std"' 'reference = 0.0316' 'band = 0.5' 'kurtosis = 3'
ffstudy check bands.toml --estimates new.csv
expect_status 0
gate 'kind = "efficiency"' 'band = 0.5' 'kurtosis = 3'
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_status 0
means 5 0 2 >worse.csv
ffstudy check bands.toml --estimates worse.csv --against old.csv
expect_status 1

# Sums instead of means.
gate 'kind = "equal"' 'band = 0.02'
awk -F, -v OFS=, 'NR > 1 {$3 *= 1000; $4 *= 1000} 1' new.csv >sums.csv
ffstudy check bands.toml --estimates sums.csv --against old.csv
expect_status 1
expect_stdout "sums instead of means, probably"
awk -F, -v OFS=, 'NR > 1 {$4 = $4 * $4} 1' new.csv >variances.csv
ffstudy check bands.toml --estimates variances.csv --against old.csv
expect_stdout "variances given as standard errors, probably"

# A bin that no sample fell into is never passed over.
awk -F, -v OFS=, 'NR == 5 {$3 = 0; $4 = 0} 1' new.csv >empty.csv
ffstudy check bands.toml --estimates empty.csv --against old.csv
expect_status 4
expect_stdout "1 bin that no sample fell into is not judged"

rm -rf results
# refused TEXT: bad.csv against old.csv is refused with this text, and nothing is written.
refused() {
    ffstudy check bands.toml --estimates bad.csv --against old.csv
    expect_status 2
    expect_stderr "$1"
    expect_no_stdout
    [ ! -e results ] || fail "expected no results"
}
cp old.csv bad.csv
refused "has the same numbers as in old.csv"
awk -F, -v OFS=, 'NR == 5 {$4 = 0} 1' new.csv >bad.csv
refused "bad.csv:5:"
refused "no spread is no evidence of precision"
awk -F, -v OFS=, 'NR == 5 {$4 = -$4} 1' new.csv >bad.csv
refused "it cannot be negative"
awk -F, -v OFS=, 'NR == 5 {$4 = "nan"} 1' new.csv >bad.csv
refused "standard_error = 'nan' (not a finite number"
{ cat new.csv && tail -n 1 new.csv; } >bad.csv
refused "'flux', bin 199 stands here again (line 201 has it already"
head -n 150 new.csv >bad.csv
refused "is not matched in bad.csv (200 bins here, 149 there"
head -n 1 new.csv >bad.csv
refused "no rows below the header (nothing would be compared)"
sed 's/flux/flax/' new.csv >bad.csv
refused "quantity = \"flux\" (bad.csv has no such quantity). Did you mean 'flax'?"
sed '1s/standard_error/sigma/' new.csv >bad.csv
refused "column 'sigma' is unknown"
awk -F, -v OFS=, '{$4 = ""} 1' new.csv >bad.csv
refused "bad.csv:1:"
{ means 6 0 1 1 && means 6 0 1 1 | tail -n +2 | sed 's/0$/1/'; } >bad.csv
refused "runs 0 and 1 of 'flux' hold the same numbers in all 200 bins"
means 6 0 1 3 | sed '300d' >bad.csv
refused "every bin needs the same runs"
cp new.csv bad.csv
ffstudy check bands.toml --estimates bad.csv
expect_status 2
expect_stderr "Add --against FILE.csv"
ffstudy check bands.toml --against old.csv
expect_status 2
# Trials are another kind of file.
# trials SEED: 50 trials of mean 1.
trials() {
    python3 -c 'import random, sys
print("trial,quantity,estimate")
for i in range(50): print(f"{i},flux,{random.Random(int(sys.argv[1]) + i).gauss(1, 0.1)!r}")' "$1"
}
trials 0 >trials.csv
ffstudy check bands.toml --estimates trials.csv
expect_status 2
expect_stderr "is of trials, which are gated on bias and std"
ffstudy check bands.toml --estimates trials.csv --against old.csv
expect_status 2
ffstudy check bands.toml --estimates trials.csv --dry-run
expect_status 2
# The picture of many bins.
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_stdout "differences in standard errors, counts as logarithms: -7.5 or less |"
# Trials are saved as means, which those of a later run are compared with.
ffstudy check bands.toml --estimates trials.csv --save-baseline base.csv
expect_status 0
expect_in_file base.csv "quantity,mean,standard_error,n"
trials 100 >trials.csv
ffstudy check bands.toml --estimates trials.csv --save-baseline means.csv --quiet
gate 'kind = "equal"' 'band = 0.2'
ffstudy check bands.toml --estimates means.csv --against base.csv
expect_status 0
