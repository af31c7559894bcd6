"""Gurney in Python: items on casters under floor motions, studies, curves and their results.

    import gurney
    run = gurney.simulate("icu_ventilator", acceleration, time_step=0.005)   # in memory
    run = gurney.run("job.toml", item__brakes=True)                          # a job, with other values
    run.to_frame(), run.play()

    study = gurney.study("study.toml", "study.h5")                           # or gurney.open("study.h5")
    study.runs                            # one row for each run
    study.to_frame()                      # one row for each item of each run
    curve = study.fragility("overturned", configuration="brakes on")
    curve.rate(gurney.Hazard(im, rate, measure="PGA", unit="g"))

    gurney.catalogue()                    # items, casters, floor coverings, rooms, buildings
    gurney.records.read("RSN1063.AT2")    # ground motions: spectra, measures, floors of buildings

All values are in SI units, angles in radians, as in the files; ``frame.attrs["units"]`` has the unit
of every column. Drawn parameters keep the unit that their name ends with.
"""

from __future__ import annotations

import importlib
import os
from typing import Any

try:
    import h5py  # noqa: F401
except ModuleNotFoundError:
    raise ModuleNotFoundError("gurney needs h5py: apt install python3-h5py, or "
                              "pip install h5py") from None

from . import program, records
from .errors import DamagedFile, Error, InputError, NotInFile
from .fragility import Fragility, Statistics
from .hazard import Hazard, read_hazard
from .jobs import item, patched, read_job
from .page import Page
from .records import Record
from .results import Results
from .shipped import catalogue, data_folder, sheet
from .simulation import Run, Runs, run, simulate, simulate_job, simulate_many
from .studies import study

__all__ = ["DamagedFile", "Error", "Fragility", "Hazard", "InputError", "NotInFile", "Page", "Record",
           "Results", "Run", "Runs", "Statistics", "catalogue", "data_folder", "item", "open", "patched", "program",
           "read_hazard", "read_job", "records", "run", "sheet", "simulate", "simulate_job",
           "simulate_many", "study"]
__version__ = "0.1.0"


def open(path: str | os.PathLike[str], verify: bool = True) -> Results:  # noqa: A001 (as h5py calls it)
    """Opens a results file of a single run or of a study, for reading.

    :param path: a file of ``gurney run`` or ``gurney merge``
    :param verify: compare the SHA-256 at the end of the file first, which reads all of it
    :returns: :class:`Results`, to be closed or used in ``with``
    :raises Error: no such file, or not one of Gurney
    :raises DamagedFile: its bytes are not those that were written
    """
    return Results(path, verify=verify)


def __getattr__(name: str) -> Any:
    """``gurney.plot``, which needs matplotlib, is imported when it is asked for."""
    if name == "plot":
        return importlib.import_module(".plot", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
