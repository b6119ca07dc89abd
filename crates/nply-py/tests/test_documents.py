"""Documents in every form are one document, and refusals say what the command says."""

from __future__ import annotations

import pickle
import tomllib
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

import nply

YARN = "examples/three-ply-yarn.toml"


def test_every_form_is_the_same_document(root: Path) -> None:
    path = root / YARN
    text = path.read_text()
    forms = [path, str(path), text, text.encode(), tomllib.loads(text)]
    answers = {nply.solve(form).to_json() for form in forms}
    assert len(answers) == 1
    by_name = nply.solve(
        title="Three-ply yarn", strands=3, diameter="0.275 mm", stiffness_ratio=0.75, turns_per_length="470 turns/m"
    )
    assert by_name.to_json() in answers
    replaced = nply.solve(path, strands=2)
    assert replaced.to_json() == nply.solve(text.replace("strands = 3", "strands = 2")).to_json() not in answers


def test_documents_of_layers_and_legs_can_be_dictionaries(root: Path) -> None:
    for ask, file in [(nply.stiffness, "rope-6x7.toml"), (nply.fit_check, "conductor-cardinal.toml"), (nply.trace, "letting-go.toml")]:
        path = root / "examples" / file
        assert ask(tomllib.loads(path.read_text())).to_json() == ask(path).to_json()


def test_numbers_of_numpy_and_quantities_are_values() -> None:
    plain = nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-0.1, force=0.30000000000000004).to_json()
    assert plain == nply.solve(
        {"ply": {"strands": np.int64(3)}, "strand": {"stiffness_ratio": np.float64(0.75)}, "load": {"force": 0.1 + 0.2}},
        pretwist=np.float64(-0.1),
    ).to_json()

    class Unit:
        def __format__(self, how: str) -> str:
            assert how == "~P"
            return "mm"

    class Quantity:
        magnitude = 0.5
        units = Unit()

    want = nply.shape(strands=3, helical_angle="20 deg", diameter="0.5 mm").to_json()
    assert nply.shape(strands=3, helical_angle="20 deg", diameter=Quantity()).to_json() == want
    assert nply.shape({"ply": {"strands": 3}, "lay": {"helical_angle": "20 deg"}, "strand": {"diameter": Quantity()}}).to_json() == want


def test_what_is_no_document_is_said() -> None:
    with pytest.raises(TypeError, match="a dictionary, a text in TOML or a path; int is none"):
        nply.solve(3)
    with pytest.raises(FileNotFoundError, match="no-such-file.toml"):
        nply.solve("no-such-file.toml")
    with pytest.raises(TypeError, match="true or false; Decimal is none"):
        nply.solve(strands=Decimal(3))
    with pytest.raises(TypeError, match="has no place in a document"):
        nply.solve({"ply": {"strands": {1, 2}}})
    loop: dict = {}
    loop["ply"] = loop
    with pytest.raises(TypeError, match="deeper"):
        nply.solve(loop)
    with pytest.raises(nply.SpecError):
        nply.solve()


def refused_inputs() -> list[Path]:
    drawers = Path(__file__).resolve().parents[3] / "tests" / "inputs"
    files = [file for drawer in ("parse_error", "unit_error", "domain_error") for file in (drawers / drawer).glob("*.toml")]
    assert len(files) > 100
    return sorted(files)


def test_refusals_are_the_command_s(root: Path, command) -> None:
    """Every filed input that is refused: the same lines, and the kind that the exit status tells."""
    for file in refused_inputs():
        name = str(file.relative_to(root))
        bytes_ = file.read_bytes()
        if b"\n[[path]]\n" in bytes_ or b"\n[map]\n" in bytes_:
            continue
        _, said = command("solve", name)
        with pytest.raises(nply.SpecError) as refused:
            nply.solve(file)
        error = refused.value
        assert "error: " + error.sentence == said.decode().splitlines()[0]
        assert error.rendered.replace(str(file), name).rstrip() == said.decode().rstrip()
        assert error.exit_code == (1 if file.parent.name == "domain_error" else 2) == (1 if error.kind == "domain" else 2)
        assert error.file == str(file) and error.line >= 1 and error.column >= 1


def test_refusals_speak_of_arguments_not_of_flags() -> None:
    with pytest.raises(nply.SpecError) as refused:
        nply.solve(strands=3, stifness_ratio=0.75)
    error = refused.value
    assert str(error) == "stifness_ratio: this argument is not known; did you mean `stiffness_ratio`?"
    assert (error.kind, error.argument, error.help) == ("unknown_key", "stifness_ratio", "did you mean `stiffness_ratio`?")
    assert (error.file, error.line, error.column) == (None, None, None)
    with pytest.raises(nply.SpecError, match=r"^force: .*\"2 mm\" is a length"):
        nply.trace(strands=3, stiffness_ratio=0.75, pretwist=-1, force="2 mm", to={"moment": 1})
    with pytest.raises(nply.SpecError, match="^to_force: "):
        nply.trace(strands=3, stiffness_ratio=0.75, pretwist=-1, to={"force": "2 mm"})
    with pytest.raises(nply.SpecError, match="^`strand` is no key of"):
        nply.solve({"ply": {"strand": 3}})


def test_refusals_travel_between_processes() -> None:
    with pytest.raises(nply.SpecError) as refused:
        nply.solve("[ply]\nstrand = 3\n")
    again = pickle.loads(pickle.dumps(refused.value))
    assert (type(again), str(again), again.__dict__) == (nply.SpecError, str(refused.value), refused.value.__dict__)
    with pytest.raises(nply.DomainError) as outside:
        nply.contact([3, 3], [0.5, 2.0])
    assert str(pickle.loads(pickle.dumps(outside.value))) == str(outside.value)


def test_reports_are_mappings_with_attributes() -> None:
    report = nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-1)
    state = report.states[0]
    assert state.helical_angle_deg == state["helical_angle_deg"] == report.to_dict()["states"][0]["helical_angle_deg"]
    assert "helical_angle_deg" in state and "states" in dir(report) and "handedness" in dir(state)
    with pytest.raises(AttributeError, match="there is no 'angle' here"):
        _ = state.angle
    with pytest.raises(KeyError):
        _ = report["angle"]
    with pytest.raises(AttributeError, match="no picture"):
        _ = report.picture
    again = pickle.loads(pickle.dumps(report))
    assert (again.to_json(), repr(again), again.to_csv()) == (report.to_json(), repr(report), report.to_csv())
    assert "<pre" in report._repr_html_() and "30.613" in report._repr_html_()


def test_csv_is_the_command_s(root: Path, command) -> None:
    out, _ = command("solve", YARN, "--format", "csv")
    assert nply.solve(root / YARN).to_csv().encode() == out
    with pytest.raises(AttributeError, match="no CSV"):
        nply.lays(strands=3).to_csv()


def test_presets_are_documents(command) -> None:
    ask = {"contact": nply.shape, "solve": nply.solve, "fit-check": nply.fit_check, "stiffness": nply.stiffness, "actuator": nply.actuator}
    for preset in nply.presets().presets:
        assert ask[preset.command](nply.preset(preset.name)).to_json().startswith("{")
        assert nply.preset(preset.name).encode() == command("preset", preset.name)[0]
    with pytest.raises(KeyError, match="there are prestressing"):
        nply.preset("no such")
