"""The page on how far the curves of the catalogue hold, docs/catalogue/checks.md: pages.py writes it from the tables."""

import statistics

from catalogue import BRAKES, motion_rows, rows as rows_of
from suites import summary
from tables import MUCH_BETTER, much_better
from words import read, table, wrapped

SHOWN = 0.05  # of p
MOVED = ["moved 0.1 m", "moved 0.3 m", "moved 1 m"]
STATES = MOVED + ["overturned"]


def percent(value):
    return f"{100 * value:.0f} %"


def floors(tables):
    def cell(row, name, unit=""):
        return "{:.2f} ({:.2f} to {:.2f})".format(*(float(row[name + end + unit]) for end in ("", "_p16", "_p84")))

    rows = ([row["floor"], row["pgv"], cell(row, "pfv"), cell(row, "pfa", "_g"), row["beyond_drift"],
             row["beyond_capacity"]] for row in read(tables, "floors.csv"))
    return ["## Floors", "",
            *wrapped(f"Peak velocity and acceleration of the floors over the {len(motion_rows())} motions (median, 16 and "
                     "84 %), and in how many of them the model is beyond what it is good for: an elastic building at a "
                     "storey drift ratio above 1 %, isolators above their capacity (`floors.csv`). Curves on the floor's "
                     "velocity hold all the same; those on the PGV of the ground assume these floors."), "",
            *table(["floor", "PGV [m/s]", "PFV [m/s]", "PFA [g]", "drift above 1 %", "isolators beyond"], rows)]


def measures(tables):
    rows, best = read(tables, "measures.csv"), read(tables, "best_measure.csv")
    curves = {(r["item"], r["floor"], r["place"], r["brakes"], r["limit_state"]): r
              for r in read(tables, "fragility.csv") if r["measure"] == "pfv"}
    better = [row["brakes"] for row in rows if much_better(row)]

    def above(brakes):
        return statistics.median(float(row["pfv_scatter"]) / float(row["best_scatter"]) - 1
                                 for row in rows if row["brakes"] == brakes and row["pfv_scatter"])

    def ratios(brakes, state):
        for row in best:
            pfv = curves[row["item"], row["floor"], row["place"], row["brakes"], row["limit_state"]]
            if ((row["brakes"], row["limit_state"]) == (brakes, state) and row["theta"] and pfv["theta"] and
                    10 <= int(row["exceed"]) <= int(row["runs"]) - 10):
                yield float(row["beta"]) / float(pfv["beta"])

    def cells(brakes):
        found = [list(ratios(brakes, state)) for state in STATES]
        return [brakes] + [f"{statistics.median(each):.2f}" if each else "" for each in found]

    text = (f"The scatter of the displacement about the PFV is in the median {percent(above('off'))} larger than about "
            f"the best measure with brakes off, {percent(above('on'))} with brakes on and {percent(above('locked'))} "
            f"locked (`measures.csv`). Where it is more than {percent(MUCH_BETTER)} larger, the curves on the best are "
            f"shipped as well (`best_measure.csv`): {len(better)} of {len(rows)} configurations, {better.count('off')} "
            f"with brakes off, {better.count('on')} on, {better.count('locked')} locked. Beta on the best measure over "
            "beta on the PFV, medians of curves with 10 outcomes of either kind (each beta is of the logarithm of its "
            "own measure):")
    return ["## Better measures", "", *wrapped(text), "", *table(["brakes", *STATES], map(cells, BRAKES))]


def sufficiency(tables):
    tested = [row for row in read(tables, "sufficiency.csv") if row["p_pfv"]]

    def cells(brakes, state):
        rows = [row for row in tested if (row["brakes"], row["limit_state"]) == (brakes, state)]
        if not rows:
            return None
        median = lambda name: statistics.median(float(row[name]) for row in rows)
        shown = [sum(float(row["p_holm_" + end]) < SHOWN for row in rows) for end in ("pfv", "vector")]
        return [f"{brakes}, {state}", len(rows), shown[0], f"{median('ratio_pfv'):.2f}", percent(median("off_pfv")),
                shown[1], percent(median("off_vector"))]

    found = [cells(brakes, state) for state in ("moved 0.3 m", "moved 1 m", "overturned") for brakes in BRAKES]
    return ["## Is the velocity of the floor enough?", "",
            *wrapped("One curve for all floors would do if floors of equal PFV had equal chances. Tested by item, place, "
                     "brakes and limit state: a probit on ln PFV with one term for each floor, its covariance over motions, F "
                     f"test, adjusted for {len(tested)} tests by Holm's method (`sufficiency.csv`). Ratio: largest over "
                     "smallest median of the floors. Off: the most that one curve for all is off on a floor, in points of the "
                     "chance. With the peak acceleration of the floor (PFA) beside the PFV:"), "",
            *table(["brakes, limit state", "tested", "floors differ", "ratio", "off", "differ with PFA", "off"],
                   filter(None, found)), "",
            *wrapped("Ratios, and what a curve is off, are medians of the items. **So use the curve of the floor that is "
                     "most like yours**, as the tables have one for each; for a floor unlike all of them `sufficiency.csv` "
                     "has P = Phi(constant + a ln PFV + b ln PFA), PFV in m/s and PFA in m/s2, as good as the last column says.")]


def not_counted(tables):
    rows = read(tables, "runs.csv")
    runs, failed = (sum(int(row[name]) for row in rows) for name in ("runs", "failed"))
    listed = ((row["item"], row["overturned"], row["failed_runs"]) for row in rows if row["failed_runs"])
    what = "untrusted (energy balance off by more than 5 %)"
    if not failed:
        return ["## Runs that are not counted", "", f"None: no run of {runs} is {what} (`runs.csv`)."]
    text = f"{failed} of {runs} runs {'is' if failed == 1 else 'are'} {what} and not counted (`runs.csv`)."
    return ["## Runs that are not counted", "",
            *wrapped(text + " `gurney explain` runs one again by its number. With it one more of the 128 runs of a curve would "
                     "exceed, or not:"), "", *table(["item", "overturned, of all", "not counted"], listed)]


def halves(tables):
    rows = read(tables, "halves.csv")
    names = {"by turns": "halves by turns: within", "by shape": "slow half against fast half: within"}
    of = {(row["division"], row["limit_state"]): row for row in rows}

    def total(division):
        inside, bounded = (sum(int(row[name]) for row in rows if row["division"] == division)
                           for name in ("within_bounded", "bounded"))
        return f"{percent(inside / bounded)} of {bounded} medians"

    cells = ([state] + [f"{of[division, state]['within_bounded']} of {of[division, state]['bounded']}" for division in names]
             for state in STATES)
    return ["## Do halves of the motions predict each other?", "",
            "Medians of one half against the intervals of the other (`halves.csv`; open floor, intervals with two ends):", "",
            *table(["limit state", *names.values()], cells), "",
            *wrapped(f"{total('by turns')} by turns, where each half has spectra of all shapes, are within the interval of "
                     f"the other half; {total('by shape')} by shape, where one half has the motions with the largest "
                     "Sa(2 s) / Sa(0.3 s). Independent halves with intervals of Student's t with 15 degrees of freedom "
                     "would give 85 % (P(|t| < 2.131 / sqrt 2)). So **the medians are of this mix of motions**: a site "
                     "whose motions are all slow or all fast differs by more than the intervals say, above all for 1 m.")]


def widths(tables):
    found = {}
    for row in read(tables, "widths.csv"):
        width = float(row["median_width"])
        found.setdefault(row["limit_state"], []).append(f"{width:.1f}" if width < 10 else "above 10")
    return ["## Are 32 motions enough?", "",
            *wrapped("Width of the interval of a median (upper over lower end; median of the curves, an interval without an "
                     "end counts as infinitely wide) with 8 motions, 16 and all 32 (`widths.csv`, open floor, disjoint "
                     "parts by turns):"), "",
            *table(["limit state", "8", "16", "32"], ([state, *cells] for state, cells in found.items())), "",
            "Eight motions are too few."]


def shares(tables):
    rows = read(tables, "variance.csv")
    parts = ("record", "parameters", "chaos")

    def cells(brakes):
        yield brakes
        for response in ("ln displacement", "overturned"):
            of = [row for row in rows if (row["brakes"], row["response"]) == (brakes, response)]
            for part in parts:
                yield percent(statistics.median(float(row[part]) for row in of)) if of else ""

    return ["## Record, parameters, chaos", "",
            *wrapped("Shares of the variance at a PGV of 0.8 m/s, flexible building, open floor ([method](methods.md#record-"
                     "parameters-chaos); `variance.csv` has each with its interval), medians of the items:"), "",
            *table(["brakes", "displacement: record", "parameters", "chaos", "overturned: record", "parameters", "chaos"],
                   map(cells, BRAKES)), "",
            *constants(tables)]


def constants(tables):
    rows = read(tables, "constants.csv")
    items = {row["item"] for row in rows}
    found = {}
    for row in rows:
        if float(row["p_holm"]) < SHOWN:
            found.setdefault((row["constant"], row["brakes"]), []).append(float(row["correlation"]))
    cells = ([f"`{constant}`", brakes, f"{len(r)} of {len(items)}", f"{min(r):.2f} to {max(r):.2f}" if len(r) > 1 else f"{r[0]:.2f}"]
             for (constant, brakes), r in sorted(found.items(), key=lambda each: (-len(each[1]), each[0])))
    return [*wrapped("Drawn constants that are shown to matter for the displacement (`constants.csv`): rank correlation within "
                     "motions, p from permutations, adjusted for the constants of an item by Holm's method. Of 3 x "
                     f"{len(items)} analyses one in 20 shows something by chance. Parameters without a distribution "
                     "(friction of swivels and axles, positions of casters, housings) have no rank. What is published of "
                     "them: [constants](constants.md)."), "",
            *table(["constant", "brakes", "items", "correlation"], cells)]


def torque(tables):
    names = ("torque_n_m", "peak_displacement_m", "residual_displacement_m", "path_length_m", "peak_yaw_rad")
    rows = ([*(row[name] for name in names), f"{row['overturned']} of {row['runs']}"]
            for row in read(tables, "brake_torque.csv"))
    return ["## More brake torque, more way", "",
            *wrapped("The mobile X-ray unit with brakes on goes farther with more torque (`brake_torque.csv`, medians of the "
                     "runs that did not overturn):"), "",
            *table(["torque of each brake [N m]", "peak displacement [m]", "residual [m]", "path [m]", "yaw [rad]",
                    "overturned"], rows), "",
            *wrapped("Its two drive wheels carry 1476 N each and slide at 0.7 of that, 1030 N; a brake of 75 N m slips at 600 "
                     "N at a wheel of 125 mm radius, one of 150 N m at 1200 N. A wheel whose brake slips holds sideways; a "
                     "locked wheel that slides does not.")]


def interval(row, name):
    """Median and interval, which fewer than 8 motions do not have."""
    if not row[name + "_low"]:
        return f"{float(row[name]):.2f}"
    return "{:.2f} ({:.2f} to {:.2f})".format(*(float(row[name + end]) for end in ("", "_low", "_high")))


def other_suites(tables):
    rows = [row for row in read(tables, "suites.csv") if not row["limit_state"].startswith("hit")]
    names = list(dict.fromkeys(row["suite"] for row in rows))
    of = {name: {(each["brakes"], each["limit_state"]): each
                 for each in summary([row for row in rows if row["suite"] == name])} for name in names}
    keys = list(dict.fromkeys(key for name in names for key in of[name]))

    def cell(each):
        return f"{each['ratio']} ({each['lowest']} to {each['highest']})" if each else ""

    inside = "; ".join(
        f"{name} {sum(row['within'] == 'yes' for row in rows if row['suite'] == name)} of "
        f"{sum(row['suite'] == name for row in rows)}" for name in names)
    draws = ([row["item"], interval(row, "theta"), interval(row, "other"), f"{float(row['ratio']):.2f}"]
             for row in read(tables, "draws.csv") if row["limit_state"] == "overturned")
    return ["## Other motions", "",
            *wrapped("Hospital bed, ventilator and infusion pole, ground and flexible building, open floor, brakes off and on, "
                     "with other motions ([how](methods.md#other-motions)): seven recorded ones, 16 synthetic ones of "
                     "assumed parameters. Medians over those of the catalogue, geometric mean and ends (`suites.csv`):"), "",
            *table(["brakes, limit state", *names], ([f"{brakes}, {state}", *(cell(of[name].get((brakes, state)))
                                                     for name in names)] for brakes, state in keys)), "",
            *wrapped(f"Within the interval of the catalogue: {inside}."), "",
            "With six draws of item, casters and yaw for each motion of the catalogue and 20 for each recorded one",
            "(`draws.csv`; flexible building, open floor, brakes on) the medians of overturning [m/s] are", "",
            *table(["item", "catalogue, 6 draws", "records, 20 draws", "ratio"], draws)]


def other_design(tables, file, title, design, other):
    """Medians of another design over those of the catalogue, and those of overturning, upstairs with brakes on."""
    rows = [row for row in read(tables, file) if not row["limit_state"].startswith("hit")]
    falls = ([row["item"], interval(row, "theta"), interval(row, "other"), f"{float(row['ratio']):.2f}"]
             for row in rows if (row["limit_state"], row["brakes"], row["floor"]) == ("overturned", "on", "flexible building"))
    keys = [key for key in ("floor", "brakes", "limit_state") if len({row[key] for row in rows}) > 1]
    inside = sum(row["within"] == "yes" for row in rows)
    return [f"## {title}", "",
            *wrapped(f"{design} ([how](methods.md#other-motions)). Medians over those of the catalogue, where both are neither "
                     f"extrapolated nor from few outcomes (`{file}`); {inside} of {len(rows)} are within the interval of the "
                     "catalogue:"), "",
            *table([*(key.replace("_", " ") for key in keys), "curves", "ratio", "lowest", "highest", "within"],
                   ([each[column] for column in (*keys, "curves", "ratio", "lowest", "highest", "within")]
                    for each in sorted(summary(rows, keys), key=lambda each: [each[key] for key in keys]))), "",
            "Overturning [m/s], flexible building, brakes on, with intervals of 95 %:", "",
            *table(["item", "catalogue", other, "ratio"], falls)]


def six_draws(tables):
    return other_design(tables, "six_draws.csv", "Draws of each motion",
                        "All items with six draws of item, casters and yaw for each motion in place of one, open floor: "
                        "flexible building, brakes on and locked; ground, brakes on", "six draws")


def jittered(tables):
    return other_design(tables, "jittered.csv", "Levels between the levels",
                        "A chaotic run says little of its neighbours: would other levels have given other curves? All "
                        "items at 0.95 and 1.05 of each level in place of it, flexible building, open floor, brakes on "
                        "and locked", "jittered levels")


def by_level(tables):
    return other_design(tables, "by_level.csv", "Motions of each level",
                        "The motions of the catalogue are those of earthquakes that gave a PGV of 0.6 m/s, scaled by 0.13 "
                        "to 7.7. All items with four suites of 32 motions, each of earthquakes that gave [the PGV of its "
                        "level](motions.md#motions-of-each-level), ground and flexible building, open floor, brakes off "
                        "and on", "motions of each level") + ["", *wrapped(
                            "On the ground items with brakes on need more velocity for the same way: strong motions have "
                            "less acceleration for their velocity than the 32 of the catalogue scaled up, and weak ones "
                            "more. Falls upstairs and on the ground stay within their intervals.")]


def page(tables):
    lines = ["# How far the curves hold", "",
             *wrapped("Checks of the [fragility catalogue](methods.md) on itself and with other motions, from its "
                      "[tables](methods.md#tables).")]
    for section in (floors, sufficiency, measures, halves, widths, shares, six_draws, jittered, by_level,
                    torque, other_suites, not_counted):
        lines += ["", *section(tables)]
    return lines + [""]
