import os
import signal

import pytest

# Python leaves Ctrl-C ignored in processes that a shell runs in the background, and tests press it.
signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(autouse=True)
def empty_folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def program():
    """The program ffstudy of the same build."""
    return os.environ["FFSTUDY"]


def study_text(sampler="sobol", line="", trials=20, sizes="[16, 64]", estimator="ray_shooting"):
    return f"""[study]
name = "s"
scene = "cube"
trials = {trials}
seed = 1
{line}
[[method]]
name = "m"
sampler = '''{sampler}'''
estimator = "{estimator}"
samples_per_patch = {sizes}
"""


def same(one, two):
    """Whether two tables are equal to the bit; a NaN is equal to a NaN."""
    return one.dtype == two.dtype and repr(one.tolist()) == repr(two.tolist())
