"""Errors of the package; each message names what is available instead."""

import difflib


class Error(Exception):
    """What this package refuses, with the reason."""


class DamagedFile(Error):
    """The bytes of a file differ from those that Gurney wrote."""


class InputError(Error, ValueError):
    """What is wrong with a job, an item or a record: a line for each error, with its place."""


class NotInFile(Error, LookupError):
    """A table, name or run that the file does not have."""


def not_in_file(where, kind, name, known):
    """The error for a name that is not among the known ones, with the nearest of them."""
    known = [str(each) for each in known]
    near = difflib.get_close_matches(str(name), known, n=1)
    meant = f" (did you mean '{near[0]}'?)" if near else ""
    return NotInFile(f"{where}: no {kind} '{name}'{meant}; it has: {shortened(known)}")


def shortened(names, most=12):
    """The first names of a list, and how many more there are."""
    names = [str(each) for each in names]
    if not names:
        return "none"
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")
