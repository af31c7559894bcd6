"""Intervals of a fragility function from the covariance of its line z = slope ln im + intercept.

An interval of any number that follows from the curve is its range over the lines of an ellipse
around the fitted one, whose size is Student's quantile: docs/theory/statistics.md of the program.
"""

import math

import numpy

FEWEST_RECORDS = 8  #: effective records below which no interval is stated
FEWEST_CAPACITIES = 4  #: the same of an incremental dynamic analysis
FARTHEST = 10  #: an end beyond this factor of the intensities of the runs is unbounded, and no curve
#: has its median there
_POINTS = 128


def student_quantile(probability, degrees):
    """Quantile of Student's distribution, from its density (degrees + t^2)^-((degrees + 1) / 2)
    with t = sqrt(degrees) tan(angle)."""
    places, weights = numpy.polynomial.legendre.leggauss(64)

    def area(angle):
        return angle / 2 * (weights * numpy.cos(angle / 2 * (places + 1)) ** (degrees - 1)).sum()

    low, high, whole = 0.0, math.pi / 2, area(math.pi / 2)
    for _ in range(60):
        middle = (low + high) / 2
        if 0.5 + area(middle) / whole / 2 < probability:
            low = middle
        else:
            high = middle
    return math.sqrt(degrees) * math.tan(low)


def outline(line, covariances, effective, confidence):
    """Lines (slope, intercept) around what the runs admit, shape (n, 2)."""
    quantile = student_quantile((1 + confidence) / 2, effective - 1)
    angle = 2 * math.pi * numpy.arange(_POINTS) / _POINTS
    circle = quantile * numpy.stack([numpy.cos(angle), numpy.sin(angle)])
    return numpy.concatenate([(numpy.asarray(line)[:, None] + numpy.linalg.cholesky(c) @ circle).T
                              for c in covariances])


def range_of(values):
    """Least and largest; NaN is what a line does not bound."""
    if numpy.isnan(values).any():
        return 0.0, math.inf
    return float(values.min()), float(values.max())


def of_theta(lines, lowest, highest):
    """Interval of the median; an end that the runs do not bound is 0 or infinity."""
    slope, intercept = lines.T
    if (slope <= 0).any():
        return 0.0, math.inf
    low, high = range_of(numpy.exp(-intercept / slope))
    return (low if low >= lowest / FARTHEST else 0.0,
            high if high <= highest * FARTHEST else math.inf)


def of_beta(line, covariances, effective, confidence):
    """Interval of beta, of its logarithm."""
    slope = line[0]
    error = max(math.sqrt(c[0, 0]) for c in covariances) / slope
    half = student_quantile((1 + confidence) / 2, effective - 1) * error
    if half > math.log(FARTHEST):
        return 0.0, math.inf
    return math.exp(-half) / slope, math.exp(half) / slope
