#!/usr/bin/env bash
# What versions 0.1.0 and 0.2.0 stored (tests/data/store_of_...) is reported, compared with the same study run anew, and
# grows.
source "$(dirname "$0")/../harness.sh"

# opens VERSION: its store, in the folder VERSION.
opens() {
    local kept=$data/store_of_$1
    mkdir "$1"
    cp "$kept/results.sqlite" "$1"

    ffstudy report "$1" --quiet
    expect_status 0
    cp "$folder/stderr" said.txt
    expect_in_file "$1/report.md" "Kept since version $1"

    # The same study file gives the same trials today.
    ffstudy run "$kept/study.toml" --out "new$1" --quiet
    expect_status 0
    ffstudy compare "$1" "new$1"
    expect_status 0
    expect_stdout "the same random numbers, equal in all 12 trials"

    sed 's/^trials = 12$/trials = 20/' "$kept/study.toml" >more.toml
    ffstudy run more.toml --out "$1"
    expect_status 0
    expect_stderr "74 of 122 trials are there already"
    ffstudy report "$1" --quiet
    expect_status 0
    expect_no_stderr
}

# The first version's stores have no checksums; when they grow, they get them.
opens 0.1.0
expect_in_file said.txt "0.1.0/results.sqlite: written by an earlier version of ffstudy"
opens 0.2.0
[ ! -s said.txt ] || fail "said of a store of 0.2.0: $(cat said.txt)"

# Flows by form factors of the second version.
printf '[materials]\n"1" = { emissivity = 0.9, temperature = 400 }\n"*" = { emissivity = 0.5, temperature = 300 }\n' >materials.toml
ffstudy heat --load "$data/store_of_0.2.0/form_factors.sqlite" --materials materials.toml \
    --flow-tolerance 1%
expect_status 0
expect_stdout "22495 ± 13"
expect_stderr "has no values of randomisations: intervals of flows are bounds"
