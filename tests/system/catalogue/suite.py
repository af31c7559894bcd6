"""The motions of the catalogue: their rows are those that suite_candidates.py draws, their spectra have the misfits of
docs/catalogue/motions.md, the choice improves what it is given, and the motions of assumed parameters are not matched.

usage: suite.py GURNEY SOURCE_DIR
"""

import math
import os
import sys
import tempfile

sys.dont_write_bytecode = True
try:
    import numpy as np
except ImportError:
    sys.exit(77)
gurney, source = sys.argv[1:]
scripts = os.path.join(source, "studies", "catalogue")
sys.path.insert(0, scripts)
import suite  # noqa: E402
import suite_candidates  # noqa: E402
import suite_target  # noqa: E402

CORES = os.cpu_count()
target = suite_target.target(gurney)
with open(os.path.join(source, "docs", "catalogue", "motions.md")) as file:
    page = file.read()

# The mixture: shares are probabilities; its variance is that within and between the earthquakes.
assert abs(target.share.sum() - 1) < 1e-12 and len(target.share) == 60
between = target.share @ (target.means - target.mean) ** 2
within = target.share @ np.array([np.diag(each) for each in target.covariances])
assert np.allclose(target.sigma**2, between + within, rtol=1e-12)
# Near its own period the velocity tells most of Sa, so that least scatter is left at 0.5 to 1 s.
assert 0.4 < suite_target.PERIODS[target.sigma.argmin()] < 1, target.sigma

# Marginals of the regression: median by the distribution function of a fine sum.
for marginal, density, low, high in (
        (suite_candidates.MARGINALS[0], lambda x: (x - 5) ** 0.1314 * (45 - x) ** 1.4474, 5, 45),
        (suite_candidates.MARGINALS[3], lambda x: np.where(x < 0, np.exp(6.7729 * x), np.exp(-17.095 * x)), -2, 0.5)):
    x = np.linspace(low, high, 200001)[:-1] + (high - low) / 400000
    y = density(x)
    assert abs(y[x < marginal(0.5)].sum() / y.sum() - 0.5) < 1e-3



def candidates(name, target):
    """The motions of a file, each of which is the candidate of its seed."""
    motions = suite.read_motions(os.path.join(scripts, name))
    for motion in motions:
        number = int(motion["parameters"].split()[0].removeprefix("seed=")) - 1000
        drawn = suite_candidates.candidate(target, number)
        assert all(motion[key] == value for key, value in drawn.items()), f"{motion}\n{drawn}"
    return motions


motions = candidates("motions.csv", target)


def pulses_of(motions):
    return sum(motion["kind"] == "near_fault" for motion in motions)


def row_of(quality):
    return " | ".join(f"{value:.2f}" for value in quality.values())


with tempfile.TemporaryDirectory() as folder:
    matched = suite.spectra(gurney, folder, motions, CORES)
    assumed = suite.spectra(gurney, folder, suite.read_motions(os.path.join(scripts, "motions_unmatched.csv")), CORES)
for name, chosen in (("the suite, 32 motions", matched), ("`motions_unmatched.csv`, 16 motions", assumed)):
    line = f"| {name} | {row_of(suite.quality(chosen, target))} |"
    assert line in page, f"not on the page: {line}"
assert list(suite.slowest_first(matched)) == list(range(len(motions)))
pulses = pulses_of(motions)
assert f"{pulses} of the {len(motions)} have a pulse" in page, pulses

# The suites of single levels have the targets of their PGV.
for level in ("0.15", "0.4", "0.8", "1.5"):
    of_level = suite_target.target(gurney, float(level))
    chosen = candidates(f"motions_by_level/{level}.csv", of_level)
    with tempfile.TemporaryDirectory() as folder:
        quality = suite.quality(suite.spectra(gurney, folder, chosen, CORES), of_level)
    magnitude = sum(float(motion["magnitude"]) for motion in chosen) / len(chosen)
    distance = math.exp(sum(math.log(float(motion["distance_km"])) for motion in chosen) / len(chosen))
    line = f"| {level} | {magnitude:.1f} | {distance:.0f} | {pulses_of(chosen)} | {row_of(quality)} |"
    assert line in page, f"not on the page: {line}"

# Among spectra of the target itself the choice finds a set that is better than its start, without repeats.
fresh = suite.simulated(target, 60, trials=1)
start = list(range(8))
better = suite.improved(list(start), fresh, target)
assert len(set(better)) == 8
assert suite.misfit(fresh[better], target) < 0.5 * suite.misfit(fresh[start], target)
