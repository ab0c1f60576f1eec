#!/usr/bin/env bash
# Hits of n trials are judged by binomial tails, bin by bin; 0 and 1 are shares like any other.
source "$(dirname "$0")/../harness.sh"

# hits SEED SHARE TRIALS: bins 0 to 19 with this share, bin 20 without a hit, bin 21 without a miss.
hits() {
    python3 - "$@" <<'END'
import random, sys
rng, share, n = random.Random(int(sys.argv[1])), float(sys.argv[2]), int(sys.argv[3])
print("quantity,bin,hits,n")
for bin in range(20): print(f"F,{bin},{sum(rng.random() < share for _ in range(n))},{n}")
print(f"F,20,0,{n}\nF,21,{n},{n}")
END
}
# gate LINES...: bands.toml with one gate on the shares.
gate() { printf '%s\n' '[[gate]]' 'name = "shares"' 'quantity = "F"' "$@" >bands.toml; }

{ echo quantity,bin,mean && for bin in $(seq 0 19); do echo "F,$bin,0.2"; done && echo F,20,0 && echo F,21,1; } >exact.csv
hits 1 0.2 4000 >new.csv
hits 2 0.2 4000 >old.csv
hits 3 0.3 4000 >other.csv

gate 'kind = "bias"' 'band = 0.05'
ffstudy check bands.toml --estimates new.csv --against exact.csv
expect_status 0
expect_stdout "22 bins: 0 outside (Holm), 0 undecided"
ffstudy check bands.toml --estimates other.csv --against exact.csv
expect_status 1
gate 'kind = "equal"' 'band = 0.05'
ffstudy check bands.toml --estimates new.csv --against old.csv
expect_status 0
ffstudy check bands.toml --estimates other.csv --against old.csv
expect_status 1

# A dry run says how many runs like this one a band needs; with as many it passes.
gate 'kind = "bias"' 'band = 0.01'
ffstudy check bands.toml --estimates new.csv --against exact.csv
expect_status 4
ffstudy check bands.toml --estimates new.csv --against exact.csv --dry-run
expect_status 0
expect_stdout "runs              1 in the file"
runs=$(awk '$1 == "shares" {print $4}' "$folder/stdout")
hits 4 0.2 $((4000 * runs)) >more.csv
ffstudy check bands.toml --estimates more.csv --against exact.csv
expect_status 0

# refused TEXT: bad.csv is refused with this text.
refused() {
    ffstudy check bands.toml --estimates bad.csv --against exact.csv
    expect_status 2
    expect_stderr "$1"
    expect_no_stdout
}
printf 'quantity,bin,hits,n\nF,0,5,4\n' >bad.csv
refused "bad.csv:2:"
refused "more hits than the 4 trials"
printf 'quantity,bin,hits,n,mean\nF,0,5,4,1\n' >bad.csv
refused "column 'mean' beside 'hits' (a file of hits has quantity, n and hits). Keep one."
gate 'kind = "std"' 'reference = 0.1' 'band = 0.5'
cp new.csv bad.csv
refused "the spread of hits follows from their share"

# Where bins are independent, a small shift of them all is seen that no bin shows.
python3 -c 'import random
rng = random.Random(7)
print("quantity,bin,mean,standard_error")
for i in range(1000): print(f"F,{i},{rng.gauss(1.00085, 0.001)!r},0.001")' >shifted.csv
gate 'kind = "bias"' 'reference = 1' 'band = 1e-9' 'combine = "holm"'
ffstudy check bands.toml --estimates shifted.csv
expect_status 4
gate 'kind = "bias"' 'reference = 1' 'band = 1e-9' 'combine = "chi_squared"' 'covariance = "independent"'
ffstudy check bands.toml --estimates shifted.csv
expect_status 1
expect_stdout "takes the bins of shifted.csv for independent"
