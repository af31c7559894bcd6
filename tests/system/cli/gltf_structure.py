#!/usr/bin/env python3
"""A file of glTF 2.0 is as its specification demands: usage gltf_structure.py FILE.gltf

Khronos Group, glTF 2.0 Specification, version 2.0.1: sections 3.6 (buffers, accessors), 3.7 (meshes),
3.11 (animations). Prints what is wrong; nothing and exit code 0: nothing is.
"""
import base64
import json
import math
import struct
import sys

COMPONENTS = {5120: ("b", 1), 5121: ("B", 1), 5122: ("h", 2), 5123: ("H", 2), 5125: ("I", 4),
              5126: ("f", 4)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
OUTPUTS = {"translation": "VEC3", "rotation": "VEC4", "scale": "VEC3"}

wrong = []


def check(right, message):
    if not right:
        wrong.append(message)
    return right


def buffers_of(file):
    buffers = []
    for i, buffer in enumerate(file["buffers"]):
        head, _, data = buffer["uri"].partition(",")
        check(head == "data:application/octet-stream;base64", f"buffer {i}: {head}")
        buffers.append(base64.b64decode(data, validate=True))
        check(len(buffers[i]) == buffer["byteLength"], f"buffer {i}: length {len(buffers[i])}")
    return buffers


def check_views(file, buffers):
    for i, view in enumerate(file["bufferViews"]):
        end = view.get("byteOffset", 0) + view["byteLength"]
        check(view["byteLength"] >= 1 and end <= len(buffers[view["buffer"]]),
              f"bufferView {i}: leaves its buffer")


def values_of(file, buffers, index):
    """The rows of an accessor, after its bounds, alignment, minimum and maximum are checked."""
    accessor = file["accessors"][index]
    name = f"accessor {index}"
    code, size = COMPONENTS[accessor["componentType"]]
    width = WIDTHS[accessor["type"]]
    view = file["bufferViews"][accessor["bufferView"]]
    inside, start = accessor.get("byteOffset", 0), view.get("byteOffset", 0)
    stride = view.get("byteStride", size * width)
    check(accessor["count"] >= 1, f"{name}: is empty")
    check(inside % size == 0 and (inside + start) % size == 0, f"{name}: is not aligned")
    last = inside + stride * (accessor["count"] - 1) + size * width
    if not check(last <= view["byteLength"], f"{name}: leaves its bufferView"):
        return []
    data = buffers[view["buffer"]]
    rows = [struct.unpack_from(f"<{width}{code}", data, start + inside + stride * row)
            for row in range(accessor["count"])]
    check(all(math.isfinite(v) for row in rows for v in row), f"{name}: a value is not finite")
    for key, least in (("min", min), ("max", max)):
        if key in accessor:
            stated = [struct.unpack("<f", struct.pack("<f", v))[0] for v in accessor[key]]
            found = [least(row[k] for row in rows) for k in range(width)]
            check(stated == found, f"{name}: {key} is {stated}, the values have {found}")
    return rows


def check_meshes(file, rows):
    for i, mesh in enumerate(file["meshes"]):
        for primitive in mesh["primitives"]:
            attributes = primitive["attributes"]
            position = file["accessors"][attributes["POSITION"]]
            check("min" in position and "max" in position, f"mesh {i}: POSITION without min or max")
            counts = {file["accessors"][a]["count"] for a in attributes.values()}
            check(len(counts) == 1, f"mesh {i}: attributes of different length")
            if primitive.get("mode", 4) == 4 and "indices" not in primitive:
                check(position["count"] % 3 == 0, f"mesh {i}: no whole triangles")
            for normal in rows[attributes["NORMAL"]] if "NORMAL" in attributes else []:
                # Single precision: three squares of relative error 6e-8 each.
                check(abs(math.hypot(*normal) - 1) < 1e-6, f"mesh {i}: a normal is no unit vector")
            if "material" in primitive:
                check(primitive["material"] < len(file["materials"]), f"mesh {i}: no such material")


def check_nodes(file):
    parents = [0] * len(file["nodes"])
    for i, node in enumerate(file["nodes"]):
        for child in node.get("children", []):
            parents[child] += 1
        check("mesh" not in node or node["mesh"] < len(file["meshes"]), f"node {i}: no such mesh")
    check(all(count <= 1 for count in parents), "a node has two parents")
    for root in (r for scene in file["scenes"] for r in scene["nodes"]):
        check(parents[root] == 0, f"node {root} of a scene is a child")


def check_animations(file, rows):
    for animation in file.get("animations", []):
        targets = set()
        for channel in animation["channels"]:
            target, sampler = channel["target"], animation["samplers"][channel["sampler"]]
            key = (target["node"], target["path"])
            check(key not in targets, f"{key}: two channels")
            targets.add(key)
            times, values = rows[sampler["input"]], rows[sampler["output"]]
            if not check(times and values, f"{key}: no times or no values"):
                continue
            given = file["accessors"][sampler["input"]]
            check(given["type"] == "SCALAR" and given["componentType"] == 5126
                  and "min" in given and "max" in given, f"{key}: times")
            check(times[0][0] >= 0 and all(a < b for a, b in zip(times, times[1:])),
                  f"{key}: times do not increase")
            check(len(times) == len(values), f"{key}: {len(times)} times, {len(values)} values")
            check(file["accessors"][sampler["output"]]["type"] == OUTPUTS[target["path"]],
                  f"{key}: type of its values")
            if target["path"] == "rotation":
                check(all(abs(math.hypot(*q) - 1) < 1e-6 for q in values),
                      f"{key}: a quaternion is no unit quaternion")


def main():
    with open(sys.argv[1], encoding="utf-8") as stream:
        file = json.load(stream)
    check(file["asset"]["version"] == "2.0", "asset.version")
    buffers = buffers_of(file)
    check_views(file, buffers)
    rows = [values_of(file, buffers, i) for i in range(len(file["accessors"]))]
    check_meshes(file, rows)
    check_nodes(file)
    check_animations(file, rows)
    print("\n".join(wrong[:20]), end="\n" if wrong else "")
    return 1 if wrong else 0


sys.exit(main())
