#!/usr/bin/env bash
# Points that programs print, as docs/study-files.md describes them.
source "$(dirname "$0")/../harness.sh"

python="/usr/bin/python3 -IS"  # which starts soon
# Sound and broken programs in one: mine.py HOW n d seed trial.
cat >mine.py <<'END'
import os, random, signal, struct, sys, time

how, n, d, seed, trial = sys.argv[1], *map(int, sys.argv[2:])
draw = random.Random(0 if how == "ignores" else time.time_ns() if how == "clock" else seed).random
rows = [[draw() for _ in range(d)] for _ in range(n)]
flat = [x for row in rows for x in row]
out = sys.stdout.buffer
if how == "raw":
    out.write(b"FFPOINTS" + struct.pack(f"<QQ{n * d}d", n, d, *flat))
elif how == "cut":
    out.write(b"FFPOINTS" + struct.pack(f"<QQ{n * d - 1}d", n, d, *flat[1:]))
elif how == "npy":
    head = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({n}, {d}), }}"
    head += " " * (63 - (10 + len(head)) % 64) + "\n"
    out.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + struct.pack(f"<{n * d}d", *flat))
elif how == "garbage":
    print("hello")
elif how == "much":
    while True:
        out.write(b"0.5 " * 100000)
elif how == "hangs":
    time.sleep(1000)
elif how == "closes":  # its output, and runs on
    os.close(1), os.close(2), time.sleep(1000)
elif how == "dies" and trial == 3:
    print("no more points", file=sys.stderr)
    sys.exit(5)
elif how == "killed":
    os.kill(os.getpid(), signal.SIGSEGV)
else:
    if how == "edge" and trial == 3:
        rows[5][1] = 1.0
    for row in rows[how == "few":]:
        print(*row)
END
# study NAME HOW [LINE]
study() {
    cat >"$1.toml" <<END
[study]
name = "$1"
scene = "cube"
trials = 6
seed = 1
[[method]]
name = "mine"
sampler = "command:$python mine.py $2 {n} {d} {seed} {trial}"
estimator = "ray_shooting"
samples_per_patch = 64
${3-}
END
}

# The same bytes on any number of threads, and in any folder.
study text text
ffstudy run text.toml --threads 1 --out a
expect_status 0
expect_stderr "note: text.toml:8:11 runs command:$python mine.py text {n} {d} {seed} {trial}"
expect_stdout "too few trials to rule out skewness"
mkdir elsewhere
cp text.toml mine.py elsewhere
ffstudy run elsewhere/text.toml --threads 2 --out b
expect_status 0
expect_equal_files a/trials.csv b/trials.csv
expect_in_file a/results.json "command:$python mine.py text {n} {d} {seed} {trial}#"
# Whatever form they are printed in, they are the same points.
$python mine.py text 64 4 7 0 >text.txt
for form in raw npy; do
    $python mine.py $form 64 4 7 0 >$form.bin
    ffstudy points "file:$form.bin" --n 64 --out $form.csv
    expect_status 0
    ffstudy points "file:text.txt" --n 64 --out text.csv
    expect_equal_files text.csv $form.csv
done

# Reports run nothing; an interrupted study continues only with the same program.
cp a/summary.csv before.csv
mv mine.py other.py
ffstudy report a
expect_status 0
expect_equal_files a/summary.csv before.csv
(cat other.py && echo "# changed") >mine.py
ffstudy run text.toml --out a
expect_status 2
expect_stderr "holds another study"
mv other.py mine.py
ffstudy run text.toml --no-commands --out c
expect_status 2
expect_stderr "text.toml:8:11: runs command:$python mine.py"
[ ! -e c ] || fail "something was written"

# Fixed points are deterministic; quotes hold words together.
ffstudy convergence --sampler "command:awk 'BEGIN { for (; i < {n}; ++i) print i / {n} \" 0.5 0.25 0.75\" }'" --samples 64 --trials 20 --out d
expect_status 0
expect_stdout "  deterministic"
ffstudy check-sampler "command:$python mine.py text {n} {d} {seed} {trial}" --n 1 --trials 2
expect_status 4
expect_stdout "same bits for the same seed"

# One process for many sets: the same points, and what it does wrong.
cat >serve.py <<'END'
import random, struct, sys, time

how, asked = sys.argv[2], 0
for line in sys.stdin:
    n, d, seed, trial = map(int, line.split())
    asked += 1
    if how == "remembers":
        seed += asked
    if how == "hashes":
        seed = hash(f"trial {trial} of {seed}")  # of a text: another one in each process
    draw = random.Random(seed).random
    flat = [draw() for _ in range(n * d)]
    if how == "hangs" and trial == 3:
        time.sleep(1000)
    if how == "dies" and trial == 3:
        sys.exit("no more points")
    if how == "leaves" and trial == 3:
        sys.exit(0)
    if how == "garbage":
        print("hello", flush=True)
    sys.stdout.buffer.write(b"FFPOINTS" + struct.pack(f"<QQ{n * d}d", n, d, *flat))
    sys.stdout.buffer.flush()
END
# serve NAME HOW [OPTION...]
serve() {
    study "$1" text
    sed -i "s|^sampler.*|sampler = \"command:$python serve.py {requests} $2\"|" "$1.toml"
    ffstudy run "$1.toml" --out "out_$1" "${@:3}"
}
serve one sound --threads 1
expect_status 0
ffstudy run one.toml --out again --threads 2
expect_status 0
expect_equal_files out_one/trials.csv again/trials.csv
# Work is cut by what points cost, and a store is read with the same cut.
sed 's/= 64$/= 4096/; s/trials = 6/trials = 40/' one.toml >large.toml
ffstudy run large.toml --out large
expect_status 0
ffstudy report large
expect_status 0
serve two remembers
expect_status 2
expect_stderr "run twice, it prints different points"
serve hashing hashes
expect_status 2
expect_stderr "started again, it prints different points"
serve three hangs --deadline 1
expect_status 3
expect_stderr "did not end within 1 s, and was stopped"
serve four dies
expect_status 3
expect_stderr "ended with exit code 1 (its stderr: no more points)"
serve five leaves
expect_status 3
expect_stderr "ended before its answer was whole"
serve six garbage
expect_status 2
expect_stderr "(not a number)"

ffstudy points 'command:./x {samples} {seed}' --n 4
expect_status 2
expect_stderr "({samples} is not replaced by anything). There are {n}, {d}, {requests}, {seed}, {trial}; a script may hold other braces."
ffstudy points "command:awk 'BEGIN { for (; i < 4; ++i) print \"0 0 0 0\" }'" --n 4
expect_status 0

# refuse CODE HOW TEXT [OPTION...]: a study of such a program ends so.
refuse() {
    study wrong "$2"
    ffstudy run wrong.toml --threads 1 --out "wrong_$2" "${@:4}"
    expect_status "$1"
    expect_stderr "$3"
}
refuse 2 clock "run twice, it prints different points"
refuse 2 ignores "prints the same points for every seed"
refuse 2 few "printed 1 set of 63 points of 4 coordinates"
refuse 2 edge "set 0, point 5, coordinate 1 is 1 (counted from 0; not in [0, 1))"
expect_stderr "(trial 3, seed "
refuse 2 garbage 'points of 4 coordinates):1: "hello" (not a number)'
refuse 2 cut "2040 bytes of numbers (its header says 64 x 4 of 8 bytes)"
refuse 3 much "bytes, and was stopped"
refuse 3 hangs "did not end within 0.2 s, and was stopped (it wrote nothing to stderr)" --deadline 0.2
refuse 2 closes "--deadline 1x: not a duration" --deadline 1x
refuse 3 closes "did not end within 1 s, and was stopped" --deadline 1
refuse 3 killed "was ended by signal 11"
refuse 3 dies "ended with exit code 5 (its stderr: no more points)"
expect_stderr "(trial 3, seed "

# not_run CODE TEXT SAMPLER
not_run() {
    ffstudy points "$3" --n 4 --out f.csv
    expect_status "$1"
    expect_stderr "$2"
}
not_run 3 "./missing: cannot be started (No such file or directory)" "command:./missing {n}"
not_run 2 "(no program)" "command: "
not_run 2 "'|' would break tables" "command:yes 0 | head -n {n}"
not_run 2 "(a quote ' is not closed)" "command:echo 'a"
