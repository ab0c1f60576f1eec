"""The rule of python/ffstudy_gates.py, by the table that tests/unit/stats/gates/gate.cpp reads too."""

import csv
import pathlib

import pytest
from ffstudy_gates import judge_mean

with open(pathlib.Path(__file__).parent.parent / "data/gate_cases.csv") as table:
    CASES = list(csv.DictReader(table))


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_is_judged_as_in_every_language(case):
    options = {key: float(case[key]) for key in ("band", "alpha", "pass_alpha", "reference_error")}
    found = judge_mean([float(value) for value in case["trials"].split()], float(case["reference"]), **options)
    assert found.verdict == case["verdict"]
    for key in ("effect", "low", "high"):
        assert getattr(found, key) == pytest.approx(float(case[key]), rel=1e-9, abs=1e-9)
