"""`gurney export ITEM --to urdf` of every item: a tree of links whose masses are those of the item.

Where urdfdom is installed (Debian: liburdfdom-tools) check_urdf reads the files as well.
"""

import json
import math
import os
import shutil
import subprocess
import tempfile
import xml.etree.ElementTree as xml

import support

support.need("numpy")
import numpy  # noqa: E402

CHECK = shutil.which("check_urdf")


def vector(text):
    return numpy.array([float(each) for each in text.split()])


def about_z(angle):
    c, s = math.cos(angle), math.sin(angle)
    return numpy.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def poses(robot):
    """Place and axes of each link, from the joints at 0; every link but the root has one parent."""
    found = {"chassis": (numpy.zeros(3), numpy.eye(3))}
    joints = robot.findall("joint")
    names = [link.get("name") for link in robot.findall("link")]
    children = [joint.find("child").get("link") for joint in joints]
    assert len(set(names)) == len(names) and sorted(children) == sorted(set(names) - {"chassis"})
    for joint in joints:  # parents stand before their children
        place, axes = found[joint.find("parent").get("link")]
        origin = joint.find("origin")
        roll, pitch, yaw = vector(origin.get("rpy"))
        assert roll == pitch == 0
        assert joint.get("type") in ("continuous", "fixed")
        assert (joint.find("axis") is not None) == (joint.get("type") == "continuous")
        found[joint.find("child").get("link")] = (place + axes @ vector(origin.get("xyz")),
                                                  axes @ about_z(yaw))
    return found


def mass_properties(robot):
    placed = poses(robot)
    parts = []
    for link in robot.findall("link"):
        inertial = link.find("inertial")
        i = {name: float(value) for name, value in inertial.find("inertia").attrib.items()}
        inertia = numpy.array([[i["ixx"], i["ixy"], i["ixz"]], [i["ixy"], i["iyy"], i["iyz"]],
                               [i["ixz"], i["iyz"], i["izz"]]])
        assert numpy.linalg.eigvalsh(inertia)[0] >= -1e-12, link.get("name")
        place, axes = placed[link.get("name")]
        parts.append((float(inertial.find("mass").get("value")),
                      place + axes @ vector(inertial.find("origin").get("xyz")),
                      axes @ inertia @ axes.T))
    mass = sum(m for m, _, _ in parts)
    center = sum(m * c for m, c, _ in parts) / mass
    inertia = sum(i + m * ((c - center) @ (c - center) * numpy.eye(3)
                           - numpy.outer(c - center, c - center)) for m, c, i in parts)
    return mass, center, inertia


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    items = json.loads(support.gurney("equipment", "ls", "--json"))["items"]
    for name in [item["key"] for item in items]:
        support.gurney("export", name, "--to", "urdf", "-o", folder)
        path = os.path.join(folder, name + ".urdf")
        robot = xml.parse(path).getroot()
        assert robot.tag == "robot" and robot.get("name")
        mass, center, inertia = mass_properties(robot)
        shown = json.loads(support.gurney("equipment", "show", name, "--json"))
        # Numbers read back as the same; 20 sums and products of 2^-53 each.
        assert abs(mass / shown["mass_kg"] - 1) < 1e-14, (name, mass)
        stated = numpy.array(shown["center_of_mass_m"])
        assert abs(center - stated).max() < 1e-14 * (1 + abs(stated).max()), (name, center)
        tensor = numpy.array(shown["inertia_kg_m2"])
        scale = abs(tensor).max() + mass * (1 + stated @ stated)
        assert abs(inertia - tensor).max() < 1e-13 * scale, (name, inertia)
        for shape in robot.iter("collision"):
            assert shape.find("geometry")[0].tag in ("box", "cylinder")
        if CHECK:
            subprocess.run([CHECK, path], check=True, capture_output=True)
print(f"{len(items)} items are trees of links" + ("" if CHECK else "; check_urdf is not installed"))
