"""The program `gurney`, for what the compiled module does not do: it is run, and its JSON is read."""

from __future__ import annotations

import functools
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import warnings
from typing import Any

from .errors import Error, InputError


@functools.cache
def path() -> str:
    """The program beside this package, else the one in ``PATH``.

    In a build that is ``build/release/gurney``, in an installation or an environment ``bin/gurney``.

    :raises Error: there is none
    """
    package = pathlib.Path(__file__).absolute().parent
    near = [package.parents[1] / "gurney"] if (package / "source_folder").exists() else []
    near += [folder / "bin/gurney" for folder in package.parents]
    found = next((str(each) for each in near if each.is_file()), shutil.which("gurney"))
    if found is None:
        raise Error("the program gurney is neither beside this package nor in PATH: pip install . "
                    "brings it, or ./dev install")
    return found


def order(*arguments: object) -> str:
    """Runs the program, and returns what it prints; its notes are warnings of Python.

    :param arguments: those of the command line, ``order("report", "study.h5", "-o", "study.html")``
    :raises InputError: what is wrong with the input, a line for each error
    """
    done = _run([str(each) for each in arguments])
    if done.returncode not in (0, 3):  # 3: a run failed, which its report states
        raise InputError(done.stderr.strip().removeprefix("gurney: ") or done.stdout.strip())
    _warn(done.stderr)
    return done.stdout


def ask(*arguments: object) -> Any:
    """Runs the program with ``--json``, and returns what it says as dicts and lists, in SI units; its
    notes are warnings of Python.

    :param arguments: those of the command line, ``ask("fragility", "study.h5")``
    :raises InputError: what is wrong with the input, each error as ``file:line:column: what``
    """
    done = _run([*(str(each) for each in arguments), "--json"])
    try:
        answer = json.loads(done.stdout)
    except json.JSONDecodeError:
        raise InputError(done.stderr.strip().removeprefix("gurney: ")) from None
    if done.returncode not in (0, 3):
        skipped = [line for line in done.stderr.splitlines() if line.startswith("skipped: ")]
        raise InputError("\n".join([_line(each) for each in answer["errors"]] + skipped)
                         if "errors" in answer else done.stderr.strip())
    _warn(done.stderr)
    return answer


def page(*arguments: object) -> str:
    """The HTML page that a command writes with ``-o``."""
    with tempfile.TemporaryDirectory() as folder:
        written = os.path.join(folder, "page.html")
        order(*arguments, "-o", written)
        return pathlib.Path(written).read_text(encoding="utf-8")


def _run(arguments: list[str]) -> subprocess.CompletedProcess[str]:
    return subprocess.run([path(), *arguments], capture_output=True, text=True,
                          stdin=subprocess.DEVNULL)


def _warn(told: str) -> None:
    """Lines such as "note: 3 records are excluded" as warnings, at the caller outside this package."""
    depth, frame = 1, sys._getframe()
    while frame.f_back and frame.f_globals.get("__package__") == __package__:
        depth, frame = depth + 1, frame.f_back
    for line in told.splitlines():
        kind, colon, text = line.partition(": ")
        if colon and kind in ("note", "warning", "skipped"):
            warnings.warn(text if kind != "skipped" else line, stacklevel=depth)


def _line(error: dict[str, Any]) -> str:
    place = [str(error[key]) for key in ("file", "line", "column") if error.get(key) is not None]
    return ": ".join([":".join(place), error["message"]] if place else [error["message"]])
