"""Errors of the package; each message names what is available instead."""

from __future__ import annotations

import difflib
import numbers
from collections.abc import Iterable


class Error(Exception):
    """What this package refuses, with the reason."""


class DamagedFile(Error):
    """The bytes of a file differ from those that Gurney wrote."""


class InputError(Error, ValueError):
    """What is wrong with a job, an item or a record: a line for each error, with its place."""


class NotInFile(Error, LookupError):
    """A table, name or run that the file does not have."""


def at_least_one(name: str, value: object) -> int:
    """A whole number of 1 or more. :raises InputError: it is none"""
    if isinstance(value, bool) or not isinstance(value, numbers.Integral) or value < 1:
        raise InputError(f"{name} = {value!r}: must be a whole number, 1 or more")
    return int(value)


def not_in_file(where: str, kind: str, name: object, known: Iterable[object]) -> NotInFile:
    """The error for a name that is not among the known ones, with the nearest of them."""
    names = [str(each) for each in known]
    near = difflib.get_close_matches(str(name), names, n=1)
    meant = f" (did you mean '{near[0]}'?)" if near else ""
    return NotInFile(f"{where}: no {kind} '{name}'{meant}; it has: {shortened(names)}")


def shortened(names: Iterable[object], most: int = 12) -> str:
    """The first names of a list, and how many more there are."""
    given = [str(each) for each in names]
    if not given:
        return "none"
    more = len(given) - most
    return ", ".join(given[:most]) + (f" and {more} more" if more > 0 else "")
