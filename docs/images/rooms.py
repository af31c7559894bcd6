"""Draws docs/images/rooms.png from the table of rooms: who may include whom, without transitive arrows.

usage: python3 docs/images/rooms.py tests/architecture/rooms.cmake | dot -Tpng -o docs/images/rooms.png
(Debian: graphviz)
"""

import re
import sys

COLORS = {"engine": "#dbe9f6", "groundmotions": "#e2f0d9", "equipment": "#fdebd0", "studies": "#ece4f4"}

text = re.search(r"set\(GURNEY_ROOMS(.*?)\)", open(sys.argv[1]).read(), re.S).group(1)
rooms = {}
for line in re.findall(r'"([^"]*)"', text):
    name, _, below = line.partition(":")
    rooms[name] = below.split()


def reach(room):
    found = set()
    for below in rooms[room]:
        found |= {below} | reach(below)
    return found


print('digraph rooms { rankdir=BT; node [shape=box, style="filled,rounded", fontname="sans-serif", fontsize=11, '
      'height=0.32, color="#666666"]; edge [color="#888888", arrowsize=0.6]; dpi=110; ranksep=0.45; nodesep=0.16;')
for room, below in rooms.items():
    top, _, rest = room.partition("/")
    print(f'"{room}" [label="{rest.replace("study/", "")}", fillcolor="{COLORS[top]}"];')
    indirect = set().union(*(reach(other) for other in below)) if below else set()
    for other in below:
        if other not in indirect:
            print(f'"{room}" -> "{other}";')
print("}")
