"""Jobs and items as dicts: read, changed in single keys, and written."""

from __future__ import annotations

import copy
import json
import os
import pathlib
import re
import tomllib
from collections.abc import Mapping
from typing import Any

import numpy

from . import engine
from .errors import InputError

Job = dict[str, Any]


def read_job(path: str | os.PathLike[str]) -> Job:
    """A job, or any other TOML or JSON file, as nested dicts.

    :raises InputError: the file is missing, or neither TOML nor JSON: ``file:line:column: what``
    """
    name = os.fspath(path)
    try:
        return parsed(pathlib.Path(path).read_text(encoding="utf-8"))
    except OSError as error:
        raise InputError(f"{name}: {error.strerror}") from error
    except json.JSONDecodeError as error:
        raise InputError(f"{name}:{error.lineno}:{error.colno}: {error.msg}") from error
    except tomllib.TOMLDecodeError as error:
        what, _, place = str(error).rpartition(" (at ")
        where = "".join(f":{each}" for each in re.findall(r"\d+", place))
        raise InputError(f"{name}{where}: {what}") from error
    except ValueError as error:
        raise InputError(f"{name}: {error}") from error


def parsed(text: str) -> Job:
    """The text of a job, TOML or JSON, as nested dicts."""
    found: Job = json.loads(text) if text.lstrip().startswith("{") else tomllib.loads(text)
    return found


def patched(job: Mapping[str, Any], overrides: Mapping[str, Any]) -> Job:
    """A copy of a job with other values.

    :param overrides: values by their dotted keys, as the ``key`` of a factor of a study:
        ``{"item.brakes": True, "settings.duration_s": 12}``. Of tables that come several times,
        ``item.bed.brakes`` is of the one with that name, ``item.0.brakes`` of the first,
        ``item.*.brakes`` of all. A dict is merged into a table, but a quantity (a dict with
        ``value``) replaces what was there; None removes a key.
    :raises InputError: a key leads through something that is no table
    """
    result = copy.deepcopy(dict(job))
    for key, value in overrides.items():
        _set(result, key.split("."), value, key)
    return result


def item(equipment: str, changes: Mapping[str, Any] | None = None, **keys: Any) -> Job:
    """An item of the catalogue with other numbers, for the argument ``item`` of :func:`simulate`.

    :param equipment: a name of the catalogue, or the path of an item file
    :param changes: values by their dotted keys in the item file, ``{"chassis.mass_kg": 40}``; those of a
        caster begin with ``caster.*.inline``, or with ``caster.NAME.inline``:
        ``{"caster.*.inline.tread.rolling_resistance_mm": 1.2}``. A number is in the unit of its key.
    :param keys: other keys of ``[item]``: ``brakes=True``, ``position_m=[1, 2]``
    :returns: a dict that describes the item in full, so that it depends on no file
    :raises InputError: no such item; a key leads nowhere
    """
    module = engine.module()
    path = module.find_data(module.DataKind.item, equipment, "")
    description = read_job(path)
    for place in description.get("caster", []):
        kind = place.pop("type", None)
        kind = kind["value"] if isinstance(kind, dict) else kind
        if kind is not None:
            place["inline"] = read_job(module.find_data(module.DataKind.caster, kind, path))
            del place["inline"]["schema"]
    for each in ("schema", "variant"):
        description.pop(each, None)
    for key, value in (changes or {}).items():
        if isinstance(value, dict) or value is None:
            stated = value
        else:
            stated = {"value": _plain(value), "source": "set by gurney.item()"}
        _set(description, key.split("."), stated, key, must_be_there=True)
    return {"name": pathlib.Path(equipment).stem, "inline": description, **keys}


def text(job: Mapping[str, Any]) -> str:
    """The job as JSON, which the program reads like TOML. Numbers and arrays of numpy, and paths
    may be in it.

    :raises InputError: what no job can hold
    """
    try:
        written = json.dumps(job, default=_plain, indent=1)
        if re.search(r"\bNaN\b", written) and (key := _nan_in(json.loads(written))):
            raise InputError(f"{key} = nan: must be a number")
        return written
    except RecursionError as error:
        raise InputError("the tables of the job are nested too deep") from error
    except (TypeError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"the tables of the job cannot be written as JSON: {error}") from error


def _nan_in(value: Any) -> str:
    """The dotted key of a number that is none; empty: there is no such."""
    inner = value.items() if isinstance(value, dict) else enumerate(value) \
        if isinstance(value, list) else ()
    for key, each in inner:
        if isinstance(each, float) and each != each:
            return str(key)
        if below := _nan_in(each):
            return f"{key}.{below}"
    return ""


def dotted(keywords: Mapping[str, Any]) -> dict[str, Any]:
    """Keywords with ``__`` for each dot: ``item__brakes`` is ``item.brakes``."""
    return {name.replace("__", "."): value for name, value in keywords.items()}


def _plain(value: object) -> Any:
    """What JSON does not know: numbers and arrays of numpy, and paths."""
    if isinstance(value, (numpy.ndarray, numpy.generic)):
        return value.tolist()
    if isinstance(value, pathlib.PurePath):
        return str(value)
    if isinstance(value, (str, int, float, bool, list, tuple)):
        return value
    raise InputError(f"{value!r}: a job has numbers, texts, lists and dicts")


def _places(table: Any, name: str, key: str) -> list[Any]:
    """The tables that a part of a key stands for."""
    if isinstance(table, dict):
        return [table.setdefault(name, {})]
    if isinstance(table, list) and name == "*":
        return list(table)
    if isinstance(table, list):
        found = [each for each in table if isinstance(each, dict) and each.get("name") == name]
        if not found and name.isdigit() and int(name) < len(table):
            found = [table[int(name)]]
        if found:
            return found
    raise InputError(f"{key}: '{name}' leads nowhere")


def _set(table: Any, names: list[str], value: Any, key: str, must_be_there: bool = False) -> None:
    *way, last = names
    tables = [table]
    for name in way:
        if must_be_there and any(isinstance(each, dict) and name not in each for each in tables):
            raise InputError(f"{key}: there is no '{name}'")
        tables = [below for each in tables for below in _places(each, name, key)]
    for each in tables:
        if isinstance(each, list):
            for one in _places(each, last, key):
                each[each.index(one)] = value
        elif not isinstance(each, dict):
            raise InputError(f"{key}: '{last}' is no key of {each!r}")
        elif must_be_there and last not in each:
            raise InputError(f"{key}: there is no '{last}'; there are {', '.join(each)}")
        elif value is None:
            each.pop(last, None)
        elif isinstance(value, Mapping) and "value" not in value and isinstance(each.get(last), dict):
            for name, inner in value.items():
                _set(each[last], [name], inner, f"{key}.{name}")
        else:
            each[last] = {name: inner for name, inner in value.items() if inner is not None} \
                if isinstance(value, Mapping) else value
