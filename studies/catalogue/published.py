"""Published values of the constants that decide, beside those of the files, and how many numbers of an item are judged:
the page docs/catalogue/constants.md, which pages.py writes from published.toml and the files of equipment.
"""

import functools
import math
import os
import statistics
import tomllib

import judgements
from catalogue import rows as rows_of
from suites import summary as ratios_of
from words import read, table, wrapped

HERE = os.path.dirname(os.path.abspath(__file__))
SHOWN = 0.05  # of p, adjusted
NORMAL = statistics.NormalDist()
KINDS = {"measured": "measured", "derived": "derived", "required": "asked for", "design": "design table"}
# Of a tread on which a derived stiffness rests: radius, width of the contact, thickness [m], load [N].
RADIUS, WIDTH, THICKNESS, LOAD = 0.05, 0.02, 0.01, 200
HOLDS = 0.2  # of the load: what ISO 22881 asks a braked caster to hold


def tread_stiffness(hardness):
    """Load over sinking [N/m] of a tread of this Shore A hardness.

    Young's modulus by Gent 1958 (from memory); a layer that cannot widen has E / (1 - nu^2) with nu = 1/2, and a wheel
    that sinks by d into it carries (4/3) sqrt(2 R) d^1.5 w E' / t.
    """
    modulus = 1e6 * 0.0981 * (56 + 7.62336 * hardness) / (0.137505 * (254 - 2.54 * hardness)) / 0.75
    sinks = (LOAD / (modulus * WIDTH / THICKNESS * 4 / 3 * math.sqrt(2 * RADIUS))) ** (2 / 3)
    return LOAD / sinks


@functools.lru_cache(maxsize=None)
def casters():
    """Files of the casters that the catalogue's items have."""
    names = {name for row in rows_of("items.csv")
             for name in judgements.caster_types(judgements.load("items", row["item"]))}
    return {name: judgements.load("casters", name) for name in sorted(names)}


def found(tree, path):
    for name in path.split("."):
        tree = tree.get(name, {})
    return tree


def files(constant, sheets):
    """What the files have, in the unit of the constant: low, value, high by name."""
    path = constant["quantity"]
    if path == "slope":
        spread = judgements.load("levelness")["slope"]["distribution"]
        return {"levelness": (0, 100 * spread["sd"], 100 * spread["high"])}
    if path == "center_of_mass":
        return {item: (sheet["center_of_mass_m"][2] / sheet["size_m"][2],) * 3 for item, sheet in sheets.items()}
    scale, result = constant.get("scale", 1), {}
    for name, file in casters().items():
        quantity = found(file, path)
        if quantity.get("value"):  # a caster that does not swivel has no friction of a swivel
            low, high = quantity["range"]
            result[name] = (low * scale, quantity["value"] * scale, high * scale)
    return result


def slope_deviation(survey, intervals):
    """Standard deviation [%] of the slopes between points so many intervals apart."""
    run = survey["spacing_mm"] * intervals
    return 100 * statistics.stdev((line[i + intervals] - line[i]) / run
                                  for line in survey["heights_mm"] for i in range(len(line) - intervals))


def ends(value):
    """Low and high of a published value, in the unit of its constant."""
    return (value["value"],) * 2 if "value" in value else (value["low"], value["high"])


def number(value):
    """Three digits at most."""
    return f"{float(f'{value:.3g}'):g}"


def words(value):
    low, high = map(number, ends(value))
    return low if low == high else f"{low} to {high}"


def outside(value, of):
    """Names of the files whose range lies below a published value, and above it."""
    low, high = ends(value)
    compared = {name: of[name] for name in value.get("at", of) if name in of}
    return (compared, [name for name, (_, _, top) in compared.items() if top < low],
            [name for name, (bottom, _, _) in compared.items() if bottom > high])


def place(value, of):
    compared, below, above = outside(value, of)
    inside = len(compared) - len(below) - len(above)
    listed = "".join(f"; {side}: {', '.join(names)}" for side, names in (("below it", below), ("above it", above))
                     if names and len(names) < len(compared))
    if not compared:
        return ""
    side = "all below it" if len(below) == len(compared) else "all above it" if len(above) == len(compared) else ""
    return side or f"in {inside} of {len(compared)}{listed}"


def distributions(constant):
    """Lognormal distributions, median and dispersion, of measured and derived values of one kind, which two make; a
    range counts by its middle."""
    groups = {}
    for value in constant["values"]:
        if value["kind"] in ("measured", "derived") and not value.get("start") and constant["quantity"] != "slope":
            groups.setdefault(value.get("group", ""), []).append(math.log(math.prod(ends(value))) / 2)
    return {name: (math.exp(statistics.fmean(of)), statistics.stdev(of)) for name, of in groups.items() if len(of) > 1}


def given(constant):
    """What the published values give in place of a judgement."""
    deviations = [value["value"] for value in constant["values"] if value.get("deviation")]
    if deviations:
        return f"normal, {number(math.sqrt(statistics.fmean(x * x for x in deviations)))} (F_L 15, 20, 25 alike)"
    of = distributions(constant)
    if of:
        return "; ".join(f"{name + ': ' if name else ''}median {number(median)}, beta {beta:.2f}"
                         for name, (median, beta) in of.items())
    if not constant["values"]:
        return "nothing"
    return "bounds" if constant["values"][0]["kind"] == "required" else "single values"


def stated(of):
    """Values of the files and the ends of their ranges."""
    if not of:
        return ""
    lows, values, highs = zip(*of.values())
    middle = number(min(values)) if min(values) == max(values) else f"{number(min(values))} to {number(max(values))}"
    return f"{middle} ({number(min(lows))} to {number(max(highs))})" if (lows, highs) != (values, values) else middle


def quantities(constant):
    """Quantities of the files that a constant stands for."""
    path, items = constant["quantity"], [judgements.load("items", row["item"]) for row in rows_of("items.csv")]
    if path == "slope":
        return [judgements.load("levelness")[name] for name in ("slope", "cross_slope")]
    if path == "center_of_mass":
        return [item["chassis"]["center_of_mass_mm"] for item in items]
    if path == "mass":
        return [item["chassis"]["mass_kg"] for item in items] + [
            payload["mass_kg"] for item in items for payload in item.get("payload", [])]
    return [quantity for quantity in (found(file, path) for file in casters().values()) if quantity]


def completed(value, survey):
    """A published value with what follows from the hardness or the heights that it states."""
    if "hardness" in value:
        return value | {"value": tread_stiffness(value["hardness"]) / 1000}
    return value | {"value": slope_deviation(survey, value["intervals"])} if "intervals" in value else value


def constants():
    with open(os.path.join(HERE, "published.toml"), "rb") as file:
        return [constant | {"values": [completed(value, constant.get("survey")) for value in constant["values"]]}
                for constant in tomllib.load(file)["constant"]]


def analyses(tables):
    """How many analyses of constants.csv show that a constant matters, and of how many."""
    rows = read(tables, "constants.csv")
    shown = {}
    for row in rows:
        if float(row["p_holm"]) < SHOWN:
            shown.setdefault(row["constant"], set()).add((row["item"], row["brakes"]))
    return shown, len({(row["item"], row["brakes"]) for row in rows})


def kept_by_brake(sheet):
    """Least share of the drawn brakes of an item that hold HOLDS of the load of their own caster."""
    item = judgements.load("items", sheet["item"])
    of = {caster["name"]: caster["type"]["value"] if isinstance(caster["type"], dict) else caster["type"]
          for caster in item["caster"]}
    shares = []
    for wheel in sheet["wheels"]:
        file = casters()[of[wheel["caster"]]]
        spread = file["brake_torque_n_m"]["distribution"]
        needs = HOLDS * wheel["load_n"] * file["wheel_diameter_mm"]["value"] / 2000
        below, cut, above = (NORMAL.cdf(math.log(torque / spread["median"]) / spread["beta"])
                             for torque in (spread["low"], needs, spread["high"]))
        shares.append(1 - min(1, max(0, (cut - below) / (above - below))))
    return min(shares)


def summary(tables, sheets):
    shown, of = analyses(tables)
    for constant in constants():
        kinds = [judgements.kind(quantity) for quantity in quantities(constant)]
        matters = len(set().union(*(shown.get(name, set()) for name in constant["ranked"])))
        values = [value["kind"] for value in constant["values"]]
        unit = f" [{constant['unit']}]" if constant["unit"] else ""
        yield [constant["name"] + unit, f"{matters} of {of}" if constant["ranked"] else "not ranked",
               " + ".join(f"{values.count(kind)} {name}" for kind, name in KINDS.items() if kind in values) or "none",
               given(constant), stated(files(constant, sheets)) if constant["quantity"] != "mass" else "",
               f"{kinds.count('judged')} of {len(kinds)}"]


def computed(sheets):
    """The numbers that the words of published.toml name."""
    kept = {item: kept_by_brake(sheet | {"item": item}) for item, sheet in sheets.items()}
    least = min(kept, key=kept.get)
    percent = lambda share: f"{100 * share:.0f} %"
    return {"least": least, "least_held": percent(kept[least]), "most_held": percent(max(kept.values())), "load": LOAD,
            "radius": f"{1000 * RADIUS:.0f}", "width": f"{1000 * WIDTH:.0f}", "thickness": f"{1000 * THICKNESS:.0f}"}


def section(constant, sheets, numbers):
    name = constant["name"][0].upper() + constant["name"][1:]
    lines = ["", f"### {name}", "", *wrapped(constant["says"].format(**numbers) + ".")]
    of = files(constant, sheets) if constant["quantity"] not in ("mass", "slope") else {}
    if constant["values"]:
        unit = f" [{constant['unit']}]" if constant["unit"] else ""
        lines += ["", *table([f"published{unit}", "of", "kind", "by", "ranges of the files"],
                             ([words(value), value["of"], KINDS[value["kind"]], value["by"], place(value, of)]
                              for value in constant["values"]))]
    return lines + ["", *wrapped(f"For the next computation: {constant['next']}.")]


def changes(tables):
    """Medians with one constant changed over those of the catalogue."""
    rows = read(tables, "changes.csv")
    cells = []
    for change in dict.fromkeys(row["change"] for row in rows):
        for each in ratios_of(row for row in rows if row["change"] == change):
            cells.append([change, f"{each['brakes']}, {each['limit_state']}",
                          f"{each['ratio']} ({each['lowest']} to {each['highest']})", f"{each['within']} of {each['curves']}"])
    items = ", ".join(f"`{name}`" for name in dict.fromkeys(row["item"] for row in rows))
    return ["## What they would change", "",
            *wrapped(f"Medians of {items} upstairs in the flexible building, on an open floor, with one constant changed as "
                     "published values ask for, over those of the catalogue: geometric mean and ends, and how many lie "
                     "within the interval of the catalogue (`changes.csv`, by `studies/catalogue/changes.py`). Motions and "
                     "draws are the same. Rolling resistance: median 1.43 mm where a caster has less. Slope: the deviation "
                     "over 0.6 m, here of the whole floor. Brakes: none holds less than the standard asks for. More rolling "
                     "resistance keeps free items nearer, steeper floors let them go farther: the two cancel in part. Better "
                     "brakes make slim items fall earlier."), "",
            *table(["change", "brakes, limit state", "ratio", "within"], cells), ""]


def judged():
    """How many numbers of each item are published and judged: of all, and of the constants above."""
    of = {row["item"]: judgements.counts(row["item"]) for row in rows_of("items.csv")}
    total = {name: sum(each[name] for each in of.values()) for name in next(iter(of.values()))}
    share = (total["published in part"] + total["judged"]) / sum(total[name] for name in judgements.KINDS)
    return ["## What is a judgement", "",
            *wrapped("Quantities in the files of an item, its casters (each file once), its floor covering and the slope of "
                     "its floor: published, published in part (a measured value of something like it, or a part of the "
                     "value or of its distribution), judged, each with its reason and range in the file. Drawn: of the last "
                     f"two those with a distribution; the others stay at their values. In all {100 * share:.0f} % are judged, "
                     "in part or whole; none is measured on an item of its kind for this catalogue."), "",
            *table(["item", *judgements.KINDS, "drawn"], ([item, *each.values()] for item, each in of.items()))]


def page(tables, sheets):
    numbers = computed(sheets)
    return ["# Constants: what is published, what is judged", "",
            *wrapped("The constants that [are shown to matter](checks.md#record-parameters-chaos) for the displacement, with "
                     "the stiffness of treads and the friction of swivels: every published value that was found, the "
                     "distribution that they give, and what the files of `equipment` have, from which the catalogue was "
                     "computed. Found means read in a public text; tables of papers that are not public were not read. "
                     "Nothing in the files was changed for this page; what should be changed stands with each constant."), "",
            *wrapped("Matters: analyses of an item and a setting of its brakes in which it is shown. Gives: lognormal "
                     "distribution of measured and derived values, where there are two. Files: their values, and the ends of "
                     "their ranges (floor slope: standard deviation, and the most). Judged: quantities of the files of "
                     "the catalogue's items and casters without a source."), "",
            *table(["constant", "matters", "published values", "gives", "files", "judged"], summary(tables, sheets)), "",
            "## Published values", "",
            *wrapped("Kinds: measured; derived from a measured value by the step that is stated; asked for by a standard or a "
                     "maker; from a table to size drives with, which errs to the high side. Ranges of the files: in how many "
                     "of them the published value is."),
            *(line for constant in constants() for line in section(constant, sheets, numbers)), "",
            *changes(tables), *judged(), ""]
