"""Results of Gurney as tables of pandas and datasets of xarray.

    import gurney
    with gurney.open("study.h5") as study:
        study.runs                            # one row for each run
        study.demands.join(study.runs)        # one row for each item of each run
        study.fragility("overturned", configuration="brakes on")

Single runs, where the compiled module is installed:

    run = gurney.simulate("icu_ventilator", acceleration, time_step=0.005)
    run.demands["icu_ventilator"]["peak_displacement"]

All values are in SI units, angles in radians, as in the file; ``frame.attrs["units"]`` has the unit
of every column. Drawn parameters keep the unit that their name ends with. Files are only read.
"""

try:
    import h5py  # noqa: F401
except ModuleNotFoundError:
    raise ModuleNotFoundError("gurney needs h5py: apt install python3-h5py, or "
                              "pip install h5py") from None

from .errors import DamagedFile, Error, InputError, NotInFile
from .fragility import Fragility
from .hazard import Hazard, read_hazard
from .limit_states import LimitState
from .results import Results
from .simulation import Run, simulate, simulate_job

__all__ = ["DamagedFile", "Error", "Fragility", "Hazard", "InputError", "LimitState", "NotInFile",
           "Results", "Run", "open", "read_hazard", "simulate", "simulate_job"]
__version__ = "0.1.0"


def open(path, verify=True):  # noqa: A001 (as h5py and xarray call it)
    """Opens a results file of a single run or of a study, for reading.

    :param path: a file of ``gurney run`` or ``gurney merge``
    :param verify: compare the SHA-256 at the end of the file first, which reads all of it
    :returns: :class:`Results`, to be closed or used in ``with``
    """
    return Results(path, verify=verify)
