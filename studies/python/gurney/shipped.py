"""What is shipped: items, casters, floor coverings, rooms, tethers, buildings."""

from __future__ import annotations

from typing import Any

import pandas

from . import engine, program
from .errors import not_in_file


def catalogue(kind: str = "items") -> pandas.DataFrame:
    """A row for each, index ``key``: the name that jobs use.

    :param kind: ``"items"`` (with ``mass_kg``, ``height_m``, ``base_over_height``, ``tilt_rad``,
        ``casters``, ``assumptions``), ``"casters"``, ``"floors"``, ``"rooms"``, ``"tethers"``,
        ``"buildings"``
    """
    found = program.ask("equipment", "ls")
    if kind not in found:
        raise not_in_file("the catalogue", "kind", kind, found)
    rows = [each if isinstance(each, dict) else {"key": each} for each in found[kind]]
    return pandas.DataFrame(rows).set_index("key")


def sheet(item: str) -> dict[str, Any]:
    """What `gurney equipment show ITEM --json` says: mass, inertia, support, tilt, wheel loads,
    resistance, in SI units.

    :param item: a name of the catalogue, or the path of an item file
    """
    found: dict[str, Any] = program.ask("equipment", "show", item)
    return found


def data_folder() -> str:
    """Where the shipped files are, placed as in the sources: ``equipment``, ``groundmotions/records``,
    ``groundmotions/buildings``, ``studies/jobs``."""
    found: str = engine.module().data_folder()
    return found
