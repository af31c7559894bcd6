"""The blind protocol: its example as its page has it, errors of a file of trials, intervals and explanations.

usage: blind.py GURNEY SOURCE_FOLDER
"""

import os
import random
import subprocess
import sys
import tempfile

try:
    import h5py  # noqa: F401
    import numpy
    import pandas  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

sys.dont_write_bytecode = True
program, source = (os.path.abspath(path) for path in sys.argv[1:3])
validation = os.path.join(source, "docs", "validation")
sys.path.insert(0, validation)
import blind  # noqa: E402


def compare(*arguments):
    return subprocess.run([sys.executable, "-B", os.path.join(validation, "blind.py"), *arguments], capture_output=True, text=True)


# The smallest and largest of 39 contain one more with 95 %; of 199 the fifth from either end; of 9 no more than 80 %.
assert blind.prediction_interval(range(39)) == (0, 38, 0.95)
assert blind.prediction_interval(range(199)) == (4, 194, 0.95)
assert blind.prediction_interval(range(9)) == (0, 8, 0.8)
# Of 2000 trials beside 39 draws of one distribution 95 % are within; five standard deviations are sqrt(0.95 * 0.05 / 2000).
source_of = random.Random(1)
inside = 0
for _ in range(2000):
    low, high, _ = blind.prediction_interval([source_of.lognormvariate(0, 1) for _ in range(39)])
    inside += low <= source_of.lognormvariate(0, 1) <= high
assert abs(inside / 2000 - 0.95) < 5 * (0.95 * 0.05 / 2000) ** 0.5, inside

assert blind.ranks(numpy.array([3.0, 1.0, 3.0])).tolist() == [1.5, 0, 1.5]
# What decides explains, in its direction; noise does not, but for 1 of 100 such sets.
numbers = numpy.random.default_rng(1)
resistance, slope = numbers.standard_normal((2, 100))
demand = numpy.exp(-2 * resistance + 0.1 * numbers.standard_normal(100))
drawn = {"resistance": resistance, "slope": slope, "constant": numpy.ones(100)}
assert blind.explains(drawn, demand, above=True) == ["smaller resistance"]
assert blind.explains(drawn, demand, above=False) == ["larger resistance"]
sets = ({str(i): column for i, column in enumerate(numbers.standard_normal((8, 39)))} for _ in range(200))
found = sum(bool(blind.explains(each, numbers.standard_normal(39), True)) for each in sets)
assert found <= 9, found  # of 200 at 1 %: more than 9 in one of 20,000 (binomial)

with open(os.path.join(source, "docs", "blind_protocol.md"), encoding="utf-8") as file:
    page = file.read().splitlines()
with tempfile.TemporaryDirectory() as folder:
    study = os.path.join(folder, "prediction.h5")
    subprocess.run([program, "run", os.path.join(validation, "blind", "prediction.toml"), "-o", study], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    trials = os.path.join(validation, "blind", "measured.csv")
    done = compare(study, trials)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[1].startswith("sealed by   SHA-256 ") and len(lines[1].split()[-1]) == 64, lines[1]
    assert lines[-1] in page and all(line in page for line in lines[2:] if "OUTSIDE" in line), done.stdout
    assert sum("within 95 %" in line for line in lines) == 15 and sum("OUTSIDE" in line for line in lines) == 1

    def refused(text, *words):
        path = os.path.join(folder, "trials.csv")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        done = compare(study, path)
        assert done.returncode == 1 and not done.stdout, done
        assert done.stderr.splitlines() == [path + each for each in words], (done.stderr, words)

    header = "configuration,record,item,demand,value\n"
    refused(header + "off,near_falt 1,machine,peak_jaw,0.1\n# none\noff,near_fault 1,machine,overturned,2\n"
            "on,near_fault 1,machine,peak_yaw,fast\non,near_fault 1,machine\n",
            ":2:5: record 'near_falt 1' is not in the study; the nearest is 'near_fault 1'",
            ":2:25: demand 'peak_jaw' is not in the study; the nearest is 'peak_yaw'",
            ":4:37: value '2' must be 0 or 1", ":5:34: value 'fast' must be a finite number",
            ":6:1: 3 cells; there must be 5")
    refused("configuration,record\n", ":1:1: columns are configuration, record; they must be " + header.strip().replace(",", ", "))
    refused(header, ": no trials")
    # A trial beyond all draws says so.
    path = os.path.join(folder, "far.csv")
    with open(path, "w", encoding="utf-8") as file:
        file.write(header + "off,near_fault 1,machine,peak_displacement,9\non,near_fault 1,machine,overturned,1\n")
    done = compare(study, path)
    assert done.stdout.count("OUTSIDE") == 1 and "within 1 of 2" in done.stdout, done.stdout
    assert compare(study).returncode == 1
