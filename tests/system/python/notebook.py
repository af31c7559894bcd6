"""Runs the notebooks of studies/python/notebooks cell by cell, without Jupyter, and compares what they
print with the outputs that they hold. A cell whose metadata says `needs` is left out where one of these
modules is missing; without gurney.simulate the test is skipped.

With the environment variable GURNEY_NOTEBOOK=write the outputs are written instead.
"""

import ast
import contextlib
import glob
import importlib.util
import io
import json
import os
import tempfile

import support

support.need_module()
support.use_package()
WRITE = os.environ.get("GURNEY_NOTEBOOK") == "write"
os.environ["MPLBACKEND"] = "Agg"


def run(source, names):
    """What a cell prints, and the value of its last expression unless a `;` ends it, as in Jupyter."""
    tree = ast.parse(source)
    shown = isinstance(tree.body[-1], ast.Expr) and not source.rstrip().endswith(";")
    last = tree.body.pop() if shown else None
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        exec(compile(tree, "cell", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "cell", "eval"), names) if last else None
    return output.getvalue() + (f"{value!r}\n" if value is not None else "")


def outputs(text):
    lines = text.splitlines(keepends=True)
    return [{"name": "stdout", "output_type": "stream", "text": lines}] if lines else []


notebooks = sorted(glob.glob(os.path.join(support.PACKAGE, "notebooks/*.ipynb")))
assert notebooks
for path in notebooks:
    with open(path, encoding="utf-8") as file:
        notebook = json.load(file)
    assert notebook["nbformat"] == 4 and notebook["cells"][0]["cell_type"] == "markdown"
    names = {"__name__": "__main__"}
    left_out = 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for number, cell in enumerate(notebook["cells"]):
            if cell["cell_type"] != "code":
                continue
            missing = [each for each in cell["metadata"].get("needs", [])
                       if importlib.util.find_spec(each) is None]
            if missing:
                print(f"cell {number} is left out: no {', '.join(missing)}")
                left_out += 1
                continue
            printed = outputs(run("".join(cell["source"]), names))
            if WRITE:
                cell["outputs"] = printed
            assert cell["outputs"] == printed, (path, number, cell["outputs"], printed)
    if WRITE:
        with open(path, "w", encoding="utf-8") as file:
            file.write(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")
    codes = sum(cell["cell_type"] == "code" for cell in notebook["cells"])
    print(f"{os.path.basename(path)}: {codes - left_out} of {codes} cells were run")
