"""The hazard of a site: annual rate of exceedance of an intensity measure."""

from __future__ import annotations

import os
from collections.abc import Sequence
from html import escape
from typing import Any

import pandas

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

    def to_frame(self, im: Sequence[float] | None = None) -> pandas.DataFrame:
        """``rate`` [1/year] at intensities [SI unit of the measure], index ``im``; NaN outside the points.

        :param im: default: the points of the curve; a power law has none
        """
        at = [float(each) for each in (self._curve.points() if im is None else im)]
        return pandas.DataFrame({"rate": [self.rate(each) for each in at]}, pandas.Index(at, name="im"))

    def __repr__(self) -> str:
        return f"<hazard over {self.measure}>"

    def _repr_html_(self) -> str:
        html: str = self.to_frame().reset_index().to_html(index=False, float_format="{:.4g}".format)
        return f"<p>Annual rate of exceeding {escape(self.measure)} [SI]</p>" + html


def read_hazard(path: str | os.PathLike[str], component: str | None = None, *,
                measure: str | None = None, site: int | None = None) -> Hazard:
    """A hazard file of schema "gurney-hazard/1", or a curve that another program published: OpenQuake's
    ``hazard_curve-mean-PGA_12.csv``, or the JSON of the hazard service of the USGS. These state their
    units (g, cm/s) and rates, but not the component.

    :param component: of a published curve, that of its ground-motion models: ``"RotD50"`` ...
    :param measure: which curve, of an answer of the USGS that has several: ``"Sa(1.0)"``
    :param site: row of the site in OpenQuake's file, from 1, if it has several
    :raises InputError: each error as ``file:line:column: what``; a disaggregation, which is no curve
    """
    name = os.fspath(path)
    if not os.path.exists(name):
        raise InputError(f"{name}: no such file")
    text = None
    if component is not None:
        text = jobs.text({"schema": "gurney-hazard/1", "component": component,
                          "usgs" if name.endswith(".json") else "openquake": os.path.abspath(name),
                          **{key: value for key, value in (("measure", measure), ("site", site))
                             if value is not None}})
    elif measure is not None or site is not None:
        raise InputError(f"{name}: measure and site go with component, of a published curve")
    hazard = Hazard.__new__(Hazard)
    hazard._take(engine.module().Hazard("hazard" if text else name, text))
    return hazard
