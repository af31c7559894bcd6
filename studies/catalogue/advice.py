"""What to do with an item, by the rule of docs/catalogue/methods.md, from losses.csv.

It is the setting of the brakes with the fewest expected days out of use, where that is settled and keeps the item in
service. All pages take it from here.
"""

from catalogue import motion_rows
from losses import SETTLED, SETTINGS
from words import read

MOTION_COUNT = len(motion_rows())
FLOOR, PLACE, SPEED = "flexible building", "open", "0.8"  # of the advice; peak floor velocity [m/s]
MOST_LOST = 0.1  # chance that it serves no longer, above which a setting does not keep it in service; an assumption
HALF = 0.5  # share of the samples below which no setting is named as the one with the fewest days
ACTIONS = {
    "hold": "Brakes do not keep it in service",
    "conflict": "One setting has the fewest days, another keeps it in service",
    "on": "Set the brakes",
    "locked": "Set the brakes, lock the swivels",
    "off": "Leave the brakes off",
    "open": "Not settled",
}
LIFE_SUPPORT = ("For life support (ventilator, incubator, pumps) what counts is that it serves on, not the days: take "
                "the setting that keeps it in service.")
LIFE_SUPPORT_ITEMS = ("icu_ventilator", "infusion_pole", "neonatal_incubator", "transport_incubator")
SETTING_WORDS = {"off": "brakes off", "on": "brakes on", "locked": "brakes on and swivels locked"}


def percent(value):
    return "0" if value < 0.005 else f"{100 * value:.0f}"


def days(value):
    return f"{value:.2f}" if value < 10 else f"{value:.0f}"


def interval_words(row, name, text):
    """Mean and interval of a quantity of a row, such as `0.15 (0.03 to 1.21)`."""
    middle, low, high = (text(float(row[name + end])) for end in ("", "_low", "_high"))
    return f"{middle} ({low} to {high})"


def keeps(row, setting):
    """Whether it keeps the item in service, by the chance in whole percent, as it is shown."""
    return round(100 * float(row["lost_" + setting])) <= 100 * MOST_LOST


def most_kept(row):
    """The setting whose service is lost least often."""
    return min(SETTINGS, key=lambda setting: float(row["lost_" + setting]))


def share(row, setting):
    """Share of the samples in which a setting has the fewest days."""
    return float(row["share_" + setting])


def settled(row):
    return share(row, row["best"]) >= SETTLED and row["best"] == row["best_by_cost"]


def likely(row):
    """Settings that may have the fewest days, the likeliest first: one where it is settled, else the two likeliest."""
    if settled(row):
        return [row["best"]]
    ranked = sorted(SETTINGS, key=lambda setting: (-share(row, setting), setting != row["best"]))
    return ranked[:1] if share(row, ranked[0]) >= SETTLED else ranked[:2]


def action(row):
    if not any(keeps(row, setting) for setting in SETTINGS):
        return "hold"
    if not settled(row):
        return "open"
    return row["best"] if keeps(row, row["best"]) else "conflict"


def keeper(row):
    """The setting that keeps an item in service where one that may have the fewest days does not; or None. It is the
    likeliest that does, or the one whose service is lost least often."""
    keeping = [setting for setting in likely(row) if keeps(row, setting)]
    if action(row) == "hold" or keeping == likely(row):
        return None
    return keeping[0] if keeping else most_kept(row)


def keepers(row):
    """Settings named as those that keep an item in service: its keeper, or where nothing is settled all that do if not
    every one does."""
    if keeper(row):
        return [keeper(row)]
    keeping = [setting for setting in SETTINGS if keeps(row, setting)]
    return keeping if action(row) == "open" and len(keeping) < len(SETTINGS) else []


def says(row):
    """The advice, with both settings where they conflict."""
    of, kept = action(row), " or ".join(keepers(row))
    if of == "conflict":
        return f"{row['best']}: fewest days; {kept}: keeps it in service"
    return ACTIONS[of] + (f"; {kept}: keeps it in service" if kept else "")


def shares(row):
    """Who has the fewest days, such as `off 97 %`, or where that is not settled `on 45 %, off 28 %`."""
    text = ", ".join(f"{setting} {percent(share(row, setting))} %" for setting in likely(row))
    return text + (f"; least cost {row['best_by_cost']}" if row["best_by_cost"] != likely(row)[0] else "")


def mark(row):
    """The likeliest setting, unless it has the fewest days in few samples; `?` where that is not settled, `+` where no
    setting keeps it in service, `/` and the setting that does where the likeliest does not."""
    first, kept = likely(row)[0], keeper(row)
    return ((first if share(row, first) >= HALF else "") + ("" if settled(row) else "?") +
            ("+" if action(row) == "hold" else "") + (f"/{kept}" if kept not in (None, first) else ""))


class Advice:
    def __init__(self, tables):
        self.rows = {(r["item"], r["floor"], r["place"], r["pfv"]): r for r in read(tables, "losses.csv")}

    def row(self, item, floor=FLOOR, place=PLACE, speed=SPEED):
        return self.rows[item, floor, place, str(speed)]

    def words(self, item, quantity, setting):
        """Mean and interval of the days out of use, or of the chance of lost service [%]."""
        return interval_words(self.row(item), f"{quantity}_{setting}", {"days": days, "lost": percent}[quantity])

    def service(self, item):
        """Why brakes do not keep it in service, or which setting does."""
        row = self.row(item)
        of = lambda setting: f"in {self.words(item, 'lost', setting)} % with {SETTING_WORDS[setting]}"
        if action(row) == "hold":
            yield (f"its service is lost in more than {percent(MOST_LOST)} % with every setting, least often "
                   f"{of(most_kept(row))} ([what straps do](tethers.md))")
        elif keeper(row):
            named = [s for s in likely(row) if not keeps(row, s)] + [keeper(row)]
            counts = "" if keeper(row) == likely(row)[0] else ": for life support that counts"
            yield f"its service is lost {', '.join(map(of, named))}{counts}"
        elif keepers(row):
            yield f"its service is lost {', '.join(map(of, SETTINGS))}"

    def least(self, item):
        """How sure it is which setting has the fewest days, and what decides."""
        row = self.row(item)
        yield "fewest days in " + ", in ".join(f"{percent(share(row, setting))} % of the samples with "
                                               f"{SETTING_WORDS[setting]}" for setting in likely(row))
        if row["best_by_cost"] != likely(row)[0]:
            yield f"least cost with {SETTING_WORDS[row['best_by_cost']]}"
        if not settled(row) and row["depends_on"]:
            yield f"it depends on what follows from: {row['depends_on'].replace(';', ',')}"

    def reason(self, item):
        loss = ", ".join(f"{self.words(item, 'days', s)} with {SETTING_WORDS[s]}" for s in SETTINGS)
        return "; ".join([*self.service(item), f"expected days out of use {loss}", *self.least(item)])

    def line(self, item):
        return f"**{says(self.row(item))}**: {self.reason(item)}"
