"""Writes the tables of docs/shipped_studies.md and docs/validation.md from the results files of their studies.

usage: python3 docs/validation/tables.py [--check] FOLDER_OF_RESULTS [NAME...]
A table follows the line <!-- tables.py NAME --> of its page; its rows are replaced, its head stays.
--check writes nothing and ends with 1 where the page has other rows.
needs python3-h5py and python3-pandas, and gurney in the PATH or in the environment variable GURNEY.
"""

import math
import pathlib
import re
import statistics
import sys
import tomllib

import numpy

from results import clopper_pearson, fragilities, gurney, items_of, joined, runs_of, tables_of

PAGES = [pathlib.Path(__file__).parent.parent / name for name in ("shipped_studies.md", "validation.md")]


def chosen(table, **levels):
    """The rows with these levels of the factors; `b_over_h` stands for the factor `b over h`."""
    for name, level in levels.items():
        table = table[table["level " + name.replace("_", " ")] == level]
    return table


def at(table, intensity):
    return table[numpy.isclose(table.intensity, intensity)]


def median(values, digits=2):
    return f"{values.median():.{digits}f}"


def spread(values, digits=2):
    return f"{values.median():.{digits}f} ({values.min():.{digits}f} to {values.max():.{digits}f})"


def neonatal_unit(results):
    table = runs_of(f"{results}/neonatal_unit.h5")
    for shaking in ("short", "long"):
        for building in ("fixed", "lead rubber", "friction pendulum"):
            for floor in ("first", "fourth"):
                rows = chosen(table, shaking=shaking, building=building, floor=floor)
                medians = [median(at(chosen(rows, brakes=brakes), level).peak_displacement)
                           for brakes in ("off", "half on", "on") for level in (0.2, 0.4, 0.8)]
                yield [shaking, building, floor, *medians, f"{rows.peak_displacement.max():.2f}"]


def operating_theatre(results):
    tables = tables_of(f"{results}/operating_theatre.h5")
    items, tethers = items_of(tables), joined(tables, "tethers")
    broken = tethers[(tethers.tether == "cord") & (tethers.time_broken >= 0)].run
    for brakes in ("off", "on"):
        for level in sorted(items.intensity.unique()):
            rows = at(chosen(items, brakes=brakes), level)
            yield [brakes, f"{level:g}", (rows.residual_displacement > 0.02).sum(), (rows.impacts > 0).sum(),
                   (rows.largest_approach_speed > 0.8).sum(), rows.run.isin(broken).sum(),
                   median(rows.peak_displacement)]


def ward_corridor(results):
    tables = tables_of(f"{results}/ward_corridor.h5")
    items, zones = items_of(tables), joined(tables, "zones")
    for beds in ("braked", "free"):
        for carts in ("braked", "free"):
            for level in (0.2, 0.4, 0.6):
                rows = at(chosen(items, beds=beds, carts=carts), level)
                here = zones[zones.run.isin(rows.run)]
                way, door = here[here.zone == "corridor"], here[here.zone == "room door"]
                farthest = [rows[rows.item.str.contains(kind)].groupby("run").peak_displacement.max()
                            for kind in ("bed", "cart")]
                yield [beds, carts, f"{level:g}",
                       f"{way.free_width_at_end.median():.2f} ({way.free_width_at_end.min():.2f})",
                       (way.free_width_at_end < 1.02).sum(), (way.free_width_at_end < 0.8).sum(),
                       (way.least_free_width < 0.6).sum(), (door.occupied_at_end > 0).sum(),
                       (rows.groupby("run").largest_approach_speed.max() > 0.4).sum(),
                       ", ".join(median(each) for each in farthest)]


def trolley_orientation(results):
    table = runs_of(f"{results}/trolley_orientation.h5")
    for period in ("0.5", "1", "2", "4"):
        for level in (0.2, 0.4, 0.8):
            cells = []
            for brakes in ("off", "on", "total lock"):
                rows = at(chosen(table, period=period, brakes=brakes), level)
                overturned = rows.overturned.sum()
                cells.append(f"{rows.peak_displacement.min():.3f} to {rows.peak_displacement.max():.3f}"
                             + (f"; {overturned} overturned" if overturned else ""))
            yield [period, f"{level:g}", *cells]


def theta_and_beta(curve):
    """Cells `theta (interval)`, `beta (interval)` of a fitted curve, else why there is none."""
    if curve["curve"] is None:
        return ["none overturned" if curve["exceeded"] == 0 else curve["status"].split(":")[0], ""]
    cells = []
    for name in ("theta", "beta"):
        low, high = curve[name + "_interval"]
        high = "no upper bound" if high is None else f"{high:.2f}"
        cells.append(f"{curve['curve'][name]:.2f} ({low:.2f} to {high})")
    return cells


def icu_ventilator_fragility(results):
    path = f"{results}/icu_ventilator_fragility.h5"
    table = runs_of(path)
    exceeds = {
        "displaced": ("displaced > 0.3 m", table.peak_displacement > 0.3),
        "hit": ("hit at > 0.4 m/s", table.largest_approach_speed > 0.4),
        "overturned": ("overturned", table.overturned),
    }
    for limit_state, (words, exceeded) in exceeds.items():
        curves = fragilities(path, limit_state)
        for brakes in ("off", "on"):
            rows = chosen(table[exceeded], brakes=brakes)
            counts = [len(at(rows, level)) for level in sorted(table.intensity.unique())]
            yield [f"{brakes}, {words}", *counts, *theta_and_beta(curves[brakes])]


def icu_ventilator_ida(results):
    path = f"{results}/icu_ventilator_ida.h5"
    table = runs_of(path)
    for brakes, curve in fragilities(path, "overturned").items():
        rows = chosen(table, brakes=brakes)
        capacities = rows[rows.overturned].groupby("record").intensity.min()
        yield [brakes, len(rows), *theta_and_beta(curve), f"{capacities.min():.2f}", f"{capacities.max():.1f}"]


def crash_cart_drawers(results):
    table = runs_of(f"{results}/crash_cart_drawers.h5")
    cart = table.item == "cart"
    events = (table.peak_travel > 0.05, table.time_of_fall >= 0, cart & (table.peak_displacement > 1),
              cart & table.overturned)
    for brakes in ("off", "on"):
        for drawers in ("latched", "locked"):
            cells = []
            for event in events:
                happened = chosen(table.assign(event=event), brakes=brakes, drawers=drawers)
                shares = happened.groupby(["intensity", "record"]).event.any().groupby("intensity").mean()
                cells.append(", ".join(f"{100 * share:.0f}" for share in shares))
            yield [brakes, drawers, *cells]


def long_period(results):
    table = runs_of(f"{results}/validation_long_period.h5")
    for period, brakes, digits in (("2 s", "off", 1), ("3 s", "off", 1), ("4 s", "off", 1), ("3 s", "half", 2),
                                   ("3 s", "on", 2)):
        rows = chosen(table, period=period, brakes=brakes)
        cells = [spread(chosen(rows, item=item).peak_displacement, digits)
                 for item in ("bed", "dialysis", "ultrasound")]
        yield [period, brakes.replace("half", "on one diagonal"), *cells,
               f"{(rows.peak_displacement > 3).sum()} of {len(rows)}"]


def fixed_beds(results):
    table = runs_of(f"{results}/validation_fixed_beds.h5")
    for item in ("ward bed", "ICU bed"):
        for brakes in ("off", "on"):
            rows = chosen(table, item=item, brakes=brakes)
            yield [item, brakes, spread(rows.peak_displacement), (rows.peak_displacement > 0.1).sum(),
                   (rows.residual_displacement > 0.02).sum()]


PAIR = ["level building", "level floor", "record", "angle", "intensity"]


def farther(table, locks):
    """Pairs of the same record, angle and intensity in which the locked machine moves farther than the free one."""
    free = chosen(table, locks="free").set_index(PAIR).peak_displacement
    locked = chosen(table, locks=locks).set_index(PAIR)
    return locked[locked.peak_displacement > free.reindex(locked.index)].reset_index()


def ultrasound_pairs(results):
    table = runs_of(f"{results}/validation_ultrasound.h5")
    for building in ("fixed", "lead rubber", "friction pendulum"):
        for floor in ("first", "fourth"):
            counts = [len(chosen(farther(table, locks), building=building, floor=floor))
                      for locks in ("casters", "wheel brakes", "all wheels")]
            yield [f"{building}, {floor} floor".replace("fixed,", "fixed base,"), *counts]


def difference(path, a, b):
    """Mean of A, mean of B, their difference with its interval, and p by Holm."""
    mean = gurney("compare", path, "--configurations", f"{a},{b}", "--demand", "peak_displacement")["means"][0]
    low, high = mean["interval"]
    return (f"{mean['a']:.2f}", f"{mean['b']:.2f}", f"{mean['difference']:.2f} ({low:.2f} to {high:.2f})",
            f"{mean['p_holm']:.3f}")


def ultrasound_means(results):
    for building in ("fixed", "lead rubber", "friction pendulum"):
        yield [building, *difference(f"{results}/validation_ultrasound.h5", f"{building}, fourth, free",
                                     f"{building}, fourth, casters")]


def isolation(results):
    path = f"{results}/validation_isolation.h5"
    table = runs_of(path)
    keys = ["record", "intensity"]
    for item in ("dialysis", "ultrasound"):
        for building in ("lead rubber", "friction pendulum", "fixed"):
            rows = chosen(table, building=building, item=item)
            free = chosen(rows, brakes="off").set_index(keys).peak_displacement
            cells = []
            for brakes in ("half", "on"):
                off, braked, change, p = difference(path, f"{building}, {item}, off", f"{building}, {item}, {brakes}")
                pairs = chosen(rows, brakes=brakes).set_index(keys).peak_displacement
                cells += [braked, f"{change}, {p}", (pairs > free.reindex(pairs.index)).sum()]
            yield [building, item, off, *cells]


def b_over_h(results):
    table = runs_of(f"{results}/validation_b_over_h.h5")
    for ratio in sorted(table["level b over h"].unique(), key=float):
        cells = []
        for floor in ("ground", "building of 0.6 s"):
            for locks in ("none", "half", "all"):
                rows = chosen(table, floor=floor, locks=locks, b_over_h=ratio)
                k, n = int(rows.overturned.sum()), len(rows)
                cells.append(f"{k}" if locks != "all" else "{} ({:.2f} to {:.2f})".format(k, *clopper_pearson(k, n)))
        yield [f"{ratio} ({2 * float(ratio):g})", *cells]


def b_over_h_height(results):
    table = runs_of(f"{results}/validation_b_over_h_height.h5")
    for height in ("0.5", "0.75", "1"):
        yield [f"{height} m", *(chosen(table, h_and_b_over_h=f"{height} m, {ratio}").overturned.sum()
                                for ratio in ("0.3", "0.35", "0.4", "0.5"))]


G = 9.80665


def slide_of_rigid_cart(amplitude, period):
    """How far the rigid cart of validation_half_locked slides in one cycle of its floor [m]: Newmark's block that resists with k g.

    mu 0.6, c = Cr / R 0.02; contacts 0.216 m before and 0.217 m behind the centre of mass, which is 0.645 m high;
    the two wheels that roll add 2 I / R^2 = 0.25 kg to 110 kg.
    """
    before, behind, height, mu, c = 0.216, 0.217, 0.645, 0.6, 0.02
    wheelbase = before + behind
    k = (mu * behind + c * before) / wheelbase / (1 + (mu - c) * height / wheelbase)
    if amplitude <= k:
        return 0.0
    frequency = 2 * math.pi / period
    start = math.asin(k / amplitude)  # phases: sliding starts, and ends where the velocity is 0 again

    def velocity(phase):
        return G / frequency * (amplitude * (math.cos(start) - math.cos(phase)) - k * (phase - start))

    low, high = math.pi - start, start + 2 * math.pi
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if velocity(middle) > 0 else (low, middle)
    width = low - start
    rigid = G / frequency**2 * (amplitude * (width * math.cos(start) - math.sin(low) + math.sin(start)) - k * width**2 / 2)
    return rigid * 110 / 110.25


def half_locked(results):
    table = runs_of(f"{results}/validation_half_locked.h5")
    for period in (2, 3, 5):
        for level in (0.1, 0.2, 0.25, 0.3):
            rows = at(table, level * G)
            drift = {(locks, cycles): -chosen(rows, locks=locks, shaking=f"{period} s, {cycles} cycles")
                     .residual_displacement_x.iloc[0] for locks in ("front", "none", "all") for cycles in (10, 20)}
            cycle = (drift["front", 20] - drift["front", 10]) / 10
            final = [f"{drift[locks, 20] + 0:.2f}".replace("-0.00", "0.00") for locks in ("front", "none", "all")]
            yield [f"{period} s", f"{level:g} g", f"{1000 * slide_of_rigid_cart(level, period):.0f}",
                   f"{abs(1000 * cycle):.0f}", *final]


def p58(results):
    curves = fragilities(f"{results}/validation_p58.h5", "overturned")
    from figures import P58
    for name, (depth, height, published) in P58.items():
        cells = []
        for friction in ("does not slide", "0.2 to 0.6"):
            for floor in ("ground", "building of 1 s"):
                curve = curves[f"{floor}, {friction}, {name}"]
                theta, _ = theta_and_beta(curve)
                fitted = curve["curve"] is not None
                cells.append(f"{theta}, {curve['curve']['beta']:.2f}" if fitted else theta)
                if friction == "does not slide":
                    cells.append(f"{curve['curve']['theta'] / published:.2f}" if fitted else "")
        yield [name, f"{depth / height:.3f}", f"{published:.3f}", *cells]


def rolling_force(item, caster):
    """Force [N] that keeps an item rolling, and its interval of 95 % by the distribution of Cr of its casters."""
    with open(pathlib.Path(__file__).parents[2] / "equipment" / "casters" / f"{caster}.toml", "rb") as file:
        rolling = tomllib.load(file)["tread"]["rolling_resistance_mm"]
    spread, normal = rolling["distribution"], statistics.NormalDist()
    ends = [normal.cdf(math.log(spread[end] / spread["median"]) / spread["beta"]) for end in ("low", "high")]
    force = gurney("equipment", "show", item)["rolling_resistance_n"]
    return force, *(force * spread["median"] / rolling["value"] * math.exp(
        spread["beta"] * normal.inv_cdf(ends[0] + tail * (ends[1] - ends[0]))) for tail in (0.025, 0.975))


def shared(k, n):
    return "{} of {}: {:.2f} to {:.2f}".format(k, n, *clopper_pearson(k, n))


def compared(results):
    """Published numbers, by whom, what is computed with its interval, and whether each number lies within."""
    e_defense, hitomi = "Sato et al. 2011", "Hitomi et al. 2022"
    table = runs_of(f"{results}/validation_long_period.h5")
    for period in ("2 s", "3 s", "4 s"):
        ways = chosen(table, period=period, brakes="off").peak_displacement
        yield ("3 m, sometimes more", e_defense, f"period of {period}: {ways.min():.1f} to {ways.max():.1f} m",
               [ways.min() <= 3 <= ways.max()])

    table = runs_of(f"{results}/validation_fixed_beds.h5")
    for item in ("ward bed", "ICU bed"):
        for brakes in ("off", "on"):
            rows = chosen(table, item=item, brakes=brakes)
            moved = int((rows.peak_displacement > 0.1).sum())
            yield ("all beds of a floor moved", "E-Defense 2009", f"{item}, brakes {brakes}, more than 0.1 m in "
                   f"{shared(moved, len(rows))}", [clopper_pearson(moved, len(rows))[1] == 1])

    table = runs_of(f"{results}/validation_ultrasound.h5")
    pairs = len(chosen(table, building="fixed", floor="fourth", locks="free"))
    more = len(chosen(farther(table, "casters"), building="fixed", floor="fourth"))
    yield ("a locked machine does not always move less", "Nikfar & Konstantinidis 2017",
           f"farther in {shared(more, pairs)}", [more > 0])
    for building in ("lead rubber", "friction pendulum"):
        *_, change, _ = difference(f"{results}/validation_ultrasound.h5", f"{building}, fourth, free",
                                   f"{building}, fourth, casters")
        yield ("less than 0 m by locking, on isolators", "Nikfar & Konstantinidis 2019", f"{building}: {change} m",
               [" to -" in change])

    table = runs_of(f"{results}/validation_b_over_h.h5")
    for words, ratio in (("half the width", "0.4"), ("the whole width", "0.2")):
        rows = chosen(table, b_over_h=ratio, locks="all")
        fell = int(rows.overturned.sum())
        yield ("next to none overturns at b / h = 0.4", hitomi, f"b {words}: {shared(fell, len(rows))}",
               [clopper_pearson(fell, len(rows))[0] < 0.01])

    for item, caster, words in (("icu_bed", "bed_150", "ICU bed, 310 kg"), ("hospital_bed", "R100", "ward bed, 120 kg")):
        force, low, high = rolling_force(item, caster)
        yield ("twelve beds of unknown mass roll with 49.6 to 92.4 N", "Backhaus et al.",
               f"{words}: {force:.0f} ({low:.0f} to {high:.0f}) N", [low <= each <= high for each in (49.6, 92.4)])

    from figures import P58
    curves = fragilities(f"{results}/validation_p58.h5", "overturned")
    for friction in ("does not slide", "0.2 to 0.6"):
        for floor in ("ground", "building of 1 s"):
            of = {name: curves[f"{floor}, {friction}, {name}"] for name in P58}
            fitted = {name: curve for name, curve in of.items() if curve["curve"] is not None}
            holds = lambda interval, value: interval[0] <= value <= (interval[1] or math.inf)
            for name, words in (("theta", "medians of overturning"), ("beta", "dispersions of 0.5")):
                yield (f"{len(fitted)} {words}", "FEMA P-58 (a formula, not tests)", f"{floor}, friction {friction}",
                       [holds(curve[name + "_interval"], P58[block][2] if name == "theta" else 0.5)
                        for block, curve in fitted.items()])


def published_numbers(results):
    rows = list(compared(results))
    for published, by, computed, within in rows:
        yield [published, by, computed, f"{sum(within)} of {len(within)}"]
    for words, is_formula in (("tests and measurements", False), ("a formula", True)):
        within = [each for _, by, _, of in rows if ("formula" in by) == is_formula for each in of]
        yield [f"**all comparisons with {words}**", "", "", f"**{sum(within)} of {len(within)}**"]
    # A number whose conditions are not published is compared under several.
    readings = {}
    for published, by, _, within in rows:
        if "formula" not in by:
            readings.setdefault((published, by), []).extend(within)
    counts = [(sum(of), len(of)) for of in readings.values()]
    yield [f"**statements of tests and measurements, of {len(counts)}**", "", "within in every comparison, in some, in none",
           "**{}, {}, {}**".format(sum(k == n for k, n in counts), sum(0 < k < n for k, n in counts),
                                   sum(k == 0 for k, _ in counts))]


TABLES = [published_numbers, fixed_beds, neonatal_unit, operating_theatre, ward_corridor, trolley_orientation, icu_ventilator_fragility,
          icu_ventilator_ida, crash_cart_drawers, long_period, ultrasound_pairs, ultrasound_means, isolation, b_over_h,
          b_over_h_height, half_locked, p58]


def replaced(page, name, rows):
    """The page with these rows in the table below the mark of this name."""
    body = "".join("| " + " | ".join(str(cell) for cell in row) + " |\n" for row in rows).replace("|  |", "| |")
    pattern = rf"(<!-- tables\.py {name} -->\n\|[^\n]*\n\| ---[^\n]*\n)(?:\|[^\n]*\n)*"
    return re.sub(pattern, lambda found: found.group(1) + body, page)


def main(results, names, check):
    others = []
    for table in TABLES:
        if names and table.__name__ not in names:
            continue
        rows = list(table(results))
        found = False
        for path in PAGES:
            before = path.read_text()
            if f"<!-- tables.py {table.__name__} -->" in before:
                after = replaced(before, table.__name__, rows)
                others += [line for line in after.splitlines() if line not in before.splitlines()]
                if not check:
                    path.write_text(after)
                found = True
        if not found:
            raise SystemExit(f"no page has a table {table.__name__}")
    if check and others:
        raise SystemExit("the pages have other rows than\n" + "\n".join(others))


if __name__ == "__main__":
    check = sys.argv[1:2] == ["--check"]
    arguments = sys.argv[1 + check:]
    if not arguments:
        raise SystemExit(__doc__)
    main(arguments[0], arguments[1:], check)
