import os
import signal
import subprocess
import threading
import time

import numpy
import pytest

import ffstudy
from conftest import same, study_text


def test_results_are_those_of_the_program(program):
    with open("s.toml", "w") as out:
        out.write(study_text())
    subprocess.run([program, "run", "s.toml", "--quiet"], check=True)
    seen = []
    found = ffstudy.Study.from_toml("s.toml").run(progress=lambda done, units: seen.append((done, units)))
    assert seen and seen[-1][0] == seen[-1][1]
    with open("results/s/summary.csv") as table:
        columns = table.readline().strip().split(",")
        rows = [line for line in table]
    assert list(found.summary.dtype.names) == columns
    assert len(found.summary) == len(rows)
    rmse = columns.index("rmse")
    printed = [float(row.split(",")[rmse] or "nan") for row in rows]
    assert repr(printed) == repr(found.summary["rmse"].tolist())
    assert found.summary["method"][0] == "m" and found.summary["samples_per_patch"].dtype == float
    assert found.summary["from_face"].dtype.kind == "U"
    with open("results/s/report.md") as report:
        assert report.read() == found.report
    assert "<table>" in found._repr_html_()


def test_tables_are_frames():
    frame = ffstudy.Study.from_toml(study_text(sizes="16")).run().frame("trials")
    assert list(frame.columns)[:3] == ["study", "scene", "method"]


def test_a_study_is_its_keys_too():
    method = {"name": "m", "sampler": "sobol", "estimator": "ray_shooting", "samples_per_patch": [16, 64]}
    of_keys = ffstudy.Study(name="s", scene="cube", trials=20, seed=numpy.int64(1), methods=[method]).run()
    assert same(of_keys.summary, ffstudy.Study(study_text()).run().summary)
    for arguments in ({}, {"text": study_text(), "methods": [method]}):
        with pytest.raises(ffstudy.InputError, match="a text, or methods"):
            ffstudy.Study(**arguments)
    with pytest.raises(ffstudy.InputError, match="trails"):
        ffstudy.Study(scene="cube", trails=20, seed=1, methods=[method]).run()


def test_notebooks_show_the_answer_and_its_picture():
    methods = [{"name": name, "sampler": name, "estimator": "ray_shooting", "samples_per_patch": 64}
               for name in ("random", "sobol")]
    found = ffstudy.Study(scene="cube", trials=20, seed=1, methods=methods).run()
    shown = found._repr_html_()
    assert "pairs" in found.answer and found.answer in shown
    assert found.picture.startswith("<svg") and found.picture in shown


def test_errors_are_plotted_on_request():
    class Axes:
        lines = {}

        def plot(self, sizes, errors, style, label):
            self.lines[label] = (list(sizes), list(errors))

        def set(self, **texts):
            self.texts = texts

        def legend(self):
            pass

    found = ffstudy.Study(study_text()).run()
    axes = found.plot("parallel", Axes())
    rows = found.summary[(found.summary["pair_class"] == "parallel") & (found.summary["samples_per_patch"] == 64)]
    assert axes.lines["m"][0] == [16, 64]
    assert axes.lines["m"][1][1] == pytest.approx(numpy.sqrt(numpy.mean(rows["rmse"] ** 2)))
    assert "parallel pairs" in axes.texts["ylabel"]


def test_errors_have_places():
    with pytest.raises(ffstudy.InputError) as error:
        ffstudy.Study(study_text().replace("trials = 20", "trials = 1"), "mine.toml").run()
    assert (error.value.file, error.value.line, error.value.column) == ("mine.toml", 4, 10)
    assert isinstance(error.value, ValueError) and isinstance(error.value, ffstudy.Error)
    with pytest.raises(ffstudy.FileError, match="missing.toml"):
        ffstudy.Study.from_toml("missing.toml")
    with open("file", "w"):
        pass
    with pytest.raises(ffstudy.FileError):
        ffstudy.Study.from_toml(study_text()).run(out="file/folder")


def test_other_code_runs_only_where_it_is_allowed():
    text = study_text("command:touch ran {n}")
    study = ffstudy.Study.from_toml(text)
    assert study.wants() == [("study:9:11", "command:touch ran {n}")]
    with pytest.raises(ffstudy.InputError, match="commands=True"):
        study.run()
    assert not os.path.exists("ran")
    with pytest.raises(ffstudy.InputError):  # it prints no points
        study.run(commands=True)
    assert os.path.exists("ran")
    with pytest.raises(ffstudy.FileError, match="did not end within 0.2 s"):
        ffstudy.Study.from_toml(study_text("command:sleep 1000")).run(commands=True, deadline=0.2)


def interrupt_after(seconds):
    threading.Timer(seconds, os.kill, (os.getpid(), signal.SIGINT)).start()


def test_ctrl_c_saves_and_the_study_resumes():
    def interrupt_once(done, units):
        if done == 1:
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.2)  # until it is noticed

    study = ffstudy.Study.from_toml(study_text(trials=400, sizes="[65536]"))
    with pytest.raises(KeyboardInterrupt):
        study.run(out="kept", threads=1, progress=interrupt_once)
    seen = []
    resumed = study.run(out="kept", progress=lambda done, units: seen.append(done))
    assert resumed.complete and seen[0] > 1
    assert same(resumed.summary, study.run().summary)


def test_errors_of_progress_are_reported():
    with pytest.raises(ffstudy.InputError, match="progress: raised ZeroDivisionError"):
        ffstudy.Study.from_toml(study_text()).run(progress=lambda done, units: 1 / 0)


def test_ctrl_c_stops_form_factors():
    interrupt_after(1)
    with pytest.raises(KeyboardInterrupt):
        ffstudy.form_factors("discs_blocked", tolerance=1e-6, level=0.999999, max_samples=10**13, threads=1)


def test_trials_and_seed_can_be_changed():
    study = ffstudy.Study.from_toml(study_text(sizes="16"))
    other = study.run(trials=30, seed=2)
    assert set(other.summary["trials"]) == {30}
    assert not numpy.array_equal(other.summary["mean"], study.run(trials=30).summary["mean"])
