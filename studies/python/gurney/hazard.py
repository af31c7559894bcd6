"""The hazard of a site: annual rate of exceedance of an intensity measure."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from . import engine, jobs
from .errors import InputError


class Hazard:
    """A hazard curve. The program reads it, so that unit, measure and points are checked as those of a
    file of schema "gurney-hazard/1"; between the points ln rate is linear in ln im, beyond them
    nothing is known.

    :param im: two or more intensities in ``unit``, increasing
    :param rate: mean annual rate of exceeding each [1/year], decreasing
    :param measure: ``"PGA"``, ``"PGV"``, ``"Sa(1.0)"`` and so on
    :param unit: ``"g"``, ``"m/s2"``, ``"m/s"`` ...; it has no default: a curve in g is not one in m/s2
    :param component: ``"geomean"``, ``"RotD50"``, ``"larger"`` and so on; that of the study
    :raises InputError: what is wrong, with what is allowed
    """

    def __init__(self, im: Sequence[float], rate: Sequence[float], *, measure: str, unit: str,
                 component: str = "geomean") -> None:
        text = jobs.text({"schema": "gurney-hazard/1", "measure": measure, "component": component,
                          "unit": unit, "im": [float(each) for each in im],
                          "rate_per_year": [float(each) for each in rate]})
        self._take(engine.module().Hazard("hazard", text))

    def _take(self, curve: Any) -> None:
        self._curve = curve
        self.measure: str = curve.measure  #: with its component, ``"PGA geomean"``

    def rate(self, im: float) -> float:
        """Mean annual rate of exceeding ``im`` [SI unit of the measure]; NaN outside the points."""
        found: float = self._curve.rate(im)
        return found

    def __repr__(self) -> str:
        return f"<hazard over {self.measure}>"


def read_hazard(path: str | os.PathLike[str]) -> Hazard:
    """A hazard file, schema "gurney-hazard/1": points, a power law, or a curve of OpenQuake.

    :raises InputError: each error as ``file:line:column: what``
    """
    name = os.fspath(path)
    if not os.path.exists(name):
        raise InputError(f"{name}: no such file")
    hazard = Hazard.__new__(Hazard)
    hazard._take(engine.module().Hazard(name, None))
    return hazard
