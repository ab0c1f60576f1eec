#!/usr/bin/env bash
# Before there is anything to save, and where nothing can be lost, a signal ends the program within a second.
source "$(dirname "$0")/../harness.sh"

# stopped SIGNAL SECONDS ARGUMENTS...: starts the program, sends the signal this long after it has come to its first
# instruction (it takes signals in by a thread: then these four are blocked), and expects exit code 130.
stopped() {
    command_line="ffstudy ${*:3} (stopped by SIG$1 after $2 s)" status=0
    "$program" "${@:3}" >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
    until grep -q '^SigBlk:.*6202$' /proc/$process/status; do sleep 0.001; done
    sleep "$2"
    kill -0 $process || fail "it was over before it could be stopped"
    local sent=$EPOCHREALTIME
    kill -"$1" $process
    wait $process || status=$?
    expect_status 130
    [ $(((${EPOCHREALTIME/./} - ${sent/./}))) -lt 1000000 ] || fail "expected the end within a second"
}

# A file that nobody writes to.
mkfifo study.toml bands.toml room.obj tables.json
for signal in INT TERM USR1; do
    stopped $signal 0 run study.toml --out out
    stopped $signal 0.2 run study.toml --out out
done
stopped TERM 0.2 check bands.toml --out out
stopped TERM 0.2 form_factors room.obj --out out
stopped TERM 0.2 audit tables.json --out out
[ ! -e out ] || fail "expected no folder before the work begins"

# Tens of thousands of sizes, to be planned.
{
    small_study 20 | sed '/^\[\[method/,$d'
    printf '[[method]]\nname = "SR"\nsampler = "random"\nestimator = "ray_shooting"\nsamples_per_patch = ['
    seq -s, 1 40000 | sed 's/$/]/'
} >sizes.toml
stopped INT 0.3 run sizes.toml --out out

# A store, while it is looked through, and while its reports are made.
small_study 20 | sed 's/^trials = 20/trials = 2000/' >long.toml
ffstudy run long.toml --out results
expect_status 0
for seconds in 0 0.05 0.2; do
    stopped USR1 $seconds report results --out again
done
