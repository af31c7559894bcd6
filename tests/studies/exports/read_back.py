"""Reads what `gurney export` wrote with Python's own parsers and compares it with the study."""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

GURNEY, WRITE = sys.argv[1:3]
G = 9.80665
FAILED = 17  # SyntheticStudy::kFailed
RECORDS, LEVELS = 40, 6


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file))


def close(a, b, relative=1e-12):
    assert abs(a - b) <= relative * max(abs(a), abs(b)), (a, b)


def export(*arguments):
    return subprocess.run([GURNEY, "export", study, *arguments], check=True, text=True,
                          capture_output=True)


def check_pelicun():
    shown = export("--to", "pelicun", "-o", "pelicun")
    assert "omitted false, 'rolled': no run exceeds" in shown.stderr, shown.stderr
    header, *rows = table("pelicun/fragility.csv")
    groups = [f"LS{i}-{name}" for i in (1, 2, 3, 4)
              for name in ("Family", "Theta_0", "Theta_1", "DamageStateWeights")]
    assert header == ["ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset",
                      "Demand-Directional"] + groups
    assert [row[0] for row in rows] == ["synthetic.false.moved", "synthetic.true.moved"]
    for row, (theta, beta) in zip(rows, curves):
        assert row[1:7] == ["0", "Peak Ground Acceleration", "g", "0", "0", "lognormal"]
        close(float(row[7]) * G, theta)
        close(float(row[8]), beta)
        assert row[9:] == [""] * 13
    with open("pelicun/fragility.json", encoding="utf-8") as file:
        described = json.load(file)
    assert set(described.pop("_GeneralInformation")) == {"ShortName", "Description", "Version",
                                                         "ComponentGroups"}
    described.pop("References")
    assert list(described) == [row[0] for row in rows]
    for each in described.values():
        assert set(each) == {"Description", "Comments", "Reference", "SuggestedComponentBlockSize",
                             "RoundUpToIntegerQuantity", "LimitStates"}
        assert set(each["LimitStates"]["LS1"]["DS1"]) == {"Description", "RepairAction"}
        assert "residual_displacement > 0.02 m" in each["Description"]
    assert "239 runs with 40 records" in described["synthetic.false.moved"]["Comments"]
    assert "1 failed" in described["synthetic.false.moved"]["Comments"]
    listed, *cautions = table("pelicun/fragility_cautions.csv")
    assert listed == ["ID", "Caution"]
    for name, caution in cautions:
        text = caution.split(": ", 1)[1]  # behind the limit state
        assert text in described[name]["Comments"], (caution, described[name]["Comments"])
    export("--to", "pelicun", "-o", "floor", "--measure", "pfv", "--configuration", "true")
    _, row = table("floor/fragility.csv")
    assert row[2:4] == ["Peak Floor Velocity", "mps"]
    close(float(row[7]), 0.1 * curves[1][0], 1e-6)  # pfv is 0.1 s times the PGA
    export("--to", "pelicun", "-o", "sa", "--measure", "Sa(1) RotD50")
    assert table("sa/fragility.csv")[1][2] == "Spectral Acceleration|1.0"


def check_nrml():
    export("--to", "nrml", "-o", "nrml")
    assert os.listdir("nrml") == ["moved.xml"]
    space = "{http://openquake.org/xmlns/nrml/0.5}"
    (model,) = xml.parse("nrml/moved.xml").getroot()
    assert model.tag == space + "fragilityModel"
    assert model.get("lossCategory") == "contents"
    assert "Synthetic & <plain>" in model.find(space + "description").text
    assert model.find(space + "limitStates").text == "moved"
    functions = model.findall(space + "fragilityFunction")
    assert [f.get("id") for f in functions] == ["false", "true"]
    for function, (theta, beta) in zip(functions, curves):
        assert (function.get("format"), function.get("shape")) == ("continuous", "logncdf")
        imls, params = function.find(space + "imls"), function.find(space + "params")
        assert imls.get("imt") == "PGA"
        assert params.get("ls") == "moved"
        mean, deviation = float(params.get("mean")), float(params.get("stddev"))
        # As OpenQuake takes them: parameters of the lognormal distribution from its moments.
        variance = math.log(1 + (deviation / mean) ** 2)
        close(math.exp(math.log(mean) - variance / 2) * G, theta)
        close(math.sqrt(variance), beta)
        assert float(imls.get("minIML")) <= 0.1 and float(imls.get("maxIML")) >= 1.2
    export("--to", "nrml", "-o", "nrml_sa", "--measure", "Sa(1) RotD50", "--limit", "moved")
    imls = xml.parse("nrml_sa/moved.xml").find(f".//{space}imls")
    assert imls.get("imt") == "SA(1.0)"


def check_tables():
    export("--to", "csv", "-o", "tables")
    assert sorted(os.listdir("tables")) == [name + ".csv" for name in (
        "assumptions", "configurations", "drawn", "failures", "half_step", "items", "motions",
        "points", "records", "runs", "warnings")]
    names, units, *rows = table("tables/runs.csv")
    assert len(rows) == 2 * RECORDS * LEVELS
    assert units[names.index("pfa")] == "m/s2"
    for i, row in enumerate(rows):
        assert int(row[names.index("run")]) == i
        level = (0.1, 0.2, 0.3, 0.5, 0.8, 1.2)[i % LEVELS]
        assert float(row[names.index("intensity")]) == level * G  # exactly
    names, _, *rows = table("tables/failures.csv")
    assert rows == [["0", str(FAILED), 'did not converge, "badly"']]
    # Drawn numbers have the unit of their key, not that of the column.
    names, units, *rows = table("tables/drawn.csv")
    assert units[names.index("value")] == "see unit", units
    assert {(row[names.index("variable")], row[names.index("unit")]) for row in rows} == {
        ("tread.patch_width_mm", "mm")}, rows[:2]
    names, _, *rows = table("tables/items.csv")
    assert len(rows) == 2 * RECORDS * LEVELS - 1
    assert rows[0][names.index("direction_of_overturning")] == ""


def check_responses():
    export("--to", "response-csv", "-o", "responses")
    names, units, *rows = table("responses/response_false.csv")
    assert names[0] == "" and units[0] == "Units"
    assert [row[0] for row in rows] == [str(i) for i in range(RECORDS * LEVELS)]
    moved = names.index("ICU bed.residual_displacement")
    assert units[moved] == "m" and units[names.index("PGA larger")] == "m/s2"
    assert units[names.index("tread.patch_width_mm")] == "mm"
    _, _, *items = table("tables/items.csv")
    column = table("tables/items.csv")[0].index("residual_displacement")
    by_run = {row[1]: row[column] for row in items}
    for row in rows:
        failed = int(row[0]) == FAILED
        assert row[names.index("ERROR")] == ("1" if failed else "0")
        assert row[moved] == by_run.get(row[0], ""), row
        close(float(row[names.index("tread.patch_width_mm")]), 3 + 0.1 * (int(row[0]) // LEVELS))
        if failed:
            first = names.index("ICU bed.peak_displacement")
            assert all(cell == "" for cell in row[first:-1]), row
    assert len(os.listdir("responses")) == 2 * (1 + LEVELS)
    # Level 0.1 g of configuration `false`: runs 0, 6, 12 and so on; the failed one is at 1.2 g.
    known = {"mps2", "mps", "m", "rad", "sec", "N", "unitless", ""}
    names, units, *rows = table("responses/demands_false_0_1_g.csv")
    assert names[1:3] == ["PFA-0-1", "PFV-0-1"] and names[-1] == "ERROR"
    assert all(len(name.split("-")) == 3 for name in names[1:-1]), names
    assert set(units[1:]) <= known, units
    assert [int(row[0]) for row in rows] == list(range(0, RECORDS * LEVELS, LEVELS))
    close(float(rows[0][1]), 1.5 * 0.1 * G)
    names, _, *rows = table("responses/demands_false_1_2_g.csv")
    (failed,) = [row for row in rows if row[-1] == "1"]
    assert int(failed[0]) == FAILED and set(failed[1:-1]) == {""}, failed


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    study = "study.h5"
    printed = subprocess.run([WRITE, study], check=True, text=True, capture_output=True).stdout
    curves = [tuple(map(float, line.split())) for line in printed.splitlines()]
    # SyntheticStudy::curve(); 40 capacities on quantiles give beta back within a few percent.
    for (theta, beta), (true_theta, true_beta) in zip(curves, ((0.35, 0.4), (0.6, 0.5))):
        close(theta, true_theta * G, 0.05)
        close(beta, true_beta, 0.1)
    check_pelicun()
    check_nrml()
    check_tables()
    check_responses()
    export("--to", "csv", "-o", "tables", "--overwrite")
print("read back")
