"""The comparison of pictures is held against pictures whose difference is known."""

import struct
import tempfile
import unittest
import zlib
from pathlib import Path

import pictures


def write(path, width, rows, channels):
    """A PNG whose rows begin with the number of their filter."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, len(rows), 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    body = zlib.compress(b"".join(bytes(row) for row in rows))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", body) + chunk(b"IEND", b""))


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path, self.other = Path(folder.name) / "a.png", Path(folder.name) / "b.png"

    def test_every_filter_is_undone(self):
        # Two pixels a row. Each row is 11 20 30 40 50 60 once the filter is undone, by hand: less the left pixel (1), less the one
        # above (2), less the mean of both, rounded down (3), less the nearest of left, above and corner to left + above - corner (4).
        rows = [
            [0, 11, 20, 30, 40, 50, 60],
            [1, 11, 20, 30, 29, 30, 30],
            [2, 0, 0, 0, 0, 0, 0],
            [3, 6, 10, 15, 15, 15, 15],
            [4, 0, 0, 0, 0, 0, 0],
        ]
        write(self.path, 2, rows, 3)
        self.assertEqual(pictures.read(self.path), (2, 5, bytes([11, 20, 30, 40, 50, 60] * 5)))

    def test_the_fourth_filter_may_choose_the_corner(self):
        # Left 10, above 30, corner 20: 10 + 30 - 20 is 20, to which the corner is nearest.
        write(self.path, 2, [[0, 20, 20, 20, 30, 30, 30], [4, 246, 246, 246, 5, 5, 5]], 3)
        self.assertEqual(pictures.read(self.path)[2][6:], bytes([10, 10, 10, 25, 25, 25]))

    def test_what_is_transparent_is_black(self):
        write(self.path, 2, [[0, 255, 255, 255, 0, 10, 20, 30, 255]], 4)
        self.assertEqual(pictures.read(self.path), (2, 1, bytes([0, 0, 0, 10, 20, 30])))

    def test_the_error_is_the_root_of_the_mean_square(self):
        write(self.path, 1, [[0, 0, 0, 0]], 3)
        write(self.other, 1, [[0, 51, 0, 0]], 3)
        # sqrt(51^2 / 3) / 255 = 1 / (5 sqrt 3).
        self.assertAlmostEqual(pictures.rmse(self.path, self.other), 1 / (5 * 3**0.5))

    def test_pictures_of_different_sizes_are_not_compared(self):
        write(self.path, 1, [[0, 0, 0, 0]], 3)
        write(self.other, 1, [[0, 0, 0, 0]] * 2, 3)
        self.assertRaises(ValueError, pictures.rmse, self.path, self.other)


if __name__ == "__main__":
    unittest.main()
