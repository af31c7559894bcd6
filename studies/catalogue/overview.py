"""The overview of the catalogue, docs/catalogue/overview.html: choose floor, level, item and brakes, see risk and loss.

pages.py writes it; the numbers are those of losses.csv, fragility.csv, tethers.csv, contents.csv and floors.csv.
"""

import json
import os

from advice import (FLOOR, LIFE_SUPPORT, LIFE_SUPPORT_ITEMS, MOST_LOST, PLACE, SPEED, action, likely, most_kept, percent,
                    says, shares)
from losses import INJURIES, SETTLED, SETTINGS, SPEEDS, consequences, curves_of, injuring, probability
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
    return numbers | {"chances": chances, "action": action(row), "says": says(row), "shares": shares(row),
                      "named": likely(row)[0], "kept": most_kept(row), "decides": row["depends_on"]}


def straps(tables, item):
    """What straps do in the bay at the floor and velocity of the advice: days and chance of lost service."""
    return [{"held": row["held"]} | {quantity: [rounded(row[quantity + end]) for end in ("", "_low", "_high")]
                                     for quantity in ("days", "lost")}
            for row in read(tables, "tethers.csv") if row["item"] == item and "strap" in row["held"]]


def shut(tables):
    """Items that fall more often with brakes on where their drawers may open: twice as often as the rigid item."""
    rows = read(tables, "contents.csv")
    drawers = {row["item"] for row in rows if row["limit_state"] == "a drawer opens"}
    return {row["item"] for row in rows if row["item"] in drawers and row["brakes"] == "on" and
            row["limit_state"] == "overturned" and int(row["exceed"]) > 2 * int(row["rigid_exceed"])}


def facts(tables, advice, names):
    of, follows, locked = curves_of(tables), consequences(), shut(tables)
    hurts = lambda item, injury: [state for state in STATES if state in injuring(lambda q: follows(item, q), injury)]
    floors = list(dict.fromkeys(floor for _, floor, _ in of))
    moves = read(tables, "floors.csv")
    return {
        "speeds": SPEEDS, "settings": SETTINGS, "places": PLACES, "states": STATES,
        "shown": {"floor": FLOOR, "place": PLACE, "speed": float(SPEED)},
        "floors": {floor: ground_speeds([(float(row["pgv"]), float(row["pfv"])) for row in moves if row["floor"] == floor])
                   for floor in floors},
        "items": [{"item": item, "name": name, "life": item in LIFE_SUPPORT_ITEMS, "shut": item in locked, "straps": straps(tables, item),
                   "hurts": {injury: hurts(item, injury) for injury in INJURIES[1:]}, "rows": {floor: {place: [
            cells(advice, of[item, floor, place], {"item": item, "floor": floor, "place": place}, speed)
            for speed in SPEEDS] for place in PLACES} for floor in floors}} for item, name in names.items()],
    }


def page(tables, advice, names):
    with open(os.path.join(HERE, "overview.html"), encoding="utf-8") as file:
        text = file.read()
    text = text.replace("<!--LIFE_SUPPORT-->", LIFE_SUPPORT).replace("<!--MOST_LOST-->", percent(MOST_LOST))
    data = json.dumps(facts(tables, advice, names), separators=(",", ":"))
    return text.replace("/*DATA*/", data.replace("<", "\\u003c"))


def rows_of(path):
    """What a written page says, by item, floor, place and velocity as losses.csv has them."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    data = json.loads(text.split('<script type="application/json" id="data">')[1].split("</script>")[0])
    for item in data["items"]:
        for floor, places in item["rows"].items():
            for place, rows in places.items():
                for speed, row in zip(data["speeds"], rows):
                    yield (item["item"], floor, place, str(speed)), row


def untrue(tables, path):
    """Where the words of a written page are not true of losses.csv; without the rules of advice.py."""
    numbers = {(r["item"], r["floor"], r["place"], r["pfv"]): r for r in read(tables, "losses.csv")}
    for where, row in rows_of(path):
        of = numbers[where]
        lost = {s: round(100 * float(of["lost_" + s])) for s in SETTINGS}
        share = {s: float(of["share_" + s]) for s in SETTINGS}
        few = [s for s in SETTINGS if f"{s}: fewest days" in row["says"]]
        named = row["says"].partition(": keeps it in service")[0].rpartition("; ")[2]
        kept = [s for s in SETTINGS if s in named.split(" or ") and "keeps it in service" in row["says"]]
        none = "do not keep it in service" in row["says"]
        told = [s for s in SETTINGS if f"{s} {percent(share[s])} %" in row["shares"]]
        yield from (f"{', '.join(where)}: '{row['says']}', '{row['shares']}' where {wrong}" for wrong, it_is in (
            ("a setting keeps it in service", none and min(lost.values()) <= 100 * MOST_LOST),
            ("no setting keeps it in service", not none and min(lost.values()) > 100 * MOST_LOST),
            ("that setting loses it", any(lost[s] > 100 * MOST_LOST for s in kept)),
            ("that setting keeps it in service", any(lost[s] <= 100 * MOST_LOST for s in few)),
            ("the advised setting loses it", row["action"] in SETTINGS and lost[row["action"]] > 100 * MOST_LOST),
            ("another is likelier", share[row["named"]] < min(SETTLED, max(share.values()))),
            ("half of the samples have another", len(told) < 2 and max(share[s] for s in told) < 0.5),
            ("it is lost less often", lost[row["kept"]] > min(lost.values()))) if it_is)
