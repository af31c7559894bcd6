"""meshio reads the shapes that `gurney export --to xdmf` writes, at their places."""

import os
import tempfile
import xml.etree.ElementTree as tree

import support

support.need("meshio", "h5py")
import h5py  # noqa: E402
import meshio  # noqa: E402

with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    support.gurney("run", os.path.join(support.SOURCE, "studies/jobs/trolley_meets_wall.toml"),
                   "-o", "run.h5", "--no-figure")
    support.gurney("export", "run.h5", "--to", "xdmf", "-o", ".")
    times = tree.parse("run.xdmf").getroot().find("Domain/Grid").findall("Grid")
    with h5py.File("run.h5") as run:
        assert len(times) == len(run["histories/time"]), len(times)
        walls = [kind for kind, item in zip(run["shapes/kind"].asstr(), run["shapes/item"].asstr())
                 if not item]
    assert walls, "the job has no room"
    # meshio reads one grid of a file: those of the first and the last time, each in a file.
    for moment in (times[0], times[-1]):
        grids = moment.findall("Grid")
        assert [grid.get("Name") for grid in grids] == ["items", "room"]
        for grid in grids:
            root = tree.Element("Xdmf", Version="3.0")
            tree.SubElement(root, "Domain").append(grid)
            tree.ElementTree(root).write("one.xdmf")
            mesh = meshio.read("one.xdmf")
            path = grid.find("Geometry/DataItem").text.split(":")[1]
            with h5py.File("run_shapes.h5") as shapes:
                assert (mesh.points == shapes[path][:]).all()
            kinds = {block.type for block in mesh.cells}
            assert kinds <= {"hexahedron", "quad", "triangle", "vertex"}, kinds
            cells = sum(len(block.data) for block in mesh.cells)
            assert cells == int(grid.find("Topology").get("NumberOfElements")), cells
            item = [value for block in mesh.cell_data["item"] for value in block]
            assert set(item) == ({-1} if grid.get("Name") == "room" else {0}), set(item)
print("meshio reads", len(times), "times")
