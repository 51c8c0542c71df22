"""PNG pictures, read and compared with Python alone."""

import struct
import zlib


def read(path):
    """Width, height, and the bytes of red, green and blue, row by row. What is transparent shows black behind it."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        (length,), kind = struct.unpack(">I", data[at : at + 4]), data[at + 4 : at + 8]
        chunk = data[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
        elif kind == b"IDAT":
            packed += chunk
        at += 12 + length
    if depth != 8 or colour not in (2, 6) or interlaced:
        raise ValueError(f"{path} is no plain PNG of 8 bits in red, green and blue")
    channels = 3 if colour == 2 else 4
    rows = unfiltered(zlib.decompress(packed), width, height, channels)
    if channels == 4:
        alpha = rows[3::4]
        colours = [bytes(value * a // 255 for value, a in zip(rows[channel::4], alpha)) for channel in range(3)]
        rows = bytearray(3 * width * height)
        for channel in range(3):
            rows[channel::3] = colours[channel]
    return width, height, bytes(rows)


def unfiltered(data, width, height, channels):
    """Undoes PNG's prediction of each byte by its neighbours (PNG specification, section 9)."""
    length = width * channels
    above = bytearray(length)
    pixels = bytearray()
    for row in range(height):
        start = row * (length + 1)
        kind, line = data[start], bytearray(data[start + 1 : start + 1 + length])
        if kind == 1:
            for i in range(channels, length):
                line[i] = (line[i] + line[i - channels]) & 255
        elif kind == 2:
            line = bytearray((a + b) & 255 for a, b in zip(line, above))
        elif kind == 3:
            for i in range(length):
                left = line[i - channels] if i >= channels else 0
                line[i] = (line[i] + (left + above[i]) // 2) & 255
        elif kind == 4:
            for i in range(length):
                left, corner = (line[i - channels], above[i - channels]) if i >= channels else (0, 0)
                up = above[i]
                a, b, c = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
                line[i] = (line[i] + (left if a <= b and a <= c else up if b <= c else corner)) & 255
        pixels += line
        above = line
    return pixels


def rmse(one, other):
    """Root of the mean squared difference of two files' bytes, from 0 to 1."""
    one, other = read(one), read(other)
    if one[:2] != other[:2]:
        raise ValueError(f"pictures of {one[:2]} and {other[:2]} pixels")
    total = sum((a - b) * (a - b) for a, b in zip(one[2], other[2]))
    return (total / len(one[2])) ** 0.5 / 255
