#!/usr/bin/env bash
# A ray shooter in NumPy, docs/examples/shoot.py, beside ours: unbiased, as exact, the same bytes on any number of threads.
# Needs NumPy.
source "$(dirname "$0")/../harness.sh"

cp "$data/../../docs/examples/shoot.py" .
cat >shoot.toml <<'STUDY'
[study]
name = "shoot"
scene = "cube"
trials = 40
seed = 1

[[method]]
name = "mine"
estimator = "command:/usr/bin/python3 shoot.py {scene} {samples} {seed}"
samples_per_patch = 300

[[method]]
name = "ours"
sampler = "random"
estimator = "ray_shooting"
samples_per_patch = 300
STUDY
ffstudy run shoot.toml --threads 1 --out a
expect_status 0
expect_stderr 'note: shoot.toml:9:13 runs command:/usr/bin/python3 shoot.py {scene} {samples} {seed}'
[ "$(grep -c 'none found' "$folder/stdout")" -ge 2 ] || fail "expected no bias of either"
ffstudy run shoot.toml --threads 2 --out b
expect_equal_files a/trials.csv b/trials.csv
expect_in_file a/results.json 'shoot.py {scene} {samples} {seed}#'
# The processor time is that of the program, without the three runs that check it: NumPy alone takes longer to load than
# our trials take.
expect_stdout 'Processor time per trial, measured: mine at 300: '
/usr/bin/python3 - <<'END' || fail 'expected the processor time of Python and nothing for ours'
import json, re
text = json.load(open("a/context.json"))["processor_time_per_trial"]
assert 0.001 < float(re.fullmatch(r"mine at 300: (\S+) s", text)[1]) < 60, text
END
