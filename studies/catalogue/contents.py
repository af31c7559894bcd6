"""What opens and what falls: the items of the catalogue that have a variant with parts and contents.

usage: contents.py GURNEY OUTPUT TABLES [--items a,b] [--threads N]

Runs each variant upstairs in the flexible building, on an open floor, brakes off and on, with the motions, levels and
draws of the catalogue. OUTPUT gets motions, jobs and results; TABLES, which has fragility.csv and more_states.csv,
gets contents.csv: curves of what is lost, and of what the rigid item does too, beside those of the rigid one.
docs/catalogue/methods.md, Parts.
"""

import os
import tempfile

import catalogue
from tables import COLUMNS, curve_row, fitted, number, write_csv
from words import read

WHERE = "flexible building,open"
SETTINGS = ("off", "on")
FELL = ("something fell", 'event = "fell"')
TOPPLED = ("something toppled", 'event = "toppled"')
DRAWER = ("a drawer or tray 50 mm open", 'demand = "peak_travel"\nabove = 0.05\nunit = "m"')
DOOR = ("a door or rail 20 degrees open", 'demand = "peak_swing"\nabove = 20\nunit = "deg"')
# Losses by limit state; an item that overturns has them too, as its run ends there.
LOST = {FELL: "contents fall", TOPPLED: "contents topple", DRAWER: "a drawer opens", DOOR: "a door or rail opens"}
# Variants by item: the name, what it can lose, and the sensitive point, on its chassis ("") or on one of its parts.
VARIANTS = {
    "crash_cart": ("drawers and defibrillator", (FELL, TOPPLED, DRAWER), ("", "defibrillator")),
    "hospital_bed": ("patient on mattress", (), ("/patient", "patient's head")),
    "icu_bed": ("patient on mattress", (DOOR,), ("/patient", "patient's head")),
    "icu_ventilator": ("arm and circuit", (), ("", "ventilator")),
    "infusion_pole": ("flexible pole and bags", (), ("/pole with pumps", "pump")),
    "medication_cart": ("drawers and computer", (FELL, TOPPLED, DRAWER), ("", "top")),
    "neonatal_incubator": ("door, tray and shelf", (FELL, TOPPLED, DRAWER, DOOR), ("/mattress tray", "infant")),
    "patient_monitor_stand": ("flexible column and tilting monitor", (), ("/monitor", "monitor")),
}
SHAKEN = "1 g at its sensitive point"
SHARED = ("moved 0.3 m", "moved 1 m", SHAKEN, "overturned")  # states of the rigid item as well


def job_text(gurney, item, jobs, suite):
    variant, states, _ = VARIANTS[item]
    only = [f"{WHERE},{setting}" for setting in SETTINGS]
    text = catalogue.job_text(gurney, {"item": item, "brakes": " ".join(SETTINGS)}, jobs, [suite], only)
    named = f'equipment = "{item}"\n'
    assert text.count(named) == 1, item
    return text.replace(named, f'{named}variant = "{variant}"\n') + "".join(
        f'\n[[study.limit_state]]\nname = "{name}"\n{words}\n' for name, words in states)


def states_file(item):
    """Text of a file of limit states: what is lost or shaken, which it is too where the item overturns first."""
    _, states, (part, point) = VARIANTS[item]
    shaken = ("shaken by 1 g", f'item = "{item}{part}"\npoint = "{point}"\n'
                               'demand = "peak_absolute_acceleration"\nabove = 1\nunit = "g"')
    text = 'schema = "gurney-limit-states/1"\n\n[[limit_state]]\nname = "overturned"\nevent = "overturned"\n'
    for (name, words), whole in [*((state, LOST[state]) for state in states), (shaken, SHAKEN)]:
        text += (f'\n[[limit_state]]\nname = "{name}"\n{words}\n\n[[limit_state]]\nname = "{whole}"\n'
                 f'any_of = ["{name}", "overturned"]\n')
    return text


def rows(gurney, item, results, shipped):
    variant, states, _ = VARIANTS[item]
    of_file = [*(LOST[state] for state in states), SHAKEN]
    wanted = [*of_file[:-1], *SHARED]
    of = [each for each in fitted(gurney, results, "--measure", "pfv")
          if each["limit_state"] in SHARED and each["limit_state"] not in of_file]
    with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
        file.write(states_file(item))
        file.flush()
        of += [each for each in fitted(gurney, results, "--measure", "pfv", "--limit-states", file.name)
               if each["limit_state"] in of_file]
    found = [curve_row(item, "pfv", each) for each in of]
    for row in sorted(found, key=lambda row: (SETTINGS.index(row["brakes"]), wanted.index(row["limit_state"]))):
        rigid = shipped.get((item, row["floor"], row["place"], row["brakes"], row["limit_state"]), {})
        ratio = float(row["theta"]) / float(rigid["theta"]) if row["theta"] and rigid.get("theta") else None
        yield row | {"variant": variant, "rigid_theta": rigid.get("theta", ""), "rigid_exceed": rigid.get("exceed", ""),
                     "ratio": number(ratio)}


def main():
    options = catalogue.options_of_studies(__doc__.splitlines()[0]).parse_args()
    shipped = {tuple(row[k] for k in ("item", "floor", "place", "brakes", "limit_state")): row
               for table in ("fragility.csv", "more_states.csv") for row in read(options.tables, table)
               if row["measure"] == "pfv"}
    found = []
    items = options.items.split(",") if options.items else VARIANTS
    for item, results in catalogue.studied(options.gurney, options.output, items, job_text, options.threads):
        found += rows(options.gurney, item, results, shipped)
    write_csv(os.path.join(options.tables, "contents.csv"), ["item", "variant", *COLUMNS[1:], "rigid_theta", "rigid_exceed", "ratio"],
              found)


if __name__ == "__main__":
    main()
