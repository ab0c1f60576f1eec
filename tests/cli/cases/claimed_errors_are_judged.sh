#!/usr/bin/env bash
# What a program claims of its errors is compared with what they are: bounds, standard errors, half widths of intervals.
source "$(dirname "$0")/../harness.sh"

# claims.py SCENE SEED KIND: estimates of the cube with normal errors of 1e-3, and a claim about each.
cat >claims.py <<'END'
import random, sys

seed, kind = int(sys.argv[2]), sys.argv[3]
rng = random.Random(seed)
claim = {"bound": 6e-3, "standard_error": 1e-3, "too_small": 5e-4, "negative": -1, "none": 0}[kind]
print("from,to,estimate" + (",error" if kind != "none" else ""))
for i in range(1, 7):
    for j in range(1, 7):
        if i == j:
            continue
        factor = 0.19982489569838738 if i + j == 7 else 0.20004377607540315
        print(f"{i},{j},{factor + rng.gauss(0, 1e-3)!r}" + (f",{claim}" if kind != "none" else ""))
END
# study KIND [LINE...]: 60 trials of it.
study() {
    printf '%s\n' '[study]' "name = \"$1\"" 'scene = "cube"' 'trials = 60' 'seed = 1' '[[method]]' 'name = "mine"' \
        "estimator = \"command:/usr/bin/python3 -IS claims.py {toml} {seed} $1\"" "${@:2}" >study.toml
    ffstudy run study.toml --out "out_$1" --replace
}
# finding KIND WANTED: of all classes of pairs, as in claimed_errors.csv.
finding() {
    expect_status 0
    awk -F, -v wanted="$2" 'NR > 1 && $NF != wanted {exit 1} END {exit NR < 2}' "out_$1/claimed_errors.csv" ||
        fail "expected $2 of $1"
}

# Six standard errors are a bound; one holds in 68 % of the trials, and half of one does not.
study bound
finding bound not_refuted
expect_stdout "always  of the estimator"
study standard_error 'claimed_level = 0.68'
finding standard_error not_refuted
expect_stdout "68 %  of the estimator"
expect_in_file out_standard_error/report.html "How often errors are within the claimed ones"
expect_in_file out_standard_error/report.html "0 of 2 claims about errors do not hold as often as they should."
study too_small 'claimed_level = 0.68'
finding too_small fails
study standard_error
finding standard_error fails
study none 'claimed_error = 1e-4'
finding none fails

study negative
expect_status 2
expect_stderr "error = '-1' (it cannot be negative). Print its size."
study none 'claimed_level = 1.5'
expect_status 2
expect_stderr "the share of errors that should be at most as claimed"

# Half widths of form_factors are such claims: 95 % of them should hold, where nothing is exact. With a plate in the
# middle the factors between opposite faces are known.
cat >intervals.sh <<'END'
set -e
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
"$1" form_factors "$2" --seed "$3" --tolerance 1e-2 --max-samples 200000 --threads 1 --quiet --out "$out/m" || [ $? = 1 ]
echo from,to,estimate,error
awk -F, 'NR > 1 {print $1 "," $2 "," $3 "," $6}' "$out/m/matrix.csv"
END
printf '%s\n' '[study]' 'name = "intervals"' 'scene = "squares_blocked:0.5"' 'trials = 20' 'seed = 1' '[[method]]' \
    'name = "ffstudy"' "estimator = \"command:/bin/bash intervals.sh $program {toml} {trial}\"" 'claimed_level = 0.95' >study.toml
ffstudy run study.toml --out out_intervals
finding intervals not_refuted
