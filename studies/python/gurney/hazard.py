"""The hazard of a site: annual rate of exceedance of an intensity measure."""

import os
import re
import tomllib
from dataclasses import dataclass

import numpy

from .errors import Error
from .units import _TO_SI


@dataclass(frozen=True)
class Hazard:
    """Points of a hazard curve: ``im`` in the SI unit of the measure, ``rate`` [1/year]; between
    the points ln rate is linear in ln im. ``measure`` is as in ``runs``, "PGV larger"."""

    im: tuple
    rate: tuple
    measure: str = ""

    def __post_init__(self):
        im, rate = numpy.asarray(self.im, float), numpy.asarray(self.rate, float)
        if im.shape != rate.shape or im.ndim != 1 or len(im) < 2:
            raise Error(f"{im.size} intensities have {rate.size} rates: must be 2 or more of each")
        if not ((numpy.diff(im) > 0).all() and (numpy.diff(rate) < 0).all() and
                im[0] > 0 and rate[-1] > 0):
            raise Error("intensities must be > 0 and increase, rates must be > 0 and decrease")
        object.__setattr__(self, "im", tuple(im))
        object.__setattr__(self, "rate", tuple(rate))

    def rate_of(self, probability, lowest=0, highest=numpy.inf):
        """Integral of P(exceeded | im) |d rate|; motions above the table count with P at its end.

        By Gauss-Legendre with 8 points on panels of at most 0.1 in ln im, whose error is far below
        rounding for a beta above 0.05.

        :param probability: function of an array of intensities
        :param lowest: only motions of intensities from here
        :param highest: and up to here
        """
        beyond = lowest <= self.im[-1] < highest
        total = float(probability(self.im[-1])) * self.rate[-1] if beyond else 0.0
        places, weights = numpy.polynomial.legendre.leggauss(8)
        for low, high, above, below in zip(self.im, self.im[1:], self.rate, self.rate[1:]):
            slope = numpy.log(above / below) / numpy.log(high / low)
            start, end = max(low, lowest), min(high, highest)
            if start >= end:
                continue
            above *= (start / low) ** -slope
            low, high = start, end
            panels = int(numpy.ceil(numpy.log(high / low) / 0.1))
            half = numpy.log(high / low) / panels / 2
            x = half * (2 * numpy.arange(panels)[:, None] + 1 + places)  # ln(im / low)
            total += float((probability(low * numpy.exp(x)) * slope * above *
                            numpy.exp(-slope * x) * half * weights).sum())
        return total


def read_hazard(path):
    """A hazard file, schema "gurney-hazard/1", with a table of points."""
    with open(path, "rb") as file:
        given = tomllib.load(file)
    if given.get("schema") != "gurney-hazard/1":
        raise Error(f"{os.fspath(path)}: schema must be \"gurney-hazard/1\"")
    if "im" not in given:
        raise Error(f"{os.fspath(path)}: it has no points (im, rate_per_year)")
    measure = re.sub(r"\(([0-9.eE+-]+)\)", lambda period: f"({float(period[1]):g})",
                     given["measure"])
    to_si = _TO_SI[given["unit"]][1]
    return Hazard([im * to_si for im in given["im"]], given["rate_per_year"],
                  f"{measure} {given.get('component', 'geomean')}")
