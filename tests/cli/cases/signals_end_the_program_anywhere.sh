#!/usr/bin/env bash
# Before there is anything to save, and where nothing can be lost, a signal ends the program within a second of its own time.
source "$(dirname "$0")/../harness.sh"

# stop SIGNAL WHEN ARGUMENTS...: starts the program, and sends the signal when it has come to its first instruction and the
# command WHEN has ended.
stop() {
    begin "${@:3}"
    wait_until is_over_or takes_signals
    # shellcheck disable=SC2086  # several words
    wait_until $2
    kill -STOP "$process" 2>/dev/null || true
    before=$(processor_time) || true
    { time { kill -"$1" "$process" && kill -CONT "$process"; wait "$process" || status=$?; }; } 2>"$folder/time"
    process=
}
# expect_end: of the last one, by its own clock: the processor time that it has used since, which is all but that before.
TIMEFORMAT='%U %S'
if runs_with_tsan; then limit=10; else limit=1; fi
expect_end() {
    expect_status 130
    awk -v before="$before" -v limit=$limit 'END {exit !($1 + $2 - before / 100 < limit)}' "$folder/time" ||
        fail "expected the end within $limit s"
}
stopped() {
    stop "$@"
    expect_end
}

# A file that nobody writes to.
mkfifo study.toml bands.toml room.obj tables.json
for signal in INT TERM USR1; do
    stopped $signal true run study.toml --out out
    stopped $signal "sleep 0.2" run study.toml --out out
done
stopped TERM "sleep 0.2" check bands.toml --out out
stopped TERM "sleep 0.2" form_factors room.obj --out out
stopped TERM "sleep 0.2" audit tables.json --out out
[ ! -e out ] || fail "expected no folder before the work begins"

# Hundreds of thousands of sizes, to be planned.
{
    small_study 20 | sed '/^\[\[method/,$d'
    printf '[[method]]\nname = "SR"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = ['
    seq -s, 1 400000 | sed 's/$/]/'
} >sizes.toml
stopped INT "has_used 30" run sizes.toml --out out

# A store, while it is looked through, and while its reports are made: at shares of the processor time of all. It may be
# over before the signal comes.
small_study 1000 >long.toml
ffstudy run long.toml --out results
expect_status 0
{ time ffstudy report results --out whole; } 2>"$folder/time"
all=$(awk 'END {printf "%d", ($1 + $2) * 100}' "$folder/time")
for share in 0 10 30 60; do
    while
        stop USR1 "is_over_or has_used $((all * share / 100))" report results --out again
        [ $status -eq 0 ]
    do try_again "the report was over before it could be stopped"; done
    expect_end
done
