# SPDX-License-Identifier: MIT
"""Reads molecules: PDB, and the XYZ files of chemists.  Atoms become balls with van der Waals radii, in angstroms.

Radii: Bondi, "van der Waals volumes and radii", 1964; Alvarez, "A cartography of the van der Waals territories", 2013.
"""
from __future__ import annotations

import re
from typing import List, Optional, Tuple

import numpy as np

from ._shape import Shape, ShapeError
from ._table import at, shown

# The count of atoms, a line with any text, and the first atom: a symbol and three numbers.
XYZ_MAGIC = (
    rb"[ \t]*\d{1,9}[ \t]*\r?\n[^\n]*\n[ \t]*[A-Za-z]{1,2}\d{0,3}(?:[ \t]+[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?){3}\s"
)
PDB_MAGIC = rb"(?:(?!ATOM  |HETATM)[A-Z][A-Z0-9]{2,5}\b[^\n]*\n|\s)*(?:ATOM  |HETATM)[ \d]{4}[\dA-Za-z*] "
_RADII = {
    "H": 1.20, "He": 1.40, "Li": 1.82, "Be": 1.53, "B": 1.92, "C": 1.70, "N": 1.55, "O": 1.52, "F": 1.47, "Ne": 1.54,
    "Na": 2.27, "Mg": 1.73, "Al": 1.84, "Si": 2.10, "P": 1.80, "S": 1.80, "Cl": 1.75, "Ar": 1.88, "K": 2.75, "Ca": 2.31,
    "Sc": 2.15, "Ti": 2.11, "V": 2.07, "Cr": 2.06, "Mn": 2.05, "Fe": 2.04, "Co": 2.00, "Ni": 1.97, "Cu": 1.96, "Zn": 2.01,
    "Ga": 1.87, "Ge": 2.11, "As": 1.85, "Se": 1.90, "Br": 1.85, "Kr": 2.02, "Rb": 3.03, "Sr": 2.49, "Y": 2.32, "Zr": 2.23,
    "Nb": 2.18, "Mo": 2.17, "Tc": 2.16, "Ru": 2.13, "Rh": 2.10, "Pd": 2.10, "Ag": 2.11, "Cd": 2.18, "In": 1.93, "Sn": 2.17,
    "Sb": 2.06, "Te": 2.06, "I": 1.98, "Xe": 2.16, "Cs": 3.43, "Ba": 2.68, "La": 2.43, "Ce": 2.42, "Gd": 2.34, "W": 2.18,
    "Re": 2.16, "Os": 2.16, "Ir": 2.13, "Pt": 2.13, "Au": 2.14, "Hg": 2.23, "Tl": 1.96, "Pb": 2.02, "Bi": 2.07, "Th": 2.45,
    "U": 2.41, "D": 1.20,
}  # fmt: skip
_UNKNOWN = 2.0  # the radius of other elements
_WATER = ("HOH", "WAT", "DOD", "H2O", "TIP", "TIP3", "SOL")


def read_pdb(data: bytes) -> Shape:
    """Read the atoms of the first model of a PDB file.  Water, and other places of the same atom, are left out."""
    places: List[Tuple[float, float, float]] = []
    symbols: List[str] = []
    seen = set()
    water = others = 0
    notes: List[str] = []
    lines = data.decode("latin-1").splitlines()
    for number, line in enumerate(lines, 1):
        kind = line[:6].rstrip()
        if kind == "ENDMDL" and places:
            rest = sum(1 for one in lines[number:] if one.startswith("MODEL"))
            if rest:
                notes.append(f"{rest} more model{'' if rest == 1 else 's'} of the same molecule left out")
            break
        if kind not in ("ATOM", "HETATM"):
            continue
        if line[17:20].strip() in _WATER:
            water += 1
            continue
        name = line[12:16], line[17:27]  # the atom, and its residue with chain and number
        if line[16:17].strip() and name in seen:
            others += 1
            continue
        seen.add(name)
        try:
            places.append((float(line[30:38]), float(line[38:46]), float(line[46:54])))
        except ValueError:
            raise at(number, 0, "columns 31 to 54 of an atom must hold three coordinates, as in PDB files") from None
        symbols.append(_symbol(line))
    if not places:
        raise ShapeError("the PDB file has no atoms" + (" besides water" if water else ""))
    notes += [f"{count} {what} left out" for count, what in ((water, "atoms of water"), (others, "second places of atoms")) if count]
    return _shape(places, symbols, "PDB", notes)


def _symbol(line: str) -> str:
    """The element of an atom: by its columns, or by the name of the atom if they are blank."""
    given = re.sub(r"[^A-Za-z]", "", line[76:78])
    if given:
        return given.capitalize()
    name = line[12:16]
    if line.startswith("HETATM") and name[:2].strip().isalpha() and name[:2].capitalize() in _RADII:
        return name[:2].capitalize()
    return re.sub(r"[^A-Za-z]", "", name)[:1].upper()


def read_molecule(data: bytes) -> Shape:
    """Read the first frame of an XYZ file of chemists: the count of atoms, a line of text, and a line for each atom."""
    lines = data.decode("latin-1").splitlines()
    count = int(lines[0])
    places: List[Tuple[float, float, float]] = []
    symbols: List[str] = []
    for number, line in enumerate(lines[2 : 2 + count], 3):
        words = line.split()
        if len(words) < 4:
            raise at(number, 0, "an atom is a symbol and three coordinates")
        try:
            x, y, z = (float(word) for word in words[1:4])
        except ValueError:
            raise at(number, 2, f"an atom has three coordinates, not {shown(' '.join(words[1:4]).encode())}") from None
        places.append((x, y, z))
        symbols.append(re.sub(r"[^A-Za-z]", "", words[0]).capitalize())
    notes = [] if len(places) == count else [f"the file is cut short: it has {len(places)} of {count} atoms"]
    if not places:
        raise at(1, 0, f"this line says {count} atoms, but none follow")
    if any(line.strip() for line in lines[2 + count :]):
        notes.append("only the first frame of the file is drawn")
    return _shape(places, symbols, "molecule", notes)


def _shape(places: List[Tuple[float, float, float]], symbols: List[str], form: str, notes: List[str]) -> Shape:
    unknown = sorted({symbol for symbol in symbols if symbol not in _RADII})
    if unknown:
        names = ", ".join(symbol or "?" for symbol in unknown[:4])
        notes.append(f"elements without a known radius have {_UNKNOWN:g} angstroms: {names}")
    points = np.array(places, dtype=np.float64)
    good = np.isfinite(points).all(axis=1)
    if not good.all():
        notes.append(f"{int((~good).sum())} atoms without a finite place left out")
    radii = np.array([_RADII.get(symbol, _UNKNOWN) for symbol in symbols])
    return Shape(points[good], format=form, columns=("x", "y", "z"), notes=tuple(notes), radii=radii[good], unit="angstroms")
