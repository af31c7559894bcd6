"""Measures studies of a very cheap case, in two shards that are merged, and predicts larger ones.

usage: scaling.py GURNEY [CASES CASES CASES...]  increasing; default: 100 400 10000

The first two sizes give the inputs of the model (model.py); the others check it. Exit code 1: the
bytes of parts are off by more than 5 %, or a shard or the merge needs more memory than predicted.
"""

import os
import subprocess
import sys
import tempfile

import model

GURNEY = os.path.abspath(sys.argv[1])
SIZES = [int(each) for each in sys.argv[2:]] or [100, 400, 10000]
SHARDS = 2
# Rows that wait to be written: 4096 of some 80 numbers and texts; those of a few sizes are less.
ROWS_IN_MEMORY = 6e6

JOB = """
schema = "gurney-job/1"
title = "Scaling"
[item]
equipment = "xu_trolley"
[item.yaw_deg]
value = 0
distribution = {{ kind = "uniform", low = 0, high = 360, assumption = "any" }}
[excitation.record]
synthetic = {{ kind = "ricker", period_s = 0.1 }}
[settings]
duration_s = 0.05
settle_time_s = 0
[study]
draws = {draws}
[study.intensity]
scales = [1]
"""


def used(*arguments):
    """Runs the program: CPU time [s] and largest memory [bytes]."""
    with open(os.devnull, "w", encoding="utf-8") as nothing:
        process = subprocess.Popen([GURNEY, *arguments], stdout=nothing, stderr=nothing)
        _, code, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(code)
    assert process.returncode == 0, arguments
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024


def files_in(folder):
    found = []
    for path, folders, names in os.walk(folder):
        found += [os.path.join(path, name) for name in folders + names]
    return found


def measure(cases, folder):
    job = os.path.join(folder, f"scaling_{cases}.toml")
    results = os.path.join(folder, f"scaling_{cases}.h5")
    with open(job, "w", encoding="utf-8") as text:
        text.write(JOB.format(draws=cases))
    shards = [used("run", job, "-o", results, "--shard", f"{i}/{SHARDS}", "-j", "1")
              for i in range(1, SHARDS + 1)]
    files = files_in(f"{results}.shards")
    part_bytes = sum(os.path.getsize(each) for each in files if each.endswith(".part"))
    merge = used("merge", f"{results}.shards")
    return {
        "cases": cases,
        "run [s]": sum(time for time, _ in shards) / SHARDS,
        "merge [s]": merge[0],
        "inodes": len(files) + 1,
        "parts [bytes]": part_bytes,
        "results [bytes]": os.path.getsize(results),
        "run memory [bytes]": max(memory for _, memory in shards),
        "merge memory [bytes]": merge[1],
    }


def inputs_from(small, large):
    def line(key, shards=1):
        return model.through((small["cases"] / shards, small[key]), (large["cases"] / shards, large[key]))

    return model.Inputs(*line("run [s]", SHARDS), small["run memory [bytes]"], line("parts [bytes]")[1],
                        *line("merge [s]"), small["merge memory [bytes]"], line("results [bytes]")[1])


def row(cases, kind, values):
    print(f"| {cases:,} | {kind} | {values['run [s]']:.1f} | {values['merge [s]']:.2f} | {values['inodes']:,} "
          f"| {values['parts [bytes]'] / 1e6:.2f} | {values['results [bytes]'] / 1e6:.2f} "
          f"| {values['run memory [bytes]'] / 1e6:.1f} | {values['merge memory [bytes]'] / 1e6:.1f} |", flush=True)


def main():
    print("| cases | | run of a shard, CPU [s] | merge, CPU [s] | inodes | parts [MB] | results [MB] "
          "| memory of a shard [MB] | memory of the merge [MB] |\n|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        measured = []
        for cases in SIZES:
            measured.append(measure(cases, folder))
            row(cases, "measured", measured[-1])
    inputs = inputs_from(measured[0], measured[1])
    wrong = []
    for each in measured[2:]:
        said = model.predict(inputs, each["cases"], SHARDS)
        row(each["cases"], "predicted", said)
        if abs(said["parts [bytes]"] / each["parts [bytes]"] - 1) > 0.05:
            wrong.append(f"parts of {each['cases']} cases")
        for key in ("run memory [bytes]", "merge memory [bytes]"):
            if each[key] > said[key] + ROWS_IN_MEMORY:
                wrong.append(f"{key} of {each['cases']} cases")
    print(f"\n{inputs}\n\nOn many cores, a shard each, of cases that take 1 s:\n")
    for cases in (10**6, 10**7):
        for cores in (2, 100, 1000):
            row(cases, f"{cores} cores", model.predict(inputs, cases, cores, case_seconds=1.0))
    for each in wrong:
        print(f"FAILED: {each}")
    return int(bool(wrong))


if __name__ == "__main__":
    sys.exit(main())
