"""Where the workspace and the command are, and how the command answers."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


def _command() -> Path | None:
    said = os.environ.get("NPLY_COMMAND")
    built = [ROOT / "target" / profile / "nply" for profile in ("release", "debug")]
    found = [Path(said)] if said else [path for path in built if path.exists()]
    return found[0] if found else None


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="session")
def command():
    """The command ``nply`` with words: standard output and standard error as bytes."""
    program = _command()
    if program is None:
        pytest.skip("the command is not built: NPLY_COMMAND says where it is")

    def run(*words: str) -> tuple[bytes, bytes]:
        done = subprocess.run([program, *words], cwd=ROOT, capture_output=True, timeout=120)
        return done.stdout, done.stderr

    return run


@pytest.fixture
def python():
    """Another Python with a program: its standard output."""
    import sys

    def run(program: str, **more) -> str:
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120, **more)
        assert done.returncode == 0, done.stderr
        return done.stdout

    assert shutil.which(sys.executable)
    return run
