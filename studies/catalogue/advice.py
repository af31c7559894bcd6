"""What to do with an item, by the rule of docs/catalogue/methods.md, from probabilities.csv and brakes.csv.

A thing is "shown" where its interval of 95 % says so; what the motions neither show nor exclude is not
advised upon.
"""

import csv
import os

from catalogue import motion_rows

MOTION_COUNT = len(motion_rows())
SPEED = "0.8"  # [m/s] peak floor velocity of the advice
FEW = 0.05  # a probability that counts as small
MOST = 0.15  # that a small probability must not reach with its upper end; 0 of 32 motions exclude 0.11
ACTIONS = {
    "high": "Tether it high",
    "tether": "Tether it",
    "leave": "Leave it",
    "brake": "Set the brakes",
    "alike": "No difference shown",
    "open": "Not decided",
}


def percent(value):
    return "0" if value < 0.005 else f"{100 * value:.0f}"


def read(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        return list(csv.DictReader(file))


class Advice:
    def __init__(self, tables):
        self.probabilities = {(r["item"], r["brakes"], r["limit_state"], r["pfv"]): r
                              for r in read(tables, "probabilities.csv")}
        self.brakes = {(r["item"], r["brakes"], r["limit_state"]): r for r in read(tables, "brakes.csv")}

    def interval(self, item, brakes, limit):
        """Probability, 0 where no curve gives one, and the ends of its interval."""
        row = self.probabilities[item, brakes, limit, SPEED]
        return float(row["probability"] or 0), float(row["low"]), float(row["high"])

    def words(self, item, brakes, limit):
        middle, low, high = self.interval(item, brakes, limit)
        return f"{percent(middle)} % ({percent(low)} to {percent(high)} %)"

    def overturns(self, item, brakes):
        middle, low, high = self.interval(item, brakes, "overturned")
        if low > FEW:
            return "shown"
        return "small" if middle <= FEW and high <= MOST else "open"

    def shortens(self, item):
        """Do brakes keep it within 1 m more often? The interval of the paired difference says so."""
        return float(self.brakes[item, "on", "moved 1 m"]["high"]) < 0

    def action(self, item):
        free, on, locked = (self.overturns(item, brakes) for brakes in ("off", "on", "locked"))
        if free == "shown":
            return "high"
        if on == "shown" or (locked == "shown" and on != "small"):
            return "tether"
        if self.interval(item, "off", "moved 1 m")[2] <= MOST:
            return "leave"
        if not self.shortens(item):
            return "alike"
        return "brake" if on == "small" else "open"

    def reason(self, item):
        action = self.action(item)
        if action == "high":
            return f"it overturns even on free casters, {self.words(item, 'off', 'overturned')}"
        if action == "tether":
            worse = "on" if self.overturns(item, "on") == "shown" else "locked"
            return f"with its brakes {worse} it overturns, {self.words(item, worse, 'overturned')}"
        if action == "leave":
            return f"free it moves 1 m in {self.words(item, 'off', 'moved 1 m')}"
        if action == "brake":
            unless = ", but do not lock its swivels" if self.overturns(item, "locked") == "shown" else ""
            falls = self.words(item, "on", "overturned")
            return f"it moves 1 m less often, and overturning is not shown, {falls}{unless}"
        if action == "alike":
            return f"{MOTION_COUNT} motions do not show that its brakes shorten its way"
        return (f"its brakes shorten its way; whether it then overturns {MOTION_COUNT} motions neither show nor exclude, "
                f"{self.words(item, 'on', 'overturned')}")

    def line(self, item):
        return f"**{ACTIONS[self.action(item)]}**: {self.reason(item)}"
