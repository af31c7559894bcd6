"""Makes the fragility catalogue of wheeled hospital equipment (docs/catalogue/methods.md).

usage: catalogue.py GURNEY OUTPUT [--items a,b] [--only FLOOR,PLACE,BRAKES]... [--variance]
           [--motions FILE... | --suite FOLDER] [--levels V,V...] [--draws N] [--threads N]

GURNEY is the program, OUTPUT a folder for motions, jobs and results. A study that is finished is not
run again, one that was interrupted goes on. --motions takes another file of synthetic motions than MOTIONS, or
one for each level, --suite recorded ones, --levels other PGV, --draws several draws of each motion; --only runs
single configurations, with the same numbers; tables.py then writes the tables. --variance runs the studies of
variance.py: several draws and replicas of each motion.
"""

import argparse
import csv
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))

MOTIONS = os.path.join(HERE, "motions.csv")  # made by suite.py
GAP_BACK, GAP_SIDE = 0.1, 0.3  # [m] from the item to the walls of its bay
LEVELS_OF_CURVES = [0.15, 0.4, 0.8, 1.5]  # [m/s] PGV of the ground
VARIANCE = {"floor": "flexible building", "place": "open", "draws": 4, "replicas": 2, "levels": [0.8]}
SOME_FAILED = 3  # exit code: the curves leave out these runs, and the tables count them
BRAKES = {
    "off": "item.brakes = false",
    "on": "item.brakes = true",
    "locked": "item.brakes = true\nitem.swivel_locks = true",
}


def rows(name):
    with open(os.path.join(HERE, name), newline="") as file:
        return list(csv.DictReader(file))


def motion_rows(path=MOTIONS):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def record_name(motion):
    """Of the record that is made of it."""
    return motion["name"].replace(" ", "_")


def make_motions(gurney, folder, path):
    os.makedirs(folder, exist_ok=True)
    for motion in motion_rows(path):
        path = os.path.join(folder, record_name(motion) + ".csv")
        if not os.path.exists(path):
            subprocess.run([gurney, "records", "make", motion["kind"], *motion["parameters"].split(),
                            "-o", path], check=True, stdout=subprocess.DEVNULL)


def brakes(settings):
    """The factor of the brakes, with the settings that the item has."""
    if not settings:
        return ""
    text = '[[study.factor]]\nname = "brakes"\n'
    for name in settings:
        text += f"[study.factor.level.{name}]\n{BRAKES[name]}\n"
    return text


def combinations(rows_of_levels):
    return f"combinations = {json.dumps(rows_of_levels)}\n" if rows_of_levels else ""


def design(item, only, variance, draws, levels):
    """The words of the template that say which runs a study has."""
    if not variance:
        return {"DRAWS": str(draws), "LEVELS": json.dumps(levels),
                "COMBINATIONS": combinations([each.split(",") for each in only])}
    chosen = [[VARIANCE["floor"], VARIANCE["place"], setting] for setting in item["brakes"].split()]
    return {"DRAWS": str(VARIANCE["draws"]), "LEVELS": json.dumps(VARIANCE["levels"]),
            "COMBINATIONS": combinations(chosen) + f"replicas = {VARIANCE['replicas']}\n"}


def sheet_of(gurney, item):
    """Facts of `gurney equipment show`."""
    return json.loads(subprocess.run([gurney, "equipment", "show", item, "--json"], check=True,
                                     capture_output=True, text=True).stdout)


def chosen_items(names):
    """Rows of items.csv: all, or those named, with commas between them."""
    items = rows("items.csv")
    if not names:
        return items
    named = names.split(",")
    unknown = set(named) - {item["item"] for item in items}
    if unknown:
        sys.exit(f"{os.path.basename(sys.argv[0])}: not in items.csv: {', '.join(sorted(unknown))}")
    return [item for item in items if item["item"] in named]


def job_text(gurney, item, jobs, suites, only=(), variance=False, draws=1, levels=LEVELS_OF_CURVES):
    """The template with the size of the item's bay.

    suites: one folder of motions, or one for each level."""
    key = "suite" if len(suites) == 1 else "suite_by_level"
    words = bay_words(sheet_of(gurney, item["item"])["size_m"]) | {
        "ITEM": item["item"],
        "SUITE": f"{key} = {json.dumps([os.path.relpath(suite, jobs) for suite in suites])}",
        "ROOT": os.path.relpath(ROOT, jobs),
        "BRAKES": brakes(item["brakes"].split()),
    } | design(item, only, variance, draws, levels)
    return filled("item_study.toml.in", words)


def bay_words(size):
    """Where the walls of an item's bay are."""
    length, width = size[:2]
    back, side = length / 2 + GAP_BACK + 0.05, width / 2 + GAP_SIDE + 0.05
    places = {"BACK": -back, "HALF_BAY": side + 0.05, "SIDE": side, "FRONT": length / 2}
    return {name: f"{place:.3f}" for name, place in places.items()}


def filled(template, words):
    with open(os.path.join(HERE, template)) as file:
        text = file.read()
    for word, value in words.items():
        text = text.replace(f"@{word}@", value)
    return text


def run(gurney, job, results, threads):
    """Ends the study's run, which an earlier call may have begun or finished; results of another job are
    an error."""
    resume = ["--resume"] if os.path.exists(results) or os.path.exists(results + ".parts") else []
    code = subprocess.run([gurney, "run", job, "-o", results, "-j", str(threads), *resume]).returncode
    if code not in (0, SOME_FAILED):
        sys.exit(f"catalogue.py: {job}: gurney run ended with {code}")


def studied(gurney, output, items, text_of, threads):
    """Runs a study of each item with the motions of the catalogue, and yields the item and its results.

    text_of(gurney, item, jobs, suite) is the job, in the folder `jobs`, with the motions of the folder `suite`."""
    jobs, suite = os.path.join(output, "jobs"), os.path.join(output, "motions")
    os.makedirs(jobs, exist_ok=True)
    make_motions(gurney, suite, MOTIONS)
    for item in items:
        print(item, flush=True)
        job, results = os.path.join(jobs, item + ".toml"), os.path.join(output, item + ".h5")
        with open(job, "w") as file:
            file.write(text_of(gurney, item, jobs, suite))
        run(gurney, job, results, threads)
        yield item, results


def options_of_studies(about):
    """Arguments of a program that runs studies beside those of the curves."""
    parser = argparse.ArgumentParser(description=about)
    for name in ("gurney", "output", "tables"):
        parser.add_argument(name)
    parser.add_argument("--items", help="some of them, with commas between (default: all)")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    return parser


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gurney")
    parser.add_argument("output")
    parser.add_argument("--items", help="of items.csv (default: all)")
    parser.add_argument("--only", action="append", default=[], help="floor, place, brakes of one configuration; repeatable")
    parser.add_argument("--variance", action="store_true", help="draws and replicas instead of the curves")
    parser.add_argument("--motions", nargs="+", default=[MOTIONS],
                        help="file of synthetic motions, or one for each level (default: that of the catalogue)")
    parser.add_argument("--suite", help="folder or list of records instead of the synthetic motions")
    parser.add_argument("--levels", default=",".join(map(str, LEVELS_OF_CURVES)), help="PGV of the ground [m/s]")
    parser.add_argument("--draws", type=int, default=1, help="of item, casters and floor for each motion (default: 1)")
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    options = parser.parse_args()
    items = chosen_items(options.items)
    jobs = os.path.join(options.output, "jobs")
    os.makedirs(jobs, exist_ok=True)
    suites = [options.suite] if options.suite else [
        os.path.join(options.output, os.path.splitext(os.path.basename(path))[0]) for path in options.motions]
    if not options.suite:
        for suite, path in zip(suites, options.motions):
            make_motions(options.gurney, suite, path)
    levels = [float(level) for level in options.levels.split(",")]
    for number, item in enumerate(items, 1):
        print(f"{number} of {len(items)}: {item['item']}", flush=True)
        job = os.path.join(jobs, item["item"] + ".toml")
        with open(job, "w") as file:
            file.write(job_text(options.gurney, item, jobs, suites, options.only, options.variance,
                                options.draws, levels))
        run(options.gurney, job, os.path.join(options.output, item["item"] + ".h5"), options.threads)


if __name__ == "__main__":
    main()
