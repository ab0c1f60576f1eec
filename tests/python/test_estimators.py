import pathlib
import subprocess

import numpy
import pytest

import ffstudy


def text(line="samples_per_patch = [100, 400]", scene="cube"):
    return f"""[study]
name = "s"
scene = "{scene}"
trials = 20
seed = 1
[[method]]
name = "m"
estimator = "mine"
{line}
"""


def kernel_sums(scene, samples, seed, trial):
    """Points on both of two parallelograms and the kernel between them."""
    rng = numpy.random.default_rng(seed)
    factors = numpy.zeros((len(scene.faces),) * 2)
    for corners, i in scene.polygons:
        for others, j in scene.polygons:
            if i == j:
                continue
            x = corners[0] + rng.random((samples, 2)) @ (corners[[1, 3]] - corners[0])
            y = others[0] + rng.random((samples, 2)) @ (others[[1, 3]] - others[0])
            across, along = (numpy.cross(c[1] - c[0], c[3] - c[0]) for c in (corners, others))
            ray = y - x
            squared = (ray**2).sum(axis=1)
            factors[i, j] += numpy.mean((ray @ across) / numpy.linalg.norm(across) * -(ray @ along)
                                        / (numpy.pi * squared**2))
    return factors


def test_a_function_is_an_estimator_like_any_other(program):
    study = ffstudy.Study.from_toml(text())
    one = study.run(estimators={"mine": kernel_sums}, threads=1, out="kept")
    two = study.run(estimators={"mine": kernel_sums}, threads=2)
    assert repr(one.trials.tolist()) == repr(two.trials.tolist())
    opposite = one.summary[(one.summary["from_face"] == "1") & (one.summary["to_face"] == "6")]
    # Within five standard errors, which fails by chance in 1e-5 of seeds; the kernel has a variance there.
    assert numpy.all(numpy.abs(opposite["bias"]) <= 5 * opposite["bias_se"])
    subprocess.run([program, "report", "kept"], check=True)  # needs no function
    with pytest.raises(ffstudy.InputError, match="holds another study"):
        study.run(estimators={"mine": lambda *arguments: numpy.zeros((6, 6))}, out="kept")


def test_an_estimator_may_be_fixed_and_without_sizes():
    found = ffstudy.Study.from_toml(text(line="")).run(
        estimators={"mine": (lambda scene, samples, seed, trial: numpy.full((6, 6), 0.2),
                             {"samples": False, "randomised": False})})
    assert set(found.summary["trials"]) == {1}


def test_an_estimator_may_say_what_it_claims_of_its_errors(program):
    ffstudy.Study.from_toml(text()).run(
        estimators={"mine": lambda *arguments: (kernel_sums(*arguments), numpy.full((6, 6), 1e6))}, out="claims")
    subprocess.run([program, "report", "claims"], check=True)
    rows = pathlib.Path("claims/claimed_errors.csv").read_text().splitlines()
    assert all(",estimator," in row and row.endswith(",not_refuted") for row in rows[1:]) and len(rows) > 1


def test_curved_scenes_come_as_toml_without_polygons():
    seen = []

    def look(scene, samples, seed, trial):
        seen.append((scene.polygons, scene.toml, scene.faces))
        return numpy.zeros((len(scene.faces),) * 2)

    ffstudy.Study.from_toml(text(line="", scene="coaxial_discs_equal")).run(
        estimators={"mine": (look, {"samples": False, "randomised": False})})
    assert seen[0][0] is None and 'shape = "disc"' in seen[0][1] and len(seen[0][2]) == 2


@pytest.mark.parametrize("estimate, message", [
    (lambda scene, samples, seed, trial: numpy.zeros((6, 5)), r"no array of shape \(6, 6\)"),
    (lambda scene, samples, seed, trial: numpy.full((6, 6), numpy.inf), "not finite"),
    (lambda scene, samples, seed, trial: "factors", "no array of shape"),
    (lambda scene, samples, seed, trial: (numpy.zeros((6, 6)), -numpy.ones((6, 6))), "an error below 0"),
    (lambda scene, samples, seed, trial: 1 / 0, "mine \\(trial 0.*raised ZeroDivisionError"),
    (lambda scene, samples, seed, trial: numpy.random.random((6, 6)), "a generator that all threads share"),
    (lambda scene, samples, seed, trial: numpy.full((6, 6), 0.125), "returns the same estimates for every seed"),
    (5, "not a function"),
    ((kernel_sums, {"d": 2}), "its options are samples and randomised"),
])
def test_faults_of_a_function_are_named(estimate, message):
    with pytest.raises(ffstudy.InputError, match=message):
        ffstudy.Study.from_toml(text()).run(estimators={"mine": estimate}, threads=1)
