"""Writes the component libraries of the fragility catalogue from its table of curves.

usage: libraries.py TABLES

TABLES holds fragility.csv, a row for each limit state. Written are pelicun/ (over the peak floor velocity) and
nrml/ (over the PGV of the ground), with the limit states of one demand as ordered states of one component: moved
0.1, 0.3 and 1 m are LS1 to LS3. Curves that would cross get their mean beta and keep their 10 % points, as `gurney
export` does (Porter, Kennedy & Bachman 2007, Earthquake Spectra 23(2), 471-489).
"""

import csv
import json
import math
import os
import re
import sys
import xml.etree.ElementTree as xml

HERE = os.path.dirname(os.path.abspath(__file__))
COMPONENTS = {"moved": ("moved 0.1 m", "moved 0.3 m", "moved 1 m"), "hit": ("hit at 0.4 m/s", "hit at 0.8 m/s"),
              "overturned": ("overturned",)}
MEASURES = {"pfv": ("Peak Floor Velocity", "mps", 1), "PGV larger": ("PGV", "cm/s", 0.01)}
# cautions of a curve that its runs do not support
UNSUPPORTED = ("extrapolated", "leave theta and beta uncertain", "no usable interval")
STATES = 4  # groups of columns in the Damage and Loss Model Library
NRML = "http://openquake.org/xmlns/nrml/0.5"
TAIL = 3.719016485  # standard deviations: 1e-4 is left out at each end of a function
REFERENCES = {
    "Baker2015": "Baker, J. W. (2015). Efficient analytical fragility function fitting using dynamic structural "
                 "analysis. Earthquake Spectra 31(1), 579-599.",
    "Porter2007": "Porter, K., Kennedy, R. & Bachman, R. (2007). Creating fragility functions for performance-based "
                  "earthquake engineering. Earthquake Spectra 23(2), 471-489."}


def plain(name):
    return re.sub(r"\W+", "_", name)


def supported(row):
    return not any(words in row["cautions"] for words in UNSUPPORTED)


def probability(curve, im):
    return 0.5 * math.erfc(-math.log(im / curve[0]) / curve[1] / math.sqrt(2))


def cross(curves):
    """Is a stricter state more probable than a milder one by 0.001 or more?"""
    low = min(theta * math.exp(-TAIL * beta) for theta, beta in curves)
    high = max(theta * math.exp(TAIL * beta) for theta, beta in curves)
    intensities = [low * (high / low) ** (i / 1000) for i in range(1001)]
    return any(probability(stricter, im) >= probability(milder, im) + 1e-3
               for milder, stricter in zip(curves, curves[1:]) for im in intensities)


def in_order(curves):
    """The curves, changed where they cross, and whether they were."""
    if not cross(curves):
        return curves, False
    mean, ordered = sum(beta for _, beta in curves) / len(curves), []
    for theta, beta in curves:
        milder = ordered[-1][0] if ordered else 0
        ordered.append((max(milder, theta * math.exp(1.28 * (mean - beta))), mean))
    return ordered, True


def components(rows, measure):
    """(id, rows, curves, changed) of each component over a measure; where a curve is not supported, the component
    of the others too."""
    settings = {}
    for row in rows:
        if row["measure"] == measure and row["theta"]:
            key = (row["item"], plain("_".join([row["floor"], row["place"], row["brakes"]])))
            settings.setdefault(key, {})[row["limit_state"]] = row
    for (item, setting), states in settings.items():
        for names in COMPONENTS.values():
            present = [states[name] for name in names if name in states]
            known = [row for row in present if supported(row)]
            for chosen in [present] + ([known] if known and len(known) < len(present) else []):
                if chosen:
                    yield (f"{item}.{setting}." + "_".join(plain(row["limit_state"]) for row in chosen), chosen,
                           *in_order([(float(row["theta"]), float(row["beta"])) for row in chosen]))


def version():
    with open(os.path.join(HERE, "..", "..", "CMakeLists.txt")) as file:
        return re.search(r"project\(gurney VERSION (\S+)", file.read())[1]


def description(name, rows, changed):
    first = rows[0]
    setting = ", ".join([first["floor"], first["place"], first["brakes"]])
    about = " ".join(
        f"{row['limit_state']}: {row['exceed']} of {row['runs']} runs exceed; {row['failed']} failed runs are not "
        f"counted.{' Caution: ' + row['cautions'] + '.' if row['cautions'] else ''}" for row in rows)
    if changed:
        about += " Caution: the fitted curves cross; they were given their mean beta, and keep their 10 % points."
    if not all(map(supported, rows)):
        about += " Incomplete: the runs do not support every curve."
    return {"Description": f"Fragility catalogue: {first['item']}, {setting}: "
                           + "; ".join(row["limit_state"] for row in rows),
            "Comments": about + " The peak floor velocity is one number for both horizontal directions: set pelicun's "
                        "multiplier for non-directional demands to 1. Record-to-record and drawn scatter only; no "
                        "dispersion was added.",
            "Reference": ["Baker2015"] + (["Porter2007"] if changed else []),
            "SuggestedComponentBlockSize": "1 EA", "RoundUpToIntegerQuantity": "True",
            "LimitStates": {f"LS{i}": {f"DS{i}": {"Description": row["limit_state"],
                                                  "RepairAction": "Not part of this study."}}
                            for i, row in enumerate(rows, 1)}}


def write_pelicun(rows, folder):
    os.makedirs(folder, exist_ok=True)
    measure, unit, in_si = MEASURES["pfv"]
    header = ["ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional"]
    for i in range(1, STATES + 1):
        header += [f"LS{i}-{each}" for each in ("Family", "Theta_0", "Theta_1", "DamageStateWeights")]
    lines, facts, groups = [], {}, {}
    for name, of, curves, changed in components(rows, "pfv"):
        cells = [name, 0 if all(map(supported, of)) else 1, measure, unit, 0, 0]
        for theta, beta in curves:
            cells += ["lognormal", f"{theta / in_si:.6g}", f"{beta:.6g}", ""]
        lines.append(cells + [""] * (len(header) - len(cells)))
        facts[name] = description(name, of, changed)
        groups[of[0]["item"]] = of[0]["item"].replace("_", " ")
    general = {"ShortName": "Gurney catalogue",
               "Description": "Fragility of hospital equipment on casters over the peak floor velocity, by simulation: "
                              "items by floor, place and brakes. States of one component are ordered.",
               "Version": f"gurney {version()}", "ComponentGroups": groups}
    with open(os.path.join(folder, "fragility.csv"), "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header] + lines)
    with open(os.path.join(folder, "fragility.json"), "w") as file:
        json.dump({"_GeneralInformation": general, "References": REFERENCES} | facts, file, indent=1)
        file.write("\n")


def write_nrml(rows, folder):
    """A file for each set of states: all functions of a file have the same."""
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        if name.endswith(".xml"):
            os.remove(os.path.join(folder, name))
    xml.register_namespace("", NRML)
    measure, _, in_si = MEASURES["PGV larger"]
    models = {}
    known = list(components(rows, "PGV larger"))
    for name, of, curves, changed in known:
        names = [plain(row["limit_state"]) for row in of]
        if names not in models.values():
            models["_".join(names)] = names
    for file, names in models.items():
        root = xml.Element(f"{{{NRML}}}nrml")
        model = xml.SubElement(root, f"{{{NRML}}}fragilityModel", id="gurney_catalogue_" + file,
                               assetCategory="contents", lossCategory="contents")
        xml.SubElement(model, f"{{{NRML}}}description").text = (
            "Gurney fragility catalogue, PGV of the ground; cautions in fragility.csv. mean and stddev are those of "
            "the intensity, not median and beta. Functions with fewer states, where the runs support no others, are "
            "in the files of the same names.")
        xml.SubElement(model, f"{{{NRML}}}limitStates").text = " ".join(names)
        for name, of, curves, changed in known:
            if [plain(row["limit_state"]) for row in of] != names:
                continue
            in_unit = [(theta / in_si, beta) for theta, beta in curves]
            function = xml.SubElement(model, f"{{{NRML}}}fragilityFunction", id=name.rsplit(".", 1)[0],
                                      format="continuous", shape="logncdf")
            xml.SubElement(function, f"{{{NRML}}}imls", imt=measure,
                           minIML=f"{min(theta * math.exp(-TAIL * beta) for theta, beta in in_unit):.6g}",
                           maxIML=f"{max(theta * math.exp(TAIL * beta) for theta, beta in in_unit):.6g}")
            for state, (theta, beta) in zip(names, in_unit):
                mean = theta * math.exp(beta ** 2 / 2)
                xml.SubElement(function, f"{{{NRML}}}params", ls=state, mean=f"{mean:.10g}",
                               stddev=f"{mean * math.sqrt(math.expm1(beta ** 2)):.10g}")
        xml.indent(root)
        xml.ElementTree(root).write(os.path.join(folder, file + ".xml"), encoding="UTF-8", xml_declaration=True)


def write(tables):
    with open(os.path.join(tables, "fragility.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    write_pelicun(rows, os.path.join(tables, "pelicun"))
    write_nrml(rows, os.path.join(tables, "nrml"))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    write(sys.argv[1])


if __name__ == "__main__":
    main()
