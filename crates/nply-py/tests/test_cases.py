"""The shared cases: the package answers with the bytes of the command."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import nply

CASES = Path(__file__).resolve().parents[3] / "tests" / "cases"
LIST = json.loads((CASES / "list.json").read_text())["cases"]
WHOLE = {"points", "branches", "steps", "elements_per_pitch"}
NAMES = {"contact": "shape"}


def ask(root: Path, case: dict) -> nply.Report:
    given: dict = {}
    for flag, value in case["arguments"].items():
        name = flag.replace("-", "_")
        if name.startswith("to_"):
            given.setdefault("to", {})[name.removeprefix("to_")] = value
        elif name in WHOLE:
            given[name] = int(value)
        else:
            given[name] = True if (name, value) == ("core", "") else value
    verb = case["verb"].replace("-", "_")
    document = [root / case["document"]] if "document" in case else []
    return getattr(nply, NAMES.get(verb, verb))(*document, **given)


@pytest.mark.parametrize("case", LIST, ids=[case["name"] for case in LIST])
def test_the_same_case_has_the_same_bytes(root: Path, case: dict) -> None:
    report = ask(root, case)
    assert report.to_json().encode() == (CASES / f"{case['name']}.json").read_bytes()
    assert report.to_dict() == json.loads(report.to_json())


@pytest.mark.parametrize("case", LIST, ids=[case["name"] for case in LIST])
def test_the_table_is_the_command_s(root: Path, command, case: dict) -> None:
    words = [case["verb"], *([case["document"]] if "document" in case else [])]
    words += [f"--{flag}" if value is True else f"--{flag}={value}" for flag, value in case["arguments"].items()]
    out, _ = command(*words)
    assert repr(ask(root, case)) + "\n" == out.decode()
