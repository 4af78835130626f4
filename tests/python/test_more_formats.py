# SPDX-License-Identifier: MIT
"""GIFTI, molecules, Gaussian cubes, USD as text, 3DXML and zipped Collada: made here, read, and damaged."""
import base64
import gzip
import io
import shutil
import zipfile
import zlib

import numpy as np
import pytest
from test_files import damaged
from test_shapes import CUBE, QUADS, write

import hrbfnpr
from hrbfnpr import shapes
from hrbfnpr.cli import main

TRIANGLES = np.array([part for a, b, c, d in QUADS for part in ((a, b, c), (a, c, d))])
POINTS = np.array(CUBE, dtype=float)


def is_right(shape, points=POINTS, count=12):
    """Whether a shape is the closed cube, seen from outside."""
    facts = shapes.mesh_facts(shape)
    corners = {tuple(np.round(p, 5)) for p in shape.points[np.unique(shape.triangles)]}
    return len(shape.triangles) == count and facts.closed and not facts.inside_out and corners == {tuple(np.round(p, 5)) for p in points}


# ---- GIFTI


def array(values, intent, kind, coding="ASCII", name="", order="RowMajorOrder", endian="LittleEndian", more=""):
    values = np.asarray(values)
    raw = (values.T if order.startswith("Column") else values).astype(("<" if endian[0] == "L" else ">") + kind).tobytes()
    text = {
        "ASCII": lambda: " ".join(map(str, values.reshape(-1).tolist())),
        "Base64Binary": lambda: base64.b64encode(raw).decode(),
        "GZipBase64Binary": lambda: base64.b64encode(zlib.compress(raw)).decode(),
    }[coding]()
    types = {"f4": "FLOAT32", "i4": "INT32", "u1": "UINT8", "f8": "FLOAT64"}
    sizes = " ".join(f'Dim{i}="{n}"' for i, n in enumerate(values.shape))
    return (
        f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{types[kind]}" ArrayIndexingOrder="{order}" '
        f'Dimensionality="{values.ndim}" {sizes} Encoding="{coding}" Endian="{endian}" {more}>'
        f"<MetaData><MD><Name><![CDATA[Name]]></Name><Value><![CDATA[{name}]]></Value></MD></MetaData><Data>{text}</Data></DataArray>"
    )


def gifti(*arrays):
    body = "".join(arrays)
    doctype = '<!DOCTYPE GIFTI SYSTEM "http://www.nitrc.org/frs/download.php/115/gifti.dtd">'
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{doctype}\n<GIFTI Version="1.0" NumberOfDataArrays="2">{body}</GIFTI>'


def surface(coding="ASCII", **how):
    return array(POINTS, "POINTSET", "f4", coding, **how), array(TRIANGLES, "TRIANGLE", "i4", coding, **how)


@pytest.mark.parametrize("coding", ["ASCII", "Base64Binary", "GZipBase64Binary"])
@pytest.mark.parametrize("endian", ["LittleEndian", "BigEndian"])
def test_surfaces_of_brains(tmp_path, coding, endian):
    more = array(np.arange(8.0), "SHAPE", "f4", coding, name="thickness", endian=endian)
    shape = shapes.read(write(tmp_path, "lh.surf.gii", gifti(*surface(coding, endian=endian), more)))
    assert is_right(shape) and shape.format == "GIFTI" and shape.up == (0, 0, 1)
    np.testing.assert_array_equal(shape.fields["thickness"].values, np.arange(8))
    if coding != "ASCII":
        columns = gifti(*surface(coding, order="ColumnMajorOrder", endian=endian))
        assert is_right(shapes.read(write(tmp_path, "b.gii.gz", gzip.compress(columns.encode()))))


def test_surfaces_of_several_hemispheres(tmp_path):
    other = array(POINTS + [5, 0, 0], "POINTSET", "f4")
    shape = shapes.read(write(tmp_path, "a.gii", gifti(*surface(), other, surface()[1])))
    assert len(shape.points) == 16 and len(shape.triangles) == 24 and shape.triangles.max() == 15


def test_unreadable_surfaces_are_named(tmp_path):
    points, faces = surface()
    packed = array(POINTS, "POINTSET", "f4", "GZipBase64Binary")
    cases = {
        "not valid XML, so it may be cut short": gifti(points, faces)[:-30],
        "has no points: it holds values for a surface in another file": gifti(array(np.arange(8.0), "SHAPE", "f4")),
        "names vertex 9, but its surface has only 8": gifti(points, array([[0, 1, 9]], "TRIANGLE", "i4")),
        "array 1 .* has 24 of 30 values: it is cut short": gifti(points.replace('Dim0="8"', 'Dim0="10"'), faces),
        "its values are in another file": gifti(points.replace('"ASCII"', '"ExternalFileBinary"'), faces),
        "holds a word that is not a number": gifti(points.replace("<Data>", "<Data>x "), faces),
        "too large": gifti(points.replace('Dim0="8"', 'Dim0="99999999999"'), faces),
        "does not say its size": gifti(points.replace('Dim0="8"', ""), faces),
        "type NIFTI_TYPE_COMPLEX64": gifti(points.replace("FLOAT32", "COMPLEX64"), faces),
        "array 1 .* is damaged": gifti(packed.replace("<Data>", "<Data>!"), faces),
        "2 arrays of points and 1 arrays of triangles": gifti(points, points, faces),
        "points .* have the shape": gifti(array(np.arange(8.0), "POINTSET", "f4"), faces),
    }
    for words, text in cases.items():
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, "a.gii", text))


# ---- Molecules


def atom(number, name, place, element="", residue="ALA", alt=" ", kind="ATOM"):
    x, y, z = place
    return f"{kind:<6}{number:>5} {name:<4}{alt}{residue:>3} A{1:>4}    {x:8.3f}{y:8.3f}{z:8.3f}{1:6.2f}{0:6.2f}          {element:>2}\n"


PDB = (
    "HEADER    A MOLECULE\nREMARK   1\nMODEL        1\n" + atom(1, " CA ", (0, 0, 0), "C") + atom(2, " N  ", (1.5, 0, 0))
    + atom(3, "1HB ", (0, 1.1, 0)) + atom(4, " O  ", (0, 0, 1.2), alt="A") + atom(4, " O  ", (0, 0, 1.3), alt="B")
    + atom(5, "ZN  ", (4, 0, 0), kind="HETATM", residue="ZN") + atom(6, " O  ", (9, 9, 9), residue="HOH", kind="HETATM")
    + "ENDMDL\nMODEL        2\n" + atom(1, " CA ", (7, 0, 0), "C") + "ENDMDL\nEND\n"
)  # fmt: skip
WATER = "3\nwater\nO 0.0 0.0 0.117\nH 0.0 0.757 -0.471\nH 0.0 -0.757 -0.471 0.1\n"


def test_molecules_are_balls(tmp_path):
    shape = shapes.read(write(tmp_path, "a.pdb", PDB))
    np.testing.assert_allclose(shape.points, [[0, 0, 0], [1.5, 0, 0], [0, 1.1, 0], [0, 0, 1.2], [4, 0, 0]])
    np.testing.assert_allclose(shape.radii, [1.7, 1.55, 1.2, 1.52, 2.01])
    assert shape.notes == ("1 more model of the same molecule left out", "1 atoms of water left out", "1 second places of atoms left out")
    assert shapes.read(write(tmp_path, "b.ent.gz", gzip.compress(PDB.encode()))).format == "PDB"
    assert shapes.read(write(tmp_path, "b.txt", PDB)).notes[0].endswith("the file holds PDB and is read as such")
    shape = shapes.read(write(tmp_path, "a.xyz", WATER))
    np.testing.assert_allclose(shape.radii, [1.52, 1.2, 1.2])
    assert shape.notes == () and shape.format == "molecule"
    twice = shapes.read(write(tmp_path, "b.xyz", WATER + WATER))
    assert twice.notes == ("only the first frame of the file is drawn",) and len(twice.points) == 3
    assert shapes.read(write(tmp_path, "c.xyz", "9\n" + WATER[2:])).notes == ("the file is cut short: it has 3 of 9 atoms",)
    assert len(shapes.read(write(tmp_path, "e.xyz", WATER.lower())).radii) == 3
    odd = shapes.read(write(tmp_path, "d.xyz", "1\n\nXx 1 2 3\n"))
    assert odd.radii == [2.0] and odd.notes == ("elements without a known radius have 2 angstroms: Xx",)


def test_points_are_no_molecules(tmp_path):
    for text in ("3\n0 0 0\n1 0 0\n0 1 0\n", "x y z\n0 0 0\n1 0 0\n0 1 0\n", "0 0 0\n1 0 0\n0 1 0\n"):
        shape = shapes.read(write(tmp_path, "a.xyz", text))
        assert shape.radii is None and shape.format == "text" and len(shape.points) == 3


def test_molecules_are_drawn_as_solids(tmp_path, capsys):
    path = write(tmp_path, "water.xyz", WATER)
    assert main(["draw", str(path), str(tmp_path / "a.png"), "--size", "120", "--style", "silhouette"]) == 0
    assert "molecule: 3 balls" in capsys.readouterr().out
    picture = hrbfnpr.draw(path, "silhouette", size=120)
    assert picture.model.csg_info.sheets == 3
    places = np.array([[0.0, 0.0, 0.117 + 1.52], [0.0, 0.757 + 1.2, -0.471], [1.52, 0.0, 0.117]])
    np.testing.assert_allclose(picture.model.evaluate(places).value, 0.0, atol=1e-9)
    assert np.array_equal(hrbfnpr.draw(shapes.read(path), "silhouette", size=120).image, picture.image)
    assert main(["check", str(path)]) == 0
    said = capsys.readouterr().out
    assert "kind: balls" in said and "bounds max: 1.52 1.957 1.637" in said and "unit: angstroms" in said


def test_unreadable_molecules_are_named(tmp_path):
    for name, text, words in (
        ("a.pdb", "HEADER\nEND\n", "has no atoms"),
        ("a.pdb", PDB.replace("   1.500", "   x.500"), "line 5: columns 31 to 54"),
        ("a.xyz", WATER.replace("0.757", "here"), "line 4, column 2: an atom has three coordinates"),
        ("a.xyz", WATER.replace(" 0.757 -0.471", ""), "line 4: an atom is a symbol and three coordinates"),
    ):
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, name, text))


# ---- Gaussian cubes


def cube(values, axes=np.eye(3) * 0.5, origin=(-3.0, -3.0, -3.0), orbitals=0):
    counts = values.shape
    lines = ["a density", "made by a test", "{} {} {} {}".format(-1 if orbitals else 1, *origin)]
    lines += ["{} {} {} {}".format(n, *axis) for n, axis in zip(counts, axes)]
    lines += ["6 6.0 0.0 0.0 0.0"] + ([f"{orbitals} " + " ".join(map(str, range(1, orbitals + 1)))] if orbitals else [])
    flat = values.reshape(-1) if not orbitals else np.stack([values.reshape(-1)] + [0 * values.reshape(-1)] * (orbitals - 1), 1).reshape(-1)
    return "\n".join(lines + [" ".join(f"{v:.6E}" for v in flat[i : i + 6]) for i in range(0, len(flat), 6)]) + "\n"


def grid(function, count=15):
    at = np.mgrid[:count, :count, :count] * 0.5 - 3.0
    return function(*at)


def test_densities_become_surfaces(tmp_path):
    density = grid(lambda x, y, z: np.exp(-np.sqrt(x * x + y * y + z * z) * 2))
    shape = shapes.read(write(tmp_path, "a.cube", cube(density)))
    facts = shapes.mesh_facts(shape)
    assert facts.closed and not facts.inside_out and facts.components == 1
    radius = np.linalg.norm(shape.points, axis=1)
    assert np.ptp(radius) < 0.25
    level = float(np.exp(-2 * radius.mean()))
    assert density[density > level].sum() / density.sum() == pytest.approx(0.95, abs=0.04)
    assert "encloses 95% of the sum of the values" in shape.notes[0]
    mirrored = cube(density, np.diag([-0.5, 0.5, 0.5]), (3.0, -3.0, -3.0))
    assert not shapes.mesh_facts(shapes.read(write(tmp_path, "b.cube", mirrored))).inside_out


def test_orbitals_have_two_lobes(tmp_path):
    orbital = grid(lambda x, y, z: z * np.exp(-(x * x + y * y + z * z)))
    for sets in (0, 1, 2):
        shape = shapes.read(write(tmp_path, "a.cub", cube(orbital, orbitals=sets)))
        facts = shapes.mesh_facts(shape)
        assert facts.closed and facts.components == 2 and not facts.inside_out
        np.testing.assert_allclose(shape.points.mean(axis=0), 0, atol=0.02)
        assert "+-" in shape.notes[0] and "90% of the sum of the squares" in shape.notes[0]
    assert shape.notes[1] == "the first of 2 sets of values is drawn"


def test_unreadable_cubes_are_named(tmp_path):
    whole = cube(grid(lambda x, y, z: np.exp(-x * x - y * y - z * z), 5))
    for text, words in (
        (whole[:500], r"cut short: it has \d+ of 125 values"),
        ("a\nb\nc\nd\ne\nf\n", "not a Gaussian cube: line 3 must hold"),
        (whole.replace("5 0.5", "99999999 0.5"), "damaged, or too large"),
        (whole.replace("5 0.5", "x 0.5"), "line 4: the head of the cube has 4 numbers here"),
        (whole[:-3] + "xyz\n", "is not a number"),
        (cube(np.zeros((3, 3, 3))), "all values of the cube are 0"),
        (cube(np.ones((3, 3, 3))), "all values of the cube are the same"),
    ):
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, "a.cube", text))


# ---- USD as text


def usd_mesh(name="box", more="", points=CUBE):
    return f'''def Mesh "{name}" (
    prepend apiSchemas = ["MaterialBindingAPI"]
)
{{
    uniform bool doubleSided = 1
    float3[] extent = [(0, 0, 0), (1, 1, 1)]
    int[] faceVertexCounts = [{", ".join("4" for _ in QUADS)}]
    int[] faceVertexIndices = {[i for quad in QUADS for i in quad]}
    rel material:binding = </Looks/red>
    point3f[] points = {[tuple(map(float, p)) for p in points]}
    color3f[] primvars:displayColor = [(1, 0, 0)] (
        interpolation = "constant"
    )
    token outputs:surface.connect = </Looks/red.outputs:surface>
    custom string note
    {more}
}}
'''


def usda(*prims, facts='metersPerUnit = 0.01\n    upAxis = "Z"'):
    return f'#usda 1.0\n(\n    """Made by a test; "quoted" (text)"""\n    {facts}\n)\n\n' + "\n".join(prims)


def test_meshes_of_usd(tmp_path):
    shape = shapes.read(write(tmp_path, "a.usda", usda(usd_mesh())))
    assert is_right(shape) and shape.up == (0, 0, 1) and shape.format == "USDA"
    assert (shape.fields["rgb"].values == [1, 0, 0]).all()
    assert shapes.read(write(tmp_path, "b.usda", usda(usd_mesh(), facts="defaultPrim = \"a\""))).up == (0, 1, 0)


def test_places_of_usd(tmp_path):
    inner = usd_mesh(more="""double3 xformOp:translate = (1, 2, 3)
    float xformOp:rotateZ:turn = 90
    float3 xformOp:scale = (2, 1, 1)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ:turn", "xformOp:scale"]""")
    outer = f'''def Xform "outer"
{{
    matrix4d xformOp:transform = ( (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (10, 0, 0, 1) )
    uniform token[] xformOpOrder = ["xformOp:transform"]
    {inner}
    def Scope "looks" {{ def Material "red" {{ }} }}
}}'''
    shape = shapes.read(write(tmp_path, "a.usda", usda(outer)))
    x, y, z = POINTS.T
    assert is_right(shape, np.column_stack([11 - y, 2 + 2 * x, 3 + z]))
    turns = usd_mesh(more='float3 xformOp:rotateXYZ = (90, 0, 90)\n    token[] xformOpOrder = ["xformOp:rotateXYZ"]')
    assert is_right(shapes.read(write(tmp_path, "b.usda", usda(turns))), np.column_stack([z, x, y]))
    quaternion = usd_mesh(more='quatf xformOp:orient = (0.70710678, 0, 0, 0.70710678)\n    token[] xformOpOrder = ["xformOp:orient"]')
    assert is_right(shapes.read(write(tmp_path, "c.usda", usda(quaternion))), np.column_stack([-y, x, z]))
    back = usd_mesh(more='double3 xformOp:translate:pivot = (1, 2, 3)\n    float3 xformOp:scale = (-1, 1, 1)\n    uniform token[] '
                    'xformOpOrder = ["xformOp:translate:pivot", "xformOp:scale", "!invert!xformOp:translate:pivot"]')  # fmt: skip
    assert is_right(shapes.read(write(tmp_path, "d.usda", usda(back))), np.column_stack([2 - x, y, z]))
    timed = usd_mesh(more='double3 xformOp:translate.timeSamples = {\n 0: (5, 0, 0),\n 1.5: (6, 0, 0),\n }\n token[] xformOpOrder = ["xformOp:translate"]')
    assert is_right(shapes.read(write(tmp_path, "e.usda", usda(timed))), POINTS + [5, 0, 0])


def test_units_are_said(tmp_path, capsys):
    for facts, unit in (('metersPerUnit = 0.01', "centimetres"), ("metersPerUnit = 0.0254", "0.0254 metres"), ("a = 1", "centimetres"),
                        ("metersPerUnit = x", "unknown")):  # fmt: skip
        assert main(["check", str(write(tmp_path, "a.usda", usda(usd_mesh(), facts=facts)))]) == 0
        assert f"unit: {unit}\n" in capsys.readouterr().out
    assert shapes.read(write(tmp_path, "a.3dxml", threedxml())).unit == "millimetres"
    density = grid(lambda x, y, z: np.exp(-x * x - y * y - z * z), 7)
    assert shapes.read(write(tmp_path, "a.cube", cube(density))).unit == "bohr"
    assert shapes.read(write(tmp_path, "a.cube", cube(density).replace("\n7 ", "\n-7 "))).unit == "angstroms"


def test_parts_of_usd_that_are_left_out(tmp_path):
    hidden = usd_mesh("hidden", 'token visibility = "invisible"')
    left = usd_mesh("left", 'uniform token orientation = "leftHanded"').replace(str([i for q in QUADS for i in q]), str([i for q in QUADS for i in q[::-1]]))
    others = 'def Sphere "ball" { double radius = 2 }\ndef Xform "ref" ( references = @other.usda@</a> ) { }\nclass "base" {' + usd_mesh() + "}"
    shape = shapes.read(write(tmp_path, "a.usda", usda(hidden, left, others)))
    assert is_right(shape)
    assert shape.notes == ("1 parts of the type Sphere left out", "1 references to other files or parts left out")
    variants = f'''def Xform "a" (
    variants = {{ string size = "small" }}
    prepend variantSets = "size"
)
{{
    variantSet "size" = {{
        "large" {{ {usd_mesh("l", points=[(9 * x, y, z) for x, y, z in CUBE])} }}
        "small" {{ {usd_mesh("s")} }}
    }}
}}'''
    assert is_right(shapes.read(write(tmp_path, "b.usda", usda(variants))))
    creases = usd_mesh(more="int[] creaseIndices = [0, 1, 2, 4, 5]\n int[] creaseLengths = [3, 2]\n float[] creaseSharpnesses = [10, 0.5]")
    assert shapes.read(write(tmp_path, "c.usda", usda(creases))).sharp_edges.tolist() == [[0, 1], [1, 2]]


def test_unreadable_usd_is_named(tmp_path):
    whole = usda(usd_mesh())
    for text, words in (
        (whole[:600], r"line \d+: .*; the file may be damaged or cut short"),
        ("#usda 1.0\n", "has no meshes$"),
        (usda('def Cube "a" { }'), "has no meshes; it has 1 parts of the type Cube, which are not read"),
        (whole.replace("point3f[] points = [(", "point3f[] points = [(x"), "points of mesh 'box' is not a list of numbers|not a number"),
        (whole.replace("faceVertexIndices = [", "faceVertexIndices = [9, "), "have 24 corners, but 25 are given"),
        (whole.replace("faceVertexIndices = [", "faceVertexIndices = [99, ").replace("[4, ", "[5, ", 1), "names vertex 99"),
        (whole.replace("def Mesh", "deaf Mesh"), "begins with def, over or class, not with 'deaf'"),
        ("#usda 1.0\n" + 'def "a" {' * 500, "nested too deep|'}' is missing|ends within"),
        ("#usda 1.0\n(a = " + "[x, " * 500, "nested too deep"),
        (usda(usd_mesh(more='float3 xformOp:scale = 2\n token[] xformOpOrder = ["xformOp:scale"]')), "operation xformOp:scale of 'box'"),
    ):
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, "a.usda", text))


# ---- Archives


def zipped(**files):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name.replace("__", "."), text)
    return data.getvalue()


REP = """<?xml version="1.0"?><XMLRepresentation xmlns="http://www.3ds.com/xsd/3DXML" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
<Root xsi:type="BagRepType"><Rep xsi:type="PolygonalRepType">{faces}<VertexBuffer><Positions>{points}</Positions></VertexBuffer></Rep></Root>
</XMLRepresentation>"""
PRODUCTS = """<Model_3dxml xmlns="http://www.3ds.com/xsd/3DXML"><Header/><ProductStructure root="1">
<Reference3D id="1" name="all"/><Reference3D id="2" name="box"/>
<Instance3D id="3"><IsAggregatedBy>1</IsAggregatedBy><IsInstanceOf>urn:3DXML:Reference:loc:2</IsInstanceOf>
<RelativeMatrix>{matrix}</RelativeMatrix></Instance3D>
<ReferenceRep id="4" format="TESSELLATED" associatedFile="urn:3DXML:box.3DRep"/>
<InstanceRep id="5"><IsAggregatedBy>2</IsAggregatedBy><IsInstanceOf>4</IsInstanceOf></InstanceRep></ProductStructure></Model_3dxml>"""
MANIFEST = '<?xml version="1.0"?><Manifest><Root>all.3dxml</Root></Manifest>'


def threedxml(matrix="1 0 0 0 1 0 0 0 1 0 0 0", faces=None, points=CUBE, rep=None, products=PRODUCTS):
    if faces is None:
        first = " ".join(map(str, TRIANGLES[:8].reshape(-1)))
        fans = ",".join(f"{a} {b} {c} {d}" for a, b, c, d in QUADS[4:5])
        strip = ",".join(f"{a} {b} {d} {c}" for a, b, c, d in QUADS[5:])
        faces = f'<Faces><Face triangles="{first}"/><Face fans="{fans}" strips="{strip}"/></Faces>'
    rep = REP.format(faces=faces, points=",".join("{} {} {}".format(*p) for p in points)) if rep is None else rep
    return zipped(Manifest__xml=MANIFEST, all__3dxml=products.format(matrix=matrix), box__3DRep=rep)


def test_products_of_3dxml(tmp_path):
    shape = shapes.read(write(tmp_path, "a.3dxml", threedxml()))
    assert is_right(shape) and shape.format == "3DXML" and shape.up == (0, 0, 1)
    x, y, z = POINTS.T
    turned = shapes.read(write(tmp_path, "b.3dxml", threedxml("0 1 0 -1 0 0 0 0 1 5 0 0")))
    assert is_right(turned, np.column_stack([5 - y, x, z]))
    coarse = '<PolygonalLOD accuracy="{}"><Faces><Face triangles="{}"/></Faces></PolygonalLOD>'
    fine = " ".join(map(str, TRIANGLES.reshape(-1)))
    levels = coarse.format(1, "0 1 2") + coarse.format(0.1, fine)
    assert is_right(shapes.read(write(tmp_path, "c.3dxml", threedxml(faces=levels))))


def test_unreadable_3dxml_is_named(tmp_path):
    endless = PRODUCTS.replace('<Reference3D id="1"', '<Instance3D id="9"><IsAggregatedBy>2</IsAggregatedBy><IsInstanceOf>1</IsInstanceOf></Instance3D><Reference3D id="1"')
    for data, words in (
        (threedxml(rep=b"V5_CFV2\0\0binary"), "'box.3DRep' .* binary or encrypted form, which is not read: its program exports STEP"),
        (threedxml(rep="<a>"), "not valid XML"),
        (threedxml(matrix="1 2"), "the place of instance '3' .* is not 12 numbers"),
        (threedxml(faces="<Faces><Face triangles='0 1 8'/></Faces>"), "names vertex 8, but its part has only 8"),
        (threedxml(faces="<Faces><Face triangles='0 1'/></Faces>"), "no groups of three"),
        (threedxml(faces="<Faces><Face triangles='0 1 x'/></Faces>"), "not a number"),
        (threedxml(products=endless), "contain each other|no triangles"),
        (zipped(Manifest__xml=MANIFEST, all__3dxml=PRODUCTS.format(matrix="")), "lacks its part 'box.3DRep'"),
        (zipped(a__txt="x"), "no part with the products"),
        (threedxml()[:300], "not a whole ZIP archive"),
    ):
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(write(tmp_path, "a.3dxml", data))


DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="24">{points}</float_array><technique_common>
<accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>{faces}</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>"""


def test_zipped_collada(tmp_path):
    with pytest.raises(shapes.ShapeError, match="the scene .*.dae.* is not in it|needs assimp"):
        shapes.read(write(tmp_path, "a.zae", zipped(a__txt="x")))
    if shutil.which("assimp") is None:
        pytest.skip("assimp is missing (Debian: assimp-utils)")
    text = DAE.format(points=" ".join(map(str, POINTS.reshape(-1))), faces=" ".join(map(str, TRIANGLES.reshape(-1))))
    shape = shapes.read(write(tmp_path, "b.zae", zipped(manifest__xml="<a/>", scene__dae=text)))
    assert shape.format == "Collada" and len(shape.triangles) == 12 and shapes.mesh_facts(shape).closed
    with pytest.raises(shapes.ShapeError, match="the .zae file is not a whole ZIP archive"):
        shapes.read(write(tmp_path, "c.zae", zipped(scene__dae=text)[:200]))


# ---- Damage


def whole_files():
    yield "a.gii", gifti(*surface("GZipBase64Binary"), array(np.arange(8.0), "SHAPE", "f4")).encode()
    yield "b.gii", gifti(*surface()).encode()
    yield from (("a.pdb", PDB.encode()), ("a.xyz", WATER.encode()), ("a.usda", usda(usd_mesh()).encode()))
    yield "a.cube", cube(grid(lambda x, y, z: np.exp(-x * x - y * y - z * z), 6)).encode()
    yield "a.3dxml", threedxml()


def test_damaged_files_are_refused_or_read(tmp_path):
    random = np.random.default_rng(3)
    refused = 0
    for name, data in whole_files():
        shapes.read(write(tmp_path, name, data))
        for _ in range(60):
            try:
                shape = shapes.read(write(tmp_path, name, damaged(data, random)))
                if shape.is_mesh:
                    shapes.mesh_facts(shape)
            except shapes.ShapeError as error:
                refused += 1
                assert str(error) and "\n" not in str(error)
    assert refused > 100
