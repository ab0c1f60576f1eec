# What a command-line case says; sourced by each file of cases/. A case runs in an empty folder of its own.
# shellcheck shell=bash

set -euo pipefail

program=${1:?usage: CASE PROGRAM DATA_FOLDER}
data=${2:?usage: CASE PROGRAM DATA_FOLDER}
export LC_ALL=C
unset COLUMNS
PYTHONPATH=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)  # arrays.py
export PYTHONPATH PYTHONDONTWRITEBYTECODE=1
folder=$(mktemp -d)
process=  # in the background
trap '[ -z "$process" ] || kill -9 "$process" 2>/dev/null || true; rm -rf "$folder"' EXIT
mkdir "$folder/work"
cd "$folder/work"

# ffstudy ARGUMENTS...: runs the program; its output and exit code are what the expectations speak of.
ffstudy() {
    command_line="ffstudy $*"
    status=0
    "$program" "$@" >"$folder/stdout" 2>"$folder/stderr" </dev/null || status=$?
}

# begin ARGUMENTS...: the same in the background, as $process. finish: waits for its end.
begin() {
    command_line="ffstudy $*"
    status=0
    "$program" "$@" >"$folder/stdout" 2>"$folder/stderr" </dev/null &
    process=$!
}
finish() {
    wait_until is_over
    status=0
    wait "$process" 2>/dev/null || status=$?
    process=
}
is_over() { ! kill -0 "$process" 2>/dev/null; }

# wait_until CONDITION...: until this command succeeds, which may take long where the machine has other work: the limit
# is for what hangs. What was begun is not over before, but with is_over_or in front of the condition.
patience=300
wait_until() {
    local end=$((SECONDS + patience)) over=false
    until "$@"; do
        ! $over || fail "it was over before: $*"
        [ $SECONDS -lt $end ] || fail "expected within $patience s: $*"
        sleep 0.01
        if [ -n "$process" ] && is_over; then over=true; fi  # and the condition is looked at once more
    done
}
is_over_or() { is_over || "$@"; }

# a_unit_is_saved OUT: by a run that continues; the log of its store shows it.
a_unit_is_saved() { [ -n "$(find "$1" -name results.sqlite-wal -size +64k 2>/dev/null)" ]; }

# runs_with_tsan: whether ThreadSanitizer is in the program. It takes ten times as long for anything, and delivers
# signals late.
runs_with_tsan() { ldd "$program" | grep libtsan >/dev/null; }

# try_again WHAT: counts in a loop around what may be over before something is done to it on its way.
tries=0
try_again() { [ $((++tries)) -lt 50 ] || fail "tried $tries times: $1"; }

# takes_signals: what was begun, by a thread for which it has blocked these four. Before, they end it or are ignored.
takes_signals() { grep -qs '^SigBlk:.*6202$' "/proc/$process/status"; }

# processor_time: what was begun has used so much, in hundredths of a second. That says how far it is where the clock does
# not, on a machine that has other work.
processor_time() { awk '{print $14 + $15}' "/proc/$process/stat" 2>/dev/null; }
has_used() { [ "$(processor_time)" -ge "$1" ] 2>/dev/null; }

# fail WHY: shows the last run and ends the case.
fail() {
    {
        echo "$(basename "$0"): $1"
        echo "--- $command_line -> exit code $status"
        echo "--- stdout" && cat "$folder/stdout"
        echo "--- stderr" && cat "$folder/stderr"
    } >&2
    exit 1
}

expect_status() { [ "$status" -eq "$1" ] || fail "expected exit code $1"; }

# expect_stdout TEXT, expect_stderr TEXT: it is part of what was printed there.
expect_stdout() { grep -Fq -e "$1" "$folder/stdout" || fail "expected on stdout: $1"; }
expect_stderr() { grep -Fq -e "$1" "$folder/stderr" || fail "expected on stderr: $1"; }
expect_no_stdout() { [ ! -s "$folder/stdout" ] || fail "expected nothing on stdout"; }
expect_no_stderr() { [ ! -s "$folder/stderr" ] || fail "expected nothing on stderr"; }

expect_file() { [ -s "$1" ] || fail "expected a file that is not empty: $1"; }
expect_in_file() { grep -Fq -e "$2" "$1" || fail "expected in $1: $2"; }
expect_nothing_written() { [ -z "$(ls -A .)" ] || fail "expected no files, found: $(ls -A .)"; }
expect_equal_files() { cmp "$1" "$2" >&2 || fail "expected equal bytes: $1 and $2"; }

# expect_refused CODE TEXT: the exit code, TEXT on stderr, nothing on stdout, nothing written.
expect_refused() {
    expect_status "$1"
    expect_stderr "$2"
    expect_no_stdout
    expect_nothing_written
}

# small_study [TRIALS]: a study file with a method of every kind.
small_study() {
    cat <<END
[study]
name = "small"
scene = ["cube", "box:2x1x0.5"]
trials = ${1:-20}
seed = 1

[[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
patches_per_face = [1, 4]
samples_per_patch = 81

[[method]]
name = "sobol"
sampler = "sobol"
estimator = "ray_shooting"
tracer = "embree"
allocation = "face"
patches_per_face = 4
samples_per_patch = 64

[[method]]
name = "kernel"
sampler = "halton"
estimator = "area_kernel"
samples_per_patch = 50

[[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = [2, 3]
estimator = "area_kernel"
patches_per_face = [1, 4]

[[method]]
name = "exact"
estimator = "closed_form"
END
}

# long_study: the same with hours of work, in units of a second at most. Its store stays small.
long_study() { small_study 20000 | sed 's/^samples_per_patch = .*/&000/'; }

# oddly_named_study: a small one with names that LaTeX and XML could take for something else.
oddly_named_study() {
    small_study 3 | sed -e "s/^name = \"small\"/&\ntitle = '50 % of \$x_1\$ \& more #1 ~ \\\\end{document} {'/" \
        -e "s/^name = \"SR\"/name = '[a]\&b%c_d\$e#f \\\\g~h^i{j}k'/" -e "s/^name = \"kernel\"/name = '*\"<-- -->\" Größe'/"
}

# blocks LANGUAGE DOCUMENT [NUMBER]: the lines of its fenced blocks of this language ("": without one), or of one of them.
blocks() {
    awk -v fence="\`\`\`$1" -v number="${3:-0}" \
        '/^```/ {open = !open; shown = open && $0 == fence && (++count == number || !number); next} shown' "$2"
}

# expect_same_results FOLDER FOLDER: every output but context.json and what rests on seconds is equal to the byte, and so is
# every row of the stores.
expect_same_results() {
    local a=$1 b=$2 file
    [ "$(ls "$a")" = "$(ls "$b")" ] || fail "expected the same files in $a and $b"
    for file in $(ls "$a"); do
        case $file in
            context.json | *_by_time.*) ;;
            results.sqlite)
                rows "$a/$file" >"$folder/a"
                rows "$b/$file" >"$folder/b"
                expect_equal_files "$folder/a" "$folder/b"
                ;;
            *) expect_equal_files "$a/$file" "$b/$file" ;;
        esac
    done
}

# rows STORE: all of a store but the circumstances, in the order of its keys.
rows() {
    /usr/bin/python3 -IS - "$1" <<'END'
import sqlite3, sys

store = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
tables = [name for (name,) in store.execute("SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name")]
for table in tables:
    if table == "context":
        continue
    columns = len(store.execute(f"SELECT * FROM {table} LIMIT 1").description)
    order = ", ".join(str(column + 1) for column in range(columns))
    sys.stdout.writelines(f"{table} {row}\n" for row in store.execute(f"SELECT * FROM {table} ORDER BY {order}"))
END
}

# saved TABLE OUT: how many rows the store there has in a table; units are those of work. Looks at a copy: a run that ends
# while another program has its store open leaves its log.
saved() {
    rm -rf "$folder/copy"
    mkdir "$folder/copy"
    cp "$2/results.sqlite" "$2/results.sqlite-wal" "$folder/copy" 2>/dev/null || true
    /usr/bin/python3 -IS - "$1" "$folder/copy/results.sqlite" <<'END' 2>/dev/null || echo 0
import sqlite3, sys

store = sqlite3.connect(f"file:{sys.argv[2]}?mode=rw", uri=True)
print(*store.execute(f"SELECT count(*) FROM {sys.argv[1]}").fetchone())
END
}
