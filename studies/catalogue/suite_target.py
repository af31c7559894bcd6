"""Response spectra over PGV that a suite of motions is matched to (docs/catalogue/motions.md).

Given PGV = v, an earthquake s of the grid has the probability p(s | v) ~ p(s) p(v | s), p(s) the same for
all s, p(v | s) lognormal by the ground-motion model. With eps = ln(v / median PGV) / sigma_v,

    E[ln Sa(T) | s, v]          = ln median Sa + rho(T, PGV) sigma(T) eps
    Cov[ln Sa(T), ln Sa(U) | s, v] = sigma(T) sigma(U) (rho(T, U) - rho(T, PGV) rho(U, PGV))

and the mixture over s has mean sum p m_s and covariance sum p (C_s + (m_s - m) (m_s - m)^T).
"""

import itertools
import json
import subprocess

import numpy as np

MAGNITUDES = (6.0, 6.5, 7.0, 7.5)
DISTANCES = (5.0, 10.0, 20.0, 40.0, 60.0)  # [km]
SITES = (760.0, 400.0, 250.0)  # V_S30 [m/s]
PGV = 0.6  # [m/s] RotD50, in the middle of the levels of the catalogue
PERIODS = np.round(np.geomspace(0.05, 5, 24), 4)  # [s]


class Target:
    """Of ln(Sa / PGV) at PERIODS [ln(1/s)]; `scenarios` are (M, R, V_S30) with the probabilities `share`."""

    def __init__(self, scenarios, share, means, covariances):
        self.scenarios, self.share, self.means, self.covariances = scenarios, share, means, covariances
        self.mean = share @ means
        apart = means - self.mean
        self.covariance = np.einsum("s,sij->ij", share, covariances) + (apart.T * share) @ apart
        self.sigma = np.sqrt(np.diag(self.covariance))
        self.correlation = self.covariance / np.outer(self.sigma, self.sigma)


def predicted(gurney, magnitude, distance, vs30):
    periods = [word for period in PERIODS for word in ("--period", str(period))]
    text = subprocess.run([gurney, "records", "model", "--magnitude", str(magnitude), "--distance", str(distance),
                           "--vs30", str(vs30), *periods, "--json"], check=True, capture_output=True, text=True)
    return json.loads(text.stdout)


def conditional(model, pgv):
    """ln p(v | s) but for a constant, and mean and covariance of ln(Sa / v)."""
    velocity = model["pgv_m_per_s"]
    epsilon = np.log(pgv / velocity["median"]) / velocity["sigma"]
    median, sigma, rho = (np.array([row[key] for row in model["sa_m_per_s2"]])
                          for key in ("median", "sigma", "correlation_with_pgv"))
    mean = np.log(median / pgv) + rho * sigma * epsilon
    covariance = np.outer(sigma, sigma) * (np.array(model["correlation"]) - np.outer(rho, rho))
    return -epsilon**2 / 2 - np.log(velocity["sigma"]), mean, covariance


def target(gurney, pgv=PGV):
    scenarios = list(itertools.product(MAGNITUDES, DISTANCES, SITES))
    parts = [conditional(predicted(gurney, *scenario), pgv) for scenario in scenarios]
    likelihood, means, covariances = (np.array(each) for each in zip(*parts))
    share = np.exp(likelihood - likelihood.max())
    return Target(scenarios, share / share.sum(), means, covariances)
