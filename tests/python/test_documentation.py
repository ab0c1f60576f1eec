import os
import re
import runpy
from pathlib import Path

import ffstudy

PAGE = (Path(__file__).parents[2] / "docs" / "python.md").read_text()


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
