"""The reference made from the sources has an entry for everything that the package gives."""

from __future__ import annotations

import importlib.util
import re
import sys
from pathlib import Path
from types import ModuleType

import pytest

PROGRAM = Path(__file__).resolve().parents[1] / "reference.py"


@pytest.fixture(scope="module")
def reference() -> ModuleType:
    spec = importlib.util.spec_from_file_location("reference", PROGRAM)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["reference"] = module
    spec.loader.exec_module(module)
    return module


def test_every_public_name_has_an_entry_with_a_signature_and_words(reference: ModuleType) -> None:
    page: str = reference.page()
    names = [*reference.public("__init__"), *reference.public("dask")]
    assert len(names) > 40
    for name in names:
        found = re.search(rf"^### {name}\n\n```python\n(.+?)\n```\n\n(.+)", page, re.MULTILINE | re.DOTALL)
        assert found is not None, name
        assert name in found[1]
        assert not found[2].startswith("#"), f"{name} says nothing"
    assert page.count("\n### ") == len(names)


def test_what_the_package_gives_is_what_its_init_imports(reference: ModuleType) -> None:
    given = sorted(name for module, names in reference.given().items() if module != "dask" for name in names)
    assert given == sorted(reference.public("__init__"))
    told = {module for _, modules in reference.PARTS for module in modules}
    assert {module for module, names in reference.given().items() if names} <= told


def test_blocks_are_closed_and_links_lead_to_an_entry(reference: ModuleType) -> None:
    page: str = reference.page()
    assert page.count("```") % 2 == 0
    headings = {line.removeprefix("### ").lower() for line in page.splitlines() if line.startswith("### ")}
    links = re.findall(r"\]\(#([\w-]+)\)", page)
    assert links and set(links) <= headings
    assert ":func:" not in page and "``" not in page.replace("```", "")


def test_signatures_are_those_of_the_sources(reference: ModuleType) -> None:
    page: str = reference.page()
    assert "nply.lays(document: Document | int | None=None" in page or "nply.lays(" in page
    assert "#### Report.to_json\n\n```python\nto_json() -> str\n```" in page
    assert "self" not in re.findall(r"```python\n(nply\.Study\(.*?)```", page, re.DOTALL)[0]
