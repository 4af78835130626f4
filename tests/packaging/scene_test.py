# SPDX-License-Identifier: MIT
"""The hash of the picture that packages draw, and the programs that draw it."""

import hashlib
import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts" / "packaging"))

import scene  # noqa: E402
import try_wheels  # noqa: E402


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def filtered(kind, row, above, channels):
    """The row of a PNG by a filter, straight from the definition."""
    def at(values, i):
        return values[i] if i >= 0 else 0

    def guess(i):
        left, up, corner = at(row, i - channels), above[i], at(above, i - channels)
        return (0, left, up, (left + up) // 2, scene.paeth(left, up, corner))[kind]

    return bytes([kind]) + bytes((row[i] - guess(i)) % 256 for i in range(len(row)))


def png(rows, width, channels):
    """A PNG whose rows use the five filters in turn, in two chunks of data."""
    above = bytes(width * channels)
    packed = b""
    for y, row in enumerate(rows):
        packed += filtered(y % 5, row, above, channels)
        above = row
    packed = zlib.compress(packed)
    header = struct.pack(">IIBBBBB", width, len(rows), 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    return (scene.PNG_SIGNATURE + chunk(b"IHDR", header) + chunk(b"IDAT", packed[:9]) + chunk(b"IDAT", packed[9:])
            + chunk(b"IEND", b""))


def noise(count):
    return hashlib.shake_128(b"noise").digest(count)


class Pictures(unittest.TestCase):
    def test_all_filters(self):
        for channels in (3, 4):
            data = noise(7 * channels * 20)
            stride = 7 * channels
            rows = [data[i:i + stride] for i in range(0, len(data), stride)]
            pixels = scene.png_pixels(png(rows, 7, channels))
            expected = data if channels == 4 else b"".join(data[i:i + 3] + b"\xff" for i in range(0, len(data), 3))
            self.assertEqual(pixels, expected)

    def test_a_png_has_the_hash_of_its_pixels(self):
        data = bytes(4 * scene.WIDTH) + noise(4 * scene.WIDTH) + bytes(4 * scene.WIDTH * (scene.HEIGHT - 2))
        rows = [data[i:i + 4 * scene.WIDTH] for i in range(0, len(data), 4 * scene.WIDTH)]
        with tempfile.TemporaryDirectory() as name:
            raw, packed = Path(name) / "picture.rgba", Path(name) / "picture.png"
            raw.write_bytes(data)
            packed.write_bytes(png(rows, scene.WIDTH, 4))
            self.assertEqual(scene.picture_hash(raw), hashlib.sha256(data).hexdigest()[:16])
            self.assertEqual(scene.picture_hash(packed), scene.picture_hash(raw))
            raw.write_bytes(data[1:])
            with self.assertRaisesRegex(ValueError, "1228799 bytes of pixels in place of 1228800"):
                scene.picture_hash(raw)

    def test_other_pngs_are_refused(self):
        data = scene.PNG_SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 16, 6, 0, 0, 0))
        with self.assertRaises(ValueError):
            scene.png_pixels(data)


class Programs(unittest.TestCase):
    def test_python(self):
        for program in (scene.PYTHON_PROGRAM, scene.PLAIN_PYTHON_PROGRAM):
            compile(program, "scene.py", "exec")
        self.assertNotIn("numpy", scene.PLAIN_PYTHON_PROGRAM)

    def test_each_function_of_the_c_program_is_loaded(self):
        text = try_wheels.loading(scene.C_PROGRAM)
        self.assertIn('#define hrbfnpr_picture_create ((__typeof__(&hrbfnpr_picture_create))'
                      'symbol("hrbfnpr_picture_create"))', text)
        self.assertNotIn("hrbfnpr_status_ok", text.lower())


if __name__ == "__main__":
    unittest.main()
