#!/usr/bin/env python3
"""Checks the lists and depth bounds of a dump against the scene's OBJ file.

usage: check_dump.py DUMP_FOLDER FILE.obj

Shares nothing with dirt but the files: reads them with OpenImageIO's Python module, brings the OBJ's
vertices into the grid frame and clips every triangle to every tile in rational arithmetic. Ends
with status 1 at the first contradiction of docs/grid.md.
"""

import json
import struct
import sys
from fractions import Fraction

import OpenImageIO as oiio


def single(x):
    """x rounded to float32."""
    return struct.unpack("f", struct.pack("f", x))[0]


def expect(holds, *what):
    if not holds:
        sys.exit("check_dump: " + " ".join(str(part) for part in what))


def read_obj(file):
    """Triangles of an OBJ file without concave polygons, as world positions in float32."""
    vertices, triangles = [], []
    for line in open(file, encoding="utf-8"):
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append([single(float(x)) for x in words[1:4]])
        elif words[:1] == ["f"]:
            corners = [int(word.split("/")[0]) for word in words[1:]]
            corners = [i - 1 if i > 0 else len(vertices) + i for i in corners]
            for k in range(1, len(corners) - 1):
                triangles.append([vertices[corners[i]] for i in (0, k, k + 1)])
    return triangles


def to_grid(position, frame):
    """World minus eye, times a power of two: one rounding."""
    return [single(single(p - e) * frame["scale"]) for p, e in zip(position, frame["eye"])]


def clip(polygon, planes):
    """The convex polygon where all planes (a, b, c) have a x + b y + c w >= 0."""
    for plane in planes:
        kept = []
        values = [sum(n * p for n, p in zip(plane, point)) for point in polygon]
        for i, (point, value) in enumerate(zip(polygon, values)):
            previous, other = polygon[i - 1], values[i - 1]
            if (value > 0) != (other > 0) and value != 0 and other != 0:
                t = value / (value - other)
                kept.append([p + t * (q - p) for p, q in zip(point, previous)])
            if value >= 0:
                kept.append(point)
        polygon = kept
    return polygon


def depths_within(triangle, view, column, row, part):
    """Least and greatest depth of a triangle inside a tile widened by that part of a tile; None
    where they do not meet, or in the eye alone."""
    s, t = view["s"], view["t"]
    tile = 2 * Fraction(view["tile"]) / Fraction(view["size"][0])  # of the face's slopes -1 to 1
    guard = tile * part
    s0, s1 = Fraction(s[column]) - guard, Fraction(s[column + 1]) + guard
    t0, t1 = Fraction(t[row]) - guard, Fraction(t[row + 1]) + guard
    polygon = clip(triangle, [(0, 0, 1), (1, 0, -s0), (-1, 0, s1), (0, 1, -t0), (0, -1, t1)])
    depths = [point[2] for point in polygon]
    return (min(depths), max(depths)) if depths and max(depths) > 0 else None


def ulps(x, count):
    """count units in the last place of float32 at x."""
    return Fraction(abs(x)) * Fraction(count, 2**23)


def parts_of(folder, file):
    """The parts of an EXR file by name: their numbers."""
    parts, index = {}, 0
    source = oiio.ImageInput.open(folder + "/" + file)
    while source.seek_subimage(index, 0):
        parts[source.spec(index, 0).getattribute("oiio:subimagename")] = index
        index += 1
    return source, parts


def pixel(image, x, y, channel):
    return image.getpixel(x, y)[image.spec().channelindex(channel)]


def read_depth(folder):
    _, parts = parts_of(folder, "depth.exr")
    images = {}
    for name, index in parts.items():
        image = oiio.ImageBuf(folder + "/depth.exr", index, 0)
        spec = image.spec()
        images[name] = [
            [(pixel(image, x, y, "near.Z"), pixel(image, x, y, "far.Z")) for x in range(spec.width)]
            for y in range(spec.height)
        ]
    return images


def read_entries(folder, name):
    """For each tile of a view its list entries (bin, Z, ZBack, id)."""
    source, parts = parts_of(folder, "ids.exr")
    data = source.read_native_deep_image(parts[name], 0)
    names = source.spec(parts[name], 0).channelnames
    at = {channel: names.index(channel) for channel in ("bin", "Z", "ZBack", "id")}
    tiles = []
    for tile in range(data.pixels):
        tiles.append(
            [
                (
                    data.deep_value_uint(tile, at["bin"], i),
                    data.deep_value(tile, at["Z"], i),
                    data.deep_value(tile, at["ZBack"], i),
                    data.deep_value_uint(tile, at["id"], i),
                )
                for i in range(data.samples(tile))
            ]
        )
    return tiles


def check_triangles(folder, triangles):
    image = oiio.ImageBuf(folder + "/triangles.exr")
    for number, triangle in enumerate(triangles):
        for corner, point in zip("abc", triangle):
            for axis, value in zip("XYZ", point):
                dumped = pixel(image, number % 4096, number // 4096, corner + "." + axis)
                expect(dumped == value, "triangle", number, corner, axis, dumped, value)


def check_tile(where, triangles, view, column, row, entries, bounds, bins):
    """Completeness (G1), tightness (G2), and the bins between."""
    listed = {}
    for bin_, near, far, number in entries:
        listed.setdefault(number, []).append((bin_, near, far))
    for number, triangle in enumerate(triangles):
        least = depths_within(triangle, view, column, row, Fraction(1, 512))
        most = depths_within(triangle, view, column, row, Fraction(1, 64))
        expect(not least or number in listed, where, "does not list", number)
        expect(most or number not in listed, where, "lists the distant", number)
        if number not in listed:
            continue
        _, near, far = listed[number][0]
        if least:
            expect(near <= least[0] and least[1] <= far, where, number, "is cut short")
        expect(near >= most[0] - ulps(most[0], 16), where, number, "begins too early")
        expect(far <= most[1] + ulps(most[1], 16), where, number, "ends too late")

        # The bins are those between the ends'; a border within rounding of an end is either's.
        length = Fraction(bounds[1]) - Fraction(bounds[0])
        place = [
            (Fraction(z) - Fraction(bounds[0])) * bins / length if length else 0 for z in (near, far)
        ]
        slack = Fraction(bins, 2**21)
        first = [min(max(int(place[0] + d), 0), bins - 1) for d in (-slack, slack)]
        last = [min(max(int(place[1] + d), 0), bins - 1) for d in (-slack, slack)]
        found = sorted(bin_ for bin_, _, _ in listed[number])
        expect(found == list(range(found[0], found[-1] + 1)), where, number, "skips a bin", found)
        expect(found[0] in first and found[-1] in last, where, number, "is in bins", found)

    ends = [(near, far) for _, near, far, _ in entries]
    if ends:
        expect(bounds[0] == min(near for near, _ in ends), where, "near", bounds)
        expect(bounds[1] == max(far for _, far in ends), where, "far", bounds)
    else:
        expect(bounds[0] > bounds[1], where, "is not empty", bounds)
    return len(entries)


def check_pyramid(name, depth):
    level = 0
    while name + ".level" + str(level + 1) in depth:
        fine, coarse = depth[f"{name}.level{level}"], depth[f"{name}.level{level + 1}"]
        expect(len(coarse) == (len(fine) + 1) // 2, name, "level", level + 1, "has other rows")
        for y, row in enumerate(coarse):
            expect(len(row) == (len(fine[0]) + 1) // 2, name, "has other columns")
            for x, bounds in enumerate(row):
                children = [b for r in fine[2 * y : 2 * y + 2] for b in r[2 * x : 2 * x + 2]]
                expect(bounds[0] == min(b[0] for b in children), name, level, x, y, "near")
                expect(bounds[1] == max(b[1] for b in children), name, level, x, y, "far")
        level += 1
    expect(len(depth[f"{name}.level{level}"]) == 1, name, "ends before one cell")


def main():
    folder, obj = sys.argv[1:]
    manifest = json.load(open(folder + "/manifest.json", encoding="utf-8"))
    expect(manifest["view"] == "full", "only full view can be checked")
    triangles = [
        [to_grid(point, manifest["frame"]) for point in triangle] for triangle in read_obj(obj)
    ]
    expect(len(triangles) == manifest["triangles"], len(triangles), "triangles in the OBJ file")
    check_triangles(folder, triangles)

    depth = read_depth(folder)
    entries = 0
    for view in manifest["view_frames"]:
        view["tile"] = manifest["tile"]
        x, y, w = view["axes"]
        seen = [
            [[Fraction(p[x]), Fraction(p[y]), Fraction(view["sign"] * p[w])] for p in triangle]
            for triangle in triangles
        ]
        columns, rows = view["tiles"]
        lists = read_entries(folder, view["name"])
        bounds = depth[view["name"] + ".level0"]
        for row in range(rows):
            for column in range(columns):
                where = f"view {view['name']} tile {column},{row}:"
                entries += check_tile(
                    where, seen, view, column, row, lists[row * columns + column],
                    bounds[row][column], manifest["bins"],
                )
        check_pyramid(view["name"], depth)
    expect(entries == manifest["list_entries"], entries, "list entries in all")
    print(f"{entries} list entries of {len(triangles)} triangles in {len(manifest['view_frames'])} "
          "views are as they should be")


main()
