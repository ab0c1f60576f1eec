#!/usr/bin/env bash
# Adaptive quadrature by SciPy, docs/examples/quadrature.py: what it claims of its errors holds.
# Needs NumPy.
source "$(dirname "$0")/../harness.sh"

cp "$data/../../docs/examples/quadrature.py" .
printf '%s\n' '[study]' 'name = "quadrature"' 'scene = ["cube", "box:1x1x4"]' 'trials = 2' 'seed = 1' '[[method]]' \
    'name = "coarse"' 'estimator = "command:/usr/bin/python3 quadrature.py {obj} 1e-2"' '[[method]]' \
    'name = "fine"' 'estimator = "command:/usr/bin/python3 quadrature.py {obj} 1e-4"' >quadrature.toml
ffstudy run quadrature.toml --deadline 600 --out out
expect_status 0
[ "$(grep -c ',not_refuted$' out/claimed_errors.csv)" = 8 ] || fail "expected 8 claims that hold"
