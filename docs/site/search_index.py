"""Leaves the tables of single items of the catalogue out of the search: their overview and methods remain."""

import json
import os

SEARCHED = {"items", "methods", "motions", "hospital"}


def is_data(location):
    folder, _, page = location.partition("#")[0].removesuffix(".html").partition("/")
    return folder == "catalogue" and page not in SEARCHED


def on_post_build(config, **_):
    path = os.path.join(config["site_dir"], "search", "search_index.json")
    with open(path, encoding="utf-8") as file:
        index = json.load(file)
    index["docs"] = [entry for entry in index["docs"] if not is_data(entry["location"])]
    with open(path, "w", encoding="utf-8") as file:
        json.dump(index, file)
