#!/usr/bin/env bash
# Runs are kept in a history, and ffstudy trend finds where their mean changes.
source "$(dirname "$0")/../harness.sh"

printf '%s\n' '[[gate]]' 'name = "flux"' 'quantity = "flux"' 'kind = "bias"' 'reference = 1' 'band = 0.2' >bands.toml
# trials SEED MEAN: 50 trials.
trials() {
    python3 - "$@" <<'END'
import random, sys
rng = random.Random(int(sys.argv[1]))
print("trial,quantity,estimate")
for trial in range(50): print(f"{trial},flux,{rng.gauss(float(sys.argv[2]), 0.05)!r}")
END
}
for run in $(seq 1 20); do
    trials "$run" "$([ "$run" -le 12 ] && echo 1 || echo 1.05)" >estimates.csv
    ffstudy check bands.toml --estimates estimates.csv --history history.csv --commit "c$run" --quiet
    # One file in twenty looks serially correlated, and this gate is inconclusive then.
    [ "$status" -eq 0 ] || expect_status 4
    [ "$run" -ne 6 ] || cp history.csv short.csv
done
[ "$(wc -l <history.csv)" -eq 21 ] || fail "expected a line for each run"
ffstudy trend history.csv --out trend
expect_status 1
expect_stdout "from c13 on"
expect_stdout "steady"
expect_in_file trend/trend.html "<svg"
ffstudy trend short.csv
expect_status 4
expect_stdout "too few"
head -n 13 history.csv >steady.csv
ffstudy trend steady.csv
expect_status 0

ffstudy check bands.toml --estimates estimates.csv --history history.csv --commit c20
expect_status 2
expect_stderr "has it already"
ffstudy check bands.toml --estimates estimates.csv --history history.csv
expect_status 2
expect_stderr "Add --commit NAME"
ffstudy trend bands.toml
expect_status 2
ffstudy trend history.csv --alpha 0.9
expect_status 2
head -n 1 history.csv >empty.csv
ffstudy trend empty.csv
expect_status 2

# Trials as a baseline of means.
ffstudy check bands.toml --estimates estimates.csv --save-baseline base.csv
expect_status 0
expect_in_file base.csv "quantity,mean,standard_error,n"
printf '%s\n' '[[gate]]' 'name = "flux"' 'quantity = "flux"' 'kind = "equal"' 'band = 0.2' >equal.toml
trials 77 1 >estimates.csv
ffstudy check bands.toml --estimates estimates.csv --save-baseline new.csv --quiet
ffstudy check equal.toml --estimates new.csv --against base.csv
expect_status 0
