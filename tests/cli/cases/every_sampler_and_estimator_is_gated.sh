#!/usr/bin/env bash
# The bands files of this project leave nothing of the catalogue out.
root=$(cd "$(dirname "$0")/../../.." && pwd)
source "$(dirname "$0")/../harness.sh"

for kind in sampler estimator; do
    ffstudy list ${kind}s
    expect_status 0
    for name in $(cut -d' ' -f1 "$folder/stdout"); do
        for bands in push nightly; do
            grep -q "^$kind = \"$name\"" "$root/tests/gates/$bands.toml" ||
                fail "tests/gates/$bands.toml has no gate on $kind $name"
        done
    done
done
