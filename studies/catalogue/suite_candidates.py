"""Draws motions for the earthquakes of a target (docs/catalogue/motions.md): parameters of
`gurney records make`, as in motions.csv.

The stochastic parameters are those of Rezaeian & Der Kiureghian (2010), Earthquake Engineering and
Structural Dynamics 39(10), 1155-1180: each is a normal variable nu with

    E[nu] = b0 + b1 F + b2 M / 7 + b3 R / 25 km + b4 V / 750 m/s,   F = 1 for reverse faulting,

and the distribution function of nu's standard form gives the parameter by its marginal distribution. The
numbers are those of a public program of a later paper of one of the authors (Rezaeian, Zhong, Hartzell &
Zareian 2015, Bulletin of the Seismological Society of America 105(6), 3036-3049), not compared with the
paper of 2010. What they predict decides nothing by itself: suite.py chooses by the spectra.
"""

import math
import random
from statistics import NormalDist

import numpy as np

NAMES = ("significant_duration_s", "middle_s", "frequency_hz", "frequency_slope_hz_per_s", "filter_damping")
BETA = np.array([[-6.195, -0.703, 6.792, 0.219, -0.523],
                 [-5.011, -0.345, 4.638, 0.348, -0.185],
                 [2.253, -0.081, -1.810, -0.211, 0.012],
                 [-2.489, 0.044, 2.408, 0.065, -0.081],
                 [-0.258, -0.477, 0.905, -0.289, 0.316]])
SIGMA = np.hypot([0.457, 0.511, 0.692, 0.129, 0.682], [0.569, 0.414, 0.723, 0.953, 0.760])
RHO = np.array([[1, 0.67, -0.13, -0.16, -0.20],
                [0.67, 1, -0.28, -0.20, -0.22],
                [-0.13, -0.28, 1, -0.20, 0.28],
                [-0.16, -0.20, -0.20, 1, -0.01],
                [-0.20, -0.22, 0.28, -0.01, 1]])
ROCK = 620  # [m/s] lowest V_S30 of the regression, assumption: the paper has sites above 600 m/s

# Assumptions, as is that of each range below.
PULSE_SHARE = {5.0: 0.4, 10.0: 0.25, 20.0: 0.1}  # of the motions at this distance [km]
NORMAL = NormalDist()


def quantile_of(density, low, high):
    """The quantile function of a density between two ends, by trapezoids."""
    x = np.linspace(low, high, 20001)
    y = density(x)
    share = np.concatenate([[0], np.cumsum((y[1:] + y[:-1]) / 2)])
    return lambda p: float(np.interp(p * share[-1], share, x))


def beta_quantile(a, b, low, high):
    return quantile_of(lambda x: ((x - low) ** (a - 1)) * ((high - x) ** (b - 1)), low, high)


MARGINALS = (
    beta_quantile(1.1314, 2.4474, 5, 45),
    beta_quantile(1.5792, 3.6405, 0.5, 40),
    quantile_of(lambda x: x ** 3.0982 * np.exp(-x / 1.4330), 0, 40),
    quantile_of(lambda x: np.where(x < 0, np.exp(6.7729 * x), np.exp(-17.095 * x)), -2, 0.5),
    beta_quantile(1.4250, 5.7208, 0.02, 1),
)


class Draws:
    """Random numbers that are the same on every machine and in every version of Python and numpy."""

    def __init__(self, seed):
        self._random = random.Random(seed).random

    def uniform(self, low, high):
        return low + (high - low) * self._random()

    def log_uniform(self, low, high):
        return math.exp(self.uniform(math.log(low), math.log(high)))

    def normal(self):
        return NORMAL.inv_cdf(self._random())

    def index(self, shares):
        """An index with these probabilities."""
        return min(int(np.searchsorted(np.cumsum(shares), self._random())), len(shares) - 1)


def regressed(draws, magnitude, distance, vs30, reverse):
    """Parameters of the noise. Sites below those of the regression have the frequency lowered by a power of
    V_S30 (assumption)."""
    factors = np.array([1, reverse, magnitude / 7, distance / 25, max(vs30, ROCK) / 750])
    error = np.linalg.cholesky(RHO) @ [draws.normal() for _ in NAMES]
    values = {name: marginal(NORMAL.cdf(nu))
              for name, marginal, nu in zip(NAMES, MARGINALS, BETA @ factors + SIGMA * error)}
    slower = (min(vs30, ROCK) / ROCK) ** draws.uniform(0.3, 1.2)
    values["frequency_hz"] *= slower
    values["frequency_slope_hz_per_s"] *= slower
    return values


def possible(values):
    """A gamma envelope, a frequency that stays above 0.3 Hz while it shakes most, and that of the vertical below
    half the Nyquist frequency (rezaeian.h)."""
    last = values["frequency_hz"] + values["frequency_slope_hz_per_s"] * values["significant_duration_s"] / 2
    return (values["significant_duration_s"] < 4 * values["middle_s"] and last > 0.3 and
            0.3 < values["frequency_hz"] < 12)


def noise(draws, scenario):
    while True:
        values = regressed(draws, *scenario, reverse=draws.uniform(0, 1) < 0.5)
        if possible(values):
            break
    return values | {"arias_ratio_h2": draws.uniform(0.5, 1), "arias_ratio_vertical": draws.uniform(0.1, 0.4),
                     "corner_frequency_hz": draws.log_uniform(0.06, 0.25)}


def pulse(draws, magnitude):
    """Period: Shahi & Baker (2011), Bulletin of the Seismological Society of America 101(2), 742-755,
    ln T_p = -5.73 + 0.99 M, sigma 0.56. Both shapes end where they began."""
    period = math.exp(-5.73 + 0.99 * magnitude + 0.56 * draws.normal())
    shape = {"gamma": draws.uniform(1.2, 2.5), "phase_deg": 90} if draws.uniform(0, 1) < 0.7 else {
        "gamma": 2, "phase_deg": 0}
    return {"period_s": min(max(period, 0.5), 10), "amplitude_m_per_s": 1,
            "arias_m_per_s": draws.log_uniform(0.5, 8)} | shape


def candidate(target, number):
    """A row of motions.csv and its scenario."""
    draws = Draws(f"gurney suite {number}")
    magnitude, distance, vs30 = scenario = target.scenarios[draws.index(target.share)]
    values = noise(draws, scenario)
    near = draws.uniform(0, 1) < PULSE_SHARE.get(distance, 0)
    if near:
        values |= pulse(draws, magnitude)
    words = [f"seed={1000 + number}"] + [f"{key}={value:.3g}" for key, value in values.items()]
    return {"kind": "near_fault" if near else "stochastic", "parameters": " ".join(words),
            "magnitude": f"{magnitude:g}", "distance_km": f"{distance:g}", "vs30_m_per_s": f"{vs30:g}"}
