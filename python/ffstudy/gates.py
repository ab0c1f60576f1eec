"""Gates on estimates: pass, fail or inconclusive."""

import csv
import os
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import List

import numpy

from . import _core
from .errors import InputError
from .tables import from_csv, to_html


@dataclass(frozen=True)
class Gate:
    """What one gate of a bands file found."""

    name: str
    kind: str  #: "bias", "std", ...
    verdict: str  #: "pass", "fail" or "inconclusive"
    words: str  #: the comparison that decided: effect, interval, band, trials


@dataclass(frozen=True)
class Verdicts:
    """What the gates of a bands file found."""

    verdict: str  #: of all together: "fail" where one fails, "pass" where all pass, else "inconclusive"
    gates: List[Gate]
    comparisons: numpy.ndarray  #: one row for each, with the columns of verdicts.csv (docs/gates.md)

    @property
    def passed(self) -> bool:
        """Whether all gates pass; inconclusive is not a pass."""
        return self.verdict == "pass"

    def __str__(self):
        return "\n".join(f"{gate.verdict}: {gate.name}: {gate.words}" for gate in self.gates)

    def _repr_html_(self):
        return to_html(["verdict", "gate", "kind", ""],
                       [[gate.verdict, gate.name, gate.kind, gate.words] for gate in self.gates])


def _rows(estimates):
    """Column names and rows of a mapping of trials by quantity, of a structured array, or of a DataFrame."""
    if hasattr(estimates, "to_records"):
        estimates = estimates.to_records(index=False)
    names = getattr(getattr(estimates, "dtype", None), "names", None)
    if names:
        return names, estimates.tolist()
    if not hasattr(estimates, "items"):
        raise InputError(f"estimates: {type(estimates).__name__} (expected a file, a table, or trials by quantity). "
                         "Give {'quantity': array}.")
    rows = []
    for quantity, values in estimates.items():
        values = numpy.asarray(values, dtype=float)
        if values.ndim != 1:
            raise InputError(f"estimates[{quantity!r}]: an array of shape {values.shape} (expected one number per "
                             "trial). Give each quantity a name of its own.")
        rows += [(trial, quantity, value) for trial, value in enumerate(values.tolist())]
    return ("trial", "quantity", "estimate"), rows


def _file(estimates, file):
    """The file itself where one is named, else `file` with what is given."""
    if isinstance(estimates, (str, os.PathLike)):
        return Path(estimates)
    names, rows = _rows(estimates)
    with open(file, "w", newline="", encoding="utf-8") as out:
        csv.writer(out, lineterminator="\n").writerows([names, *rows])
    return file


def check(estimates, bands, *, against=None) -> Verdicts:
    """Judges estimates of any program by the gates of a bands file, as `ffstudy check BANDS --estimates FILE` does.

    estimates: trials by quantity, {"F12": array (trials,)}; or a table (structured array or DataFrame) with the columns
        of docs/gating-your-code.md, e.g. quantity, mean, standard_error; or such a CSV file.
    bands: a bands file, or its text, which has at least one line break. Each gate has a quantity.
    against: estimates to compare with, for gates of the kinds "equal" and "distribution".

    Raises InputError where the data cannot be judged, e.g. where trials repeat; FileError.
    """
    is_text = isinstance(bands, str) and "\n" in bands
    text, origin = (bands, "bands") if is_text else (_core.read_bands_file(bands), os.fspath(bands))
    with tempfile.TemporaryDirectory(prefix="ffstudy") as folder:
        given = _file(estimates, Path(folder) / "estimates")
        other = "" if against is None else _file(against, Path(folder) / "against")
        try:
            found = _core.judge(text, origin, given, other)
        except InputError as error:
            raise InputError(str(error).replace(folder + os.sep, "")) from None  # arrays have no file
    return Verdicts(found.verdict, [Gate(*gate) for gate in found.gates], from_csv(found.comparisons))
