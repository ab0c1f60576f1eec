"""Tests that pass, fail and are inconclusive, for tests/frameworks/run."""

import numpy
import pytest
from ffstudy_gates import assert_mean_within, gate


def draw(n, bias=0.0):
    return numpy.random.default_rng(1).normal(0.2 + bias, 1e-3, n)


def test_passes():
    assert_mean_within(draw(100), 0.2, band=1e-3)


def test_fails():
    assert_mean_within(draw(100, 0.1), 0.2, band=1e-3)


def test_is_inconclusive():
    assert_mean_within(draw(100), 0.2, band=1e-5)


@gate(reference=0.2, band=2e-4)
def test_takes_as_many_trials_as_it_needs(seed):
    return numpy.random.default_rng(seed).normal(0.2, 1e-3)


@gate(reference=0.2, band=2e-4)
@pytest.mark.parametrize("mean", [0.2, 0.3])
def test_judges_each_parameter(seed, mean):
    return numpy.random.default_rng(seed).normal(mean, 1e-3)


class TestGroup:
    sigma = 1e-3

    @pytest.mark.parametrize("mean", [0.2])
    @gate(reference=0.2, band=2e-4)
    def test_takes_fixtures_and_parameters(self, tmp_path, seed, mean):
        assert tmp_path.exists()
        return numpy.random.default_rng(seed).normal(mean, self.sigma)

    @staticmethod
    @gate(reference=0.2, band=2e-4)
    def test_is_static(any_name_of_the_seed):
        return numpy.random.default_rng(any_name_of_the_seed).normal(0.2, 1e-3)
