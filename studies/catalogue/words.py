"""Tables read and written, and lines wrapped, for the pages of the catalogue."""

import csv
import os
import textwrap


def read(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        return list(csv.DictReader(file))


def wrapped(text, indent=""):
    return textwrap.wrap(text, 118, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def table(header, rows):
    return ["| " + " | ".join(header) + " |", "| --- " * len(header) + "|",
            *("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)]
