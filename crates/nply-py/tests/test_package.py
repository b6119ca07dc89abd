"""What the package says of itself."""

from __future__ import annotations

import inspect
import re
import subprocess
import sys
import typing
from importlib.metadata import version
from pathlib import Path

import pytest

import nply
from nply import _nply, data


def test_every_public_name_is_documented() -> None:
    for name in nply.__all__:
        found = getattr(nply, name)
        if name.startswith("__"):
            continue
        assert inspect.getdoc(found), name
        if inspect.isclass(found) and not issubclass(found, Exception):
            for part, value in vars(found).items():
                public = not part.startswith("_") and (inspect.isfunction(value) or isinstance(value, property))
                assert not public or inspect.getdoc(value), f"{name}.{part}"
        if inspect.isfunction(found):
            doc = inspect.getdoc(found) or ""
            assert ">>>" in doc or name in ("figures",), f"{name} has no example"
            for parameter in inspect.signature(found).parameters:
                assert re.search(rf"\b{parameter}\b", doc), f"{name}: {parameter} is not explained"


def test_nothing_public_is_left_out() -> None:
    modules = ["arrays", "curves", "errors", "fits", "pictures", "reports", "shapes", "studies", "sweeps", "tables"]
    offered = {name for module in modules for name in getattr(__import__(f"nply.{module}"), module).__all__}
    assert offered - set(nply.__all__) <= {"Curves", "Document", "Measurements"}
    assert set(nply.__all__) <= set(dir(nply))


def test_keyword_arguments_are_the_command_s_flags() -> None:
    for layered, names in [(False, data.Data), (True, data.ConstructionData)]:
        assert sorted(names.__annotations__) == sorted(name for name, _, _ in _nply.keys(layered))


def test_the_stub_is_the_module() -> None:
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "nply._nply"], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout


def test_the_version_is_one() -> None:
    assert nply.__version__ == version("nply") == nply.presets().version


def test_hints_can_be_asked_for() -> None:
    assert typing.get_type_hints(nply.jobs) is not None
    assert (Path(nply.__file__).parent / "py.typed").exists()


def test_the_readme_s_program_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    readme = (Path(__file__).parents[1] / "README.md").read_text()
    programs = re.findall(r"```python\n(.*?)```", readme, re.DOTALL)
    assert programs
    for program in programs:
        exec(program, {})  # noqa: S102
    assert (tmp_path / "angle.svg").read_text().startswith("<svg")
