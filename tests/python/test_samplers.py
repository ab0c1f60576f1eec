import subprocess

import numpy
import pytest

import ffstudy
from conftest import same, study_text


def shifted(n, d, seed, trial):
    shift = numpy.random.default_rng(seed).random(d)
    return (numpy.arange(n)[:, None] * 0.7548776662466927 ** numpy.arange(1, d + 1) + shift) % 1


def test_points_are_those_of_the_program(program):
    subprocess.run([program, "points", "sobol", "--n", "64", "--d", "3", "--seed", "5", "--trial", "2", "--out", "p.npy"],
                   check=True)
    assert numpy.array_equal(numpy.load("p.npy"), ffstudy.points("sobol", 64, 3, seed=5, trial=2))
    assert not numpy.array_equal(ffstudy.points("sobol", 64), ffstudy.points("sobol", 64, seed=2))
    numpy.save("own.npy", numpy.array([[0.25, 0.5], [0.75, 0]]))
    assert numpy.array_equal(ffstudy.points("file:own.npy", 2, 2), [[0.25, 0.5], [0.75, 0]])
    for wrong in ("sobo", "gauss_legendre", "stratified"):
        with pytest.raises(ffstudy.InputError, match=wrong):
            ffstudy.points(wrong, 63)


def test_a_function_is_a_method_like_any_other():
    study = ffstudy.Study.from_toml(study_text("mine", sizes='"2^4..2^8"'))
    one = study.run(samplers={"mine": shifted}, threads=1)
    two = study.run(samplers={"mine": shifted}, threads=2)
    assert same(one.summary, two.summary) and same(one.trials, two.trials)
    assert one.complete and len(one.trials) == 20 * 5 * 30
    # Unbiased: the reference lies within five standard errors everywhere, which fails by chance in 1e-4 of seeds.
    pairs = one.summary[numpy.isfinite(one.summary["bias_se"])]
    assert numpy.all(numpy.abs(pairs["bias"]) <= 5 * pairs["bias_se"])
    assert set(one.summary["sampler"]) == {one.summary["sampler"][0]}
    assert one.summary["sampler"][0].startswith("mine#")


def test_changed_code_is_another_sampler():
    study = ffstudy.Study.from_toml(study_text("mine"))
    first = study.run(samplers={"mine": shifted}, out="kept")
    assert same(first.summary, study.run(samplers={"mine": shifted}, out="kept").summary)
    with pytest.raises(ffstudy.InputError, match="holds another study"):
        study.run(samplers={"mine": lambda n, d, seed, trial: numpy.random.default_rng(seed).random((n, d))}, out="kept")
    third = study.run(samplers={"mine": shifted}, out="kept")
    assert same(first.summary, third.summary)


def test_reports_need_no_function(program):
    ffstudy.Study.from_toml(study_text("mine")).run(samplers={"mine": shifted}, out="kept")
    subprocess.run([program, "report", "kept"], check=True)
    with open("kept/summary.csv") as table:
        assert "mine#" in table.read()


def test_functions_can_be_of_fewer_coordinates_and_fixed():
    def grid(n, d, seed, trial):
        return numpy.arange(n)[:, None] / n * [1, 0.5]

    study = ffstudy.Study.from_toml(study_text("grid", estimator="point_to_polygon"))
    found = study.run(samplers={"grid": (grid, {"d": 2, "randomised": False})})
    assert set(found.summary["trials"]) == {1}
    with pytest.raises(ffstudy.InputError, match="2 coordinates"):
        ffstudy.Study.from_toml(study_text("grid")).run(samplers={"grid": (grid, {"d": 2, "randomised": False})})


one_generator = numpy.random.default_rng(1)


def seeded_anew(n, d, seed, trial):
    """Repeats what it does in one thread, and not where two take turns between its draws."""
    numpy.random.seed(seed % 2**32)
    return numpy.stack([numpy.random.random(n) for _ in range(d)], axis=1)


@pytest.mark.parametrize("fill, message", [
    (lambda n, d, seed, trial: numpy.zeros((n, d + 1)), r"shape \(16, 5\) \(expected \(16, 4\)\)"),
    (lambda n, d, seed, trial: numpy.ones((n, d)), "point 0, coordinate 0 is 1 .*not in"),
    (lambda n, d, seed, trial: numpy.full((n, d), numpy.nan), "coordinate 0 is nan"),
    (lambda n, d, seed, trial: "points", "returned no array of numbers"),
    (lambda n, d, seed, trial: 1 / 0, "mine \\(trial 0.*raised ZeroDivisionError"),
    (lambda n: 0, "raised TypeError"),
    (lambda n, d, seed, trial: one_generator.random((n, d)), "run twice, it returns different points"),
    (lambda n, d, seed, trial: numpy.random.random((n, d)), "a generator that all threads share"),
    (seeded_anew, "a generator that all threads share"),
    (lambda n, d, seed, trial: numpy.full((n, d), 0.5), "returns the same points for every seed"),
    (5, "not a function"),
    (numpy.sin, "not a function written in Python"),
    ((shifted, {"dimension": 2}), "its options are d and randomised"),
])
def test_faults_of_a_function_are_named(fill, message):
    with pytest.raises(ffstudy.InputError, match=message):
        ffstudy.Study.from_toml(study_text("mine")).run(samplers={"mine": fill}, threads=1)


def test_names_of_the_catalogue_are_taken():
    with pytest.raises(ffstudy.InputError, match="one of this name already"):
        ffstudy.Study.from_toml(study_text("sobol")).run(samplers={"sobol": shifted})
