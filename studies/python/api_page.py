#!/usr/bin/env python3
"""Prints docs/python_api.md from the signatures and docstrings of the package.

usage: PYTHONPATH=build/release/python python3 studies/python/api_page.py > docs/python_api.md
"""

import inspect
import re
import textwrap

import gurney
import gurney.plot

WIDTH = 116
GROUPS = (
    ("Run", gurney, ("simulate", "simulate_many", "run", "simulate_job", "study", "Run", "Runs")),
    ("Jobs and items", gurney, ("read_job", "patched", "item", "catalogue", "sheet", "data_folder")),
    ("Results", gurney, ("open", "Results", "Page")),
    ("Curves and hazard", gurney, ("Fragility", "Statistics", "Hazard", "read_hazard")),
    ("Ground motions", gurney.records, ("read", "read_all", "from_array", "process", "ls", "measures", "spectrum", "scale",
                                        "select", "Selection", "floor", "make", "kinds", "model", "Record")),
    ("Figures", gurney.plot, ("history", "fragility", "cloud", "selection")),
    ("The program", gurney.program, ("path", "order", "ask", "page")),
    ("Errors", gurney, ("Error", "InputError", "DamagedFile", "NotInFile")),
)


def plain(text):
    """Roles of Sphinx become code, ``x`` too."""
    text = re.sub(r":\w+:`~?(?:gurney\.)?([^`]+)`", r"`\1`", text)
    return re.sub(r"``([^`]+)``", r"`\1`", text)


def fields(doc):
    """The text before the fields, and the fields: (name, text)."""
    parts = re.split(r"^:(param \w+|returns|raises \w+):\s*", doc, flags=re.MULTILINE)
    found, after = [], []
    for name, text in zip(parts[1::2], parts[2::2]):
        own, _, rest = text.partition("\n\n")
        found.append((name, own))
        after.append(rest)
    return "\n\n".join([parts[0], *filter(None, after)]), found


def body(doc):
    text, found = fields(plain(inspect.cleandoc(doc)))
    lines = []
    for paragraph in filter(None, (each.strip() for each in text.split("\n\n"))):
        indented = paragraph.startswith("    ")
        lines += [paragraph if indented else "\n".join(textwrap.wrap(paragraph, WIDTH)), ""]
    for name, own in found:
        kind, _, of = name.partition(" ")
        label = f"`{of}`" if kind == "param" else f"raises `{of}`" if of else "returns"
        lines += textwrap.wrap(f"- {label}: {' '.join(own.split())}", WIDTH, subsequent_indent="  ")
    return lines + [""] * bool(found)


class Bare(str):
    """An annotation that is printed without quotes."""

    def __repr__(self):
        return str(self)


def signature(name, of):
    given = inspect.signature(of)
    stated = given.replace(
        parameters=[each.replace(annotation=Bare(each.annotation)) if each.annotation is not each.empty
                    else each for each in given.parameters.values() if each.name != "self"],
        return_annotation=Bare(given.return_annotation))
    text = re.sub(r"\b(numpy\.typing|pandas|os)\.(?=[A-Z])", "", name + str(stated))
    return "\n".join(textwrap.wrap(text, WIDTH, subsequent_indent="    ", break_long_words=False))


def members(of):
    for name, each in vars(of).items():
        if name.startswith("_") or not getattr(each, "__doc__", None):
            continue
        if isinstance(each, property) or type(each).__name__ == "cached_property":
            yield f"`{name}`", each
        elif inspect.isfunction(each):
            yield None, each


def described(module, name):
    of = getattr(module, name)
    prefix = module.__name__ + "."
    lines = [f"### {prefix}{name}", ""]
    if not (inspect.isclass(of) and issubclass(of, Exception)):
        if not inspect.isclass(of) or name == "Hazard":  # others are made by functions
            lines += ["```text", signature(prefix + name, of), "```", ""]
    lines += body(of.__doc__)
    if inspect.isclass(of) and not issubclass(of, Exception):
        for label, each in members(of):
            doc = body(each.__doc__)
            if label:
                lines += textwrap.wrap(f"{label}: {' '.join(' '.join(doc).split())}", WIDTH) + [""]
            else:
                lines += ["```text", signature(f"{name}.{each.__name__}", each), "```", ""] + doc
    return lines


def page():
    lines = ["# Python: reference", "",
             "Generated from the docstrings by `studies/python/api_page.py`; a test compares. How to use it:",
             "[Python](python.md). Numbers are in SI units, angles in radians.", ""]
    for title, module, names in GROUPS:
        lines += [f"## {title}", ""]
        for name in names:
            lines += described(module, name)
    text = "\n".join(lines)
    return re.sub(r"\n{3,}", "\n\n", text).rstrip() + "\n"


if __name__ == "__main__":
    print(page(), end="")
