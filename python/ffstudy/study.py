"""Studies: what is run, and what comes out."""

import hashlib
import html
import json
import os
import pickle
import random
import tempfile
import threading
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import List, Optional, Tuple

import numpy

from . import _core
from .errors import InputError
from .tables import from_csv, to_html

_names = threading.Lock()  # of functions: from reading a study to its end they mean the same


@dataclass(frozen=True)
class Scene:
    """What a function that estimates form factors gets."""

    name: str
    faces: List[str]  #: their names
    closed: bool
    polygons: Optional[List[Tuple[numpy.ndarray, int]]]  #: corners (k, 3), counter-clockwise as seen from the side that
    #: radiates, and the face, from 0; -1 is only in the way. None where a surface is curved
    toml: str  #: the scene in the words of docs/scenes.md, whatever its shapes


class Results:
    """What was found. Arrays have the columns of the files of these names (docs/results.md)."""

    def __init__(self, tables):
        self.summary = from_csv(tables.summary)  #: one row for each scene, method, size and quantity
        self.slopes = from_csv(tables.slopes)  #: how fast errors fall
        self.trials = from_csv(tables.trials)  #: every direct estimate
        self.report = tables.report  #: as report.md
        self.answer = tables.answer  #: the study's question answered in a sentence or a few, intervals included
        self.picture = tables.picture  #: SVG of what the answer ranks; empty where it ranks nothing
        self.warnings = tables.warnings
        self.complete = tables.complete

    def frame(self, name="summary"):
        """A table as pandas.DataFrame; needs pandas."""
        import pandas

        return pandas.DataFrame(getattr(self, name))

    def plot(self, pairs="adjacent", axes=None):
        """Draws errors against evaluations, a line for each method, and returns the axes; needs matplotlib.

        pairs: "parallel", "adjacent" or "other".   axes: where to draw; new ones if not given.
        """
        if axes is None:
            from matplotlib import pyplot

            axes = pyplot.subplots()[1]
        rows = self.summary[self.summary["pair_class"] == pairs]
        for method in dict.fromkeys(rows["method"]):
            of_method = rows[rows["method"] == method]
            sizes = of_method["samples_per_patch"] * of_method["patches_per_face"]
            known = numpy.unique(sizes[numpy.isfinite(sizes)])
            axes.plot(known, [numpy.sqrt(numpy.mean(of_method["rmse"][sizes == size] ** 2)) for size in known], "o-",
                      label=str(method))
        axes.set(xscale="log", yscale="log", xlabel="samples per face", ylabel=f"RMSE of a run, {pairs} pairs")
        axes.legend()
        return axes

    def _repr_html_(self):
        shown = [name for name in ("scene", "method", "samples_per_patch", "from_face", "to_face", "mean", "bias", "rmse")
                 if name in self.summary.dtype.names]
        table = to_html(shown, self.summary[shown].tolist())
        return f"<p><b>{html.escape(self.answer)}</b></p>{self.picture}<details><summary>Summary</summary>{table}</details>"


def _add(digest, value, seen):
    """Adds what a value does or is: of a function its code, its defaults and what it has closed over."""
    plain = getattr(value, "__func__", value)
    if id(plain) in seen:  # a function that calls itself
        return
    if hasattr(plain, "__code__"):
        seen = seen | {id(plain)}
        closed = [cell.cell_contents for cell in plain.__closure__ or ()]
        _add(digest, (plain.__code__, plain.__defaults__, plain.__kwdefaults__, closed), seen)
        if plain is not value:
            _add(digest, getattr(value.__self__, "__dict__", None), seen)
    elif hasattr(value, "co_code"):
        _add(digest, (value.co_code, value.co_names, value.co_varnames, value.co_freevars, value.co_consts), seen)
    elif isinstance(value, (tuple, list, dict)):
        digest.update(f"{type(value).__name__} of {len(value)}: ".encode())
        for each in value.items() if isinstance(value, dict) else value:
            _add(digest, each, seen)
    elif isinstance(value, frozenset):  # its order differs from session to session
        _add(digest, sorted(map(repr, value)), seen)
    else:
        try:
            digest.update(pickle.dumps(value, protocol=4))
        except Exception:  # of any kind, where something cannot be pickled
            digest.update(repr(value).encode())


def _code_hash(function):
    called = function if hasattr(function, "__code__") else getattr(function, "__call__", None)
    if not hasattr(called, "__code__"):
        raise InputError(f"{function!r}: not a function written in Python (its code is part of the study). Wrap it in one.")
    digest = hashlib.sha256()
    _add(digest, called, frozenset())
    return digest.hexdigest()[:16]


def _shared_generators():
    return random.getstate(), pickle.dumps(numpy.random.get_state())


class _Watched:
    """A function, whose first calls must not draw from a generator that all threads share: results would depend on them."""

    def __init__(self, function):
        self._function = function
        self._watched = 2

    def __call__(self, *arguments):
        if self._watched == 0:
            return self._function(*arguments)
        self._watched -= 1
        before = _shared_generators()
        made = self._function(*arguments)
        if _shared_generators() != before:
            raise InputError("it draws from a generator that all threads share (that of random or numpy.random). "
                             "Take numpy.random.default_rng(seed).")
        return made


def _functions(kind, functions, defaults):
    """Name, function and all options of each."""
    for name, function in (functions or {}).items():
        function, options = function if isinstance(function, tuple) else (function, {})
        if not name.isidentifier():
            raise InputError(f"{kind}: {name!r} (expected a name of a function). Use letters, digits and _.")
        if not callable(function):
            raise InputError(f"{kind}[{name!r}]: {function!r} (not a function). Give one, or (function, options).")
        if not set(options) <= set(defaults):
            raise InputError(f"{kind}[{name!r}]: {options!r} (its options are {' and '.join(defaults)}). Remove others.")
        yield name, function, {**defaults, **options}


def _to_toml(study, methods):
    """A study file. Numbers, texts and lists are written alike in JSON and TOML."""
    def lines(section):
        return "".join(f"{key} = {json.dumps(value, ensure_ascii=False, default=lambda array: array.tolist())}\n" for key, value in section.items())

    return f"[study]\n{lines(study)}" + "".join(f"[[method]]\n{lines(method)}" for method in methods)


class Study:
    """A study: scenes, methods, sizes, trials, seed, as a study file says them (docs/study-files.md)."""

    def __init__(self, text=None, origin="study", *, methods=None, **study):
        """The text of a study file; or its keys: those of [study] by name, and `methods`, a dict for each.

        Study(scene="cube", trials=64, seed=1, methods=[{"name": "Sobol'", "sampler": "sobol",
              "estimator": "ray_shooting", "samples_per_patch": "2^6..2^12"}])
        """
        if (text is None) == (methods is None):
            raise InputError("Study: a text, or methods (expected one of the two). Give one.")
        self.text = text if text is not None else _to_toml({"name": "study", **study}, methods)
        self.origin = origin

    @classmethod
    def from_toml(cls, study):
        """A study file by path, or its text, which has at least one line break."""
        if isinstance(study, str) and "\n" in study:
            return cls(study)
        return cls(_core.read_study_file(study), os.fspath(study))

    def wants(self):
        """What the study loads and runs besides ffstudy, as pairs (place, plug-in or command)."""
        return _core.wants(self.text, self.origin)

    def run(self, *, samplers=None, estimators=None, trials=None, seed=None, threads=None, out=None, commands=False, deadline=60,
            progress=None):
        """Runs the study, or resumes what is in `out`, and returns its Results.

        samplers: Python functions by name, fill(n, d, seed, trial) -> array (n, d) in [0, 1); methods then name them
            as samplers. Points must follow from the arguments alone. (function, {"d": 2, "randomised": False})
            declares that it gives at most 2 coordinates, or the same points for every seed.
        estimators: likewise estimate(scene, samples, seed, trial) -> array (faces, faces); `scene` is a Scene.
            (function, {"samples": False, "randomised": False}) takes no sizes, or gives the same for every seed.
        trials, seed: instead of the study's.   threads: all cores where not given; results do not depend on them.
        out: a folder that keeps the results, to resume or for `ffstudy report`; none is left where not given.
        commands: whether plug-ins and programs that the study names may run.   deadline: of a program, in seconds.
        progress: called as progress(units_done, units).

        Raises InputError, FileError; KeyboardInterrupt on Ctrl-C, after what was done is saved.
        """
        wanted = self.wants()
        if wanted and not commands:
            place, code = wanted[0]
            raise InputError(f"{place}: {code} (a study that runs other code is run where it is trusted). Call "
                             "run(commands=True).")
        _core.admit(self.text, self.origin, deadline)
        request = self.text, self.origin, trials, seed
        threads = threads if threads is not None else len(os.sched_getaffinity(0))
        with _names:
            for name, function, options in _functions("samplers", samplers, {"d": 4, "randomised": True}):
                _core.add_function(name, _code_hash(function), _Watched(function), options["d"], options["randomised"])
            for name, function, options in _functions("estimators", estimators, {"samples": True, "randomised": True}):
                _core.add_estimator(name, _code_hash(function), _Watched(function), options["samples"], options["randomised"])
            if out is not None:
                tables = _core.run_study(*request, Path(out), threads, progress)
            else:
                with tempfile.TemporaryDirectory(prefix="ffstudy") as folder:
                    tables = _core.run_study(*request, Path(folder), threads, progress)
        for text in tables.warnings:
            warnings.warn(text, stacklevel=2)
        return Results(tables)
