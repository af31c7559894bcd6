"""Opens a results file with h5py, pandas and xarray, without tricks. Exit code 77: not installed."""

import os
import subprocess
import sys
import tempfile

try:
    import h5py
    import pandas
    import xarray
    import h5netcdf  # noqa: F401  (xarray reads HDF5 through it)
except ImportError as error:
    print(f"skipped: {error} (Debian: python3-h5py python3-xarray python3-h5netcdf)")
    sys.exit(77)

with tempfile.TemporaryDirectory() as folder:
    paths = [os.path.join(folder, name) for name in ("a.h5", "b.h5")]
    for path, perturb in zip(paths, ("1", "170")):
        # Fresh memory is filled with another byte each time: no byte of the file may come from it.
        subprocess.run([sys.argv[1], path], check=True, env={**os.environ, "MALLOC_PERTURB_": perturb})
    with open(paths[0], "rb") as a, open(paths[1], "rb") as b:
        assert a.read() == b.read(), "two processes wrote different bytes"

    with h5py.File(paths[0]) as file:
        assert file.attrs["filetype"] == "gurney-results"
        assert file["items/peak_displacement"].attrs["units"] == "m"
        items = pandas.DataFrame({name: data[:] for name, data in file["items"].items()})
        assert abs(items["peak_yaw"][0] - 1.25) < 1e-15
        wheels = pandas.DataFrame({name: data[:] for name, data in file["wheels"].items()})
        assert wheels.set_index("wheel")["liftoffs"][b"rear right"] == 3
        assert len(pandas.DataFrame({name: data[:] for name, data in file["events"].items()})) == 0
        assert file["histories/normal_force"].dims[1][0].name == "/histories/wheel"
        assert file["histories/normal_force"].compression == "gzip"
        assert file["histories/normal_force"].shuffle

    with xarray.open_dataset(paths[0], group="items", engine="h5netcdf") as items:
        assert items.time_of_overturning.isnull().all()
        assert items.item.values[0] == "Trolley"
    with xarray.open_dataset(paths[0], group="histories", engine="h5netcdf") as histories:
        assert histories.normal_force.dims == ("time", "wheel")
        assert histories.displacement.dims == ("time", "item", "axis")
        assert histories.point_velocity.dims == ("time", "point", "axis")
        assert abs(float(histories.displacement.sel(time=1.0, item="Trolley", axis="x"))) < 1
    for group in ("runs", "wheels", "points", "events", "zones", "tethers", "energy", "verification",
                  "assumptions"):
        xarray.open_dataset(paths[0], group=group, engine="h5netcdf").load().close()
print("opened with h5py", h5py.__version__, "and xarray", xarray.__version__)
