#!/usr/bin/env python3
"""Writes the models and textures of the scenes beside this file; the .scene files are by hand."""

import math
import pathlib
import random
import struct
import zlib

FOLDER = pathlib.Path(__file__).parent / "scenes"


def png(name, width, height, channels, pixel):
    """An 8-bit PNG; pixel(x, y) gives one value a channel, 0 to 1."""
    rows = b""
    for y in range(height):
        row = bytes(round(255 * min(max(c, 0), 1)) for x in range(width) for c in pixel(x, y))
        rows += b"\0" + row

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    kind = {1: 0, 3: 2, 4: 6}[channels]
    header = struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)
    (FOLDER / name).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
        chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


class Obj:
    def __init__(self, library):
        self.lines = ["mtllib " + library]
        self.counts = {"v": 0, "vt": 0, "vn": 0}

    def add(self, kind, *numbers):
        self.lines.append(kind + "".join(f" {n:.6g}" for n in numbers))
        self.counts[kind] += 1
        return self.counts[kind]

    def use(self, material):
        self.lines.append("usemtl " + material)

    def quad(self, corner, u, v, repeat=1):
        vertices, coordinates = [], []
        for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
            vertices.append(self.add("v", *(c + s * a + t * b for c, a, b in zip(corner, u, v))))
            coordinates.append(self.add("vt", s * repeat, t * repeat))
        self.lines.append("f" + "".join(f" {a}/{b}" for a, b in zip(vertices, coordinates)))

    def box(self, low, high):
        d = [h - l for l, h in zip(low, high)]
        x, y, z = (d[0], 0, 0), (0, d[1], 0), (0, 0, d[2])
        shift = lambda a: [l + c for l, c in zip(low, a)]
        for corner, u, v in ((low, y, x), (low, z, y), (low, x, z), (shift(z), x, y),
                             (shift(x), y, z), (shift(y), z, x)):
            self.quad(corner, u, v)

    def sphere(self, center, radius, rings=9):
        at = {}
        for i in range(rings + 1):
            for k in range(2 * rings + 1):
                theta, phi = math.pi * i / rings, math.pi * k / rings
                n = (math.sin(theta) * math.cos(phi), math.cos(theta),
                     math.sin(theta) * math.sin(phi))
                at[i, k] = "{}/{}/{}".format(
                    self.add("v", *(c + radius * d for c, d in zip(center, n))),
                    self.add("vt", 2 * k / rings, 2 - 2 * i / rings), self.add("vn", *n))
        for i in range(rings):
            for k in range(2 * rings):
                corners = [at[i, k], at[i, k + 1], at[i + 1, k + 1], at[i + 1, k]]
                if i == 0: corners.pop(0)
                elif i == rings - 1: corners.pop(2)
                self.lines.append("f " + " ".join(corners))

    def write(self, name):
        (FOLDER / name).write_text("\n".join(self.lines) + "\n")


def textures():
    dots = lambda x, y, n: math.hypot(x % n - n / 2 + 0.5, y % n - n / 2 + 0.5) / (n / 2)
    png("bumps.png", 32, 32, 1, lambda x, y: (math.sqrt(max(1 - dots(x, y, 16) ** 2, 0)),))
    png("gloss.png", 16, 16, 1, lambda x, y: (1.0 if (x // 4 + y // 4) % 2 else 0.1,))
    png("glow.png", 16, 16, 3,
        lambda x, y: (1, 0.5, 0.1) if 4 <= x < 12 and y % 4 < 2 else (0.02, 0.02, 0.05))
    png("tiles.png", 32, 32, 3, lambda x, y: (0.35, 0.3, 0.25) if x % 16 == 0 or y % 16 == 0
        else (0.62, 0.55, 0.46) if (x // 16 + y // 16) % 2 else (0.5, 0.42, 0.34))
    generator = random.Random(7)
    leaves = [(generator.random() * 64, generator.random() * 64, generator.random() * math.pi)
              for _ in range(34)]

    def leaf(x, y):
        for cx, cy, angle in leaves:
            dx, dy = (x - cx + 32) % 64 - 32, (y - cy + 32) % 64 - 32
            a = dx * math.cos(angle) + dy * math.sin(angle)
            b = dy * math.cos(angle) - dx * math.sin(angle)
            if (a / 9) ** 2 + (b / 3.5) ** 2 < 1: return 1
        return 0

    def pillow(x, y):
        a, b = (x % 16 - 7.5) / 8, (7.5 - y % 16) / 8
        n = (0.8 * a ** 3, 0.8 * b ** 3, 1)
        return [0.5 + 0.5 * c / math.hypot(*n) for c in n]

    png("pillows.png", 32, 32, 3, pillow)
    # Occlusion (which nothing reads), roughness, metal.
    png("plates.png", 32, 32, 3, lambda x, y: (1, 0.25 + 0.5 * (y // 8 % 2),
                                               1 if (x // 8 + y // 8) % 2 else 0))
    png("arrow.png", 16, 16, 3, lambda x, y: (0.8, 0.2, 0.1)
        if y >= 3 and abs(x - 7.5) < (1.6 if y > 8 else y - 2) else (0.85, 0.8, 0.6))
    png("leaf_mask.png", 64, 64, 1, lambda x, y: (leaf(x, y),))
    png("leaf.png", 64, 64, 4, lambda x, y: (0.2, 0.45 + 0.1 * (x % 2), 0.1, leaf(y, x)))


def room(obj):
    obj.use("floor")
    obj.quad((-2, 0, 2), (4, 0, 0), (0, 0, -4), 4)
    obj.use("wall")
    obj.quad((-2, 0, -2), (4, 0, 0), (0, 3, 0))
    obj.quad((-2, 0, 2), (0, 0, -4), (0, 3, 0))
    obj.quad((2, 0, -2), (0, 0, 4), (0, 3, 0))
    obj.quad((-2, 3, -2), (4, 0, 0), (0, 0, 4))


def materials():
    obj = Obj("materials.mtl")
    room(obj)
    names = ("mirror", "gold", "brushed", "plastic", "checked", "bumpy")
    for i, name in enumerate(names):
        obj.use(name)
        obj.sphere((-1.25 + 1.25 * (i % 3), 0.45 + 0.95 * (i // 3), -0.6 - 0.7 * (i // 3)), 0.45)
    obj.use("glow")
    obj.quad((1.95, 0.6, -1.2), (0, 0, 1.6), (0, 1.2, 0))
    obj.write("materials.obj")


def cards():
    obj = Obj("cards.mtl")
    room(obj)
    obj.use("masked")
    obj.quad((-1.6, 0, -0.4), (1.5, 0, -0.6), (0, 1.9, 0))
    obj.use("alpha")
    obj.quad((0.1, 0, -0.9), (1.5, 0, 0.7), (0, 1.9, 0))
    obj.use("gone")
    obj.quad((-1.5, 0.1, 0.6), (3, 0, 0), (0, 1, 0))
    obj.write("cards.obj")


def maps():
    """Maps of normals, roughness and metal, transforms, borders that continue."""
    obj = Obj("maps.mtl")
    room(obj)
    for i, name in enumerate(("pillows", "plates", "dents")):
        obj.use(name)
        obj.sphere((-1.25 + 1.25 * i, 0.45, -0.2), 0.45)
    for i, name in enumerate(("clamped", "turned")):
        obj.use(name)
        obj.quad((-1.7 + 1.75 * i, 1.2, -1.2), (1.6, 0, 0), (0, 1.2, 0), 2)
    obj.use("mirrored")
    obj.quad((1.95, 0.6, 0.6), (0, 0, -1.6), (0, 1.2, 0), -2)
    obj.use("hole")
    obj.quad((-1.4, 0, 0.9), (2.8, 0, 0), (0, 0.5, 0), 3)
    obj.write("maps.obj")


FOLDER.mkdir(exist_ok=True)
textures()
materials()
cards()
maps()
