#!/usr/bin/env bash
# A study that is changed reuses every trial that it has in common with the one in its folder, and gives the bytes that
# it would have given at once.
source "$(dirname "$0")/../harness.sh"

# study TRIALS LEVEL METHODS...
study() {
    printf '[study]\nname = "grows"\nscene = "cube"\ntrials = %s\nlevel = %s\nseed = 3\n' "$1" "$2"
    local method
    for method in "${@:3}"; do
        case $method in
            rays) printf '[[method]]\nname = "rays"\nsampler = "sobol"\nestimator = "ray_shooting"\nsamples_per_patch = [64, 256]\n' ;;
            again) printf '[[method]]\nname = "again"\nsampler = "sobol"\nestimator = "ray_shooting"\ncompletion = "reciprocal"\nsamples_per_patch = 64\n' ;;
            kernel) printf '[[method]]\nname = "kernel"\nsampler = "random"\nestimator = "area_kernel"\npatches_per_face = 4\nsamples_per_patch = 16\n' ;;
            nodes) printf '[[method]]\nname = "nodes"\nsampler = "gauss_legendre"\nestimator = "area_kernel"\nnodes = [3, 3]\n' ;;
        esac
    done
}
# grown FILES...: out has the bytes of a run that begins with nothing.
expect_bytes_of_a_fresh_run() {
    rm -rf fresh
    ffstudy run study.toml --out fresh --quiet
    expect_status 0
    for file in report.html report.md answer.svg summary.csv slopes.csv trials.csv results.json; do
        [ -e fresh/$file ] || continue
        expect_equal_files fresh/$file out/$file
    done
}

study 30 0.95 kernel rays >study.toml
ffstudy run study.toml --out out --quiet
expect_status 0

# Another method, another order, another level, more trials: one after the other, and all at once.
study 30 0.95 nodes rays kernel >study.toml
ffstudy run study.toml --out out --dry-run
expect_stdout "90 of 91 trials are there already"
ffstudy run study.toml --out out
expect_status 0
expect_stderr "90 of 91 trials are there already, from a study that differs in"
expect_bytes_of_a_fresh_run
study 30 0.99 nodes rays kernel >study.toml
ffstudy run study.toml --out out
expect_stderr "91 of 91 trials are there already"
expect_bytes_of_a_fresh_run
study 75 0.99 nodes rays kernel >study.toml
ffstudy run study.toml --out out
expect_stderr "91 of 226 trials are there already"
expect_bytes_of_a_fresh_run
study 400 0.95 again kernel rays nodes >study.toml
ffstudy run study.toml --out out --threads 2
expect_stderr "226 of 1601 trials are there already"
expect_bytes_of_a_fresh_run
[ "$(ls out/*.sqlite)" = out/results.sqlite ] || fail "expected one store where nothing was left behind"

# Fewer trials are a part of what is there.
study 100 0.95 again kernel rays nodes >study.toml
ffstudy run study.toml --out out --dry-run
expect_stdout "are none of this study, and need --replace"
ffstudy run study.toml --out out
expect_status 2
expect_stderr "has all trials of this study and 1200 beyond them"
study 400 0.95 again kernel rays nodes >study.toml
ffstudy run study.toml --out out --dry-run
expect_stdout "1601 of 1601 trials are there already"

# What would be left behind is never dropped silently.
study 400 0.95 kernel >study.toml
cp out/results.sqlite kept.sqlite
ffstudy run study.toml --out out
expect_status 2
expect_stderr "1201 of its 1601 trials are none of this one"
expect_stderr "add --replace, which keeps the old store aside"
expect_equal_files kept.sqlite out/results.sqlite
ffstudy run study.toml --out out --replace
expect_status 0
expect_stderr "400 of 400 trials are there already"
expect_stderr "the old store is kept as out/results.before-1.sqlite"
expect_equal_files kept.sqlite out/results.before-1.sqlite
expect_bytes_of_a_fresh_run
ffstudy report out/results.before-1.sqlite --out before --quiet
expect_status 0
ffstudy compare out/results.before-1.sqlite out
expect_stdout "out/results.before-1.sqlite: study"
expect_stdout "out/results.sqlite: study"
sed -i 's/seed = 3/seed = 4/' study.toml
ffstudy run study.toml --out out
expect_status 2
expect_stderr "[study]: 'seed = 3' there, 'seed = 4' here"
ffstudy run study.toml --out out --replace --quiet
expect_status 0
expect_file out/results.before-2.sqlite
expect_bytes_of_a_fresh_run

# A run that was killed has a log beside its store.
killed() {
    rm -rf out
    begin run study.toml --out out
    wait_until is_over_or a_unit_is_saved out
    kill -9 "$process" 2>/dev/null || true
    finish
    [ -s out/results.sqlite-wal ] && [ "$(saved units out)" -gt 0 ]
}
study 2000 0.95 rays >study.toml
until killed; do try_again "the study was not killed after its first unit and before its last one"; done
study 2000 0.99 rays nodes >study.toml
ffstudy run study.toml --out out
expect_status 0
expect_stderr "of 4001 trials are there already"
expect_bytes_of_a_fresh_run
