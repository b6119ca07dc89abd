"""Arrays: the numbers of single plies, and NumPy's manners."""

from __future__ import annotations

import numpy as np
import pytest

import nply

ANGLES = np.radians(np.linspace(0.5, 89.5, 40))


def test_contacts_are_those_of_single_plies() -> None:
    for strands in (2, 3, 7, 12, 13, 40):
        shift, radius = nply.contact(strands, ANGLES)
        for i in range(0, len(ANGLES), 7):
            one = nply.shape(strands=strands, helical_angle=f"{np.degrees(ANGLES[i]):.17g} deg")
            assert radius[i] == pytest.approx(one.radius_ratio, rel=2e-15, abs=0)
            assert shift[i] == pytest.approx(one.arclength_shift, rel=4e-14, abs=1e-15)


def test_touching_strands_touch() -> None:
    """Another route: helices of the radius that is given come to two strand radii of each other, and not nearer."""
    strands = np.arange(3, 9)[:, None]
    theta = np.radians([10.0, 30.0, 60.0])
    _, rho = nply.contact(strands, theta)
    t = np.linspace(-np.pi, np.pi, 20001)
    for i, j in np.ndindex(rho.shape):
        lag = 2 * np.pi / strands[i, 0]
        height = rho[i, j] / np.tan(theta[j]) * t
        distance = np.sqrt(2 * rho[i, j] ** 2 * (1 - np.cos(t + lag)) + height**2)
        assert 2.0 - 1e-12 < distance.min() < 2.0 + 1e-5


def test_states_are_those_of_single_plies() -> None:
    pretwist = np.linspace(-2, 2, 9)
    force = np.array([[-0.2], [0.0], [0.3]])
    for balance in ("contact", "radial"):
        found = nply.equilibria(3, 0.75, pretwist=pretwist, force=force, moment=0.1, balance=balance)
        assert found.shape == (3, 9) == found.count.shape
        for i, j in np.ndindex(3, 9):
            one = nply.solve(
                strands=3, stiffness_ratio=0.75, pretwist=pretwist[j], force=force[i, 0], moment=0.1, balance=balance
            )
            row = found.row((i, j))
            assert row.handedness.tolist() == [state.handedness for state in one.states]
            want = [state.helical_angle_deg for state in one.states]
            assert np.degrees(row.helical_angle) == pytest.approx(want, abs=1e-10)
        assert np.array_equal(found.row(10).helical_angle, found.row((1, 1)).helical_angle)
        assert len(found.rows) == len(found) == found.offsets[-1]


def test_strand_twist_is_another_question_than_pretwist() -> None:
    one = nply.solve(strands=3, stiffness_ratio=0.75, pretwist=-1).states[0]
    back = nply.equilibria(3, 0.75, strand_twist=one.strand_twist)
    assert np.degrees(back.row().helical_angle[0]) == pytest.approx(one.helical_angle_deg, abs=1e-9)


def test_broadcasting_is_numpy_s() -> None:
    whole = nply.contact(np.full((4, 5), 6), np.broadcast_to(ANGLES[:5], (4, 5)))
    for strands, theta in [
        (6, np.broadcast_to(ANGLES[:5], (4, 5))),
        (np.full((4, 1), 6), ANGLES[:5]),
        (np.full((4, 1), 6, dtype=np.uint8), ANGLES[:5].tolist()),
        (np.full(4, 6.0)[:, None], np.asfortranarray(np.broadcast_to(ANGLES[:5], (4, 5)))),
        (6, np.repeat(ANGLES[:5], 3)[::3] * np.ones((4, 1))),
        (6, np.broadcast_to(ANGLES[:5], (4, 5)).astype(">f8")),
    ]:
        found = nply.contact(strands, theta)
        assert found.radius_ratio.shape == (4, 5) and found.radius_ratio.dtype == np.float64
        assert np.array_equal(found.radius_ratio, whole.radius_ratio)
        assert np.array_equal(found.arclength_shift, whole.arclength_shift)
    assert nply.contact([], []).radius_ratio.shape == (0,)
    assert nply.contact(np.ones((0, 3)), 0.5).radius_ratio.shape == (0, 3)
    assert nply.equilibria([], 0.75, pretwist=1).count.shape == (0,)
    with pytest.raises(ValueError, match="broadcast"):
        nply.contact([2, 3], [0.1, 0.2, 0.3])


def test_single_numbers_give_single_numbers() -> None:
    for strands, theta in [(6, 0.3), (np.int32(6), np.float64(0.3)), (np.array(6), np.array(0.3)), (6.0, 0.3)]:
        shift, radius = nply.contact(strands, theta)
        assert type(shift) is float and type(radius) is float
    assert isinstance(nply.contact([6], 0.3).radius_ratio, np.ndarray)


def test_stretches_join_without_a_seam() -> None:
    """Longer than any stretch of rows that is worked on at once."""
    n = 3 * (1 << 18) + 17
    theta = np.resize(ANGLES, n)
    strands = np.resize(np.arange(2, 14), n)
    _, radius = nply.contact(strands, theta)
    some = np.unique(np.r_[np.arange(0, n, 9973), n - 1, np.arange(-3, 3) + (1 << 18), np.arange(-3, 3) + (1 << 14)])
    for i in some:
        assert radius[i] == pytest.approx(nply.contact(int(strands[i]), float(theta[i])).radius_ratio, rel=1e-15)
    twist = np.resize(np.linspace(-2, 2, 101), 50_000)
    whole = nply.equilibria(np.resize(np.arange(2, 9), 50_000), 0.75, pretwist=twist)
    for i in (0, 16383, 16384, 32768, 49_999):
        one = nply.equilibria(2 + i % 7, 0.75, pretwist=twist[i])
        assert np.allclose(whole.row(i).helical_angle, one.helical_angle, rtol=0, atol=1e-13)


def test_threads_change_no_number() -> None:
    twist = np.linspace(-2, 2, 40_000)
    nply.set_jobs(1)
    assert nply.jobs() == 1
    alone = nply.equilibria(5, 0.75, pretwist=twist)
    nply.set_jobs(3)
    shared = nply.equilibria(5, 0.75, pretwist=twist)
    nply.set_jobs(None)
    for name, column in alone.to_dict().items():
        assert np.array_equal(column, shared.to_dict()[name])
    with pytest.raises(ValueError):
        nply.set_jobs(0)


def test_what_is_outside_the_theory_is_refused_with_its_place() -> None:
    with pytest.raises(nply.DomainError) as refused:
        nply.contact(3, 1.6)
    assert (refused.value.quantity, refused.value.value, refused.value.index) == ("helical_angle", 1.6, ())
    assert str(refused.value) == (
        "helical_angle = 1.6 is outside the theory: it must be at least 0 and less than pi/2 (90 degrees)"
    )
    with pytest.raises(nply.DomainError, match=r"strands = -3 .*\(element \[1, 0\]\)"):
        nply.contact([[3], [-3]], [0.1, 0.2])
    with pytest.raises(nply.DomainError, match="strands = 1 "):
        nply.equilibria(1, 0.75, pretwist=1)
    with pytest.raises(nply.DomainError, match="stiffness_ratio"):
        nply.equilibria(3, [0.75, 0.0], pretwist=1)
    with pytest.raises(nply.DomainError, match="strands = 4294967299"):
        nply.contact(2**32 + 3, 0.5)
    assert issubclass(nply.DomainError, ValueError)


def test_or_it_is_nan_with_its_reason() -> None:
    theta = np.array([[0.3, np.nan], [-0.1, 0.4]])
    found = nply.contact([2, 3], theta, errors="nan")
    assert np.isnan(found.radius_ratio).tolist() == [[False, True], [True, False]]
    assert [refused.index for refused in found.refused] == [(0, 1), (1, 0)]
    assert [refused.quantity for refused in found.refused[:]] == ["helical_angle"] * 2
    states = nply.equilibria(3, 0.75, pretwist=[1.0, np.inf, 1.0], errors="nan")
    assert states.count[1] == 0 and states.count[0] == states.count[2] > 0
    assert states.refused.rows.tolist() == [1] and "pretwist" in str(states.refused[-1])
    assert not nply.contact(3, 0.4, errors="nan").refused


def test_what_is_no_number_is_a_type_error() -> None:
    for strands in (2.5, np.nan, "3", True, 3j):
        with pytest.raises(TypeError):
            nply.contact(strands, 0.3)
    with pytest.raises(TypeError, match="either pretwist or strand_twist"):
        nply.equilibria(3, 0.75)
    with pytest.raises(TypeError, match="either pretwist or strand_twist"):
        nply.equilibria(3, 0.75, pretwist=1, strand_twist=1)
    with pytest.raises(ValueError, match='"contact" or "radial"'):
        nply.equilibria(3, 0.75, pretwist=1, balance="both")
    with pytest.raises(ValueError, match="errors"):
        nply.contact(3, 0.3, errors="ignore")
