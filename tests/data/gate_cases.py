"""Means of trials with the verdicts of gates on them, for every implementation of the rule.

    PYTHONPATH=python /usr/bin/python3 tests/data/gate_cases.py > tests/data/gate_cases.csv

The trials are drawn by NumPy and rounded; intervals and verdicts are those of python/ffstudy_gates.py, whose quantiles
are SciPy's.
"""

import numpy
from ffstudy_gates import judge_mean

draw = numpy.random.default_rng(1)
LAWS = {
    "normal": lambda n: draw.normal(0, 1, n),
    "exponential": lambda n: draw.exponential(1, n) - 1,
    "falling": lambda n: 1 - draw.exponential(1, n),
    "log-normal": lambda n: draw.lognormal(0, 1, n) - numpy.exp(0.5),
    "two values": lambda n: numpy.where(draw.random(n) < 0.3, 0.7, -0.3),
}
CASES = [  # name, law, trials, reference, options
    ("passes", "normal", 50, 0, {"band": 0.8}),
    ("fails above", "normal", 50, -2, {"band": 0.8}),
    ("fails below", "normal", 50, 2, {"band": 0.8}),
    ("is undecided", "normal", 50, 0, {"band": 0.05}),
    ("passes beside a reference with an error", "normal", 50, 0, {"band": 0.8, "reference_error": 0.2}),
    ("is undecided for an error of its reference", "normal", 50, 0, {"band": 0.8, "reference_error": 0.6}),
    ("few trials never show symmetry", "normal", 10, 0, {"band": 2}),
    ("a long upper tail reaches far up", "exponential", 60, 0, {"band": 1.2, "alpha": 0.01}),
    ("a long lower tail reaches far down", "falling", 60, 0, {"band": 1.2, "alpha": 0.01}),
    ("fails for all its skewness", "exponential", 60, -3, {"band": 0.5, "alpha": 0.01}),
    ("too skewed for an interval", "log-normal", 40, 0, {"band": 3, "pass_alpha": 1e-4}),
    ("hits and misses", "two values", 40, 0, {"band": 0.4, "pass_alpha": 0.01}),
]

print("name,reference,band,alpha,pass_alpha,reference_error,verdict,effect,low,high,trials")
for name, law, n, reference, options in CASES:
    options = {"alpha": 1e-4, "pass_alpha": 0.05, "reference_error": 0, **options}
    trials = [float(text) for text in map("{:.3g}".format, LAWS[law](n))]
    found = judge_mean(trials, reference, **options)
    given = ",".join(str(options[key]) for key in ("band", "alpha", "pass_alpha", "reference_error"))
    print(f"{name},{reference},{given},{found.verdict},{found.effect:.12g},{found.low:.12g},{found.high:.12g}",
          " ".join(f"{value:g}" for value in trials), sep=",")
