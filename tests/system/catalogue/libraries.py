"""The component libraries of the catalogue follow the rules of the formats, and hold every curve of its table.

The rules are those of the Damage and Loss Model Library 3.1 and of NRML 0.5 in our words.

usage: libraries.py SOURCE_DIR
"""

import csv
import filecmp
import json
import os
import re
import shutil
import sys
import tempfile
import xml.etree.ElementTree as xml

sys.dont_write_bytecode = True
source = sys.argv[1]
sys.path.insert(0, os.path.join(source, "studies", "catalogue"))
import libraries  # noqa: E402

data = os.path.join(source, "docs", "catalogue", "data")
with open(os.path.join(data, "fragility.csv"), newline="") as file:
    curves = [row for row in csv.DictReader(file) if row["theta"]]


def check_pelicun():
    with open(os.path.join(data, "pelicun", "fragility.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    with open(os.path.join(data, "pelicun", "fragility.json")) as file:
        facts = json.load(file)
    general = facts.pop("_GeneralInformation")
    references = facts.pop("References")
    assert set(general) == {"ShortName", "Description", "Version", "ComponentGroups"}, general
    assert all(isinstance(general[key], str) and general[key] for key in ("ShortName", "Description", "Version"))
    assert isinstance(general["ComponentGroups"], dict) and general["ComponentGroups"]
    assert all(isinstance(text, str) for text in references.values())
    assert set(facts) == {row["ID"] for row in rows} and len(facts) == len(rows)
    fixed = {"ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional"}
    assert all(name in fixed or re.fullmatch(r"LS\d+-(Family|Theta_0|Theta_1|DamageStateWeights)", name)
               for name in rows[0])
    states_of = {}
    for row in rows:
        about = facts[row["ID"]]
        assert row["Incomplete"] in ("0", "1") and row["Demand-Directional"] in ("0", "1"), row
        assert row["Demand-Type"] == "Peak Floor Velocity" and float(row["Demand-Offset"]).is_integer(), row
        assert set(about) == {"Description", "Comments", "Reference", "SuggestedComponentBlockSize",
                              "RoundUpToIntegerQuantity", "LimitStates"}, about
        assert about["RoundUpToIntegerQuantity"] in ("True", "False")
        assert set(about["Reference"]) <= set(references)
        states = [f"LS{i}" for i in range(1, 5) if row[f"LS{i}-Family"]]
        assert states == list(about["LimitStates"]) and states, row["ID"]
        parameters = [(float(row[f"{each}-Theta_0"]), float(row[f"{each}-Theta_1"])) for each in states]
        assert all(theta > 0 and beta > 0 for theta, beta in parameters) and not libraries.cross(parameters), row["ID"]
        names = [about["LimitStates"][each][each.replace("LS", "DS")]["Description"] for each in states]
        states_of[row["ID"]] = row["Incomplete"], names
    # A component is incomplete where a curve of it is not supported, and each supported curve is in a complete one.
    complete = 0
    for row in (each for each in curves if each["measure"] == "pfv"):
        setting = f"{row['item']}." + libraries.plain("_".join([row["floor"], row["place"], row["brakes"]])) + "."
        of = [(flag, names) for name, (flag, names) in states_of.items()
              if name.startswith(setting) and row["limit_state"] in names]
        assert of, row
        assert libraries.supported(row) == any(flag == "0" for flag, _ in of), (row, of)
        complete += libraries.supported(row)
    assert complete > 1000, complete
    return len(rows)


def check_nrml():
    count = 0
    space = f"{{{libraries.NRML}}}"
    for name in sorted(os.listdir(os.path.join(data, "nrml"))):
        model = xml.parse(os.path.join(data, "nrml", name)).getroot().find(space + "fragilityModel")
        states = model.find(space + "limitStates").text.split()
        ids = set()
        for function in model.findall(space + "fragilityFunction"):
            assert [each.get("ls") for each in function.findall(space + "params")] == states, function.get("id")
            assert function.get("id") not in ids, function.get("id")
            ids.add(function.get("id"))
            imls = function.find(space + "imls")
            assert imls.get("imt") == "PGV" and 0 < float(imls.get("minIML")) < float(imls.get("maxIML"))
            count += 1
    return count


components, functions = check_pelicun(), check_nrml()
with tempfile.TemporaryDirectory() as work:
    shutil.copy(os.path.join(data, "fragility.csv"), work)
    libraries.write(work)
    for folder in ("pelicun", "nrml"):
        same = filecmp.dircmp(os.path.join(work, folder), os.path.join(data, folder))
        assert not (same.left_only or same.right_only or same.diff_files), (folder, same.diff_files)
print(f"{components} components and {functions} functions follow the rules and are those of the table")
