#!/usr/bin/env bash
# --save-baseline, --baseline: the same study passes, a worse one fails, a changed one is refused.
source "$(dirname "$0")/../harness.sh"

# bands SAMPLES: efficiency and mean of Sobol' rays.
bands() {
    for kind in efficiency bias; do
        band=$([ $kind = bias ] && echo 0.01 || echo 0.8)
        printf '[[gate]]\nname = "%s"\nkind = "%s"\nscene = "cube"\nsampler = "sobol"\nestimator = "ray_shooting"\n' \
            $kind $kind
        printf 'samples_per_patch = %s\npairs = "parallel"\nreference = "baseline"\nband = %s\n' "$1" "$band"
    done
}

bands 64 >bands.toml
ffstudy check bands.toml
expect_refused_here() { expect_status 2 && expect_stderr "$1" && expect_no_stdout; }
expect_refused_here "Add --baseline FILE"
ffstudy check bands.toml --save-baseline base.json
expect_status 0
expect_file base.json
[ ! -e results ] || fail "saving a baseline judges nothing"

ffstudy check bands.toml --baseline base.json
expect_status 0
expect_stdout "the baseline took"

# As if it had been twice as efficient.
sed -E 's/("variance":\{"mean_square":)[0-9.e-]+/\11e-12/' base.json >better.json
ffstudy check bands.toml --baseline better.json --out worse
expect_status 1

bands 128 >bands.toml
ffstudy check bands.toml --baseline base.json --out changed
expect_refused_here "a changed study cannot be compared"
echo '{}' >none.json
ffstudy check bands.toml --baseline none.json
expect_refused_here "none.json: is not a baseline"
ffstudy check bands.toml --baseline missing.json
expect_status 3
ffstudy check bands.toml --baseline base.json --save-baseline base.json
expect_status 2

# A rate over seeds that share a baseline is none, and another baseline is other data for the ledger.
bands 64 >bands.toml
ffstudy check bands.toml --baseline base.json --seed-sweep 3
expect_status 2
expect_stderr "all seeds would share the error of one baseline"
ffstudy check bands.toml --baseline base.json --again c1
expect_status 0
ffstudy check bands.toml --baseline better.json --again c1
expect_status 1
