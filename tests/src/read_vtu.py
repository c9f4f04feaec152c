"""Prints the contents of the VTU files of a run as read by meshio, as JSON: python read_vtu.py DIRECTORY

Reads every .vtu file that the .pvd files of the directory list; there must be no other .vtu files.
"""

import json
import sys
import xml.etree.ElementTree as tree
from pathlib import Path

import meshio
import numpy


def numbers(array):
    flat = numpy.asarray(array, dtype=float)
    components = 1 if flat.ndim == 1 else flat.shape[1]
    assert numpy.isfinite(flat).all()
    return {
        "components": components,
        "count": flat.shape[0],
        "sum": float(flat.sum()),
        "least": float(flat.min()),
        "largest": float(flat.max()),
    }


def described(path):
    mesh = meshio.read(path)
    corners = [block.data for block in mesh.cells]
    assert all(0 <= block.min() and block.max() < len(mesh.points) for block in corners)
    # meshio returns one array per kind of cells.
    joined = {name: numpy.concatenate(blocks) for name, blocks in mesh.cell_data.items()}
    return {
        "points": numbers(mesh.points),
        "cells": {block.type: len(block.data) for block in mesh.cells},
        "point_data": {name: numbers(values) for name, values in mesh.point_data.items()},
        "cell_data": {name: numbers(values) for name, values in joined.items()},
    }


def main():
    folder = Path(sys.argv[1])
    found, listed = {}, {}
    for collection in sorted(folder.glob("*.pvd")):
        sets = tree.parse(collection).getroot().iter("DataSet")
        listed[collection.name] = [[float(entry.get("timestep")), entry.get("file")] for entry in sets]
        for _, name in listed[collection.name]:
            found[name] = described(folder / name)
    assert set(found) == {path.name for path in folder.glob("*.vtu")}, "files that no list names"
    json.dump({"collections": listed, "files": found}, sys.stdout)


main()
