"""What opens and what falls: the items of the catalogue that have a variant with parts and contents.

usage: contents.py GURNEY OUTPUT TABLES [--items a,b] [--threads N]

Runs each variant upstairs in the flexible building, on an open floor, brakes off and on, with the motions, levels and
draws of the catalogue. OUTPUT gets motions, jobs and results; TABLES, which has fragility.csv, gets contents.csv: curves
of what is lost, and of what the rigid item does too, beside those of the rigid one. docs/catalogue/methods.md, Parts.
"""

import argparse
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
LOST = {FELL: "contents fall", TOPPLED: "contents topple", DRAWER: "a drawer opens", DOOR: "a door opens"}  # or the item overturns
# By item its variant and what it can lose.
VARIANTS = {
    "crash_cart": ("drawers and defibrillator", (FELL, TOPPLED, DRAWER)),
    "hospital_bed": ("patient on mattress", ()),
    "icu_bed": ("patient on mattress", ()),
    "icu_ventilator": ("arm and circuit", ()),
    "infusion_pole": ("flexible pole and bags", ()),
    "medication_cart": ("drawers and computer", (FELL, TOPPLED, DRAWER)),
    "neonatal_incubator": ("door, tray and shelf", (FELL, TOPPLED, DRAWER, DOOR)),
    "patient_monitor_stand": ("flexible column and tilting monitor", ()),
}
SHARED = ("moved 0.3 m", "moved 1 m", "overturned")  # states of the rigid item as well


def job_text(gurney, item, jobs, suite):
    variant, states = VARIANTS[item]
    only = [f"{WHERE},{setting}" for setting in SETTINGS]
    text = catalogue.job_text(gurney, {"item": item, "brakes": " ".join(SETTINGS)}, jobs, suite, only)
    named = f'equipment = "{item}"\n'
    assert text.count(named) == 1, item
    return text.replace(named, f'{named}variant = "{variant}"\n') + "".join(
        f'\n[[study.limit_state]]\nname = "{name}"\n{words}\n' for name, words in states)


def lost_states(states):
    """A file of limit states: what is lost, which it is too where the item overturns first and the run ends."""
    text = 'schema = "gurney-limit-states/1"\n\n[[limit_state]]\nname = "overturned"\nevent = "overturned"\n'
    for name, words in states:
        text += (f'\n[[limit_state]]\nname = "{name}"\n{words}\n\n[[limit_state]]\nname = "{LOST[name, words]}"\n'
                 f'any_of = ["{name}", "overturned"]\n')
    return text


def rows(gurney, item, results, shipped):
    variant, states = VARIANTS[item]
    lost = [LOST[state] for state in states]
    wanted = lost + list(SHARED)
    of = [each for each in fitted(gurney, results, "--measure", "pfv") if each["limit_state"] in SHARED]
    if states:
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as file:
            file.write(lost_states(states))
            file.flush()
            of += [each for each in fitted(gurney, results, "--measure", "pfv", "--limit-states", file.name)
                   if each["limit_state"] in lost]
    found = [curve_row(item, "pfv", each) for each in of]
    for row in sorted(found, key=lambda row: (SETTINGS.index(row["brakes"]), wanted.index(row["limit_state"]))):
        rigid = shipped.get((item, row["floor"], row["place"], row["brakes"], row["limit_state"]), {})
        ratio = float(row["theta"]) / float(rigid["theta"]) if row["theta"] and rigid.get("theta") else None
        yield row | {"variant": variant, "rigid_theta": rigid.get("theta", ""), "rigid_exceed": rigid.get("exceed", ""),
                     "ratio": number(ratio)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gurney")
    parser.add_argument("output")
    parser.add_argument("tables")
    parser.add_argument("--items", help="of VARIANTS (default: all)")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_args()
    jobs, suite = os.path.join(options.output, "jobs"), os.path.join(options.output, "motions")
    os.makedirs(jobs, exist_ok=True)
    catalogue.make_motions(options.gurney, suite, catalogue.MOTIONS)
    shipped = {tuple(row[k] for k in ("item", "floor", "place", "brakes", "limit_state")): row
               for row in read(options.tables, "fragility.csv") if row["measure"] == "pfv"}
    found = []
    for item in options.items.split(",") if options.items else VARIANTS:
        print(item, flush=True)
        job, results = os.path.join(jobs, item + ".toml"), os.path.join(options.output, item + ".h5")
        with open(job, "w") as file:
            file.write(job_text(options.gurney, item, jobs, suite))
        catalogue.run(options.gurney, job, results, options.threads)
        found += rows(options.gurney, item, results, shipped)
    write_csv(os.path.join(options.tables, "contents.csv"), ["item", "variant", *COLUMNS[1:], "rigid_theta", "rigid_exceed", "ratio"],
              found)


if __name__ == "__main__":
    main()
