"""How the medians of the catalogue change where published values contradict the constants that it drew.

usage: changes.py GURNEY OUTPUT TABLE

Runs three items upstairs in the flexible building, on an open floor, with the motions of the catalogue and equipment in
which one constant is changed (CHANGES); OUTPUT is a folder for equipment, jobs and results. TABLE gets the medians beside
the shipped ones. Docs: docs/catalogue/constants.md.
"""

import glob
import os
import re
import shutil
import subprocess
import sys

import suites
from catalogue import ROOT
from tables import write_csv

HERE = os.path.dirname(os.path.abspath(__file__))
ITEMS = ("hospital_bed", "icu_ventilator", "infusion_pole")  # those of the other suites
WHERE = "flexible building,open"
SHIPPED = os.path.join(ROOT, "docs", "catalogue", "data")


def numbers(text, table):
    """Numbers of a table of a TOML file, by key."""
    body = text.split(f"\n[{table}]", 1)[1].split("\n[", 1)[0]
    return {key: float(value) for key, value in re.findall(r"^(\w+) = (-?[\d.e-]+)", body, re.MULTILINE)}


def changed(text, table, values):
    """The text with these numbers in a table, which has each of them."""
    before, after = text.split(f"\n[{table}]", 1)
    body, *rest = re.split(r"(?=\n\[)", after, maxsplit=1)
    for key, value in values.items():
        body, count = re.subn(rf"^{key} = -?[\d.e-]+", f"{key} = {value:g}", body, flags=re.MULTILINE)
        if count != 1:
            raise ValueError(f"[{table}] has {count} numbers {key}")
    return before + f"\n[{table}]" + body + "".join(rest)


def rolling(text):
    """Cr of the wheels that were measured, where a caster has less: 1.43 mm, twice and half of it at the ends."""
    if numbers(text, "tread.rolling_resistance_mm.distribution")["median"] >= 1.43:
        return text
    return changed(text, "tread.rolling_resistance_mm.distribution", {"median": 1.43, "low": 0.715, "high": 2.86})


def sloping(text):
    """The deviation of the slope over 0.6 m of the floor that was measured."""
    for name in ("slope", "cross_slope"):
        text = changed(text, f"{name}.distribution", {"sd": 0.0031, "low": -0.0093, "high": 0.0093})
    return text


def holding(text):
    """No brake that holds less than the standard asks for at the rated load, the median of the shipped ones."""
    table = "brake_torque_n_m.distribution"
    return changed(text, table, {"low": numbers(text, table)["median"]})


CHANGES = {  # name: which files, the change, settings of the brakes in which it is run
    "rolling resistance 1.43 mm": ("casters/*.toml", rolling, ("off",)),
    "slope deviates by 0.31 %": ("levelness.toml", sloping, ("off",)),
    "no brake below the standard": ("casters/*.toml", holding, ("on",)),
}


def data_with(folder, pattern, change):
    """A folder of data whose equipment has the change."""
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(ROOT):
        if name not in ("equipment", "build") and not os.path.lexists(os.path.join(folder, name)):
            os.symlink(os.path.join(ROOT, name), os.path.join(folder, name))
    equipment = os.path.join(folder, "equipment")
    shutil.copytree(os.path.join(ROOT, "equipment"), equipment, dirs_exist_ok=True)
    for path in glob.glob(os.path.join(equipment, pattern)):
        with open(path) as file:
            text = file.read()
        with open(path, "w") as file:
            file.write(change(text))


def medians(gurney, folder, name):
    pattern, change, settings = CHANGES[name]
    data_with(os.path.join(folder, "data"), pattern, change)
    only = [word for setting in settings for word in ("--only", f"{WHERE},{setting}")]
    environment = {**os.environ, "GURNEY_DATA": os.path.join(folder, "data")}
    subprocess.run([sys.executable, os.path.join(HERE, "catalogue.py"), gurney, folder, "--items", ",".join(ITEMS), *only],
                   check=True, env=environment)
    subprocess.run([sys.executable, os.path.join(HERE, "tables.py"), gurney, folder, os.path.join(folder, "tables")],
                   check=True, env=environment)
    return suites.curves(os.path.join(folder, "tables"))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    gurney, output, table = (os.path.abspath(word) for word in sys.argv[1:])
    shipped, rows = suites.curves(SHIPPED), []
    for number, name in enumerate(CHANGES):
        found = medians(gurney, os.path.join(output, f"change_{number}"), name)
        rows += [{"change": name} | row for row in suites.pairs(shipped, found)]
    write_csv(table, list(rows[0]), rows)


if __name__ == "__main__":
    main()
