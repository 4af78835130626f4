# SPDX-License-Identifier: MIT
"""glTF files with EXT_meshopt_compression, written by an encoder of the test."""
import json
import struct

import numpy as np
import pytest
from conftest import torus
from test_meshes import glb

from hrbfnpr import shapes
from hrbfnpr.shapes import _meshopt

COUNT = 700  # more than two blocks of 256 vertices
BOTH = bytes([0x00, 0x76, 0x87, 0x56, 0x67, 0x78, 0xA9, 0x86, 0x65, 0x89, 0x68, 0x98, 0x01, 0x69, 0x00, 0x00])


def packed_bytes(values):
    values = np.concatenate([values, np.zeros(-len(values) % 16, np.int64)])
    widths, body = [], b""
    for group in values.reshape(-1, 16).tolist():
        forms = {0: b""} if not any(group) else {3: bytes(group)}
        for width, bits in ((1, 2), (2, 4)) if any(group) else ():
            largest = (1 << bits) - 1
            digits = "".join(f"{min(value, largest):0{bits}b}" for value in group)
            forms[width] = int(digits, 2).to_bytes(2 * bits, "big") + bytes(v for v in group if v >= largest)
        width = min(forms, key=lambda w: len(forms[w]))
        widths.append(width)
        body += forms[width]
    widths += [0] * (-len(widths) % 4)
    return bytes(sum(w << 2 * k for k, w in enumerate(widths[i : i + 4])) for i in range(0, len(widths), 4)) + body


def packed_attributes(elements):
    rows = elements.view(np.uint8).reshape(len(elements), -1).astype(np.int64)
    stride = rows.shape[1]
    most = min(8192 // stride // 16 * 16, 256)
    before, body = rows[0], b"\xa0"
    for first in range(0, len(rows), most):
        block = rows[first : first + most]
        steps = np.diff(np.vstack([before, block]), axis=0) & 0xFF
        for k in range(stride):
            body += packed_bytes(np.where(steps[:, k] < 128, 2 * steps[:, k], 2 * (255 - steps[:, k]) + 1))
        before = block[-1]
    return body + bytes(max(32 - stride, 0)) + rows[0].astype(np.uint8).tobytes()


def number(value):
    made = b""
    while value >= 0x80:
        made, value = made + bytes([value & 0x7F | 0x80]), value >> 7
    return made + bytes([value])


def packed_triangles(triangles, version=1):
    """Encodes triangles. Also returns which codes for a corner were used."""
    codes, data, used = b"", b"", set()
    edges, vertices, new, last = [], [], 0, 0

    def far(corner):
        nonlocal data, last
        step, last = corner - last, corner
        data += number(2 * step if step >= 0 else -2 * step - 1)

    for triangle in triangles.tolist():
        turns = [(triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]) for k in range(3)]
        beside = [(edges[-15:][::-1].index(t[:2]), t) for t in turns if t[:2] in edges[-15:]]
        if beside:
            edge, (a, b, c) = min(beside)
            recent = vertices[-16:][::-1]
            if c == new:
                third, new = 0, new + 1
            elif c in recent and 0 < recent.index(c) < (13 if version else 15):
                third = recent.index(c)
            elif version and abs(c - last) == 1:
                third, last = (14 if c > last else 13), c
            else:
                third = 15
                far(c)
            used.add(("edge", min(third, 1) if third < 13 else third))
            codes += bytes([edge << 4 | third])
            if third == 0 or third >= (13 if version else 15):
                vertices.append(c)
            edges += [(c, b), (a, c)]
            continue
        a, b, c = next((t for t in turns if t[0] == new), turns[0])
        recent, kinds, start = vertices[-16:][::-1], [], new
        for corner in (a, b, c):
            if corner == new:
                kinds.append(0)
                new += 1
            else:
                kinds.append(recent.index(corner) + 1 if corner in recent[:14] and kinds else 15)
        both = kinds[1] << 4 | kinds[2]
        if kinds[0] == 0 and both in BOTH[:14] and 15 not in kinds:
            used.add("table")
            codes += bytes([0xF0 | BOTH.index(both)])
        elif both or not start:
            used.add(("alone", kinds[0]))
            codes += bytes([0xFE if kinds[0] == 0 else 0xFF])
            data += bytes([both])
            for corner, kind in zip((a, b, c), kinds):
                if kind == 15:
                    far(corner)
        vertices += [corner for corner, kind in zip((a, b, c), kinds) if kind in (0, 15)]
        edges += [(b, a), (c, b), (a, c)]
    return bytes([0xE0 | version]) + codes + data + BOTH, used


def canonical(triangles):
    return [min(tuple(t[k:] + t[:k]) for k in range(3)) for t in np.asarray(triangles).tolist()]


def shuffled(seed):
    """A long strip of triangles with random triangles inserted."""
    random = np.random.default_rng(seed)
    rows = [(i, i + 1, i + 2) if i % 2 else (i + 1, i, i + 2) for i in range(COUNT - 2)]
    for i in random.integers(0, COUNT - 2, 200):
        rows.insert(int(i), tuple(random.choice(COUNT, 3, replace=False).tolist()))
    return np.array(rows)


@pytest.mark.parametrize("version", [0, 1])
def test_triangle_lists_are_decoded(version):
    _, _, grid = torus_mesh()
    used = set()
    by_hand = np.array([(0, 1, 2), (3, 4, 5), (6, 7, 8), (9, 2, 3), (2, 9, 500), (500, 9, 499), (499, 9, 501), (502, 9, 600)])
    for triangles in (grid, shuffled(1), shuffled(2), by_hand):
        data, ways = packed_triangles(triangles, version)
        used |= ways
        unpacked = _meshopt.unpack({"count": triangles.size, "byteStride": 4, "mode": "TRIANGLES"}, data)
        assert canonical(np.frombuffer(unpacked, "<u4").reshape(-1, 3)) == canonical(triangles)
    ways = {("edge", 0), ("edge", 1), ("edge", 15), ("alone", 15), "table"}
    assert used >= (ways | {("edge", 13), ("edge", 14)} if version else ways)


def test_index_sequences_are_decoded():
    wanted = np.array([5, 6, 9, 70000, 70001, 3, 2])
    data, last = b"\xd1", [0, 0]
    for k, value in enumerate(wanted.tolist()):
        step, last[k % 2] = value - last[k % 2], value
        data += number((2 * step if step >= 0 else -2 * step - 1) << 1 | k % 2)
    unpacked = _meshopt.unpack({"count": 7, "byteStride": 4, "mode": "INDICES"}, data + bytes(4))
    np.testing.assert_array_equal(np.frombuffer(unpacked, "<u4"), wanted)


def test_the_exponential_filter_is_decoded():
    words = np.array([[3 | (5 << 24)], [(-3 & 0xFFFFFF) | (0xFE << 24)]], dtype=np.uint32).view("<i4")
    extension = {"count": 2, "byteStride": 4, "mode": "ATTRIBUTES", "filter": "EXPONENTIAL"}
    unpacked = _meshopt.unpack(extension, packed_attributes(words))
    np.testing.assert_array_equal(np.frombuffer(unpacked, "<f4"), [96, -0.75])


def torus_mesh():
    around, along = 40, 20
    points, normals = torus(around, along)
    corner = np.arange(around * along).reshape(around, along)
    a, b = corner, np.roll(corner, -1, axis=0)
    c, d = np.roll(b, -1, axis=1), np.roll(a, -1, axis=1)
    quads = np.stack([a, b, c, d], axis=-1).reshape(-1, 4)
    return points, normals, quads[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)


def document_of(points, triangles):
    views, data = [], b""
    indices, _ = packed_triangles(triangles)
    steps = np.zeros((len(points), 4), "<i2")  # four int16: 8 bytes a vertex
    steps[:, :3] = np.round(points / np.abs(points).max() * 32767)
    for packed, count, stride, mode in (
        (packed_attributes(steps), len(points), 8, "ATTRIBUTES"),
        (indices, triangles.size, 2, "TRIANGLES"),
    ):
        extension = {"buffer": 0, "byteOffset": len(data), "byteLength": len(packed), "byteStride": stride, "mode": mode}
        extension["count"] = count
        views.append({"buffer": 1, "byteLength": count * stride, "extensions": {"EXT_meshopt_compression": extension}})
        data += packed + bytes(-len(packed) % 4)
    accessors = [
        {"bufferView": 0, "componentType": 5122, "count": len(points), "type": "VEC3", "normalized": True},
        {"bufferView": 1, "componentType": 5123, "count": triangles.size, "type": "SCALAR"},
    ]
    return {
        "asset": {"version": "2.0"}, "extensionsRequired": ["EXT_meshopt_compression", "KHR_mesh_quantization"],
        "nodes": [{"mesh": 0, "scale": 3 * [float(np.abs(points).max())]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data)}, {"byteLength": 1}], "bufferViews": views, "accessors": accessors,
    }, data  # fmt: skip


def test_a_compressed_file_is_read(tmp_path):
    points, _, triangles = torus_mesh()
    document, data = document_of(points, triangles)
    path = tmp_path / "packed.glb"
    path.write_bytes(glb(document, data))
    shape = shapes.read(path)
    np.testing.assert_allclose(shape.points, points, atol=2e-4)
    assert canonical(shape.triangles) == canonical(triangles)


def test_damaged_files_are_refused(tmp_path):
    document, data = document_of(*torus_mesh()[::2])
    extension = document["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]
    path = tmp_path / "damaged.glb"
    for change, words in (
        ({"byteLength": 40}, "is damaged"), ({"byteLength": 0}, "is damaged"), ({"count": -1}, "is damaged"),
        ({"mode": "TUNES"}, "in the unknown mode 'TUNES'"), ({"byteOffset": 3}, "in the unknown version [0-9]"), ({"byteStride": 0}, "is damaged"),
    ):  # fmt: skip
        broken = json.loads(json.dumps(document))
        broken["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {**extension, **change}
        path.write_bytes(glb(broken, data))
        with pytest.raises(shapes.ShapeError, match=words):
            shapes.read(path)


def test_any_damage_is_an_error_or_another_shape(tmp_path):
    document, data = document_of(*torus_mesh()[::2])
    path = tmp_path / "damaged.glb"
    random = np.random.default_rng(4)
    refused = 0
    for at, value in zip(random.integers(0, len(data), 60).tolist(), random.integers(0, 256, 60).tolist()):
        path.write_bytes(glb(document, data[:at] + struct.pack("B", value) + data[at + 1 :]))
        try:
            shapes.read(path)
        except shapes.ShapeError:
            refused += 1
    assert refused > 5
