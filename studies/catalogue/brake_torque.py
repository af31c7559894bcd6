"""How far the mobile X-ray unit goes with brakes that hold more or less.

usage: brake_torque.py GURNEY OUTPUT TABLE [TORQUE...]

The runs of catalogue.py --variance with its brakes on, without replicas, once for each torque [N m], which all
brakes have in all runs. OUTPUT is a folder for motions, jobs and results; TABLE gets a row for each torque.
docs/catalogue/methods.md says what they show.
"""

import os
import sys

import h5py
import numpy

import catalogue
from tables import number, write_csv

ITEM, CASTER, TORQUES = "mobile_xray", "drive_250", (75, 150, 300, 600)


def text_of(folder, name):
    with open(os.path.join(catalogue.ROOT, "equipment", folder, name + ".toml")) as file:
        return file.read()


def write(path, text):
    with open(path, "w") as file:
        file.write(text)


def job(gurney, folder, torque):
    """Writes a caster, an item with it, and a job with that; returns the job's path."""
    caster = text_of("casters", CASTER)
    first, after = caster.index("[brake_torque_n_m]"), caster.index("[tread]")
    held = f'[brake_torque_n_m]\nvalue = {torque}\nrange = [10, 1000]\nassumption = "the torque of this study"\n\n'
    write(os.path.join(folder, f"caster_{torque}.toml"), caster[:first] + held + caster[after:])
    write(os.path.join(folder, f"item_{torque}.toml"),
          text_of("items", ITEM).replace(f'"{CASTER}"', f'"caster_{torque}.toml"'))
    text = catalogue.job_text(gurney, {"item": ITEM, "brakes": "on"}, folder, [os.path.join(folder, "motions")],
                              variance=True)
    path = os.path.join(folder, f"job_{torque}.toml")
    write(path, text.replace(f'equipment = "{ITEM}"', f'equipment = "item_{torque}.toml"')
          .replace(f"replicas = {catalogue.VARIANCE['replicas']}\n", ""))
    return path


def row(results, torque):
    """Medians of the runs that did not overturn."""
    with h5py.File(results) as file:
        items = {name: file["items"][name][:] for name in file["items"]}
    stood = ~(items["time_of_overturning"] >= 0)
    medians = {f"{name}_{unit}": number(numpy.median(numpy.abs(items[name][stood]))) for name, unit in (
        ("peak_displacement", "m"), ("residual_displacement", "m"), ("path_length", "m"), ("peak_yaw", "rad"))}
    return {"torque_n_m": torque, "runs": len(stood), "overturned": int((~stood).sum())} | medians


def main():
    gurney, folder, table, *torques = sys.argv[1:]
    catalogue.make_motions(gurney, os.path.join(folder, "motions"), catalogue.MOTIONS)
    rows = []
    for torque in [int(each) for each in torques] or TORQUES:
        results = os.path.join(folder, f"torque_{torque}.h5")
        catalogue.run(gurney, job(gurney, folder, torque), results, os.cpu_count())
        rows.append(row(results, torque))
    write_csv(table, list(rows[0]), rows)


if __name__ == "__main__":
    main()
