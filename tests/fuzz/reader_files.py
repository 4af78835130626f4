# SPDX-License-Identifier: MIT
"""Small valid files of every format that hrbfnpr.shapes reads, as a base for damaged ones."""
import base64
import gzip
import io
import json
import struct
import zipfile

import numpy as np

VERTICES = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
TRIANGLES = [three for a, b, c, d in QUADS for three in ((a, b, c), (a, c, d))]
NORMALS = [tuple(2 * x - 1 for x in vertex) for vertex in VERTICES]


def rows(*columns, mark=" "):
    return "".join(mark.join(str(x) for part in row for x in part) + "\n" for row in zip(*columns))


def ply(form, list_type="uchar"):
    head = f"ply\nformat {form} 1.0\ncomment a cube\nelement vertex 8\n"
    head += "".join(f"property float {name}\n" for name in ("x", "y", "z", "nx", "ny", "nz"))
    head += f"property uchar red\nelement face 6\nproperty list {list_type} int vertex_indices\nend_header\n"
    if form == "ascii":
        red = [(200,)] * 8
        faces = "".join("4 {} {} {} {}\n".format(*quad) for quad in QUADS)
        return (head + rows(VERTICES, NORMALS, red) + faces).encode()
    order = "<" if "little" in form else ">"
    data = b"".join(struct.pack(order + "6fB", *v, *n, 200) for v, n in zip(VERTICES, NORMALS))
    code = {"uchar": "B", "uint": "I", "int": "i"}[list_type]
    return head.encode() + data + b"".join(struct.pack(order + code + "4i", 4, *quad) for quad in QUADS)


def ply_strips():
    head = "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\n"
    head += "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
    return (head + rows(VERTICES) + "9 0 2 1 3 -1 4 5 6 7\n").encode()


def obj():
    text = "mtllib a.mtl\no cube\n" + "".join("v {} {} {}\n".format(*v) for v in VERTICES)
    text += "".join("vn {} {} {}\n".format(*n) for n in NORMALS) + "vt 0 0\nusemtl a\ns off\n"
    text += "".join("f " + " ".join(f"{i + 1}/1/{i + 1}" for i in quad) + "\n" for quad in QUADS[:3])
    return (text + "f -1 -2 \\\n -3\nf 1//1 2//2 3//3\n").encode()


def stl(binary):
    if binary:
        facets = b"".join(
            struct.pack("<12fH", 0, 0, 1, *(x for i in three for x in VERTICES[i]), 0) for three in TRIANGLES
        )
        return bytes(80) + struct.pack("<I", len(TRIANGLES)) + facets
    text = "solid cube\n"
    for three in TRIANGLES:
        corners = "".join("vertex {} {} {}\n".format(*VERTICES[i]) for i in three)
        text += f"facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n"
    return (text + "endsolid cube\n").encode()


def off(kind="OFF", wide=()):
    faces = "".join("4 {} {} {} {}\n".format(*quad) for quad in QUADS)
    return (f"{kind}\n8 6 0\n" + rows(VERTICES, *wide) + faces).encode()


def pcd(form):
    head = "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z\nSIZE 4 4 4 4 4 4\nTYPE F F F F F F\n"
    head += f"COUNT 1 1 1 1 1 1\nWIDTH 8\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 8\nDATA {form}\n"
    if form == "ascii":
        return (head + rows(VERTICES, NORMALS)).encode()
    if form == "binary":
        return head.encode() + b"".join(struct.pack("<6f", *v, *n) for v, n in zip(VERTICES, NORMALS))
    raw = b"".join(struct.pack("<8f", *column) for column in zip(*(v + n for v, n in zip(VERTICES, NORMALS))))
    # LZF with literal runs only.
    packed = b"".join(bytes([len(raw[i : i + 32]) - 1]) + raw[i : i + 32] for i in range(0, len(raw), 32))
    return head.encode() + struct.pack("<II", len(packed), len(raw)) + packed


def off_binary(order="<"):
    """A binary OFF. In big-endian order each face ends with a count of colours, as Geomview writes it."""
    behind = [0] if order == ">" else []
    data = struct.pack(f"{order}3i", 8, 6, 0) + b"".join(struct.pack(f"{order}3f", *v) for v in VERTICES)
    return b"OFF BINARY\n" + data + b"".join(struct.pack(f"{order}{5 + len(behind)}i", 4, *quad, *behind) for quad in QUADS)


def gltf_document(uri=None):
    """A glTF with a rotated node, a triangle mesh with a sparse accessor, and points with normals."""
    positions = b"".join(struct.pack("<3f", *v) for v in VERTICES)
    indices = b"".join(struct.pack("<3H", *three) for three in TRIANGLES)
    sparse = struct.pack("<2H3f3f", 0, 1, 0, 0, 2, 1, 0, 2)
    data = positions + indices + sparse
    views = [(0, len(positions)), (len(positions), len(indices)), (len(positions) + len(indices), 4),
             (len(positions) + len(indices) + 4, 24)]  # fmt: skip
    document = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
        "nodes": [{"children": [1], "translation": [1, 2, 3], "rotation": [0, 0, 0.6, 0.8], "scale": [1, 2, -1]},
                  {"mesh": 0, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], "skin": 0}, {"mesh": 1}],
        "skins": [{"joints": [0, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 2, "mode": 4}]},
                   {"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0}, "mode": 0},
                                   {"attributes": {"POSITION": 0}, "indices": 2, "mode": 5}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8},
            {"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 8, "sparse": {
                "count": 2, "indices": {"bufferView": 2, "componentType": 5123}, "values": {"bufferView": 3}}},
            {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 36},
        ],
        "bufferViews": [{"buffer": 0, "byteOffset": start, "byteLength": size} for start, size in views],
        "buffers": [{"byteLength": len(data)} if uri is None else {"byteLength": len(data), "uri": uri(data)}],
    }  # fmt: skip
    return json.dumps(document).encode(), data


def gltf():
    return gltf_document(lambda data: "data:application/octet-stream;base64," + base64.b64encode(data).decode())[0]


def packed_document():
    """A glTF with EXT_meshopt_compression, encoded without any prediction."""
    steps = [[]] + [[b - a for a, b in zip(*pair)] for pair in zip(VERTICES, VERTICES[1:])]
    turned = [[2 * step if step >= 0 else -2 * step - 1 for step in row] or [0, 0, 0] for row in steps]
    positions = b"\xa0"
    for k in range(4):  # byte columns; the last one is 0
        column = [row[k] for row in turned] + 8 * [0] if k < 3 else []
        positions += b"\3" + bytes(column) if column else b"\0"
    positions += bytes(32)
    indices, last = b"\xe1" + 12 * b"\xff", 0
    for three in TRIANGLES:
        indices += b"\xff"
        for corner in three:
            step, last = corner - last, corner
            indices += bytes([2 * step if step >= 0 else -2 * step - 1])
    indices += bytes(16)
    views, data = [], positions + indices
    for packed, start, count, stride, mode in (
        (positions, 0, 8, 4, "ATTRIBUTES"), (indices, len(positions), 36, 2, "TRIANGLES"),
    ):  # fmt: skip
        extension = {"buffer": 0, "byteOffset": start, "byteLength": len(packed), "byteStride": stride, "count": count}
        views.append({"buffer": 1, "extensions": {"EXT_meshopt_compression": {**extension, "mode": mode}}})
    document = {
        "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "bufferViews": views, "buffers": [{"byteLength": len(data)}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5120, "type": "VEC3", "count": 8},
                      {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 36}],
    }  # fmt: skip
    return json.dumps(document).encode(), data


def glb(text, data):
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(data)
    head = struct.pack("<4sII", b"glTF", 2, size) + struct.pack("<I4s", len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(data), b"BIN\0") + data


def las(version=2, form=0):
    """A LAS file whose coordinate system is in degrees, with a class for each point."""
    data = b"GEOGCS[]"
    record = struct.pack("<H16sHH32s", 0, b"LASF_Projection", 2112, len(data), b"") + data
    head = bytearray(375 if version == 4 else 227)
    head[:4], head[24], head[25] = b"LASF", 1, version
    size = 30 if form == 6 else 20
    struct.pack_into("<HIIBHI", head, 94, len(head), len(head) + len(record), 1, form, size, 0 if version == 4 else 8)
    struct.pack_into("<6d", head, 131, 0.1, 0.1, 0.1, 5, 6, 7)
    if version == 4:
        struct.pack_into("<Q", head, 247, 8)
    places = (struct.pack("<3i3xBB", *v, i % 6, i % 6) for i, v in enumerate(VERTICES))
    return bytes(head) + record + b"".join(place.ljust(size, b"\0") for place in places)


def ptx(points=VERTICES, columns=2, turn=((1, 0, 0), (0, 1, 0), (0, 0, 1)), stood=(0, 0, 0), more="0.5"):
    """A PTX scan in the scanner's frame. `turn` (for row vectors) and `stood` place the scanner."""
    matrix = [(*row, 0) for row in turn] + [(*stood, 1)]
    head = f"{columns}\n{len(points) // columns}\n" + rows([stood], mark=" ") + rows(turn) + rows(matrix)
    return (head + "".join("{:.6f} {:.6f} {:.6f} {}\n".format(*p, more) for p in points)).encode()


def grid():
    head = "ncols 4\nnrows 3\nxllcorner 7.5\nyllcorner 46.0\ncellsize 0.01\nNODATA_value -9999\n"
    heights = "".join(" ".join(str(x * y) for x in range(4)) + "\n" for y in range(3))
    return (head + heights[:-2] + "-9999\n").encode()


def pgm(binary):
    head = ("P5" if binary else "P2") + "\n# cell 24.5 m x 30.8 m\n4 3\n" + ("65535" if binary else "255") + "\n"
    if binary:
        return head.encode() + struct.pack(">12H", *(1000 * i for i in range(12)))
    return (head + "".join(f"{i} " for i in range(12))).encode()


def vtk():
    text = "# vtk DataFile Version 3.0\ncube\nASCII\nDATASET POLYDATA\nPOINTS 8 float\n" + rows(VERTICES)
    return (text + "POLYGONS 6 30\n" + "".join("4 {} {} {} {}\n".format(*quad) for quad in QUADS)).encode()


def xml(kind, body):
    counts = 'NumberOfPoints="8" ' + ('NumberOfPolys="6"' if kind == "PolyData" else 'NumberOfCells="6"')
    places = '<DataArray type="Float32" NumberOfComponents="3" format="ascii">' + rows(VERTICES) + "</DataArray>"
    return (
        f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian"><{kind}>'
        f"<Piece {counts}><Points>{places}</Points>{body}</Piece></{kind}></VTKFile>\n"
    ).encode()


def array(name, kind, numbers):
    return f'<DataArray type="{kind}" Name="{name}" format="ascii">{" ".join(map(str, numbers))}</DataArray>'


def vtp():
    corners = array("connectivity", "Int64", [i for quad in QUADS for i in quad])
    return xml("PolyData", f"<Polys>{corners}{array('offsets', 'Int64', range(4, 25, 4))}</Polys>")


def vtu():
    corners = array("connectivity", "Int64", [i for quad in QUADS for i in quad])
    ends = array("offsets", "Int64", range(4, 25, 4)) + array("types", "UInt8", [9] * 6)
    return xml("UnstructuredGrid", f"<Cells>{corners}{ends}</Cells>")


CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"


def mf3_model(build='<item objectid="1"/>', resources=""):
    """The XML of a 3MF file with the cube as object 1."""
    vertices = "".join('<vertex x="{}" y="{}" z="{}"/>'.format(*v) for v in VERTICES)
    triangles = "".join('<triangle v1="{}" v2="{}" v3="{}"/>'.format(*t) for t in TRIANGLES)
    mesh = f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"
    head = f'<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" xmlns="{CORE}">'
    objects = f'<object id="1" type="model">{mesh}</object>{resources}'
    return f"{head}<resources>{objects}</resources><build>{build}</build></model>"


def lattice():
    """The XML of a 3MF file with beams and a ball at the corners of the cube."""
    beams = '<b:beam v1="0" v2="1"/><b:beam v1="1" v2="7" r1="0.1" r2="0.2" cap1="butt"/>'
    said = 'radius="0.1" minlength="0.01" cap="sphere" ballmode="mixed" ballradius="0.2"'
    more = f'<b:beamlattice {said}><b:beams>{beams}</b:beams><b:balls><b:ball vindex="3" r="0.3"/></b:balls></b:beamlattice>'
    return mf3_model().replace("</mesh>", more + "</mesh>")


def slices():
    """The XML of a 3MF file with a cube of two slices, in place of the cube."""
    corners = "".join(f'<s:vertex x="{x}" y="{y}"/>' for x, y in ((0, 0), (1, 0), (1, 1), (0, 1)))
    polygon = '<s:polygon startv="0">' + "".join(f'<s:segment v2="{to}"/>' for to in (1, 2, 3, 0)) + "</s:polygon>"
    levels = "".join(f'<s:slice ztop="{top}"><s:vertices>{corners}</s:vertices>{polygon}</s:slice>' for top in (0.5, 1))
    stack = f'<s:slicestack id="9" zbottom="0">{levels}</s:slicestack>'
    model = mf3_model().replace("<resources>", f"<resources>{stack}")
    return model.replace('<object id="1"', '<object id="1" s:slicestackid="9" s:meshresolution="lowres"')


def npy():
    data = io.BytesIO()
    np.save(data, np.arange(120.0).reshape(10, 12)[:, :10])
    return data.getvalue()


def npz():
    data = io.BytesIO()
    np.savez(data, z=np.arange(12.0).reshape(3, 4), x=np.arange(4.0), y=np.arange(3.0))
    return data.getvalue()


def mf3(model=None, name="3D/3dmodel.model", target=None, more=()):
    kind = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    relations = "http://schemas.openxmlformats.org/package/2006/relationships"
    links = f'<Relationships xmlns="{relations}"><Relationship Target="{target or "/" + name}" Type="{kind}"/>'
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_STORED) as archive:
        for part, text in (("_rels/.rels", links + "</Relationships>"), (name, model or mf3_model()), *more):
            archive.writestr(zipfile.ZipInfo(part), text)
    return data.getvalue()


def amf():
    def under(name, parts):
        return f"<{name}>{parts}</{name}>"

    places = ("".join(under(axis, value) for axis, value in zip("xyz", vertex)) for vertex in VERTICES)
    vertices = "".join(under("vertex", under("coordinates", place)) for place in places)
    corners = ("".join(under(f"v{k + 1}", value) for k, value in enumerate(triangle)) for triangle in TRIANGLES)
    mesh = under("mesh", under("vertices", vertices) + under("volume", "".join(under("triangle", c) for c in corners)))
    place = '<instance objectid="1"><deltax>2</deltax><rz>30</rz></instance>'
    return f'<amf unit="inch"><object id="1">{mesh}</object><constellation id="2">{place}</constellation></amf>'.encode()


def wires():
    return ("".join(f"v {x} {y} {z}\n" for x, y, z in VERTICES) + "l 1 2 3 4 1\nl -4 -1\nl 2/1 7/1\n").encode()


def files():
    """The bytes of each file by name. Files that need a missing package are refused, which is fine."""
    table = rows(VERTICES, NORMALS)
    numbered = "id,X,Y,Z,nx,ny,nz\n" + rows([(i,) for i in range(8)], VERTICES, NORMALS, mark=",")
    return {
        "ascii.ply": ply("ascii"), "little.ply": ply("binary_little_endian"),
        "big.ply": ply("binary_big_endian", "int"), "wide.ply": ply("binary_little_endian", "uint"),
        "strips.ply": ply_strips(), "cube.obj": obj(), "wires.obj": wires(), "text.stl": stl(False), "binary.stl": stl(True),
        "cube.off": off(), "normals.off": off("NOFF", (NORMALS,)), "ascii.pcd": pcd("ascii"),
        "binary.pcd": pcd("binary"), "packed.pcd": pcd("binary_compressed"),
        "cube.gltf": gltf(), "cube.glb": glb(*gltf_document()),
        "packed.glb": glb(*packed_document()), "little.off": off_binary(), "big.off": off_binary(">"),
        "cube.las": las(), "cube_4.las": las(4), "grid.asc": grid(), "text.pgm": pgm(False), "binary.pgm": pgm(True),
        "classes.las": las(4, 6), "heights.npy": npy(), "heights.npz": npz(), "beams.3mf": mf3(lattice()), "slices.3mf": mf3(slices()),
        "stream.off": off().replace(b" ", b"\n"), "map.csv": ("Lat,Lon,Height\n" + rows(VERTICES, mark=",")).encode(),
        "laser.txt": ("# 1: shot\n# 2: x\n# 3: y\n# 4: z [m]\n" + rows([(i,) for i in range(8)], VERTICES)).encode(),
        "windows.obj": obj().replace(b"v 0", b"v 1.#IND"), "cube.3mf": mf3(), "cube.amf": amf(), "cube.ptx": ptx(),
        "cube.vtk": vtk(), "cube.vtp": vtp(), "cube.vtu": vtu(), "plain.xyz": table.encode(),
        "comma.csv": numbered.encode(), "decimal.txt": table.replace("1", "1,5").replace(" ", "\t").encode(),
        "meshlab.pts": ("8\n" + table).encode(), "cloud.asc": ("//X Y Z Nx Ny Nz\n" + table).encode(),
        "wide.txt": table.encode("utf-16"), "oriented.xyzn": table.encode(),
        "packed.xyz.gz": gzip.compress(table.encode(), mtime=0),
    }  # fmt: skip
