"""What to do with an item, by the rule of docs/catalogue/methods.md, from losses.csv.

It is the setting of the brakes with the least expected loss, unless even that leaves it out of service too often.
"""

from catalogue import motion_rows
from losses import SETTLED, SETTINGS
from words import read

MOTION_COUNT = len(motion_rows())
FLOOR, PLACE, SPEED = "flexible building", "open", "0.8"  # of the advice; peak floor velocity [m/s]
MOST_LOST = 0.1  # chance that it serves no longer, above which brakes alone are not enough; an assumption
ACTIONS = {
    "hold": "Brakes do not keep it in service",
    "on": "Set the brakes",
    "locked": "Set the brakes, lock the swivels",
    "off": "Leave the brakes off",
    "open": "Not settled",
}
SETTING_WORDS = {"off": "brakes off", "on": "brakes on", "locked": "brakes on and swivels locked"}


def percent(value):
    return "0" if value < 0.005 else f"{100 * value:.0f}"


def days(value):
    return f"{value:.2f}" if value < 10 else f"{value:.0f}"


def interval_words(row, name, text):
    """Mean and interval of a quantity of a row, such as `0.15 (0.03 to 1.21)`."""
    middle, low, high = (text(float(row[name + end])) for end in ("", "_low", "_high"))
    return f"{middle} ({low} to {high})"


class Advice:
    def __init__(self, tables):
        self.rows = {(r["item"], r["floor"], r["place"], r["pfv"]): r for r in read(tables, "losses.csv")}

    def row(self, item, floor=FLOOR, place=PLACE, speed=SPEED):
        return self.rows[item, floor, place, str(speed)]

    def settled(self, row):
        return float(row["share"]) >= SETTLED and row["best"] == row["best_by_cost"]

    def action(self, item, **where):
        row = self.row(item, **where)
        if not self.settled(row):
            return "open"
        return "hold" if float(row["lost_" + row["best"]]) > MOST_LOST else row["best"]

    def words(self, item, quantity, setting, **where):
        """Mean and interval of the days out of use, or of the chance of lost service [%]."""
        text = {"days": days, "lost": percent}[quantity]
        return interval_words(self.row(item, **where), f"{quantity}_{setting}", text)

    def reason(self, item):
        row, best = self.row(item), self.row(item)["best"]
        loss = ", ".join(f"{self.words(item, 'days', s)} with {SETTING_WORDS[s]}" for s in SETTINGS)
        text = f"expected days out of use {loss}"
        action = self.action(item)
        if action == "hold":
            return (f"even with {SETTING_WORDS[best]}, where it loses least, its service is lost in "
                    f"{self.words(item, 'lost', best)} %; {text}. [What straps do](tethers.md)")
        if action == "open":
            share = percent(float(row["share"]))
            text += f"; {SETTING_WORDS[best]} loses least in {share} % of the samples"
            if row["best_by_cost"] != best:
                text += f"; by cost {SETTING_WORDS[row['best_by_cost']]} loses least"
            if row["depends_on"]:
                text += f"; it depends on what follows from: {row['depends_on'].replace(';', ',')}"
            return text
        return f"{text}; least in {percent(float(row['share']))} % of the samples"

    def line(self, item):
        return f"**{ACTIONS[self.action(item)]}**: {self.reason(item)}"

    def mark(self, item, **where):
        """Setting with the least loss, `?` where it is not settled, `+` where brakes do not keep it in service."""
        row = self.row(item, **where)
        lost = float(row["lost_" + row["best"]]) > MOST_LOST
        return row["best"] + ("" if self.settled(row) else "?") + ("+" if lost else "")
