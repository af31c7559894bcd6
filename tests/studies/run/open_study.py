"""Reads a study's file as docs/studies.md shows it. Exit code 77: not installed.

usage: open_study.py GURNEY SOURCE_FOLDER
"""

import os
import re
import subprocess
import sys
import tempfile

try:
    import h5netcdf  # noqa: F401  (xarray reads HDF5 through it)
    import h5py
    import pandas
    import xarray
except ImportError as error:
    print(f"skipped: {error} (Debian: python3-h5py python3-pandas python3-xarray python3-h5netcdf)")
    sys.exit(77)

gurney, source = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
with open(os.path.join(source, "docs/studies.md"), encoding="utf-8") as page:
    blocks = re.findall(r"^```python\n(.*?)^```", page.read(), re.MULTILINE | re.DOTALL)
assert len(blocks) == 2, blocks

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    job = os.path.join(source, "studies/jobs/brakes_study.toml")
    subprocess.run([gurney, "run", job, "-o", "study.h5"], check=True)
    known, values = {}, []
    for block in blocks:
        *lines, last = block.strip().split("\n")
        exec("\n".join(lines), known)
        values.append(eval(last, known))
    by_level, value = values
    table = known["table"]
    assert list(by_level.index) == ["false", "true"], by_level  # texts, and names of the levels
    assert len(table["runs"]) == 2 * 3 * 2, len(table["runs"])
    assert (table["runs"]["outcome"] != "diverged").all()
    assert float(value) == table["items"]["peak_displacement"].max() > 0
    assert known["items"].item.values[0] == b"xu_trolley", known["items"].item.values
    known["items"].close()
    with h5py.File("study.h5") as file:
        names = list(file)
        assert file["items/peak_displacement"].attrs["units"] == "m"
    for name in names:
        xarray.open_dataset("study.h5", group=name, engine="h5netcdf").load().close()
    print(f"{len(names)} tables opened with h5py {h5py.__version__}, pandas {pandas.__version__} "
          f"and xarray {xarray.__version__}")
