import ast
import contextlib
import inspect
import io
import json
import os
import re
import runpy
from pathlib import Path

import ffstudy

DOCUMENTS = Path(__file__).parents[2] / "docs"
PAGE = (DOCUMENTS / "python.md").read_text()


def test_the_example_draws_its_figure(program, monkeypatch):
    (example,) = re.findall(r"```python\n(.*?)```", PAGE, re.S)
    assert len(example.splitlines()) < 30
    Path("example.py").write_text(example)
    monkeypatch.setenv("PATH", os.path.dirname(program), prepend=os.pathsep)
    names = runpy.run_path("example.py")
    assert Path("korobov.pdf").read_bytes().startswith(b"%PDF-")
    for name in names["names"]:
        rows = names["opposite"][names["opposite"]["method"] == name]
        assert set(rows["samples_per_patch"]) == {2.0**k for k in range(6, 13)}


def test_the_page_and_the_stub_name_what_there_is():
    stub = Path(ffstudy.__file__).with_name("__init__.pyi").read_text()
    for name in ffstudy.__all__:
        assert re.search(rf"^(class|def) {name}\b", stub, re.M), name
        assert f"`{name}" in PAGE or f".{name}`" in PAGE or name == "FormFactors", name
    for method in ("from_toml", "run", "wants"):
        assert f"def {method}(" in stub


def test_the_stub_has_the_parameters_of_functions():
    """With their defaults, by name and in order."""
    stub = ast.parse(Path(ffstudy.__file__).with_name("__init__.pyi").read_text())
    functions = {node.name: node.args for node in stub.body if isinstance(node, ast.FunctionDef)}
    assert {"form_factors", "heat", "points", "exact", "check"} <= set(functions)
    for name, arguments in functions.items():
        there = inspect.signature(getattr(ffstudy, name)).parameters
        assert [a.arg for a in arguments.args + arguments.kwonlyargs] == list(there), name
        defaults = [*arguments.defaults, *(default for default in arguments.kw_defaults if default is not None)]
        expected = [parameter.default for parameter in there.values() if parameter.default is not inspect.Parameter.empty]
        assert [ast.literal_eval(default) for default in defaults] == expected, name


def test_the_notebook_prints_what_it_shows():
    cells = json.loads((DOCUMENTS / "examples" / "furnace.ipynb").read_text())["cells"]
    names = {}
    for cell in cells:
        if cell["cell_type"] != "code":
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec("".join(cell["source"]), names)
        assert printed.getvalue() == "".join(line for output in cell["outputs"] for line in output["text"])
