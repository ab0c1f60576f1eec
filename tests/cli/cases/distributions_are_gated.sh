#!/usr/bin/env bash
# Counts against shares and other counts, trials against a known distribution and other trials.
source "$(dirname "$0")/../harness.sh"

# gate LINES...: bands.toml with one gate on the energy.
gate() { printf '%s\n' '[[gate]]' 'name = "energy"' 'quantity = "energy"' 'kind = "distribution"' "$@" >bands.toml; }
# counts SEED TILT: 20000 events in 20 bins, the first ten bins more likely by TILT, the others less.
counts() {
    python3 - "$@" <<'END'
import random, sys
rng, tilt = random.Random(int(sys.argv[1])), float(sys.argv[2])
weights = [1 + tilt] * 10 + [1 - tilt] * 10
found = [0] * 20
for bin in rng.choices(range(20), weights, k=20000): found[bin] += 1
print("quantity,bin,count")
for bin, count in enumerate(found): print(f"energy,{bin},{count}")
END
}
# trials SEED N MEAN: normal values.
trials() {
    python3 - "$@" <<'END'
import random, sys
rng = random.Random(int(sys.argv[1]))
print("trial,quantity,estimate")
for trial in range(int(sys.argv[2])): print(f"{trial},energy,{rng.gauss(float(sys.argv[3]), 1)!r}")
END
}

counts 1 0 >new.csv
counts 2 0 >old.csv
counts 3 0.3 >tilted.csv
{ echo "quantity,bin,share" && for bin in $(seq 0 19); do echo "energy,$bin,0.05"; done; } >shares.csv
gate 'band = 0.1'
for reference in shares.csv old.csv; do
    ffstudy check bands.toml --estimates new.csv --against $reference
    expect_status 0
    ffstudy check bands.toml --estimates tilted.csv --against $reference
    expect_status 1
    expect_stdout "errors)"
done
gate 'band = 0.001'
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_status 4

# Never wrong: weights, missing bins, the same file, shares without counts.
gate 'band = 0.1'
sed 's/,0,.*/,0,1000.5/' new.csv >bad.csv
ffstudy check bands.toml --estimates bad.csv --against old.csv
expect_status 2
expect_stderr "weighted events"
sed '$d' shares.csv >bad.csv
ffstudy check bands.toml --estimates new.csv --against bad.csv
expect_status 2
expect_stderr "is not matched in"
sed 's/0.05/0.04/' shares.csv >bad.csv
ffstudy check bands.toml --estimates new.csv --against bad.csv
expect_status 2
expect_stderr "add up to 0.8"
ffstudy check bands.toml --estimates new.csv --against new.csv
expect_status 2
expect_stderr "has the same numbers as in"
# Small counts are equal by chance.
printf '%s\n' quantity,bin,count energy,0,11 energy,1,12 >few.csv
ffstudy check bands.toml --estimates few.csv --against few.csv
expect_status 4
ffstudy check bands.toml --estimates shares.csv --against old.csv
expect_status 2
expect_stderr "holds shares"

# Trials.
trials 1 4000 0 >new.csv
trials 2 500 0.8 >shifted.csv
trials 3 500 0 >old.csv
gate 'band = 0.06' 'reference = "normal(0, 1)"'
ffstudy check bands.toml --estimates new.csv
expect_status 0
ffstudy check bands.toml --estimates new.csv --dry-run
expect_status 0
expect_stdout "4000 in the file"
ffstudy check bands.toml --estimates shifted.csv
expect_status 1
gate 'band = 0.06'
ffstudy check bands.toml --estimates shifted.csv --against old.csv
expect_status 1
ffstudy check bands.toml --estimates old.csv --against old.csv
expect_status 2
expect_stderr "the same values in both files"
ffstudy check bands.toml --estimates old.csv
expect_status 2
gate 'band = 0.06' 'reference = "normal"'
ffstudy check bands.toml --estimates new.csv
expect_status 2
expect_stderr "fitted to the values that are tested they change the critical values"

# At any time, between bounds.
printf '%s\n' '[[gate]]' 'name = "share"' 'quantity = "energy"' 'kind = "bias"' 'reference = 0' 'band = 1' \
    'anytime = "bounded"' 'bounds = [-10, 10]' >bands.toml
ffstudy check bands.toml --estimates new.csv
expect_status 0
expect_stdout "at any time"
sed -i 's/-10, 10/-1, 1/' bands.toml
ffstudy check bands.toml --estimates new.csv
expect_status 2
expect_stderr "leave the bounds -1 to 1"
