import os
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy
import numpy.typing

SceneFile = Union[str, os.PathLike[str]]
Fill = Callable[[int, int, int, int], numpy.typing.ArrayLike]

Estimate = Callable[[Scene, int, int, int], numpy.typing.ArrayLike]

class Error(Exception): ...

class InputError(Error, ValueError):
    file: Optional[str]
    line: Optional[int]
    column: Optional[int]

class FileError(Error, OSError): ...

class FormFactors:
    factors: Any
    half_widths: Any
    areas: numpy.ndarray
    names: List[str]
    missed: int
    trusted: bool
    samples: int
    faults: List[str]
    notes: List[str]
    def sparse(self) -> Any: ...

class Heat:
    names: List[str]
    areas: numpy.ndarray
    radiosity: numpy.ndarray
    irradiation: numpy.ndarray
    net: numpy.ndarray
    power: numpy.ndarray
    temperature: numpy.ndarray
    balance: numpy.ndarray
    groups: Any
    cases: List[str]
    trusted: bool
    warnings: List[str]

class Gate:
    name: str
    kind: str
    verdict: str
    words: str

class Verdicts:
    verdict: str
    gates: List[Gate]
    comparisons: numpy.ndarray
    @property
    def passed(self) -> bool: ...

class Results:
    summary: numpy.ndarray
    slopes: numpy.ndarray
    trials: numpy.ndarray
    report: str
    answer: str
    picture: str
    warnings: List[str]
    complete: bool
    def frame(self, name: str = "summary") -> Any: ...
    def plot(self, pairs: str = "adjacent", axes: Optional[Any] = None) -> Any: ...

class Scene:
    name: str
    faces: List[str]
    closed: bool
    polygons: Optional[List[Tuple[numpy.ndarray, int]]]
    toml: str

class Study:
    text: str
    origin: str
    def __init__(
        self,
        text: Optional[str] = None,
        origin: str = "study",
        *,
        methods: Optional[Sequence[Mapping[str, Any]]] = None,
        **study: Any,
    ) -> None: ...
    @classmethod
    def from_toml(cls, study: SceneFile) -> Study: ...
    def wants(self) -> List[Tuple[str, str]]: ...
    def run(
        self,
        *,
        samplers: Optional[Mapping[str, Union[Fill, Tuple[Fill, Dict[str, Any]]]]] = None,
        estimators: Optional[Mapping[str, Union[Estimate, Tuple[Estimate, Dict[str, Any]]]]] = None,
        trials: Optional[int] = None,
        seed: Optional[int] = None,
        threads: Optional[int] = None,
        out: Optional[SceneFile] = None,
        commands: bool = False,
        deadline: float = 60,
        progress: Optional[Callable[[int, int], object]] = None,
    ) -> Results: ...

def form_factors(
    scene: Optional[SceneFile] = None,
    *,
    vertices: Optional[numpy.typing.ArrayLike] = None,
    faces: Optional[Sequence[Sequence[int]]] = None,
    names: Optional[Sequence[str]] = None,
    closed: bool = False,
    tolerance: float = 1e-5,
    level: float = 0.95,
    simultaneous: bool = False,
    seed: int = 0,
    threads: Optional[int] = None,
    max_samples: int = 1_000_000_000,
) -> FormFactors: ...
def heat(
    scene: Optional[SceneFile] = None,
    materials: Optional[SceneFile] = None,
    *,
    vertices: Optional[numpy.typing.ArrayLike] = None,
    faces: Optional[Sequence[Sequence[int]]] = None,
    names: Optional[Sequence[str]] = None,
    closed: bool = False,
    emissivity: Optional[numpy.typing.ArrayLike] = None,
    temperature: Optional[numpy.typing.ArrayLike] = None,
    flux: Optional[numpy.typing.ArrayLike] = None,
    surroundings: Optional[float] = None,
    scale: float = 1,
    tolerance: float = 1e-4,
    level: float = 0.95,
    seed: int = 1,
    threads: Optional[int] = None,
    max_samples: int = 1_000_000_000,
    interval: str = "statistical",
) -> Heat: ...
def check(
    estimates: Union[SceneFile, Mapping[str, numpy.typing.ArrayLike], numpy.ndarray, Any],
    bands: SceneFile,
    *,
    against: Optional[Any] = None,
) -> Verdicts: ...
def points(
    name: str, n: int, d: int = 4, seed: int = 1, trial: int = 0, *, deadline: float = 60
) -> numpy.ndarray: ...
def exact(scene: SceneFile, i: int, j: int) -> Optional[float]: ...
def load_plugin(file: SceneFile) -> List[str]: ...
