"""Lognormal fragility functions by maximum likelihood, independently of the program's own fit.

P(exceeded | im) = Phi(ln(im / theta) / beta). A run that exceeds at im has a capacity of at most
im, one that does not has a higher one; an incremental dynamic analysis brackets the capacity of
each analysis case. Both are intervals (low, high] of ln capacity, whose likelihood
Phi(a high + b) - Phi(a low + b) is log-concave in a = 1 / beta and b = -ln(theta) / beta, so
that Newton's method finds its only maximum (Baker 2015, Earthquake Spectra 31(1), 579-599).
"""

import math
from dataclasses import dataclass, field

import numpy
import pandas

from .errors import Error, NotInFile, not_in_file
from .limit_states import find, runs_that_exceed
from .units import factor

_erfc = numpy.vectorize(math.erfc, otypes=[float])


@dataclass(frozen=True)
class Fragility:
    """A fragility function. ``theta`` is in ``units``; both are NaN if ``status`` is not "fitted".

    ``method`` is "outcomes", or "capacities" after an IDA that this limit state ended.
    ``covariance`` is that of (ln theta, ln beta), robust to records that runs share, shape (2, 2).
    Its intervals are symmetric; `gurney fragility` has intervals that are right for few records.
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

    def probability(self, im):
        """P(exceeded | im) for intensities in ``units``; an array has the shape of ``im``."""
        im = numpy.asarray(im, dtype=float)
        with numpy.errstate(divide="ignore"):
            z = numpy.log(im / self.theta) / self.beta
        return 0.5 * _erfc(-z / math.sqrt(2))

    def theta_in(self, unit):
        """The median in another unit, such as ``"g"``."""
        return self.theta / factor(unit, self.units)

    def annual_rate(self, hazard):
        """Mean annual rate of exceeding the limit state [1/year], over the range of the hazard.

        :param hazard: :class:`gurney.Hazard` of the same measure
        """
        if hazard.measure not in ("", self.measure):
            raise Error(f"the hazard is of {hazard.measure}, the curve over {self.measure}")
        return hazard.rate_of(self.probability)


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
    status, theta, beta, covariance = fit(low, high, weight, group)
    stripes = data.groupby("im")["exceeded"].agg(runs="count", exceeded="sum").reset_index()
    return Fragility(name, words, configuration, measure, units,
                     "capacities" if capacities else "outcomes", status, theta, beta, covariance,
                     len(data), int(data["exceeded"].sum()), data["record"].nunique(),
                     int(runs["failed"][of].sum()), stripes)


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
    :returns: status, theta, beta, covariance of (ln theta, ln beta)
    """
    nothing = (math.nan, math.nan, numpy.full((2, 2), math.nan))
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
    value, scores, hessian = _likelihood(x, low, high, weight)
    for _ in range(200):
        step = numpy.linalg.solve(hessian, weight @ scores)
        size = 1.0
        while size > 1e-12:
            following = _likelihood(x - size * step, low, high, weight)
            if following[0] >= value:
                break
            size /= 2
        x, done = x - size * step, abs(size * step).max() <= 1e-12 * abs(x).max()
        value, scores, hessian = following
        if done or size <= 1e-12:
            break
    slope, intercept = x
    if slope <= 0:
        return "not increasing", *nothing
    theta, beta = math.exp(centre - scale * intercept / slope), scale / slope
    return "fitted", theta, beta, _covariance(x, scale, weight, scores, hessian, group)


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
        return -numpy.inf, scores, hessian
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
    return weight @ log_p, scores, numpy.tensordot(weight, second, 1)


def _covariance(x, scale, weight, scores, hessian, group):
    """Of (ln theta, ln beta), robust to runs of one record (Liang & Zeger 1986, Biometrika
    73(1), 13-22)."""
    groups, place = numpy.unique(group, return_inverse=True)
    of_group = numpy.zeros((len(groups), 2))
    numpy.add.at(of_group, place, weight[:, None] * scores)
    inverse = numpy.linalg.inv(-hessian)
    count = len(groups)
    robust = inverse @ of_group.T @ of_group @ inverse * (count / (count - 1) if count > 1 else
                                                          math.nan)
    slope, intercept = x
    change = numpy.array([[scale * intercept / slope ** 2, -scale / slope], [-1 / slope, 0]])
    return change @ robust @ change.T
