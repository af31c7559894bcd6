"""Studies from Python: the program runs them, with its threads, progress and resuming."""

from __future__ import annotations

import contextlib
import hashlib
import os
import pathlib
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from . import jobs, program
from .errors import Error, InputError, at_least_one
from .results import Results


def study(job: str | os.PathLike[str] | Mapping[str, Any], output: str | os.PathLike[str], *,
          overrides: Mapping[str, Any] | None = None, threads: int | None = None,
          progress: bool | Callable[[str], None] = True, resume: bool = False,
          overwrite: bool = False) -> Results:
    """Runs a study, and opens its results.

    :param job: the path of a job file with a table ``[study]``, or a job as a dict
    :param output: the results file, ``"study.h5"``; log and part files are beside it
    :param overrides: other values by their dotted keys, see :func:`gurney.patched`
    :param threads: all of the machine if not stated; the results have the same bytes for any number
    :param progress: True prints the lines of the program to stderr, a function is called with each
    :param resume: continue an interrupted study, or open a complete one
    :param overwrite: replace files that exist
    :returns: :class:`gurney.Results`; runs that failed are ``failed`` in its ``runs``
    :raises InputError: what is wrong with the job, or files exist
    :raises KeyboardInterrupt: after Ctrl-C; finished runs are kept, and ``resume`` goes on

    A job with ``overrides``, or a dict, is written as ``NAME.job.json``, NAME that of the results, and
    stays, since :func:`Results.play` and `gurney replay` need it: in the folder where its relative
    paths start, that of the job file, of a dict that of the results. Beside results in another folder
    the name has eight digits more, which stand for that folder. One with another content stays as it
    is unless ``overwrite`` or ``resume`` is given and the program accepts the job.
    """
    file = pathlib.Path(output)
    command = ["-o", str(file)]
    if threads is not None:
        command += ["-j", str(at_least_one("threads", threads))]
    command += [f"--{name}" for name, wanted in (("resume", resume), ("overwrite", overwrite))
                if wanted]
    tell = progress if callable(progress) else _print if progress else lambda line: None
    start = [program.path(), "run"]
    path, text = _job_file(job, overrides or {}, file)
    with _written(path, text, file, may_replace=overwrite or resume):
        _follow([*start, str(path), *command], tell)
    return Results(str(file))


def _print(line: str) -> None:
    print(line, file=sys.stderr)


def _job_file(job: str | os.PathLike[str] | Mapping[str, Any], overrides: Mapping[str, Any],
              output: pathlib.Path) -> tuple[pathlib.Path, str | None]:
    """The file of the job, and its text if this call makes it."""
    if isinstance(job, (str, os.PathLike)):
        path = pathlib.Path(job)
        if not overrides:
            return path, None
        given, folder = jobs.read_job(path), path.parent
    else:
        given, folder = dict(job), output.parent
    changed = jobs.patched(given, overrides)
    if "study" not in changed:
        raise InputError("the job has no table [study]: gurney.run() makes a single run")
    place = os.path.relpath(output.parent.absolute(), folder.absolute())
    where = "" if place == os.curdir else "." + hashlib.sha256(os.fsencode(place)).hexdigest()[:8]
    return folder / f"{output.name.removesuffix('.h5')}{where}.job.json", jobs.text(changed)


@contextlib.contextmanager
def _written(path: pathlib.Path, text: str | None, output: pathlib.Path, *,
             may_replace: bool) -> Iterator[None]:
    """Holds the text at the path while the program runs, and leaves it there unless it is refused: what
    stood there before is then as it was."""
    if text is None or path.is_file() and path.read_bytes() == text.encode():
        yield
        return
    before = path.with_name(path.name + ".before")
    if replaces := path.exists():
        if not may_replace or path.is_dir():
            raise InputError(f"{path}: exists, and is not this job; overwrite=True replaces a file")
        os.replace(path, before)
    try:
        try:
            path.write_bytes(text.encode())
        except OSError as error:
            raise InputError(f"{path}: {error.strerror}") from error
        yield
    except InputError:
        if replaces:
            os.replace(before, path)
        elif not pathlib.Path(f"{output}.parts").exists():  # else finished runs need it
            path.unlink(missing_ok=True)
        raise
    finally:
        if replaces:  # accepted, even if runs failed or were interrupted
            before.unlink(missing_ok=True)


def _follow(command: list[str], tell: Callable[[str], None]) -> None:
    """Runs the program, and passes on each line of its standard error."""
    lines: list[str] = []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                          stdin=subprocess.DEVNULL) as running:
        try:
            assert running.stderr is not None
            for line in running.stderr:
                lines.append(line.rstrip("\n"))
                tell(lines[-1])
        except KeyboardInterrupt:
            running.send_signal(signal.SIGINT)
            running.wait()
            raise
    if running.returncode == 1:
        raise InputError("\n".join(lines).removeprefix("gurney: "))
    if running.returncode not in (0, 3):
        raise Error(f"gurney run ended with {running.returncode}:\n" + "\n".join(lines))
