"""The curves of the catalogue with a dispersion for what its models leave out.

usage: dispersion.py TABLES OUTPUT DISPERSION

OUTPUT gets fragility.csv of TABLES with sqrt(beta^2 + DISPERSION^2) in place of each beta and of the ends of its
interval, above.csv, and the libraries for pelicun and OpenQuake; losses.py and gurney hospital read it like that of TABLES.
docs/catalogue/methods.md says what DISPERSION may stand for.
"""

import math
import os
import shutil
import sys

import libraries
from tables import COLUMNS, number, write_csv
from words import read


def widened(row, dispersion):
    """A row of fragility.csv; medians stay, dispersions of independent causes add by their squares."""
    return row | {name: number(math.hypot(float(row[name]), dispersion)) for name in ("beta", "beta_low", "beta_high")
                  if row[name] not in ("", "inf")}


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    tables, output, text = sys.argv[1:]
    try:
        dispersion = float(text)
    except ValueError:
        dispersion = math.nan
    if not 0 <= dispersion <= 1:
        sys.exit(f"dispersion.py: DISPERSION is '{text}', a number in [0, 1] is allowed")
    if os.path.realpath(tables) == os.path.realpath(output):
        sys.exit("dispersion.py: OUTPUT is TABLES; a second call would widen the curves again")
    os.makedirs(output, exist_ok=True)
    write_csv(os.path.join(output, "fragility.csv"), COLUMNS,
              (widened(row, dispersion) for row in read(tables, "fragility.csv")))
    shutil.copy(os.path.join(tables, "above.csv"), output)
    libraries.write(output)


if __name__ == "__main__":
    main()
