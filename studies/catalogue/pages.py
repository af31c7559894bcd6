"""Writes the pages of the fragility catalogue, docs/catalogue, from the tables of tables.py.

usage: pages.py GURNEY RESULTS TABLES PAGES
       pages.py --texts GURNEY TABLES PAGES
       pages.py --check GURNEY TABLES PAGES

PAGES gets items.md and overview.html, a page for each item, checks.md, constants.md, contents.md and tethers.md, and figures of the items; with
--texts no figures, which need the results of all runs. --check writes nothing and ends with 1 where the texts of the
pages are not those of the tables, or where the advice of overview.html is not what its numbers say.
"""

import json
import os
import statistics
import subprocess
import sys

import checks
import overview
import published
from advice import (ACTIONS, FLOOR, LIFE_SUPPORT, MOST_LOST, MOTION_COUNT, PLACE, SETTING_WORDS, SPEED, Advice, action,
                    days, interval_words, keepers, mark, percent, says, shares)
from catalogue import LEVELS_OF_CURVES, VARIANCE, rows, sheet_of
from contents import SHARED, VARIANTS
from losses import INJURIES, SETTINGS, consequences, curves_of, injuring, reached
from tables import FURTHER, much_better
from words import read, wrapped

WHERE = (FLOOR, PLACE)  # of the overview
MAPPED = (0.4, 0.8, 1.2)  # [m/s] of the speeds of losses.csv
MOVED = ["moved 0.1 m", "moved 0.3 m", "moved 1 m"]
HIT = ["hit at 0.4 m/s", "hit at 0.8 m/s"]
HIGHEST = 2 * max(LEVELS_OF_CURVES)  # extrapolated medians above say only that [m/s]
SHOWN = 0.05  # of p, adjusted for the number of constants


CAUTION = ("Synthetic motions, and mostly assumed parameters of a class of items ([sources](../equipment.md#items)): "
           "[not for a make, a site or attachments](methods.md#what-it-must-not-be-used-for).")


def cell(row):
    if row["theta"]:
        mark = "*" if row["cautions"] and ("only" in row["cautions"] or "extrapolated" in row["cautions"]) else ""
        if mark and float(row["theta"]) > HIGHEST:
            return f"> {HIGHEST:g}*"
        return f"{float(row['theta']):.2f} ({float(row['beta']):.2f}){mark}"
    return f"{row['exceed']}/{row['runs']}"


class Catalogue:
    def __init__(self, tables):
        rows = [row for row in read(tables, "fragility.csv") if row["measure"] == "pfv"]
        self.rows = {(r["item"], r["floor"], r["place"], r["brakes"], r["limit_state"]): r
                     for r in rows + read(tables, "more_states.csv")}
        self.items = sorted({r["item"] for r in rows})
        self.floors = list(dict.fromkeys(r["floor"] for r in rows))
        self.measures = read(tables, "measures.csv")
        self.variance = read(tables, "variance.csv")
        self.constants = read(tables, "constants.csv")
        self.measure_of = {(r["item"], r["floor"], r["place"], r["brakes"]): r for r in self.measures}


def decisions(advice, names):
    """Each action with its items, the one to read first; with the settings where they conflict."""
    def named(item):
        row = advice.row(item)
        if action(row) == "conflict":
            return f"[{names[item]}]({item}.md) ({says(row)})"
        kept = " or ".join(keepers(row))
        return f"[{names[item]}]({item}.md)" + (f" ({kept} keeps it in service)" if kept else "")

    lines = []
    for each, words in ACTIONS.items():
        items = [named(item) for item in names if action(advice.row(item)) == each]
        if items:
            lines += wrapped(f"- **{words}** ({len(items)}): {', '.join(items)}", "  ")
    return lines


def loss_of_all(advice, names):
    lines = ["| item | days, brakes off | on | locked | lost [%], off | on | locked | |",
             "| --- | --- | --- | --- | --- | --- | --- | --- |"]
    for item, name in names.items():
        cells = " | ".join(advice.words(item, quantity, setting)
                           for quantity in ("days", "lost") for setting in SETTINGS)
        lines.append(f"| [{name}]({item}.md) | {cells} | {says(advice.row(item)).lower()} |")
    return lines


def injuries(tables, names):
    """Chances [%] that somebody beside an item may be hurt, at the floor, place and velocity of the advice."""
    follows, curves = consequences(), curves_of(tables)
    lines = ["| item | seriously [%], brakes off | on | locked | at all, off | on | locked |", "| --- " * 7 + "|"]
    for item, name in names.items():
        cells = []
        for injury in INJURIES[:0:-1]:
            states = injuring(lambda quantity: follows(item, quantity), injury)
            found = reached(curves[item, FLOOR, PLACE], states, float(SPEED), f"{item} {injury}")
            cells += ["{} ({} to {})".format(*map(percent, found[setting])) for setting in SETTINGS]
        lines.append(f"| [{name}]({item}.md) | " + " | ".join(cells) + " |")
    return lines


def action_map(advice, floors, names, place):
    """The setting with the fewest days, by floor and level."""
    columns = [f"{floor.removesuffix(' building')} {speed}" for floor in floors for speed in MAPPED]
    lines = ["| item | " + " | ".join(columns) + " |", "| --- " * (1 + len(columns)) + "|"]
    for item, name in names.items():
        marks = (mark(advice.row(item, floor, place, speed)) for floor in floors for speed in MAPPED)
        lines.append(f"| [{name}]({item}.md) | " + " | ".join(marks) + " |")
    return lines


def tether_table(rows, names):
    """Table of what straps do in the bay: loss, chance of lost service, hits and falls of all runs, way, turn, tension."""
    lines = ["| item | held by | days | lost [%] | hit at 0.8 m/s | overturned | way [m] | turn [deg] | tension [kN] | broken |",
             "| --- " * 10 + "|"]

    def ends(row, quantity, unit, digits):
        both = (row[quantity + end] for end in ("_median", "_p95"))
        return " to ".join(f"{float(end) / unit:.{digits}f}" for end in both if end)

    for row in rows:
        cells = [f"[{names[row['item']]}]({row['item']}.md)", row["held"], interval_words(row, "days", days),
                 interval_words(row, "lost", percent), f"{row['hit at 0.8 m/s']}/{row['runs']}",
                 f"{row['overturned']}/{row['runs']}", ends(row, "displacement_m", 1, 2), ends(row, "yaw_deg", 1, 0),
                 ends(row, "tension_n", 1000, 1), row["broken"]]
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def held_medians(rows):
    """Medians of the items: chance of lost service and way, by how they are held."""
    def median(held, column):
        return statistics.median(float(row[column]) for row in rows if row["held"] == held)

    return "; ".join(f"{held} {percent(median(held, 'lost'))} % and {median(held, 'displacement_m_median'):.1f} m"
                     for held in dict.fromkeys(row["held"] for row in rows))


def tethers_page(rows, names):
    return ["# What straps do", "",
            *wrapped("Items in their bay, upstairs in the flexible building, held by nothing, by their brakes, and by straps "
                     "to the wall behind them ([method](methods.md#tethers)). Days out of use and chance of lost service at "
                     f"a peak floor velocity of {SPEED} m/s; runs that exceed of those at all levels; median and 95 % of "
                     "the largest displacement, yaw and tension at a PGV of 0.8 m/s; straps that broke, of all runs."), "",
            *wrapped("Two straps keep an item where its lines reach, and throw it against the wall: lost service becomes "
                     "rarer, hits more frequent, and at 3 kN many straps break. By days out of use straps of this "
                     f"kind gain little or lose, unless the wall or the item is padded: what a hit costs decides. A strap with "
                     "brakes loses service least. Medians of the items, lost service and way: "
                     f"{held_medians(rows)}. {CAUTION}"), "",
            *tether_table(rows, names), ""]


def contents_table(rows, names):
    """What is lost of each variant with parts, and in brackets runs that exceed of the rigid item."""
    states = list(dict.fromkeys(row["limit_state"] for row in rows))
    states.sort(key=lambda state: (state in SHARED, SHARED.index(state) if state in SHARED else 0))
    lines = ["| item, with | brakes | " + " | ".join(states) + " |", "| --- " * (2 + len(states)) + "|"]
    for item, brakes in dict.fromkeys((row["item"], row["brakes"]) for row in rows):
        of = {row["limit_state"]: row for row in rows if (row["item"], row["brakes"]) == (item, brakes)}
        cells = []
        for state in states:
            row = of.get(state)
            rigid = f"; {row['exceed']}, rigid {row['rigid_exceed']}" if row and row["rigid_exceed"] else ""
            cells.append(cell(row) + rigid if row else "")
        variant = next(iter(of.values()))["variant"]
        lines.append(f"| [{names[item]}]({item}.md), {variant} | {brakes} | " + " | ".join(cells) + " |")
    return lines


def contents_page(rows, names):
    missing = [f"`{item}`" for item in VARIANTS if item not in {row["item"] for row in rows}]
    return ["# What opens and what falls", "",
            *wrapped("Items whose file has a variant with parts and contents ([which](../equipment.md#variants-with-parts-and-"
                     f"contents)), {WHERE[0]}, open floor, with the motions, levels and draws of the catalogue "
                     "([contents.csv](data/contents.csv), by `studies/catalogue/contents.py`). Median peak floor velocity "
                     "[m/s] (logarithmic standard deviation), or runs that exceed ([legend](methods.md#pages-of-the-items)); "
                     "then runs of 128 that exceed, and of the rigid item of the other pages. What falls, opens or is shaken "
                     "counts an item that overturns as well, as its run ends there. The sensitive point is on the part "
                     "that carries it: the patient's head, the tray under the infant, the monitor that tilts. Locks of "
                     "drawers are off. Nearly all numbers of the "
                     f"parts are assumptions: {CAUTION[0].lower() + CAUTION[1:]}"), "",
            *contents_table(rows, names), "",
            *wrapped("**Drawers that open carry the centre of mass out of the base**: where the row of an item with brakes on "
                     "overturns more often than the rigid one, lock its drawers before its brakes are set. The advice of the "
                     "other pages is for items whose parts stay shut."), "",
            *wrapped("**A mattress spares the patient; a flexible pole or column shakes what it carries**: 1 g at the "
                     "sensitive point takes more velocity than with the rigid bed, and less than with the rigid pole or "
                     "stand, brakes off."), "",
            *(wrapped(f"Not run: {', '.join(missing)}.") + [""] if missing else [])]


def parts_line(rows, item):
    """What parts that move change of an item's falls; nothing where it has no such variant."""
    of = [row for row in rows if (row["item"], row["limit_state"]) == (item, "overturned")]
    return [*wrapped("With its parts free ([what opens and what falls](contents.md)) it overturns in " + ", in ".join(
        f"{row['exceed']} of {row['runs']} runs with {SETTING_WORDS[row['brakes']]}, rigid {row['rigid_exceed']}"
        for row in of) + "."), ""] if of else []


def overview_page(tables, advice, names, floors):
    return ["# What to brake, what to hold, what to leave", "",
            *wrapped("The action with the least expected time out of use at a peak floor velocity of "
                     f"{SPEED} m/s, upstairs in a flexible building, on an open floor, from {MOTION_COUNT} motions "
                     f"([rule](methods.md#what-to-do)). {CAUTION}"), "",
            *wrapped("**[Choose](overview.html)** floor, place, velocity and how many you have: a page of its own, which needs "
                     "no network."), "",
            *decisions(advice, names), "",
            *wrapped("Keeps it in service: the chance that its service is lost (moved 1 m, or overturned) is not "
                     f"above {percent(MOST_LOST)} %. {LIFE_SUPPORT} Drawers and doors are shut: with drawers "
                     "that may open, braked carts fall far more often ([what opens and what falls](contents.md))."), "",
            *wrapped("Straps keep more items in service, and throw them against the wall: [what they do](tethers.md). "
                     "What a fall or a torn line costs is an assumption with a range (`equipment/consequences.toml`): "
                     "put in what they cost you ([how](methods.md#what-to-do))."), "",
            "Days out of use and chance that its service is lost, with intervals of 95 %:", "",
            *loss_of_all(advice, names), "",
            "## Who may be hurt", "",
            *wrapped("Chance of a state in which somebody beside the item may be hurt seriously (it overturns), or at all "
                     "(it also moves 1 m or is hit at 0.4 m/s or more), with intervals of 95 %. Which state may hurt, and "
                     "how badly, is assumed (`equipment/consequences.toml`), and nobody needs to stand there: no number of "
                     "injured."), "",
            *injuries(tables, names), "",
            "## By floor and level", "",
            *wrapped("Floor and peak floor velocity [m/s]: the brakes with the fewest days (off, on, locked: on with "
                     "locked swivels); `?`: not settled, with the likeliest where it has the fewest days in at least "
                     "half of the samples; `+`: with every setting its service is lost in more than "
                     f"{percent(MOST_LOST)} %; `/on`: with the likeliest it is lost so often, with on it is not."), "",
            "Open floor:", "", *action_map(advice, floors, names, "open"), "",
            "Bay, with walls behind and beside it:", "", *action_map(advice, floors, names, "bay"), ""]


def item_table(catalogue, item, place):
    limits = MOVED + (HIT if place == "bay" else []) + ["overturned"]
    lines = ["| floor | brakes | " + " | ".join(limits) + " |", "| --- " * (2 + len(limits)) + "|"]
    for floor in catalogue.floors:
        for brakes in SETTINGS:
            cells = [cell(catalogue.rows[item, floor, place, brakes, limit]) for limit in limits]
            mark = "†" if much_better(catalogue.measure_of[item, floor, place, brakes]) else ""
            lines.append(f"| {floor.removesuffix(' building')} | {brakes}{mark} | " + " | ".join(cells) + " |")
    return lines


def loss_table(catalogue, advice, item):
    lines = ["| floor | place | brakes off | on | locked | fewest | advice |", "| --- " * 7 + "|"]
    for floor in catalogue.floors:
        for place in ("open", "bay"):
            row = advice.row(item, floor, place)
            cells = " | ".join(interval_words(row, f"days_{setting}", days) for setting in SETTINGS)
            lines.append(f"| {floor.removesuffix(' building')} | {place} | {cells} | {shares(row)} | "
                         f"{says(row).lower()} |")
    return lines


def further_table(catalogue, item):
    lines = ["| place | brakes | " + " | ".join(FURTHER) + " |", "| --- " * (2 + len(FURTHER)) + "|"]
    for place in ("open", "bay"):
        for brakes in SETTINGS:
            cells = [cell(catalogue.rows[item, WHERE[0], place, brakes, limit]) for limit in FURTHER]
            lines.append(f"| {place} | {brakes} | " + " | ".join(cells) + " |")
    return lines


def share_cell(row, part):
    middle, low, high = (f"{100 * float(row[part + end]):.0f}" for end in ("", "_low", "_high"))
    return f"{middle} ({low} to {high})"


def variance_table(catalogue, item):
    parts = ["record", "parameters", "chaos"]
    lines = ["| brakes | of | " + " | ".join(f"{part} [%]" for part in parts) + " |", "| --- " * (2 + len(parts)) + "|"]
    for row in catalogue.variance:
        if row["item"] == item:
            cells = " | ".join(share_cell(row, part) for part in parts)
            lines.append(f"| {row['brakes']} | {row['response']} | {cells} |")
    return lines


def constants_line(catalogue, item):
    """The constants whose influence on the displacement is shown, or the strongest of those that are not."""
    own = [row for row in catalogue.constants if row["item"] == item]
    words = lambda row: (f"`{row['constant']}` (brakes {row['brakes']}: {row['correlation']}, "
                         f"p {float(row['p_holm']):.3f})")
    shown = [words(row) for row in own if float(row["p_holm"]) < SHOWN]
    if shown:
        return "To be measured first, by rank correlation with the displacement: " + ", ".join(shown) + "."
    strongest = min(own, key=lambda row: float(row["p"]))
    draws = VARIANCE["draws"] * MOTION_COUNT
    return f"No constant is shown to matter in {draws} draws; the strongest is {words(strongest)}."


def best_measures(catalogue, item):
    """How often each measure predicts the displacement best."""
    count = {}
    for row in catalogue.measures:
        if row["item"] == item and row["best"]:
            count[row["best"]] = count.get(row["best"], 0) + 1
    ranked = sorted(count.items(), key=lambda each: (-each[1], each[0]))
    return ", ".join(f"{name} ({n})" for name, n in ranked[:3])


def item_page(catalogue, advice, item, sheet, parts):
    size = " x ".join(f"{1000 * each:.0f}" for each in sheet["size_m"])
    return [
        f"# {sheet['name']}", "", *wrapped(sheet["description"] + "."), "",
        *wrapped(f"{sheet['mass_kg']:.0f} kg, {size} mm, base over height {sheet['base_over_height']:.2f}, tips from "
                 f"{sheet['tips_from_g']:.2f} g where its wheels cannot roll. Data: `equipment/items/{item}.toml`."), "",
        *wrapped(f"{advice.line(item)} ([rule](methods.md#what-to-do)). {CAUTION}"), "",
        *parts_line(parts, item),
        f"![Plan and sides](images/{item}.svg)", "",
        f"![Fragility on an upper floor of the flexible building](images/{item}_fragility.svg)", "",
        "## Expected days out of use", "",
        *wrapped(f"At a peak floor velocity of {SPEED} m/s, with intervals of 95 %; fewest: setting, share of the "
                 "samples ([rule](methods.md#what-to-do)):"), "",
        *loss_table(catalogue, advice, item), "",
        "## Fragility", "",
        "Median peak floor velocity [m/s] (logarithmic standard deviation) or runs that exceed",
        "([legend](methods.md#pages-of-the-items)). Open floor:", "",
        *item_table(catalogue, item, "open"), "",
        "Bay:", "",
        *item_table(catalogue, item, "bay"), "",
        f"[Further limit states](methods.md#further-limit-states), {WHERE[0]}:", "",
        *further_table(catalogue, item), "",
        "## Sources of scatter", "",
        f"[Shares of the variance](checks.md#record-parameters-chaos) at a PGV of 0.8 m/s, {WHERE[0]}:", "",
        *variance_table(catalogue, item), "",
        *wrapped(constants_line(catalogue, item) + " [Method](checks.md#record-parameters-chaos)."), "",
        *wrapped("Best predictors of the peak displacement (configurations; [all](data/measures.csv)): "
                 f"{best_measures(catalogue, item)}."), ""]


def figures(gurney, item, results, images):
    def run(*arguments):
        subprocess.run([gurney, *arguments, "--overwrite"], check=True, stdout=subprocess.DEVNULL)

    run("equipment", "show", item, "--figure", os.path.join(images, item + ".svg"))
    chosen = [f"{WHERE[0]}, {WHERE[1]}, {brakes}" for brakes in SETTINGS]
    run("fragility", os.path.join(results, item + ".h5"), "--measure", "pfv",
        *[word for name in chosen for word in ("--configuration", name)],
        *[word for limit in ("moved 0.3 m", "moved 1 m", "overturned") for word in ("--limit", limit)],
        "--figure", os.path.join(images, item + "_fragility.svg"))


def texts(gurney, tables):
    """Each page by its name."""
    catalogue, advice = Catalogue(tables), Advice(tables)
    sheets = {item: sheet_of(gurney, item) for item in catalogue.items}
    parts = read(tables, "contents.csv")
    pages = {item + ".md": item_page(catalogue, advice, item, sheet, parts) for item, sheet in sheets.items()}
    names = {item: sheet["name"] for item, sheet in sheets.items()}
    pages["items.md"] = overview_page(tables, advice, names, catalogue.floors)
    pages["checks.md"] = checks.page(tables)
    pages["constants.md"] = published.page(tables, sheets)
    pages["contents.md"] = contents_page(parts, names)
    pages["tethers.md"] = tethers_page(read(tables, "tethers.csv"), names)
    return {name: "\n".join(lines) for name, lines in pages.items()} | {
        "overview.html": overview.page(tables, advice, names)}


def stale(gurney, tables, folder):
    for name, text in texts(gurney, tables).items():
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            if file.read() != text:
                yield f"{name} is not what pages.py writes"
    yield from overview.untrue(tables, os.path.join(folder, "overview.html"))


def main():
    mode, arguments = (sys.argv[1], sys.argv[2:]) if sys.argv[1:2] in (["--check"], ["--texts"]) else ("", sys.argv[1:])
    if len(arguments) != (3 if mode else 4):
        sys.exit(__doc__)
    if mode == "--check":
        sys.exit("\n".join(stale(*arguments)) or 0)
    gurney, tables, pages = arguments[0], *arguments[-2:]
    os.makedirs(os.path.join(pages, "images"), exist_ok=True)
    for name, text in texts(gurney, tables).items():
        if not mode and name.removesuffix(".md") in {row["item"] for row in rows("items.csv")}:
            figures(gurney, name.removesuffix(".md"), arguments[1], os.path.join(pages, "images"))
        with open(os.path.join(pages, name), "w", encoding="utf-8") as file:
            file.write(text)


if __name__ == "__main__":
    main()
