"""Writes losses.csv: what each setting of the brakes is expected to cost, by item, floor, place and velocity.

usage: losses.py TABLES [CONSEQUENCES]

TABLES has fragility.csv and above.csv, and gets losses.csv; CONSEQUENCES (default: equipment/consequences.toml) says what follows
from each limit state. Docs: docs/catalogue/methods.md, What to do.
"""

import csv
import functools
import math
import os
import random
import statistics
import sys
import tomllib
from concurrent.futures import ProcessPoolExecutor

from catalogue import BRAKES

HERE = os.path.dirname(os.path.abspath(__file__))
CONSEQUENCES = os.path.join(HERE, "..", "..", "equipment", "consequences.toml")
SETTINGS = tuple(BRAKES)
SPEEDS = (0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2, 1.5)  # [m/s] peak floor velocity
SAMPLES = 400
SUPPORTED = 10  # runs that exceed; the curve of fewer is bounded by what happens just above a velocity
SETTLED = 0.9  # share of the samples in which an action has the least loss
QUANTITIES = ("days", "cost_ratio")
INJURIES = ("none", "minor", "serious")
COLUMNS = ["item", "floor", "place", "pfv", *(f"{q}_{s}{end}" for q in (*QUANTITIES, "lost") for s in SETTINGS
           for end in ("", "_low", "_high")),
           "best", *(f"share_{s}" for s in SETTINGS), "best_by_cost", "share_by_cost", "depends_on"]
NORMAL = statistics.NormalDist()
Z95 = NORMAL.inv_cdf(0.975)


def consequences(path=CONSEQUENCES):
    """For each quantity and item (None: any) the states with (low, value, high); the last that fits counts."""
    with open(path, "rb") as file:
        rows = tomllib.load(file)["consequence"]

    def bounds(value):
        return (value["range"][0], value["value"], value["range"][1]) if isinstance(value, dict) else (value,) * 3

    def of(item, quantity):
        return {row["limit_state"]: bounds(row[quantity]) for row in rows
                if "items" not in row or item in row["items"]}

    return of


def losing(of_item):
    """States after which the item serves no longer where it stands."""
    return {state for state, service in of_item("service").items() if service[1] == "lost"}


def injuring(of_item, least):
    """States in which somebody beside the item may be hurt, so badly at least."""
    return {state for state, injury in of_item("injury").items() if INJURIES.index(injury[1]) >= INJURIES.index(least)}


def within(bounds, u):
    """Quantile of a value whose median is its stated one, linear on either side up to the ends of its range."""
    low, value, high = bounds
    return low + 2 * u * (value - low) if u < 0.5 else value + (2 * u - 1) * (high - value)


@functools.lru_cache(maxsize=None)
def scatter(middle, low, high):
    """A parameter of a curve and the logarithmic widths of its interval below and above; the other side's width where
    the interval has no end."""
    value = float(middle)
    widths = [abs(math.log(float(end) / value)) if end not in ("", "inf", "0") else None for end in (low, high)]
    return value, [own if own is not None else other or 0 for own, other in zip(widths, widths[::-1])]


def spread(curve, name, z):
    """Parameter of a curve at a normal score."""
    value, widths = scatter(curve[name], curve[name + "_low"], curve[name + "_high"])
    return value * math.exp(z * widths[z > 0] / Z95)


def probability(curve, speed, z, z_beta=0):
    """Chance to exceed at a peak floor velocity.

    @param z       score of the uncertainty of its median, larger is likelier
    @param z_beta  and of its dispersion

    A curve of few outcomes, or none that could be fitted to them, is bounded by monotony: of each motion the run just
    above the velocity. Where none of the runs exceeds, Jeffreys' prior gives Beta(1/2, runs + 1/2): near 0 the chance is
    x^2 / (2 runs) with x standard normal, whose |x| has the quantile of z at (1 + Phi(z)) / 2.
    """
    above = curve.get("above", {}).get(speed)
    bounded = above and not above.endswith("/0")
    if not curve["theta"] and int(curve["exceed"]):
        if not bounded:
            raise ValueError(f"{curve['exceed']} runs exceed without a curve, and above.csv has no motion above {speed} m/s")
        return at_most(*map(int, above.split("/")), z)
    if not curve["theta"]:
        half = NORMAL.cdf(z) / 2 + 0.5
        return min(1, NORMAL.inv_cdf(min(half, 1 - 1e-12)) ** 2 / (2 * float(curve["runs"])))
    theta, beta = spread(curve, "theta", -z), spread(curve, "beta", z_beta)
    by_curve = 0.5 * math.erfc(-math.log(speed / theta) / beta / math.sqrt(2))
    if int(curve["exceed"]) >= SUPPORTED or not bounded:
        return by_curve
    return min(by_curve, at_most(*map(int, above.split("/")), z))


@functools.lru_cache(maxsize=None)
def chances_of(exceed, motions):
    """Ordered samples of a share by Jeffreys' prior."""
    source = random.Random(f"{exceed} of {motions}")
    return sorted(source.betavariate(exceed + 0.5, motions - exceed + 0.5) for _ in range(999))


def at_most(exceed, motions, z):
    """Chance at a normal score of which so many motions exceed just above the velocity."""
    return chances_of(exceed, motions)[min(998, int(999 * NORMAL.cdf(z)))]


def expected(values, chances):
    """Mean of the worst that happens: rarer states of an item come after more frequent ones, as in gurney hospital."""
    loss = reached = 0.0
    for state in sorted(values, key=values.get, reverse=True):
        chance = max(reached, chances.get(state, 0))
        loss += values[state] * (chance - reached)
        reached = chance
    return loss


def least(losses):
    """The first of those that lose least."""
    return min(losses, key=losses.get)


def ends(values):
    ordered = sorted(values)
    at = lambda share: ordered[min(len(ordered) - 1, int(share * len(ordered)))]
    return at(0.025), at(0.975)


def depends_on(curves, states, speed):
    """States whose assumed value, at an end of its range alone, makes another action the best; by the middle curves."""
    chances = {s: {state: probability(curves[s][state], speed, 0) for state in states} for s in curves}
    stated = {name: bounds[1] for name, bounds in states.items()}

    def best(values):
        return least({s: expected(values, chances[s]) for s in curves})

    for state, (low, _, high) in states.items():
        if any(best(stated | {state: end}) != best(stated) for end in (low, high)):
            yield state


def states_of(curves, of_item):
    """For each quantity the consequences of those limit states that have curves."""
    known = next(iter(curves.values()))
    return {q: {state: bounds for state, bounds in of_item(q).items() if state in known} for q in QUANTITIES}


def samples_of(curves, of_item, speed, seed):
    """Days, share of the price and chance of lost service of each setting, sample by sample.

    A sample is a pair: with the stated consequences, and with those drawn from their ranges.

    @param curves  by setting and limit state
    """
    random_source = random.Random(seed)
    states = states_of(curves, of_item)
    known = next(iter(curves.values()))
    lost = losing(of_item) & set(known)
    samples = {q: [] for q in (*QUANTITIES, "lost")}
    for _ in range(SAMPLES):
        # The motions of all settings are the same ones, and so are the scores of their curves.
        z = {state: (random_source.gauss(0, 1), random_source.gauss(0, 1)) for state in known}
        chances = {s: {state: probability(curves[s][state], speed, *z[state]) for state in known} for s in curves}
        for quantity in QUANTITIES:
            stated = {state: bounds[1] for state, bounds in states[quantity].items()}
            drawn = {state: within(bounds, random_source.random()) for state, bounds in states[quantity].items()}
            samples[quantity].append(tuple({s: expected(values, chances[s]) for s in curves}
                                           for values in (stated, drawn)))
        samples["lost"].append(({s: max(chances[s][state] for state in lost) for s in curves},) * 2)
    return samples


def reached(curves, states, speed, seed):
    """Mean and ends of the interval of the chance that one of the states is reached, by setting."""
    random_source = random.Random(seed)
    known = sorted(states & set(next(iter(curves.values()))))
    samples = []
    for _ in range(SAMPLES):
        z = {state: (random_source.gauss(0, 1), random_source.gauss(0, 1)) for state in known}
        samples.append({s: max(probability(curves[s][state], speed, *z[state]) for state in known) for s in curves})
    return {s: (statistics.fmean(each[s] for each in samples), *ends(each[s] for each in samples)) for s in curves}


def mean_of(samples, setting):
    """Mean with the stated consequences."""
    return statistics.fmean(stated[setting] for stated, _ in samples)


def cells(samples, setting):
    """Mean and ends of the interval, as texts."""
    return [f"{value:.3g}" for value in (mean_of(samples, setting), *ends(drawn[setting] for _, drawn in samples))]


def best_of(samples):
    """The setting with the least mean."""
    return least({s: mean_of(samples, s) for s in samples[0][0]})


def share_of(samples, setting):
    """Share of the samples in which a setting has the least loss; a tie counts for each, so that shares may add up to
    more than 1."""
    return f"{sum(drawn[setting] <= min(drawn.values()) for _, drawn in samples) / len(samples):.2f}"


def row_of(curves, of_item, speed, seed):
    samples = samples_of(curves, of_item, speed, seed)
    row = {"pfv": speed}
    for quantity, of in samples.items():
        for s in SETTINGS:
            name = f"{quantity}_{s}"
            row |= dict(zip((name, name + "_low", name + "_high"), cells(of, s)))
    row["best"] = best_of(samples["days"])
    row |= {f"share_{s}": share_of(samples["days"], s) for s in SETTINGS}
    row["best_by_cost"] = best_of(samples["cost_ratio"])
    row["share_by_cost"] = share_of(samples["cost_ratio"], row["best_by_cost"])
    row["depends_on"] = "; ".join(depends_on(curves, states_of(curves, of_item)["days"], speed))
    return row


def curves_of(tables):
    """Curves on the peak floor velocity by item, floor and place, then by setting and limit state; `above` has what
    above.csv counts, where that is there."""
    result, key, above = {}, ("item", "floor", "place", "brakes", "limit_state"), {}
    if os.path.exists(os.path.join(tables, "above.csv")):
        with open(os.path.join(tables, "above.csv"), newline="") as file:
            above = {tuple(row[name] for name in key): {speed: row[str(speed)] for speed in SPEEDS}
                     for row in csv.DictReader(file) if row["measure"] == "pfv"}
    with open(os.path.join(tables, "fragility.csv"), newline="") as file:
        for row in csv.DictReader(file):
            if row["measure"] == "pfv":
                of = result.setdefault((row["item"], row["floor"], row["place"]), {})
                counts = above.get(tuple(row[name] for name in key), {})
                of.setdefault(row["brakes"], {})[row["limit_state"]] = row | {"above": counts}
    return result


def rows_of(task):
    item, floor, place, curves, speeds, path = task
    of = consequences(path)
    return [{"item": item, "floor": floor, "place": place} |
            row_of(curves, lambda quantity: of(item, quantity), speed, f"{item} {floor} {place} {speed}")
            for speed in speeds]


def rows(tables, path=CONSEQUENCES, only=lambda *_: True):
    tasks = [(*where, curves, [speed for speed in SPEEDS if only(*where, speed)], path)
             for where, curves in curves_of(tables).items()]
    with ProcessPoolExecutor() as pool:
        for found in pool.map(rows_of, [task for task in tasks if task[4]]):
            yield from found


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    with open(os.path.join(sys.argv[1], "losses.csv"), "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows(*sys.argv[1:]))


if __name__ == "__main__":
    main()
