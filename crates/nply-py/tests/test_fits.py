"""Known numbers come back from measurements that were made of them, in whatever form these come."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np
import pytest

import nply

GAMMA, SIGMA = 0.8, 0.05


@pytest.fixture(scope="module")
def measured() -> dict[str, np.ndarray]:
    draw = np.random.default_rng(5)
    twist = np.linspace(-1.6, -0.4, 25)
    found = nply.equilibria(3, GAMMA, pretwist=twist)
    angle = np.degrees([found.row(i).helical_angle[0] for i in range(25)])
    return {
        "pretwist": twist,
        "helical_angle [deg]": angle + draw.normal(0, SIGMA, 25),
        "helical_angle_error [deg]": np.full(25, SIGMA),
    }


def test_a_known_ratio_comes_back_from_noisy_angles(measured: dict[str, np.ndarray]) -> None:
    report = nply.fit(measured, strands=3, stiffness_ratio=1, estimate="stiffness_ratio")
    [estimate] = report.estimates
    assert abs(estimate.value - GAMMA) < 4 * estimate.standard_error < 0.05
    assert 0.001 < report.probability < 0.999 and report.degrees_of_freedom == 24
    assert report.picture.svg.startswith("<svg") and len(list(csv.reader(io.StringIO(report.to_csv())))) == 26


def test_tables_texts_and_files_are_the_same_measurements(measured: dict[str, np.ndarray], tmp_path: Path, command) -> None:
    import pyarrow as pa

    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(measured)
    rows.writerows(zip(*(column.tolist() for column in measured.values())))
    path = tmp_path / "measurements"
    path.write_text(text.getvalue())
    asked = {"strands": 3, "stiffness_ratio": 1, "estimate": "stiffness_ratio"}
    answers = {nply.fit(form, **asked).to_json() for form in (measured, text.getvalue(), path, pa.table(measured))}
    assert len(answers) == 1
    out, said = command("fit", str(path), "--strands=3", "--stiffness-ratio=1", "--estimate=stiffness_ratio", "--json")
    assert answers == {out.decode()}, said


def test_what_is_no_measurement_is_said(measured: dict[str, np.ndarray]) -> None:
    with pytest.raises(nply.SpecError) as refused:
        nply.fit("angle,pretwist\n1,2\n", strands=3, stiffness_ratio=1, estimate="stiffness_ratio")
    assert refused.value.line == 1
    with pytest.raises(ValueError, match="one length"):
        nply.fit({"a": [1], "b": [1, 2]}, strands=3, estimate="stiffness_ratio")
    with pytest.raises(FileNotFoundError):
        nply.fit("none.csv", strands=3, estimate="stiffness_ratio")
