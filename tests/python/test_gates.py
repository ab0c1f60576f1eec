import subprocess

import numpy
import pandas
import pytest

import ffstudy
from ffstudy.tables import from_csv, to_html

BANDS = """[gates]
alpha = 0.001
[[gate]]
name = "unbiased"
kind = "{kind}"
quantity = "F16"
reference = 0.2
band = 0.01
"""
BIAS = BANDS.format(kind="bias")


def trials(mean=0.2, std=0.005, count=100):
    return numpy.random.default_rng(1).normal(mean, std, count)


@pytest.mark.parametrize("estimates, verdict", [(trials(), "pass"), (trials(mean=0.25), "fail"),
                                                (trials(std=0.1), "inconclusive")])
def test_trials_are_judged(estimates, verdict):
    found = ffstudy.check({"F16": estimates}, BIAS)
    assert found.verdict == verdict and found.passed == (verdict == "pass")
    (gate,) = found.gates
    assert (gate.name, gate.kind, gate.verdict) == ("unbiased", "bias", verdict)
    assert "100 trials" in gate.words
    assert found.comparisons["value"][0] == pytest.approx(estimates.mean() - 0.2, abs=1e-12)
    assert "unbiased" in str(found) and "<table>" in found._repr_html_()


def test_verdicts_are_those_of_the_program(program):
    with open("bands.toml", "w") as out:
        out.write(BIAS)
    with open("estimates.csv", "w") as out:
        out.write("trial,quantity,estimate\n")
        out.writelines(f"{trial},F16,{value!r}\n" for trial, value in enumerate(trials().tolist()))
    subprocess.run([program, "check", "bands.toml", "--estimates", "estimates.csv", "--out", "kept", "--quiet"], check=True)
    with open("kept/verdicts.csv") as table:
        expected = from_csv(table.read())
    for found in (ffstudy.check({"F16": trials()}, "bands.toml"), ffstudy.check("estimates.csv", "bands.toml")):
        assert repr(found.comparisons.tolist()) == repr(expected.tolist())


def test_tables_are_judged():
    means = numpy.array([("F16", 0.2001, 0.0005)], dtype=[("quantity", "U3"), ("mean", float), ("standard_error", float)])
    assert ffstudy.check(means, BIAS).passed
    assert ffstudy.check(pandas.DataFrame(means), BIAS).passed
    equal = BANDS.format(kind="equal").replace("reference = 0.2\n", "")
    other = means.copy()
    other["mean"] = 0.2002
    assert ffstudy.check(means, equal, against=other).passed


def test_errors_have_places():
    wrong = trials()
    wrong[3] = numpy.nan
    with pytest.raises(ffstudy.InputError) as error:
        ffstudy.check({"F16": wrong}, BIAS)
    assert (error.value.file, error.value.line) == ("estimates", 5)
    with pytest.raises(ffstudy.InputError) as error:
        ffstudy.check({"F16": trials()}, BIAS.replace("band = 0.01", "band = 0"))
    assert (error.value.file, error.value.line) == ("bands", 8)
    for estimates in ({"F16": trials(count=5)}, {"F16": numpy.full(100, 0.2)}, {"F16": numpy.ones((2, 2))}, {"F12": trials()}, 5):
        with pytest.raises(ffstudy.InputError):
            ffstudy.check(estimates, BIAS)
    with pytest.raises(ffstudy.FileError, match="missing.csv"):
        ffstudy.check("missing.csv", BIAS)


def test_large_tables_show_their_beginning_and_their_size():
    shown = to_html(["<a>"] * 30, [[1] * 30] * 200)
    assert "&lt;a&gt;" in shown and "<p>200 × 30</p>" in shown
    assert shown.count("<tr>") == 51 and shown.count("<th>") == 21
