"""Studies: what is run, and what comes out."""

import csv
import hashlib
import io
import os
import tempfile
import threading
import warnings
from pathlib import Path

import numpy

from . import _core
from .errors import InputError

_names = threading.Lock()  # of functions: from reading a study to its end they mean the same


_TEXTS = {"study", "scene", "method", "sampler", "estimator", "completion", "nodes", "allocation", "from_face", "to_face",
          "pair_class", "interval_method", "std_interval_method"}


def _is_number(field):
    try:
        float(field or "nan")
    except ValueError:
        return False
    return True


def _table(text):
    """A CSV text as a structured array: columns of numbers are floats (an empty field is NaN), others are texts."""
    rows = list(csv.reader(io.StringIO(text)))
    columns = []
    for name, *fields in zip(*rows) if len(rows) > 1 else [(name,) for name in rows[0]]:
        columns.append((name, numpy.array(fields, dtype=str) if name in _TEXTS or not all(map(_is_number, fields))
                        else numpy.array([float(field or "nan") for field in fields])))
    table = numpy.empty(len(rows) - 1, dtype=[(name, values.dtype) for name, values in columns])
    for name, values in columns:
        table[name] = values
    return table


class Results:
    """What was found. Arrays have the columns of the files of these names (docs/results.md)."""

    def __init__(self, tables):
        self.summary = _table(tables.summary)  #: one row for each scene, method, size and quantity
        self.slopes = _table(tables.slopes)  #: how fast errors fall
        self.trials = _table(tables.trials)  #: every direct estimate
        self.report = tables.report  #: as report.md
        self.warnings = tables.warnings
        self.complete = tables.complete

    def frame(self, name="summary"):
        """A table as pandas.DataFrame; needs pandas."""
        import pandas

        return pandas.DataFrame(getattr(self, name))

    def _repr_html_(self):
        shown = [name for name in ("scene", "method", "samples_per_patch", "from_face", "to_face", "mean", "bias", "rmse")
                 if name in self.summary.dtype.names]
        escape = lambda text: str(text).replace("&", "&amp;").replace("<", "&lt;")
        head = "".join(f"<th>{name}</th>" for name in shown)
        rows = "".join("<tr>" + "".join(f"<td>{escape(row[name])}</td>" for name in shown) + "</tr>"
                       for row in self.summary)
        return f"<table><tr>{head}</tr>{rows}</table>"


def _code_hash(function):
    """Of what a function does: its code and that of functions in it, its defaults and what it has closed over."""
    digest = hashlib.sha256()

    def add(code):
        digest.update(code.co_code)
        digest.update(repr((code.co_names, code.co_varnames, code.co_freevars)).encode())
        for constant in code.co_consts:
            add(constant) if hasattr(constant, "co_code") else digest.update(repr(constant).encode())

    plain = function if hasattr(function, "__code__") else getattr(type(function), "__call__", None)
    if not hasattr(plain, "__code__"):
        raise InputError(f"{function!r}: not a function written in Python (its code is part of the study). Wrap it in one.")
    add(plain.__code__)
    closed = [cell.cell_contents for cell in plain.__closure__ or ()]
    digest.update(repr((plain.__defaults__, plain.__kwdefaults__, closed)).encode())
    if plain is not function:
        digest.update(repr(vars(function)).encode())
    return digest.hexdigest()[:16]


class Study:
    """A study: scenes, methods, sizes, trials, seed, as a study file says them (docs/study-files.md)."""

    def __init__(self, text, origin="study"):
        self.text = text
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

    def run(self, *, samplers=None, trials=None, seed=None, threads=None, out=None, commands=False, deadline=60,
            progress=None):
        """Runs the study, or resumes what is in `out`, and returns its Results.

        samplers: Python functions by name, fill(n, d, seed, trial) -> array (n, d) in [0, 1); methods then name them
            as samplers. Points must follow from the arguments alone. (function, {"d": 2, "randomised": False})
            declares that it gives at most 2 coordinates, or the same points for every seed.
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
        request = _core.StudyRequest(self.text, self.origin, trials, seed)
        threads = threads if threads is not None else len(os.sched_getaffinity(0))
        with _names:
            for name, function in (samplers or {}).items():
                function, options = function if isinstance(function, tuple) else (function, {})
                if not name.isidentifier():
                    raise InputError(f"samplers: {name!r} (a name of a function is wanted). Use letters, digits and _.")
                if not callable(function):
                    raise InputError(f"samplers[{name!r}]: {function!r} (not a function). Give fill(n, d, seed, trial).")
                if not set(options) <= {"d", "randomised"}:
                    raise InputError(f"samplers[{name!r}]: {options!r} (its options are d and randomised). Remove others.")
                _core.add_function(name, _code_hash(function), function, options.get("d", 4),
                                   options.get("randomised", True))
            if out is not None:
                tables = _core.run_study(request, Path(out), threads, progress)
            else:
                with tempfile.TemporaryDirectory(prefix="ffstudy") as folder:
                    tables = _core.run_study(request, Path(folder), threads, progress)
        for text in tables.warnings:
            warnings.warn(text, stacklevel=2)
        return Results(tables)
