"""Fields of a solved position as NumPy arrays, in SI units and ground coordinates."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Integers = NDArray[np.int64]
Booleans = NDArray[np.bool_]


def as_array(exported: Any) -> NDArray[Any]:
    """Creates an array from bytes, type and shape. It shares the memory of the bytes, so it cannot be
    changed."""
    data, kind, shape = exported
    return np.frombuffer(data, dtype=kind).reshape(shape)


@dataclass(frozen=True)
class Contact:
    """Contact patch of a tooth pair. A row of each array is a cell or a slice of its contact line."""

    bodies: tuple[str, str]
    """Names of the two bodies."""
    teeth: tuple[int, int]
    """Tooth of each body, counter-clockwise from 0."""
    back: bool
    """True for coast flanks."""
    corners: Floats
    """Corners of each cell, m; shape (cells, 4, 3)."""
    pressure: Floats
    """Pressure in each cell, Pa; 0 without contact."""
    edge: Booleans
    """True where either surface is on its rounded edge."""
    radius: Floats
    """Radius of the centre of each cell on both bodies, m; shape (cells, 2)."""
    roll_angle: Floats
    """Roll angle of the centre of each cell on both bodies, rad; NaN without an involute."""
    axial: Floats
    """Axial coordinate of the centre of each cell on both bodies, m; NaN in a plane model."""
    line_point: Floats
    """Points of the contact line, m; shape (slices, 3)."""
    line_length: Floats
    """Length of each slice along the contact line, m."""
    line_force: Floats
    """Normal force of each slice, N."""

    @property
    def line_load(self) -> Floats:
        """Load per length of each slice, N/m."""
        load: Floats = self.line_force / self.line_length
        return load


@dataclass(frozen=True)
class Fillet:
    """Stresses in the surface of a fillet. A row of each array is a point."""

    body: str
    tooth: int
    flank: int
    """Flank next to the fillet: 0 or 1."""
    section: Integers
    """Section along the face of each point, from 0; a plane model has one."""
    points: Floats
    """Points, m; shape (points, 3)."""
    depth: Floats
    """Distance along the profile from the end of the flank towards the root, m."""
    stresses: Floats
    """Stress along the profile, along the face, and shear stress, Pa. A plane model has only the
    first; the others are 0."""
    principal: Floats
    """Largest and smallest principal stress, Pa; shape (points, 2)."""


@dataclass(frozen=True)
class Mesh:
    """Deformed mesh of an elastic body, or of one sector of a gear."""

    body: str
    tooth: int | None
    """Tooth of a gear's sector; None for other bodies."""
    points: Floats
    """Undeformed points, m; shape (points, 3)."""
    displacements: Floats
    """Displacement of each point, m; for gears relative to the frame of the body."""
    stresses: Floats
    """Stresses xx, yy, zz, yz, zx, xy at each point, Pa; shape (points, 6)."""
    stress_errors: Floats
    """Estimated errors of the stresses as von Mises stresses, Pa; NaN without an estimate."""
    cells: tuple[Integers, ...]
    """Corners of each cell, as indices of points."""
    shapes: tuple[str, ...]
    """Shape of each cell."""

    @property
    def von_mises(self) -> Floats:
        """Von Mises stress at each point, Pa."""
        xx, yy, zz, yz, zx, xy = self.stresses.T
        normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
        stress: Floats = np.sqrt(0.5 * normal + 3.0 * (yz**2 + zx**2 + xy**2))
        return stress


@dataclass(frozen=True)
class Fields:
    """Fields of a solved position."""

    contacts: tuple[Contact, ...]
    """Contact patches, loaded or not."""
    fillets: tuple[Fillet, ...]
    """Fillets of loaded teeth and their neighbours, if an output requires root stresses."""
    meshes: tuple[Mesh, ...]
    """Meshes of elastic bodies, if the run keeps "bodies"; elastic shafts always."""


def fields(exported: dict[str, Any]) -> Fields:
    """Converts the dictionaries of the extension module."""
    return Fields(
        contacts=tuple(_contact(contact) for contact in exported["contacts"]),
        fillets=tuple(_fillet(fillet) for fillet in exported["fillets"]),
        meshes=tuple(_mesh(mesh) for mesh in exported["meshes"]),
    )


def _arrays(exported: dict[str, Any], names: Iterable[str]) -> dict[str, Any]:
    return {name: as_array(exported[name]) for name in names}


def _contact(exported: dict[str, Any]) -> Contact:
    names = (
        "corners", "pressure", "radius", "roll_angle", "axial", "line_point", "line_length", "line_force",
    )  # fmt: skip
    return Contact(
        bodies=tuple(exported["bodies"]),
        teeth=tuple(exported["teeth"]),
        back=exported["back"],
        edge=as_array(exported["edge"]).astype(bool),
        **_arrays(exported, names),
    )


def _fillet(exported: dict[str, Any]) -> Fillet:
    names = ("section", "points", "depth", "stresses", "principal")
    return Fillet(
        body=exported["body"], tooth=exported["tooth"], flank=exported["flank"], **_arrays(exported, names)
    )


def _mesh(exported: dict[str, Any]) -> Mesh:
    names = ("points", "displacements", "stresses", "stress_errors")
    ends = as_array(exported["ends"])
    return Mesh(
        body=exported["body"],
        tooth=exported["tooth"],
        cells=tuple(np.split(as_array(exported["corners"]), ends[:-1])) if len(ends) else (),
        shapes=tuple(exported["shapes"]),
        **_arrays(exported, names),
    )
