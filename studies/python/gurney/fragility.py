"""Lognormal fragility functions by maximum likelihood, independently of the program's own fit.

P(exceeded | im) = Phi(ln(im / theta) / beta). A run that exceeds at im has a capacity of at most
im, one that does not has a higher one; an incremental dynamic analysis brackets the capacity of
each analysis case. Both are intervals (low, high] of ln capacity, whose likelihood
Phi(a high + b) - Phi(a low + b) is log-concave in a = 1 / beta and b = -ln(theta) / beta, so
that Newton's method finds its only maximum (Baker 2015, Earthquake Spectra 31(1), 579-599).
"""

import math
import warnings
from dataclasses import dataclass, field

import numpy
import pandas

from . import intervals
from .errors import Error, NotInFile, not_in_file
from .limit_states import find, runs_that_exceed
from .units import factor

_erfc = numpy.vectorize(math.erfc, otypes=[float])


@dataclass(frozen=True)
class Fragility:
    """A fragility function. ``theta`` is in ``units``; both are NaN if ``status`` is not "fitted".

    ``method`` is "outcomes", or "capacities" after an IDA that this limit state ended.
    ``covariance`` is that of (ln theta, ln beta), robust to records that runs share, shape (2, 2).
    ``effective_records`` count as one each; with fewer than 8 (4 capacities) no interval is stated.
    The intervals are those of `gurney fragility` but for those of capacities, which the program
    takes from the likelihood.
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
    covariance: numpy.ndarray = field(repr=False)
    runs: int
    exceeded: int
    records: int
    failed: int
    stripes: pandas.DataFrame = field(repr=False)  #: im, runs, exceeded; one row for each im
    effective_records: float = 0.0
    line: tuple = field(default=(math.nan, math.nan), repr=False)  #: slope, intercept of z
    line_covariances: tuple = field(default=(), repr=False)  #: an interval takes the largest variance

    def probability(self, im):
        """P(exceeded | im) for intensities in ``units``; an array has the shape of ``im``."""
        im = numpy.asarray(im, dtype=float)
        with numpy.errstate(divide="ignore"):
            z = numpy.log(im / self.theta) / self.beta
        return 0.5 * _erfc(-z / math.sqrt(2))

    def theta_in(self, unit):
        """The median in another unit, such as ``"g"``."""
        return self.theta / factor(unit, self.units)

    @property
    def has_intervals(self):
        """Whether there are enough effective records for intervals."""
        fewest = (intervals.FEWEST_CAPACITIES if self.method == "capacities"
                  else intervals.FEWEST_RECORDS)
        return self.status == "fitted" and self.effective_records >= fewest * (1 - 1e-9)

    def _lines(self, confidence):
        return intervals.outline(self.line, self.line_covariances, self.effective_records,
                                 confidence)

    def theta_interval(self, confidence=0.95):
        """(low, high) of the median in ``units``; 0 or infinity where the runs do not bound it;
        None with too few records."""
        if not self.has_intervals:
            return None
        return intervals.of_theta(self._lines(confidence), self.stripes["im"].min(),
                                  self.stripes["im"].max())

    def beta_interval(self, confidence=0.95):
        """(low, high) of beta, in the manner of :meth:`theta_interval`."""
        if not self.has_intervals:
            return None
        return intervals.of_beta(self.line, self.line_covariances, self.effective_records,
                                 confidence)

    def annual_rate(self, hazard):
        """Mean annual rate of exceeding the limit state [1/year], over the range of the hazard.
        Warns where more than a tenth of it is from motions that were not analysed.

        :param hazard: :class:`gurney.Hazard` of the same measure
        """
        if hazard.measure not in ("", self.measure):
            raise Error(f"the hazard is of {hazard.measure}, the curve over {self.measure}")
        rate = hazard.rate_of(self.probability)
        lowest, highest = self.stripes["im"].min(), self.stripes["im"].max()
        for where, low, high in (("below the lowest", 0, lowest),
                                 ("above the highest", highest, math.inf)):
            share = hazard.rate_of(self.probability, low, high) / rate if rate > 0 else 0
            if share > 0.1:
                warnings.warn(f"{100 * share:.0f} % of the rate of '{self.limit_state}' is from "
                              f"motions {where} analysed intensity", stacklevel=2)
        return rate

    def annual_rate_interval(self, hazard, confidence=0.95):
        """(low, high) of :meth:`annual_rate`: the rates of the lines that the runs admit. None
        with too few records."""
        if not self.has_intervals:
            return None
        rates = [hazard.rate_of(lambda im: 0.5 * _erfc(-(slope * numpy.log(im) + intercept) /
                                                       math.sqrt(2)))
                 for slope, intercept in self._lines(confidence)]
        return intervals.range_of(numpy.array(rates))


def fit_of_study(results, limit_state, measure=None, configuration=None):
    """See :meth:`gurney.Results.fragility`."""
    runs = results.runs
    if results.kind != "study":
        raise Error(f"{results.path}: a fragility needs the runs of a study; this is a single run")
    name, words, exceeded, ended = _outcomes(results, limit_state)
    configuration = _configuration(results, configuration)
    im, measure, units, own = _measure(results, measure)
    of = runs["configuration"] == configuration
    data = pandas.DataFrame({"im": im, "exceeded": exceeded, "record": runs["record_index"],
                             "case": runs["analysis_case"]})[of]
    data = data[data["exceeded"].notna() & (data["im"] > 0)]
    data["exceeded"] = data["exceeded"].astype(bool)
    capacities = own and ended
    low, high, weight, group = _brackets(data) if capacities else _intervals(data)
    status, theta, beta, covariance, effective, line, of_line = fit(low, high, weight, group)
    stripes = data.groupby("im")["exceeded"].agg(runs="count", exceeded="sum").reset_index()
    return Fragility(name, words, configuration, measure, units,
                     "capacities" if capacities else "outcomes", status, theta, beta, covariance,
                     len(data), int(data["exceeded"].sum()), data["record"].nunique(),
                     int(runs["failed"][of].sum()), stripes, effective, line, of_line)


def _outcomes(results, limit_state):
    """Name, definition, outcome of each run, and whether the state ended the IDA."""
    if isinstance(limit_state, pandas.Series):
        name = str(limit_state.name or "given")
        outcomes = limit_state.reindex(results.runs.index)
        return name, name, outcomes.where(~results.runs["failed"]), False
    state = find(results, limit_state)
    intensity = results.job.get("study", {}).get("intensity", {})
    until = intensity.get("ida", intensity.get("hunt", {})).get("until")
    ended = until is not None and _same(state, results.limit_states[until])
    return state.name, state.words, runs_that_exceed(results, state), ended


def _same(a, b):
    """The same requirement, whatever the names."""
    return ((a.table, a.column, a.above, a.place, a.every, a.at_least, len(a.parts)) ==
            (b.table, b.column, b.above, b.place, b.every, b.at_least, len(b.parts)) and
            math.isclose(a.limit, b.limit, rel_tol=1e-15, abs_tol=0) and
            all(_same(x, y) for x, y in zip(a.parts, b.parts)))


def _configuration(results, name):
    known = list(results.configurations["name"])
    if name is None and len(known) > 1:
        raise Error(f"{results.path}: which configuration? It has: {', '.join(known)}")
    if name is not None and name not in known:
        raise not_in_file(results.path, "configuration", name, known)
    return known[0] if name is None else name


def _measure(results, name):
    """Intensities of the runs, the measure's name and unit, and whether it is the study's own."""
    runs, own = results.runs, results.provenance["intensity_measure"]
    if name is None or name == own:
        if not own:
            raise Error(f"{results.path}: its records are not scaled to a measure; state one")
        return runs["intensity"], own, runs.attrs["units"]["intensity"], True
    known = [own, "pfa", "pfv"] + [each for each in results.motions.columns
                                   if each not in ("record", "scale", "set")]
    if name not in known:
        raise not_in_file(results.path, "intensity measure", name, filter(None, known))
    if runs[name].isna().all():
        raise NotInFile(f"{results.path}: no record has {name}")
    return runs[name], name, runs.attrs["units"][name], False


def _intervals(data):
    """Of outcomes: a capacity at most at im, or above it."""
    x = numpy.log(data["im"].to_numpy())
    exceeded = data["exceeded"].to_numpy()
    return (numpy.where(exceeded, -numpy.inf, x), numpy.where(exceeded, x, numpy.inf),
            numpy.ones(len(x)), data["record"].to_numpy())


def _brackets(data):
    """Of an IDA: the capacity of each case by its first exceedance (Vamvatsikos & Cornell 2002,
    EESD 31(3), 491-514); the cases of a record share its weight of one."""
    rows = []
    for (record, _), case in data.groupby(["record", "case"]):
        high = case["im"][case["exceeded"]].min()
        high = numpy.inf if math.isnan(high) else high
        low = case["im"][~case["exceeded"] & (case["im"] < high)].max()
        rows.append((-numpy.inf if math.isnan(low) else math.log(low), math.log(high), record))
    low, high, record = (numpy.array(column) for column in zip(*rows))
    _, place, count = numpy.unique(record, return_inverse=True, return_counts=True)
    return low, high, 1 / count[place], record


def fit(low, high, weight, group):
    """Maximum likelihood of a normal distribution of ln capacity from intervals (low, high].

    :param low: shape (n,), ln of the intensity that the capacity is above, or -inf
    :param high: shape (n,), ln of the one that it is at most at, or inf
    :param weight: shape (n,)
    :param group: shape (n,), records; observations of one are not independent
    :returns: status, theta, beta, covariance of (ln theta, ln beta), effective records, the line
        (slope, intercept) of z over ln im, and its covariances with records independent, with runs
        independent, and (of outcomes) with as much dependence within all records
    """
    nothing = (math.nan, math.nan, numpy.full((2, 2), math.nan), 0.0, (math.nan, math.nan), ())
    finite = numpy.concatenate([low[numpy.isfinite(low)], high[numpy.isfinite(high)]])
    if not numpy.isfinite(high).any():
        return ("no run exceeds" if len(low) else "no runs"), *nothing
    if not numpy.isfinite(low).any():
        return "all runs exceed", *nothing
    if low.max() <= high.min():
        return ("quasi-complete separation" if low.max() == high.min()
                else "complete separation"), *nothing
    centre, scale = finite.mean(), finite.std()  # so that both unknowns are of order one
    low, high = (low - centre) / scale, (high - centre) / scale
    x = numpy.array([1.0, 0.0])
    value, scores, hessian, each = _likelihood(x, low, high, weight)
    for _ in range(200):
        step = numpy.linalg.solve(hessian, weight @ scores)
        size = 1.0
        while size > 1e-12:
            following = _likelihood(x - size * step, low, high, weight)
            if following[0] >= value - 1e-13 * (1 + abs(value)):  # flat to rounding
                break
            size /= 2
        x, done = x - size * step, abs(size * step).max() <= 1e-12 * abs(x).max()
        value, scores, hessian, each = following
        if done or size <= 1e-12:
            break
    slope, intercept = x
    if slope <= 0:
        return "not increasing", *nothing
    outcomes = (numpy.isfinite(low) != numpy.isfinite(high)).all()
    ln_theta = centre - scale * intercept / slope
    if outcomes and not (finite.min() - math.log(intervals.FARTHEST) <= ln_theta <=
                         finite.max() + math.log(intervals.FARTHEST)):
        return "not increasing", *nothing
    theta, beta = math.exp(ln_theta), scale / slope
    back = numpy.array([[1 / scale, 0], [-centre / scale, 1]])  # of x to slope, intercept of ln im
    line = back @ x
    of_line = [back @ c @ back.T for c in
               (_cluster_covariance(weight, scores, each, group), numpy.linalg.inv(-hessian))]
    slope, intercept = line
    change = numpy.array([[intercept / slope ** 2, -1 / slope], [-1 / slope, 0]])
    covariance = change @ of_line[0] @ change.T
    groups, place = numpy.unique(group, return_inverse=True)
    if not outcomes:
        # As many exact capacities as tell as much of beta
        effective = float(numpy.clip(0.5 / covariance[1, 1], 2, max(2, len(groups))))
    else:
        x = centre + scale * numpy.where(numpy.isfinite(low), low, high)
        risk, safe = _score_factors(line, x)
        effective = _effective(risk, safe, weight, place)
        if len(groups) > 1:
            of_line.append(_shared_covariance(of_line, x, risk, safe, place))
    return "fitted", theta, beta, covariance, effective, tuple(line), tuple(of_line)


def _log_phi(z):
    """ln of the normal distribution function, also far below zero."""
    z = numpy.asarray(z, dtype=float)
    far = numpy.isfinite(z) & (z < -30)
    result = numpy.full(z.shape, -numpy.inf)
    near = ~far & (z > -numpy.inf)
    result[near] = numpy.log(0.5 * _erfc(-z[near] / math.sqrt(2)))
    # Abramowitz & Stegun 1964, 26.2.12; the first term left out is 15 z^-6 < 3e-8
    t = z[far] ** -2
    result[far] = (-z[far] ** 2 / 2 - numpy.log(-z[far]) - math.log(2 * math.pi) / 2 +
                   numpy.log1p(-t + 3 * t ** 2))
    return result


def _likelihood(x, low, high, weight):
    """ln L, the scores (n, 2) of the observations, and the Hessian (2, 2)."""
    z_low, z_high = (x[0] * edge + numpy.where(numpy.isfinite(edge), x[1], 0)
                     for edge in (low, high))
    if x[0] <= 0:  # an infinite edge keeps its side
        z_low = numpy.where(numpy.isfinite(low), z_low, -numpy.inf)
        z_high = numpy.where(numpy.isfinite(high), z_high, numpy.inf)
    upper = z_low > -z_high  # the smaller of the two tails, where the difference is exact
    a, b = numpy.where(upper, -z_high, z_low), numpy.where(upper, -z_low, z_high)
    top, bottom = _log_phi(b), _log_phi(a)
    with numpy.errstate(divide="ignore", invalid="ignore", over="ignore"):
        log_p = top + numpy.log1p(-numpy.exp(bottom - top))
    log_p = numpy.where(numpy.isnan(log_p) | (b <= a), -numpy.inf, log_p)
    scores, hessian = numpy.zeros((len(low), 2)), numpy.zeros((2, 2))
    if not numpy.isfinite(log_p).all():
        return -numpy.inf, scores, hessian, numpy.zeros((len(low), 2, 2))
    second = numpy.zeros((len(low), 2, 2))
    for edge, z, sign in ((high, z_high, 1), (low, z_low, -1)):
        at = numpy.isfinite(edge)
        ratio = numpy.zeros(len(low))
        ratio[at] = sign * numpy.exp(-z[at] ** 2 / 2 - math.log(2 * math.pi) / 2 - log_p[at])
        basis = numpy.stack([numpy.where(at, edge, 0), numpy.ones(len(low))], axis=1)
        scores += ratio[:, None] * basis
        second -= (ratio * numpy.where(at, z, 0))[:, None, None] * (basis[:, :, None] *
                                                                    basis[:, None, :])
    second -= scores[:, :, None] * scores[:, None, :]
    return weight @ log_p, scores, numpy.tensordot(weight, second, 1), second


def _cluster_covariance(weight, scores, second, group):
    """Of x, robust to runs of one record, corrected for the record's own information (Bell &
    McCaffrey 2002, Survey Methodology 28(2), 169-181)."""
    groups, place = numpy.unique(group, return_inverse=True)
    count = len(groups)
    of_group, information = numpy.zeros((count, 2)), numpy.zeros((count, 2, 2))
    numpy.add.at(of_group, place, weight[:, None] * scores)
    numpy.add.at(information, place, -weight[:, None, None] * second)
    others = (1 + 1e-9) * information.sum(axis=0) - information
    influence = numpy.linalg.solve(others, of_group[:, :, None])[:, :, 0]
    return (count - 1) / count * influence.T @ influence if count > 1 else numpy.full((2, 2),
                                                                                      math.nan)


def _score_factors(line, x):
    """The scores of runs at ln im = x that exceed, and of those that do not but for the sign,
    shapes (n, 2)."""
    z = line[0] * x + line[1]
    log_density = -z ** 2 / 2 - math.log(2 * math.pi) / 2
    basis = numpy.stack([x, numpy.ones(len(z))], axis=1)
    return tuple(numpy.exp(log_density - _log_phi(side))[:, None] * basis for side in (z, -z))


def _effective(risk, safe, weight, place):
    """As many records of equal weight as have the same sum of squares of their shares in the
    expected information."""
    information = numpy.zeros((place.max() + 1, 2, 2))
    numpy.add.at(information, place, weight[:, None, None] * risk[:, :, None] * safe[:, None, :])
    inverse = numpy.linalg.inv(information.sum(axis=0))
    shares = numpy.trace(inverse @ information, axis1=1, axis2=2) / 2
    return float(1 / (shares ** 2).sum())


def _shared_covariance(of_line, x, risk, safe, place):
    """Of the line, with as much dependence within all records as of_line[0] shows over all, between
    independent runs, of_line[1], and runs of which one capacity of the record decides."""
    spread = numpy.zeros((2, 2))
    for record in range(place.max() + 1):
        order = numpy.flatnonzero(place == record)
        order = order[numpy.argsort(x[order], kind="stable")]
        below = numpy.cumsum(safe[order], axis=0) - safe[order]
        pairs = below.T @ risk[order]  # P of one (1 - P) of the higher, over the variances
        spread += safe[order].T @ risk[order] + pairs + pairs.T
    groups = place.max() + 1
    decided = groups / (groups - 1) * of_line[1] @ spread @ of_line[1]
    information = numpy.linalg.inv(of_line[1])
    most = (information @ decided).trace() - 2
    share = numpy.clip(((information @ of_line[0]).trace() - 2) / most, 0, 1) if most > 0 else 0
    return share * decided + (1 - share) * of_line[1]
