"""The overview of the catalogue, docs/catalogue/overview.html: choose floor, level, item and brakes, see risk and loss.

pages.py writes it; the numbers are those of losses.csv, fragility.csv and floors.csv.
"""

import json
import os

from advice import FLOOR, PLACE, SPEED
from losses import SETTINGS, SPEEDS, curves_of, probability
from words import read

HERE = os.path.dirname(os.path.abspath(__file__))
PLACES = ("open", "bay")
STATES = ("moved 0.1 m", "moved 0.3 m", "moved 1 m", "hit at 0.4 m/s", "hit at 0.8 m/s", "overturned")


def rounded(value):
    """Two digits: what is drawn."""
    number = float(f"{float(value):.2g}")
    return int(number) if number.is_integer() else number


def ground_speeds(levels):
    """PGV of the ground at which the median peak velocity of a floor is each of SPEEDS, linear between the levels that
    were run; none outside of them."""
    levels = sorted(levels, key=lambda level: level[1])

    def at(speed):
        for (low, pfv_low), (high, pfv_high) in zip(levels, levels[1:]):
            if pfv_low <= speed <= pfv_high:
                return float(f"{low + (high - low) * (speed - pfv_low) / (pfv_high - pfv_low):.2g}")
        return None

    return [at(speed) for speed in SPEEDS]


def cells(advice, curves, where, speed):
    row = advice.row(**where, speed=speed)
    numbers = {quantity: [[rounded(row[f"{quantity}_{setting}{end}"]) for end in ("", "_low", "_high")]
                          for setting in SETTINGS] for quantity in ("days", "lost")}
    chances = [[rounded(f"{probability(curves[setting][state], speed, 0):.2f}") for state in STATES]
               for setting in SETTINGS]
    return numbers | {"chances": chances, "action": advice.action(**where, speed=speed), "best": row["best"],
                      "share": float(row["share"]), "cheapest": row["best_by_cost"], "decides": row["depends_on"]}


def facts(tables, advice, names):
    of = curves_of(tables)
    floors = list(dict.fromkeys(floor for _, floor, _ in of))
    moves = read(tables, "floors.csv")
    return {
        "speeds": SPEEDS, "settings": SETTINGS, "places": PLACES, "states": STATES,
        "shown": {"floor": FLOOR, "place": PLACE, "speed": float(SPEED)},
        "floors": {floor: ground_speeds([(float(row["pgv"]), float(row["pfv"])) for row in moves if row["floor"] == floor])
                   for floor in floors},
        "items": [{"item": item, "name": name, "rows": {floor: {place: [
            cells(advice, of[item, floor, place], {"item": item, "floor": floor, "place": place}, speed)
            for speed in SPEEDS] for place in PLACES} for floor in floors}} for item, name in names.items()],
    }


def page(tables, advice, names):
    with open(os.path.join(HERE, "overview.html"), encoding="utf-8") as file:
        template = file.read()
    return template.replace("/*DATA*/", json.dumps(facts(tables, advice, names), separators=(",", ":")).replace("<", "\\u003c"))
