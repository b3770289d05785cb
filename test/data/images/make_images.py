#!/usr/bin/env python3
"""Writes the PNG files beside it: one of each kind that maps come in. Needs Python alone.

All show the same four pixels, in two rows: 0, 254 / 205, 100 (or what comes nearest at that depth).
"""
import pathlib
import struct
import zlib

GREY, RGB, INDEXED, GREY_ALPHA, RGBA = 0, 2, 3, 4, 6


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(name, depth, color, rows, *extra):
    header = struct.pack(">IIBBBBB", 2, 2, depth, color, 0, 0, 0)
    pixels = zlib.compress(b"".join(b"\0" + row for row in rows))
    parts = [chunk(b"IHDR", header), *extra, chunk(b"IDAT", pixels), chunk(b"IEND", b"")]
    (pathlib.Path(__file__).parent / name).write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(parts))


palette = chunk(b"PLTE", bytes([0] * 3 + [254] * 3 + [205] * 3 + [100] * 3))
png("grey8.png", 8, GREY, [bytes([0, 254]), bytes([205, 100])])
png("grey16.png", 16, GREY, [struct.pack(">HH", 0, 254 * 257), struct.pack(">HH", 205 * 257 + 90, 100 * 257 - 90)])
png("grey1.png", 1, GREY, [bytes([0b01000000]), bytes([0b10000000])])
png("grey_gamma.png", 8, GREY, [bytes([0, 254]), bytes([205, 100])], chunk(b"gAMA", struct.pack(">I", 100000)))
png("indexed8.png", 8, INDEXED, [bytes([0, 1]), bytes([2, 3])], palette)
png("indexed2.png", 2, INDEXED, [bytes([0b00010000]), bytes([0b10110000])], palette)
png("indexed_transparent.png", 8, INDEXED, [bytes([0, 1]), bytes([2, 3])], palette, chunk(b"tRNS", bytes([255, 255, 0])))
png("grey_alpha.png", 8, GREY_ALPHA, [bytes([0, 255, 254, 255]), bytes([205, 0, 100, 128])])
png("rgb.png", 8, RGB, [bytes([0] * 3 + [254] * 3), bytes([205] * 3 + [255, 0, 0])])
png("rgba.png", 8, RGBA, [bytes([0] * 3 + [255] + [254] * 3 + [255]), bytes([205] * 3 + [7] + [100] * 3 + [255])])
