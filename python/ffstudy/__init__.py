"""Form-factor methods under honest statistics, from Python.

    import ffstudy
    found = ffstudy.form_factors("room.obj", tolerance=1e-4)
    found.factors, found.half_widths          # numpy arrays (faces, faces), dimensionless
    ffstudy.heat("room.obj", "materials.toml").power   # (faces, 2): both ends, in W
    ffstudy.points("sobol", 1024, 4, seed=1)  # (1024, 4) in [0, 1)
    ffstudy.Study.from_toml("study.toml").run().summary["rmse"]
    ffstudy.check({"F12": estimates}, "bands.toml").passed

Results are those of the program `ffstudy` to the bit: the same study and seed give the same numbers. Errors are
`ffstudy.InputError` and `ffstudy.FileError`; Ctrl-C stops a computation cleanly. docs/python.md has more.
"""

import json
import os
from dataclasses import dataclass
from typing import Any, List, Optional, Sequence, Union

import numpy

from . import _core
from .errors import Error, FileError, InputError
from .gates import Gate, Verdicts, check
from .study import Results, Scene, Study
from .tables import MOST_ROWS, to_html

__all__ = ["Error", "FileError", "FormFactors", "Gate", "Heat", "InputError", "Results", "Scene", "Study", "Verdicts", "check", "exact",
           "form_factors", "heat", "load_plugin", "points"]

SceneFile = Union[str, os.PathLike]


@dataclass(frozen=True)
class FormFactors:
    """All form factors between the faces of a scene, each with an interval."""

    factors: Any  #: (faces, faces), dimensionless: row i is what leaves face i. Of more than 2048 faces SciPy's
    #: csr_matrix, else numpy.ndarray
    half_widths: Any  #: likewise: the larger half of each interval
    areas: numpy.ndarray  #: (faces,), in squared units of length of the scene
    names: List[str]  #: of the faces
    missed: int  #: pairs of faces whose interval is wider than the tolerance
    trusted: bool  #: whether nothing speaks against the scene and the matrix as a whole
    samples: int  #: rays and points that were spent
    faults: List[str]  #: what is wrong with the scene
    notes: List[str]  #: what may be meant by it, with what is assumed

    def sparse(self):
        """The factors as scipy.sparse.csr_matrix; needs scipy."""
        from scipy.sparse import csr_matrix

        return csr_matrix(self.factors)

    def _repr_html_(self):
        shown = self.factors[:MOST_ROWS + 1]
        rows = shown.toarray() if hasattr(shown, "toarray") else shown
        return to_html(["", *self.names], [[name, *(f"{value:.6g}" for value in row)]
                                           for name, row in zip(self.names, rows)], rows=len(self.names))


def _threads(threads):
    return threads if threads is not None else len(os.sched_getaffinity(0))


def _scene(scene):
    """Name and text of a scene; no text for a built-in one."""
    file, before_zone, zone = os.fspath(scene).partition(" zone:")
    if isinstance(scene, str) and not _core.is_scene_file(file):
        return scene, None
    return os.path.basename(file) + before_zone + zone, _core.read_scene_file(file)


def _obj(vertices, faces, names, closed):
    """The text of an OBJ file; numbers are written so that they read back to the same bits."""
    vertices = numpy.asarray(vertices, dtype=float)
    if vertices.ndim != 2 or vertices.shape[1] != 3:
        raise InputError(f"vertices: an array of shape {vertices.shape} (expected (vertices, 3)). Give x, y, z.")
    if names is not None and len(names) != len(faces):
        raise InputError(f"names: {len(names)} (there are {len(faces)} faces). Give one for each.")
    lines = ["# closed"] if closed else []
    lines += [f"v {x!r} {y!r} {z!r}" for x, y, z in vertices.tolist()]
    for number, face in enumerate(faces):
        corners = [int(corner) for corner in face]
        if any(corner < 0 or corner >= len(vertices) for corner in corners):
            raise InputError(f"faces[{number}]: {corners} (vertices are counted from 0 to {len(vertices) - 1}). "
                             "Correct the corner.")
        if names is not None:
            if not str(names[number]).strip() or len(str(names[number]).split()) != 1:
                raise InputError(f"names[{number}]: {names[number]!r} (a name is one word). Use _ for a space.")
            lines.append(f"g {names[number]}")
        lines.append("f " + " ".join(str(corner + 1) for corner in corners))
    text = "\n".join(lines) + "\n"
    return text if names is not None else _core.with_faces_of_polygons(text)


def _scene_or_polygons(caller, scene, vertices, faces, names, closed):
    """Name and text of the scene that was given as one, or as polygons."""
    if (scene is None) == (vertices is None or faces is None):
        raise InputError(f"{caller}: a scene, or vertices and faces (expected one of the two). Give one.")
    if scene is None:
        return "polygons.obj", _obj(vertices, faces, names, closed)
    if closed:
        raise InputError(f"{caller}: closed belongs to vertices and faces (a file says it itself). Leave it out.")
    return _scene(scene)


def form_factors(scene: Optional[SceneFile] = None, *, vertices=None, faces: Optional[Sequence[Sequence[int]]] = None,
                 names: Optional[Sequence[str]] = None, closed: bool = False, tolerance: float = 1e-5, level: float = 0.95,
                 simultaneous: bool = False, seed: int = 0, threads: Optional[int] = None,
                 max_samples: int = 1_000_000_000) -> FormFactors:
    """All form factors of a scene, exactly where geometry allows it and by sampling elsewhere.

    scene: a built-in scene ("cube", "box:2x1x0.5") or a file of any kind that the program reads (of EnergyPlus's also
        with a zone: "house.idf zone:Attic").
    vertices, faces: instead of it, an array (vertices, 3) and the corners of each polygon, counted from 0 and
        counter-clockwise as seen from the side that radiates. `names` gives faces names; faces of one name are one.
        `closed` says that every ray hits one of them.
    tolerance: largest half width of an interval.   level: of the intervals, above 0.5.
    simultaneous: the level is that of all entries and row sums at once.   max_samples: rays and points in all.

    Raises InputError, FileError; KeyboardInterrupt on Ctrl-C.
    """
    name, text = _scene_or_polygons("form_factors", scene, vertices, faces, names, closed)
    found = _core.form_factors(name, text, tolerance, level, simultaneous, seed, _threads(threads), max_samples)
    return FormFactors(found.factors, found.half_widths, numpy.array(found.areas), found.names, found.missed,
                       found.trusted, found.samples, found.faults, found.notes)


@dataclass(frozen=True)
class Heat:
    """What grey diffuse faces emit, reflect and absorb. Quantities are arrays (faces, 2): both ends of intervals.
    Where the materials have [[case]]s they have one more axis, (cases, faces, 2)."""

    names: List[str]  #: of the faces
    areas: numpy.ndarray  #: (faces,), m²
    radiosity: numpy.ndarray  #: W/m², emitted and reflected
    irradiation: numpy.ndarray  #: W/m²
    net: numpy.ndarray  #: W/m², out of the face
    power: numpy.ndarray  #: W, net times area
    temperature: numpy.ndarray  #: K
    balance: numpy.ndarray  #: (2,), or (cases, 2): W, all powers together: what the surroundings take up, or 0
    groups: Any  #: {name: (low, high)}: W of each group of faces; a list of them, one for each case
    cases: List[str]  #: names of the cases; empty where there are none
    trusted: bool  #: whether nothing speaks against the scene and its form factors as a whole
    warnings: List[str]  #: what is wrong with the scene, and temperatures that may be in other units


def _materials(names, emissivity, temperature, flux, surroundings):
    """The text of a materials file for arrays of as many values as there are faces, or one for all."""
    columns = {}
    for key, values in (("emissivity", emissivity), ("temperature", temperature), ("flux", flux)):
        if values is None:
            continue
        values = numpy.asarray(values, dtype=float)
        if values.shape not in ((), (len(names),)):
            raise InputError(f"{key}: an array of shape {values.shape} (there are {len(names)} faces). Give one value, "
                             "or one for each.")
        columns[key] = numpy.broadcast_to(values, len(names)).tolist()
    lines = [] if surroundings is None else [f"surroundings = {float(surroundings)!r}"]
    lines.append("[materials]")
    for face, name in enumerate(names):
        given = ", ".join(f"{key} = {values[face]!r}" for key, values in columns.items()
                          if not numpy.isnan(values[face]))
        lines.append(f"{json.dumps(name, ensure_ascii=False)} = {{ {given} }}")
    return "\n".join(lines) + "\n"


def heat(scene: Optional[SceneFile] = None, materials: Optional[SceneFile] = None, *, vertices=None,
         faces: Optional[Sequence[Sequence[int]]] = None, names: Optional[Sequence[str]] = None, closed: bool = False,
         emissivity=None, temperature=None, flux=None, surroundings: Optional[float] = None, scale: float = 1,
         tolerance: float = 1e-4, level: float = 0.95, seed: int = 1, threads: Optional[int] = None,
         max_samples: int = 1_000_000_000, interval: str = "statistical") -> Heat:
    """Heat between the faces of a scene, as `ffstudy heat` finds it.

    scene, or vertices, faces, names and closed: as for form_factors.
    materials: a materials file (docs/heat.md).
    emissivity, temperature, flux, surroundings: instead of it, one value for all faces or an array (faces,), in K and
        W/m². A face has a temperature or a flux; the other is NaN.
    scale: metres per unit of length.   tolerance: largest half width of a form factor.
    level: of each interval.   max_samples: rays and points in all.
    interval: "statistical", or "bound": for all form factors within intervals that hold all at once with that level.

    Raises InputError, FileError; KeyboardInterrupt on Ctrl-C.
    """
    if interval not in ("statistical", "bound"):
        raise InputError(f"heat: interval = {interval!r} (expected 'statistical' or 'bound'). Take one of them.")
    name, text = _scene_or_polygons("heat", scene, vertices, faces, names, closed)
    arrays = [emissivity, temperature, flux, surroundings]
    if (materials is None) == all(values is None for values in arrays):
        raise InputError("heat: a materials file, or emissivity with temperature or flux (expected one of the two). "
                         "Give one.")
    if materials is not None:
        origin = os.fspath(materials)
        properties = _core.read_materials_file(origin)
    else:
        origin = "arrays"
        properties = _materials(_core.face_names(name, text), *arrays)
    found = _core.heat(name, text, properties, origin, scale, interval == "statistical", tolerance, level, seed,
                       _threads(threads), max_samples)
    cases = [case for case in found.cases if case]
    groups = [dict(of_case) for of_case in found.groups]

    def shaped(values):
        return values if cases else values[0]

    return Heat(found.names, numpy.array(found.areas), shaped(found.radiosity), shaped(found.irradiation),
                shaped(found.net), shaped(found.power), shaped(found.temperature), shaped(found.balance[:, 0]),
                shaped(groups), cases, found.trusted, found.warnings)


def points(name: str, n: int, d: int = 4, seed: int = 1, trial: int = 0, *, deadline: float = 60) -> numpy.ndarray:
    """The points of a sampler, an array (n, d) in [0, 1): those of `ffstudy points`.

    name: a sampler of `ffstudy list samplers` or of a plug-in that is loaded, "file:points.npy#owen" or
        "command:./mine --n {n} --d {d} --seed {seed}", which runs the program.   d: 1 to 4.
    deadline: seconds that a program may take.
    """
    return _core.points(name, n, d, seed, trial, deadline)


def exact(scene: SceneFile, i: int, j: int) -> Optional[float]:
    """The exact form factor from face i to face j, counted from 1 as the program's faces are; None where none is known."""
    name, text = _scene(scene)
    return _core.exact(name, text, i, j)


def load_plugin(file: SceneFile) -> List[str]:
    """Loads a plug-in with samplers (docs/adding-a-sampler.md) and returns their full names. It runs its code."""
    return _core.load_plugin(os.fspath(file))
