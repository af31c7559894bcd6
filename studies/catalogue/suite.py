"""Chooses a suite of synthetic motions whose spectra have the median and the scatter of a ground-motion model
(docs/catalogue/motions.md).

usage: suite.py GURNEY OUTPUT [--pgv 0.6] [--motions 32] [--candidates 600] [--threads N]
       suite.py GURNEY OUTPUT [--pgv 0.6] --compare MOTIONS.csv

OUTPUT gets the candidates, their spectra and motions.csv, the suite. --compare prints how well another file
of motions has the target. Needs numpy.
"""

import argparse
import csv
import hashlib
import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import suite_candidates
import suite_target

KIND_NAMES = {"near_fault": "pulse", "stochastic": "noise"}
SIGMA_WEIGHT = 2  # of the scatter's misfit to that of the median: Jayaram, Lin & Baker (2011)
CORRELATION_WEIGHT = 3  # of that of the correlations between periods; assumption, theirs is 0
COLUMNS = ("name", "kind", "parameters", "magnitude", "distance_km", "vs30_m_per_s")


def spectrum(gurney, folder, motion):
    """ln(Sa / PGV) of a motion at PERIODS, both RotD50; kept in a file beside the motion."""
    key = hashlib.sha256(f"{motion['kind']} {motion['parameters']}".encode()).hexdigest()[:16]
    path = os.path.join(folder, key)
    if not os.path.exists(path + ".json"):
        subprocess.run([gurney, "records", "make", motion["kind"], *motion["parameters"].split(), "-o", path + ".csv",
                        "--overwrite"], check=True, capture_output=True)
        names = ["PGV"] + [f"Sa({period})" for period in suite_target.PERIODS]
        words = [word for name in names for word in ("--measure", name)]
        text = subprocess.run([gurney, "records", "info", path + ".csv", *words, "--json"], check=True,
                              capture_output=True, text=True).stdout
        measures = json.loads(text)["records"][0]["measures"]
        os.remove(path + ".csv")
        with open(path + ".json", "w") as file:
            json.dump([each["values"]["RotD50"] for each in measures.values()], file)
    with open(path + ".json") as file:
        velocity, *accelerations = json.load(file)
    return np.log(np.array(accelerations) / velocity)


def spectra(gurney, folder, motions, threads):
    os.makedirs(folder, exist_ok=True)
    with ThreadPoolExecutor(threads) as pool:
        return np.array(list(pool.map(lambda motion: spectrum(gurney, folder, motion), motions)))


def correlation(chosen):
    """Of the last axis, over the one before it."""
    apart = (chosen - chosen.mean(axis=-2, keepdims=True)) / chosen.std(axis=-2, keepdims=True)
    return np.matmul(np.swapaxes(apart, -1, -2), apart) / chosen.shape[-2]


def misfit(chosen, target):
    """Over the periods; `chosen` may have axes before the last two, of motions and periods."""
    mean, sigma = chosen.mean(axis=-2) - target.mean, chosen.std(axis=-2, ddof=1) - target.sigma
    rho = correlation(chosen) - target.correlation
    return ((mean**2).sum(axis=-1) + SIGMA_WEIGHT * (sigma**2).sum(axis=-1) +
            CORRELATION_WEIGHT * (rho**2).mean(axis=(-1, -2)))


def simulated(target, count, trials=200):
    """Spectra drawn from the target: the set of `trials` with the least misfit (Jayaram, Lin & Baker 2011)."""
    draws = suite_candidates.Draws("gurney suite, simulated spectra")
    factors = {}

    def one():
        s = draws.index(target.share)
        if s not in factors:
            values, vectors = np.linalg.eigh(target.covariances[s])
            factors[s] = vectors * np.sqrt(np.maximum(values, 0))
        return target.means[s] + factors[s] @ [draws.normal() for _ in suite_target.PERIODS]

    return min((np.array([one() for _ in range(count)]) for _ in range(trials)), key=lambda x: misfit(x, target))


def nearest(wanted, available):
    """Of each simulated spectrum the nearest candidate that is not taken."""
    taken = []
    for row in wanted:
        apart = ((available - row) ** 2).sum(axis=1)
        apart[taken] = np.inf
        taken.append(int(apart.argmin()))
    return taken


def improved(taken, available, target):
    """Swaps single motions while that lowers the misfit (Jayaram, Lin & Baker 2011; Baker & Lee 2018)."""
    best = misfit(available[taken], target)
    while True:
        before = best
        for place in range(len(taken)):
            others = available[taken[:place] + taken[place + 1:]]
            trial = np.concatenate([np.broadcast_to(others, (len(available), *others.shape)), available[:, None]], axis=1)
            value = misfit(trial, target)
            value[taken[:place] + taken[place + 1:]] = np.inf
            if value.min() < best:
                taken[place], best = int(value.argmin()), value.min()
        if best > 0.999 * before:
            return taken


def quality(chosen, target):
    """Largest and root mean square misfit of median and scatter over the periods, in natural logarithms."""
    mean = chosen.mean(axis=0) - target.mean
    sigma = chosen.std(axis=0, ddof=1) - target.sigma
    rho = correlation(chosen) - target.correlation
    return {"median_largest": np.abs(mean).max(), "median_rms": np.sqrt((mean**2).mean()),
            "sigma_largest": np.abs(sigma).max(), "sigma_rms": np.sqrt((sigma**2).mean()),
            "correlation_rms": np.sqrt((rho**2).mean())}


def read_motions(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write_motions(path, motions):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(motions)


def slowest_first(chosen):
    """The order of the motions by Sa(2 s) / Sa(0.3 s): the first half of the suite has what is slow."""
    slow, fast = (np.abs(suite_target.PERIODS - period).argmin() for period in (2, 0.3))
    return np.argsort(chosen[:, fast] - chosen[:, slow], kind="stable")


def named(motions):
    """Each with its kind and a number as its name."""
    count = {}
    for motion in motions:
        count[motion["kind"]] = count.get(motion["kind"], 0) + 1
        yield {"name": f"{KIND_NAMES[motion['kind']]} {count[motion['kind']]}"} | motion


def write_spectra(path, target, chosen):
    """What a figure needs: the target, and a column for each motion."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["period_s", "target_mean", "target_sigma", *range(1, len(chosen) + 1)])
        for i, period in enumerate(suite_target.PERIODS):
            numbers = [target.mean[i], target.sigma[i], *chosen[:, i]]
            writer.writerow([period, *(f"{number:.4f}" for number in numbers)])


def tell(name, chosen, target):
    print(f"{name}: {len(chosen)} motions; " + ", ".join(f"{key} {value:.3f}" for key, value in
                                                      quality(chosen, target).items()))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gurney")
    parser.add_argument("output")
    parser.add_argument("--pgv", type=float, default=suite_target.PGV, help="given peak ground velocity [m/s]")
    parser.add_argument("--motions", type=int, default=32)
    parser.add_argument("--candidates", type=int, default=600)
    parser.add_argument("--compare", help="a file of motions whose spectra are compared with the target")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_args()
    target = suite_target.target(options.gurney, options.pgv)
    if options.compare:
        motions = read_motions(options.compare)
        chosen = spectra(options.gurney, os.path.join(options.output, "compared"), motions, options.threads)
        os.makedirs(options.output, exist_ok=True)
        write_spectra(os.path.join(options.output, "compared.csv"), target, chosen)
        tell(options.compare, chosen, target)
        return
    if options.motions < 3 or options.candidates < options.motions:
        sys.exit("suite.py: at least 3 motions, and as many candidates")
    motions = [suite_candidates.candidate(target, number) for number in range(1, options.candidates + 1)]
    available = spectra(options.gurney, os.path.join(options.output, "candidates"), motions, options.threads)
    taken = improved(nearest(simulated(target, options.motions), available), available, target)
    taken = [taken[i] for i in slowest_first(available[taken])]
    write_motions(os.path.join(options.output, "motions.csv"), named(motions[i] for i in taken))
    write_spectra(os.path.join(options.output, "spectra.csv"), target, available[taken])
    tell("candidates", available, target)
    tell("suite", available[taken], target)


if __name__ == "__main__":
    main()
