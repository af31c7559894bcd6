"""docs/tutorial.md: its commands print what the page shows, its files are the shipped ones, its
Python gives the numbers in its comments. The commands and the Python of docs/python.md run. Without
the packages only the commands are run."""

import contextlib
import io
import os
import re
import shutil
import subprocess
import tempfile

import support

PACKAGES = ("h5py", "pandas", "xarray", "matplotlib")

with open(os.path.join(support.SOURCE, "docs/tutorial.md"), encoding="utf-8") as page:
    blocks = re.findall(r"^```(\w+)\n(.*?)^```", page.read(), re.MULTILINE | re.DOTALL)
shipped = []
for name in ("jobs/tutorial_run", "jobs/tutorial_study", "assessment/hazard"):
    with open(os.path.join(support.SOURCE, f"studies/{name}.toml"), encoding="utf-8") as file:
        shipped.append(file.read())
assert [text for kind, text in blocks if kind == "toml"] == shipped

with tempfile.TemporaryDirectory() as folder:
    for name in ("studies", "equipment", "groundmotions"):
        shutil.copytree(os.path.join(support.SOURCE, name), os.path.join(folder, name))
    os.makedirs(os.path.join(folder, "build"))
    os.symlink(os.path.dirname(support.BUILT), os.path.join(folder, "build/release"))
    os.chdir(folder)
    environment = {**os.environ,
                   "PATH": f"{os.path.dirname(support.GURNEY)}:{os.environ['PATH']}"}
    printed = ""
    for kind, text in blocks:
        if kind == "sh":
            for command in text.splitlines():
                if not command.startswith("./dev"):
                    printed += subprocess.run(["bash", "-euo", "pipefail", "-c", command],
                                              check=True, capture_output=True, text=True,
                                              env=environment).stdout
        elif kind == "text":
            for line in text.splitlines():
                assert line in printed, f"the program does not print: {line}"
        elif kind == "python" and support.has(*PACKAGES):
            output = io.StringIO()
            with contextlib.redirect_stdout(output):
                exec(text, {})
            shown = output.getvalue()
            assert re.search(r"^130 +on +clough_penzien 2 ", shown, re.MULTILINE), shown
            numbers = [float(number) for number in re.findall(r"\d\.\d+(?:e-?\d+)?", shown)]
            for expected in re.findall(r"# .*?(0\.\d+.*)$", text, re.MULTILINE):
                for number in re.findall(r"0\.\d+", expected):
                    unit = 10.0 ** -len(number.split(".")[1])  # of its last digit
                    assert any(abs(each - float(number)) <= unit / 2 for each in numbers), number
    with open(os.path.join(support.SOURCE, "docs/python.md"), encoding="utf-8") as page:
        text = page.read()
    commands = re.findall(r"^```sh\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    for command in commands:
        subprocess.run(["bash", "-euo", "pipefail", "-c", command], check=True, env=environment,
                       capture_output=True)
    support.need(*PACKAGES)
    support.use_package()
    os.environ["PATH"] = environment["PATH"]  # examples ask the program
    import matplotlib
    matplotlib.use("Agg")
    examples = re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
    assert len(examples) == 9, examples
    for example in examples:
        if "simulate(" in example and not support.has_module():
            print("gurney.simulate is not built: its example was not run")
            continue
        exec(example, {})
    assert os.path.getsize("moved_python.svg") > 1000
print("the pages are right")
