"""Draws the pictures of the documentation with the commands of their pages.

usage: python3 docs/images/draw.py GURNEY RESULTS IMAGES [PICTURE...]
IMAGES: where the pictures go, such as docs/images. RESULTS: a folder; results files that are there are used, others
are made there (all: about an hour of CPU time). PICTURE: such as play.png; default: all. needs rsvg-convert (Debian:
librsvg2-bin), chromium for pages in a browser, graphviz for rooms.png, python3-h5py and python3-pandas for
validation_*.png.
"""

import os
import pathlib
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent.parent
JOBS = SOURCE / "studies" / "jobs"


def page(command, width, height, link=""):
    """Commands for a screenshot of a page that `command` writes."""
    return [f"{command} -o page.html --overwrite",
            "chromium --headless --no-sandbox --hide-scrollbars --disable-gpu --use-angle=swiftshader "
            "--enable-unsafe-swiftshader --virtual-time-budget=5000 --user-data-dir=$PWD/profile "
            f"--window-size={width},{height} --screenshot=$OUT \"file://$PWD/page.html{link}\""]


def figure(command, width, option="-o", drawn="drawn.svg"):
    """Commands for a figure of the program, as a picture of this width."""
    options = f" {option} {drawn} --overwrite" if option else ""
    return [command + options, f"rsvg-convert --width {width} -o $OUT {drawn}"]


def plotted(arguments, width=900):
    return figure(f"gurney plot {arguments}", width)


def replayed(run, job):
    return figure(f"gurney replay {job}.h5 {run} --job {JOBS}/{job}.toml -o replayed.h5 --overwrite", 900, "",
                  "replayed.svg")


def pulled(name, width):
    return figure("gurney pulling pulling_tests.h5 -o pulled --overwrite", width, "", f"pulled/{name}.svg")


def checked(name):
    """Of a study beside an observation."""
    return [f"mkdir -p checked && {sys.executable} -B $SOURCE/docs/validation/figures.py . checked " + name,
            f"rsvg-convert -o $OUT checked/validation_{name}.svg"]


OFFSET = "awk -F, -v OFS=, '/^[0-9]/ { $2 += 0.01; $3 -= 0.02 } 1' $SOURCE/groundmotions/records/synthetic_3c.csv > offset.csv; "
SUITE = ("mkdir -p suite; for seed in 1 2 3 4 5; do gurney records make clough_penzien seed=$seed -o suite/$seed.csv "
         "--overwrite; done; gurney records scale suite --target 'eurocode8 ground=B ag_g=0.3' --periods 0.2:2 -o suite.csv")
ROOF = ("gurney records floor $SOURCE/groundmotions/records/synthetic_3c.csv --building "
        "$SOURCE/groundmotions/buildings/lead_rubber_hospital.toml --storey roof -o roof.csv --overwrite")
CALIBRATED = "gurney calibrate $SOURCE/studies/calibration/example -o calibrated --overwrite"
VERIFIED = "gurney verify skid_to_roll alignment --json > verified.json"

# Of each picture: the jobs whose results it shows, and its commands.
PICTURES = {
    "calibration.png": ([], figure(CALIBRATED, 1180, "", "calibrated/calibration.svg")),
    "equipment.png": ([], figure("gurney equipment show icu_ventilator", 1250, "--figure")),
    "equipment_parts.png": ([], figure("gurney equipment show neonatal_incubator --variant 'door, tray and shelf'", 1060,
                                       "--figure")),
    "explain.png": (["pole_overturns"], figure("gurney explain pole_overturns.h5", 1000)),
    "hospital.png": ([], figure("gurney hospital $SOURCE/studies/hospitals/ward.toml", 1100, "--figure")),
    "icu_ventilator_shake.png": (["icu_ventilator_shake"],
                                 figure("true", 1300, "", "icu_ventilator_shake.svg")),
    "loss.png": (["icu_ventilator_fragility"],
                 figure("gurney loss icu_ventilator_fragility.h5 --measure 'PGA geomean' --hazard "
                        "$SOURCE/studies/assessment/hazard.toml", 1100, "--figure")),
    "play.png": (["icu_bay"], page("gurney play icu_bay.h5", 1080, 680, "#t=10.9")),
    "play_ghosts.png": (["icu_ventilator_fragility"],
                        page("gurney play icu_ventilator_fragility.h5 --run 262 --ghosts --job "
                             f"{JOBS}/icu_ventilator_fragility.toml", 1080, 680, "#t=12.4&view=top")),
    "plot_cloud.png": (["icu_ventilator_ida"],
                       plotted("icu_ventilator_ida.h5 cloud peak_velocity --measure 'PGV geomean' --grey")),
    "plot_collisions.png": (["ward_corridor"],
                            plotted(f"ward_corridor.h5 collisions --job {JOBS}/ward_corridor.toml --configuration "
                                    "'braked, free' --width 150mm --font-size 8")),
    "plot_ida.png": (["icu_ventilator_ida"], plotted("icu_ventilator_ida.h5 ida --configuration off")),
    "plot_trajectories.png": (["icu_bay"], plotted("icu_bay.h5 trajectories")),
    "pulling_figure_4.png": (["pulling_tests"], pulled("figure_4", 1000)),
    "pulling_figure_6.png": (["pulling_tests"], pulled("figure_6", 735)),
    "pulling_figure_7.png": (["pulling_tests"], pulled("figure_7", 1050)),
    "pulling_figure_11.png": (["pulling_tests"], pulled("figure_11", 1000)),
    "record.png": ([], figure("gurney records plot $SOURCE/groundmotions/records/synthetic_3c.csv", 1116)),
    "record_with_offset.png": ([], figure(OFFSET + "gurney records plot offset.csv", 1000)),
    "record_at_rest.png": ([], figure(OFFSET + "gurney records plot offset.csv --step 'baseline kind=end_at_rest'", 1000)),
    "report.png": (["icu_ventilator_fragility"], page("gurney report icu_ventilator_fragility.h5", 900, 1227)),
    "report_calibration.png": ([], page(f"{CALIBRATED}; gurney report calibrated/calibration.json", 900, 1227)),
    "report_verification.png": ([], page(f"{VERIFIED}; gurney report verified.json", 900, 1227)),
    "roof_of_isolated_hospital.png": ([], figure(f"{ROOF}; gurney records plot roof.csv", 1000)),
    "rooms.png": ([], [f"{sys.executable} -B $SOURCE/docs/images/rooms.py $SOURCE/tests/architecture/rooms.cmake "
                       "| dot -Tpng -o $OUT"]),
    "scaled_suite.png": ([], figure(SUITE, 1000, "--overwrite --figure")),
    "shipped_corridor.png": (["ward_corridor"], replayed(46, "ward_corridor")),
    "shipped_fragility.png": (["icu_ventilator_fragility"], figure("gurney fragility icu_ventilator_fragility.h5", 900,
                                                                   "--figure")),
    "shipped_incubator.png": (["neonatal_unit"], replayed(413, "neonatal_unit")),
    "shipped_theatre.png": (["operating_theatre"], replayed(95, "operating_theatre")),
    "shipped_trolley.png": (["trolley_orientation"], replayed(995, "trolley_orientation")),
    "tutorial_displacement.svg": (["tutorial_run"],
                                  ["gurney plot tutorial_run.h5 history displacement -o $OUT --width 150mm --overwrite"]),
    "tutorial_fragility.svg": (["tutorial_study"],
                               ["gurney plot tutorial_study.h5 fragility far overturned -o $OUT --width 150mm --overwrite"]),
    "tutorial_path.svg": (["tutorial_run"],
                          ["gurney plot tutorial_run.h5 trajectories -o $OUT --width 90mm --overwrite"]),
    "validation_b_over_h.png": (["validation_b_over_h"], checked("b_over_h")),
    "validation_half_locked.png": (["validation_half_locked"], checked("half_locked")),
    "validation_long_period.png": (["validation_long_period"], checked("long_period")),
    "validation_p58.png": (["validation_p58"], checked("p58")),
    "validation_ultrasound.png": (["validation_ultrasound"], checked("ultrasound")),
    "vector_fragility.svg": (["ventilator_brakes"],
                             ["gurney fragility ventilator_brakes.h5 --limit moved --measure 'PGA geomean' --and "
                              "'PGV geomean' --figure $OUT --overwrite"]),
}


# Pictures that need hours, or a hand: how each was made.
OTHERS = {
    "peers.svg": "./dev bench --peers FOLDER",
    "sensitivity_total.svg": "gurney sensitivity --figure of ventilator_sensitivity with 8 records and 64 draws",
    "synthetic_motions.png": "gnuplot, of gurney records make with default values",
    "workbench.png": "the page of ./dev workbench, after Shake",
    "workbench_item.png": "the page of ./dev workbench, after Edit item",
}


def draw(name, results, images):
    jobs, commands = PICTURES[name]
    for job in jobs:
        if not (results / f"{job}.h5").exists():
            subprocess.run(["gurney", "run", JOBS / f"{job}.toml", "-o", f"{job}.h5"], cwd=results, check=True,
                           stdout=subprocess.DEVNULL)
    for command in commands:
        subprocess.run(command, shell=True, cwd=results, check=True, env=os.environ | {"OUT": str(images / name)},
                       stdout=subprocess.DEVNULL)


def use(program):
    """Makes `gurney` of the commands this program."""
    os.environ |= {"PATH": f"{pathlib.Path(program).resolve().parent}:{os.environ['PATH']}", "SOURCE": str(SOURCE)}


if __name__ == "__main__":
    if len(sys.argv) < 4:
        raise SystemExit(__doc__)
    use(sys.argv[1])
    folders = [pathlib.Path(each).resolve() for each in sys.argv[2:4]]
    for folder in folders:
        folder.mkdir(parents=True, exist_ok=True)
    for name in sys.argv[4:] or PICTURES:
        draw(name, *folders)
        print(name)
