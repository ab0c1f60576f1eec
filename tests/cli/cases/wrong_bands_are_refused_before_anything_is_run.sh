#!/usr/bin/env bash
# Exit code 2 with file, line and column, before anything is run or written.
source "$(dirname "$0")/../harness.sh"

# refused TEXT LINES...: a gate with these lines (line 6 on) is refused with TEXT.
refused() {
    local text=$1
    shift
    printf '[[gate]]\nname = "g"\nscene = "cube"\nestimator = "%s"\nsamples_per_patch = 64\n' "${estimator:-ray_shooting}" \
        >"$folder/bands.toml"
    printf '%s\n' "$@" >>"$folder/bands.toml"
    ffstudy check "$folder/bands.toml"
    expect_refused 2 "$text"
    expect_stderr "bands.toml:"
}

refused 'bands.toml:8:8: band = 0 (a band of zero width' 'kind = "bias"' 'sampler = "random"' 'band = 0'
refused "bands.toml:6:8: kind = 'bais' is unknown. Did you mean 'bias'?" 'kind = "bais"' 'sampler = "random"' 'band = 1'
refused 'Did you mean "sobol"?' 'kind = "bias"' 'sampler = "sobl"' 'band = 1'
refused "bands.toml:9:1: unknown key 'bandd'" 'kind = "bias"' 'sampler = "random"' 'band = 1' 'bandd = 1'
refused "bands.toml:9:9: pairs = '1-9'" 'kind = "bias"' 'sampler = "random"' 'band = 1' 'pairs = "1-9"'
refused 'no number of trials can decide' 'kind = "bias"' 'sampler = "random"' 'band = 1e-13'
estimator=area_kernel refused 'variance is infinite' 'kind = "bias"' 'sampler = "random"' 'band = 1'
refused 'band: missing' 'kind = "bias"' 'sampler = "random"'

ffstudy check missing.toml
expect_refused 3 "missing.toml"
printf '[gates]\nalpha = 2\n' >"$folder/bands.toml"
ffstudy check "$folder/bands.toml"
expect_refused 2 "bands.toml:2:9: alpha = 2"
ffstudy check "$folder/bands.toml" --seed 1 --fresh-seed
expect_refused 2 "seed"
