#!/usr/bin/env bash
# Risks, levels, bands, baselines and estimates beyond what can be computed are refused by name, with exit code 2.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

refused() {
    expect_status 2
    expect_stderr "$1"
    expect_no_stdout
}

gate='[[gate]]\nname = "%s"\nkind = "%s"\n'
rays='scene = "cube"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = 64\n'

for alpha in 5e-324 1e-16 1e-13; do
    printf "[gates]\nalpha = $alpha\n$gate${rays}band = 1e-2\n" g bias >tiny.toml
    ffstudy check tiny.toml
    refused "tiny.toml:2:9: alpha"
done

# Estimates: one without its decimal point, and powers that are no numbers.
printf "$gate"'quantity = "F16"\nreference = 0.2\nband = 1e-3\n' mean bias >file.toml
printf "$gate"'quantity = "F16"\nreference = 0.002\nband = 0.5\n' spread std >>file.toml
estimates() {
    echo trial,quantity,estimate
    for trial in $(seq 0 59); do echo "$trial,F16,0.$((2000 + (trial * 37) % 61))"; done
}
estimates | sed 's/^4,F16,0./4,F16,0/' >wild.csv
ffstudy check file.toml --estimates wild.csv
expect_status 4
expect_stdout "inconclusive"
estimates | sed '7s/0\.2/1e200/' >huge.csv
ffstudy check file.toml --estimates huge.csv
refused "huge.csv:7:7: estimate = '1e200"

# A baseline with numbers that no run gives.
printf "[gates]\nlooks = 1\nmax_trials = 100\n$gate${rays}band = 0.5\n" faster efficiency >base.toml
ffstudy check base.toml --save-baseline base.json
expect_status 0
for freedom in 1e308 1e-300; do
    sed "0,/\"freedom\":[0-9.e+-]*/s//\"freedom\":$freedom/" base.json >damaged.json
    ffstudy check base.toml --baseline damaged.json
    refused "damaged.json: is not a baseline (gate 'faster', quantity 1: freedom"
done

# Levels and numbers of seeds.
printf '[study]\nname = "s"\nscene = "cube"\ntrials = 2\nseed = 1\n[[method]]\nname = "a"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = 64\n' >s.toml
for level in nan 0.999999999999999 0.999999999999 0.5 inf; do
    ffstudy run s.toml --level $level
    refused "--level"
done
ffstudy run s.toml --level 0.999999999
expect_status 0
expect_stdout "no test: too few trials"

# Two trials: estimates, one note, no verdict.
ffstudy convergence --sampler random --samples 256,1024,4096 --trials 2
expect_status 0
grep -q "BIASED\|none found (\|× better\|times less" "$folder/stdout" && fail "a verdict from two trials"
expect_stdout "no test: too few trials"
