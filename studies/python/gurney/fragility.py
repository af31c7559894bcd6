"""Fragility functions: those of the program, fitted by its own code."""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import lru_cache
from html import escape
from typing import TYPE_CHECKING, Any

import numpy
import numpy.typing
import pandas

from . import engine
from .errors import Error, InputError, not_in_file
from .hazard import Hazard
from .units import factor

if TYPE_CHECKING:
    from .results import Results


@dataclass(frozen=True)
class Fragility:
    """A fragility function, P(exceeded | im) = Phi(ln(im / theta) / beta), as `gurney fragility` fits
    and judges it. ``theta``, the intervals and all intensities are in ``units``.

    ``status`` is "fitted", or says why there is no curve and what is known of its median; ``theta`` and
    ``beta`` are NaN then. ``method`` is "outcomes", "capacities" after an IDA, or "cloud".
    Intervals are None with fewer than 8 effective records (4 of capacities); an end that the runs do
    not bound is 0 or infinity. ``cautions`` says what to know before use.
    """

    limit_state: str
    words: str
    configuration: str
    measure: str
    units: str
    method: str
    status: str
    theta: float
    beta: float
    runs: int
    exceeded: int
    records: int
    failed: int
    effective_records: float
    confidence: float
    theta_interval: tuple[float, float] | None
    beta_interval: tuple[float, float] | None
    cautions: tuple[str, ...]
    covariance: numpy.typing.NDArray[numpy.float64] = field(repr=False)  #: of (ln theta, ln beta)
    stripes: pandas.DataFrame = field(repr=False)  #: im, runs, exceeded, isotonic
    band: pandas.DataFrame = field(repr=False)  #: im, low, high; pointwise, empty: no band
    range: tuple[float, float] = field(repr=False)  #: lowest and highest intensity of the runs
    _curve: Any = field(repr=False, compare=False)

    def probability(self, im: numpy.typing.ArrayLike) -> numpy.typing.NDArray[numpy.float64]:
        """P(exceeded | im) for intensities >= 0 in ``units``, in the shape of ``im``; NaN: no curve, or
        an intensity that is NaN.

        :raises InputError: an intensity is below 0
        """
        given = numpy.asarray(im, dtype=float)
        if (given < 0).any():
            raise InputError(f"im = {given[given < 0].ravel()[0]:g}: an intensity is 0 or more")
        flat = [math.nan if math.isnan(each) else self._curve.probability(each)
                for each in given.ravel()]
        return numpy.array(flat).reshape(given.shape)

    def theta_in(self, unit: str) -> float:
        """The median in another unit, such as ``"g"``.

        :raises Error: the unit is of another quantity
        """
        return self.theta / factor(unit, self.units)

    def rate(self, hazard: Hazard) -> dict[str, Any] | None:
        """Mean annual rate of exceeding the limit state at a site; None without a curve.

        :param hazard: of the same measure and component
        :returns: ``per_year`` [1/year], NaN where the runs support none; ``interval`` or None;
            ``supported``: the analysed intensities and the hazard curve reach far enough; ``cautions``
        :raises Error: the hazard is of another measure
        """
        if hazard.measure != self.measure:
            raise Error(f"the hazard is of {hazard.measure}, the curve over {self.measure}")
        found: dict[str, Any] | None = self._curve.rate(hazard._curve)
        return found

    def annual_rate(self, hazard: Hazard) -> float:
        """``per_year`` of :meth:`rate` [1/year], with its cautions as warnings; NaN without a curve."""
        found = self.rate(hazard)
        for caution in found["cautions"] if found else ():
            warnings.warn(f"{self.limit_state}: {caution}", stacklevel=2)
        return float(found["per_year"]) if found else math.nan

    def to_frame(self) -> pandas.DataFrame:
        """One row with the numbers of the curve."""
        low, high = self.theta_interval or (math.nan, math.nan)
        return pandas.DataFrame([{
            "limit_state": self.limit_state, "configuration": self.configuration,
            "measure": self.measure, "units": self.units, "method": self.method, "status": self.status,
            "theta": self.theta, "theta_low": low, "theta_high": high, "beta": self.beta,
            "runs": self.runs, "exceeded": self.exceeded, "records": self.records}])

    def _repr_html_(self) -> str:
        notes = "".join(f"<li>{escape(each)}</li>" for each in self.cautions)
        html: str = self.to_frame().to_html(index=False, float_format="{:.4g}".format)
        return html + (f"<ul>{notes}</ul>" if notes else "")


class Statistics:
    """The limit states, outcomes and curves of a study's file."""

    def __init__(self, results: Results) -> None:
        if results.kind != "study":
            raise Error(f"{results.path}: a fragility needs the runs of a study; this is a single run")
        self._results = results
        self._of = lru_cache(8)(lambda *lines: engine.module().Study(results.path, list(lines)))

    def limit_states(self) -> dict[str, str]:
        """Those of the job, or the usual four: their definitions by name."""
        return dict(self._of().limit_states())

    def _study(self, limit_state: str) -> tuple[Any, str]:
        """The study that knows a limit state, and the name it has there."""
        known = self.limit_states()
        if limit_state in known:
            return self._of(), limit_state
        try:
            study = self._of(limit_state)
        except InputError:
            if not re.search("[<>]", limit_state):
                raise not_in_file(self._results.path, "limit state", limit_state, known) from None
            raise
        return study, study.limit_states()[0][0]

    def exceeded(self, limit_state: str) -> pandas.Series:
        """Whether each run that did not fail exceeds: a Series of bool, index ``run``."""
        study, name = self._study(limit_state)
        runs, exceeded = study.outcomes(name)
        return pandas.Series(exceeded, index=pandas.Index(runs, name="run"), name=name, dtype=bool)

    def fit(self, limit_state: str | pandas.Series, measure: str | None, configuration: str | None,
            method: str | None, confidence: float) -> Fragility:
        """See :meth:`gurney.Results.fragility`."""
        if not 0 < confidence < 1:
            raise InputError(f"confidence = {confidence}: must be between 0 and 1")
        if method not in (None, "cloud"):
            raise InputError(f"method = {method!r}: must be None or 'cloud'")
        index = self._configuration(configuration)
        if isinstance(limit_state, pandas.Series):
            name = str(limit_state.name or "given")
            if method:
                raise InputError("method = 'cloud': needs a demand above a limit, not outcomes")
            curve = self._of().curve_of_outcomes(_outcomes(limit_state), index, measure or "",
                                                 confidence)
        else:
            study, name = self._study(limit_state)
            curve = study.curve(name, index, measure or "", method == "cloud", confidence)
        return _fragility(curve, name, confidence)

    def _configuration(self, name: str | None) -> int:
        known = list(self._results.configurations["name"])
        if name is None and len(known) > 1:
            raise Error(f"{self._results.path}: which configuration? It has: {', '.join(known)}")
        if name is not None and name not in known:
            raise not_in_file(self._results.path, "configuration", name, known)
        return 0 if name is None else known.index(name)


def _outcomes(given: pandas.Series) -> dict[int, bool]:
    """By run; NaN: no outcome."""
    kept = given.dropna()
    wrong = [each for each in kept if each not in (True, False)]
    if wrong:
        raise InputError(f"an outcome is {wrong[0]!r}: must be True, False or NaN")
    index = given.index
    if not pandas.api.types.is_integer_dtype(index) or len(index) and index.min() < 0:
        raise InputError("an outcome's index is not the number of a run: must be 0, 1, 2 ...")
    if not index.is_unique:
        raise InputError(f"run {index[index.duplicated()][0]} has several outcomes")
    return {int(run): bool(each) for run, each in kept.items()}


def _fragility(curve: Any, name: str, confidence: float) -> Fragility:
    given = curve.numbers()
    reason = given.pop("reason")
    given["words"] = given["words"] or name
    given["stripes"] = _frame(given["stripes"], ("im", "runs", "exceeded", "isotonic"))
    given["band"] = _frame(given["band"], ("im", "low", "high"))
    given["cautions"] = tuple(given["cautions"])
    return Fragility(limit_state=name, status=reason or "fitted", confidence=confidence,
                     _curve=curve, **given)


def _frame(rows: Iterable[Any], columns: tuple[str, ...]) -> pandas.DataFrame:
    return pandas.DataFrame(rows, columns=list(columns), dtype=float)
