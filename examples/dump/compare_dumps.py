#!/usr/bin/env python3
"""Names and counts what differs between two dumps: compare_dumps.py FOLDER FOLDER

Compares the bits of the EXR files that both manifests name. Of pictures it says channel by channel
how many values differ, and of the first three the pixel (in depth.exr the tile) and both values.
Lists (ids.exr) are compared as sets: how many entries only one of the two has, and the tile and the
channels of the first three. (ids.csv only says again what is in ids.exr. Tools that compare images
scale integers to floats and let small differences pass.) Needs OpenImageIO's Python module and NumPy
(Debian: python3-openimageio python3-numpy). Ends with status 1 where anything differs.
"""

import json
import os
import sys

import numpy as np
import OpenImageIO as oiio

SHOWN = 3


class Part:
    """What one part of a file holds, and how many values."""

    def __init__(self, source, part):
        spec = source.spec(part, 0)
        self.width, self.deep, self.names = spec.width, spec.deep, list(spec.channelnames)
        kinds = [str(spec.channelformat(i)) if spec.channelformats else str(spec.format)
                 for i in range(spec.nchannels)]
        if not self.deep:
            self.channels = [source.read_image(part, 0, i, i + 1, kind).ravel()
                             for i, kind in enumerate(kinds)]
            self.size = sum(values.size for values in self.channels)
            return
        deep = source.read_native_deep_image(part, 0)
        gets = [deep.deep_value_uint if kind == "uint" else deep.deep_value for kind in kinds]
        self.lists = [{tuple(get(pixel, i, sample) for i, get in enumerate(gets))
                       for sample in range(deep.samples(pixel))}
                      for pixel in range(deep.pixels)]
        self.size = sum(map(len, self.lists))

    def place(self, pixel):
        return f"{pixel % self.width},{pixel // self.width}"


def picture_differences(a, b):
    """Lines that say what differs, each with its count."""
    for name, x, y in zip(a.names, a.channels, b.channels):
        at = np.flatnonzero(x.view(np.uint32) != y.view(np.uint32))
        if at.size:
            first = "; ".join(f"{a.place(i)}: {x[i]}, not {y[i]}" for i in at[:SHOWN])
            yield at.size, f"{name}: {at.size} of {x.size} differ; {first}"


def list_differences(a, b, folders):
    for mine, other, folder in ((a, b, folders[0]), (b, a, folders[1])):
        only = [(pixel, entry) for pixel, (x, y) in enumerate(zip(mine.lists, other.lists))
                for entry in sorted(x - y)]
        if only:
            first = "; ".join(
                f"{mine.place(pixel)}: " + ", ".join(
                    f"{name} {value}" for name, value in zip(mine.names, entry))
                for pixel, entry in only[:SHOWN])
            yield len(only), f"{len(only)} of {mine.size} entries only in {folder}; {first}"


def differences(a, b, folders):
    if a.names != b.names or a.deep != b.deep:
        yield max(a.size, b.size), "the channels differ"
    elif a.deep and len(a.lists) == len(b.lists) and a.width == b.width:
        yield from list_differences(a, b, folders)
    elif not a.deep and a.size == b.size and a.width == b.width:
        yield from picture_differences(a, b)
    else:
        yield max(a.size, b.size), "the sizes differ"


def exr_files(folder):
    with open(os.path.join(folder, "manifest.json"), encoding="utf-8") as manifest:
        files = json.load(manifest)["files"]
    return {file["file"]: file["parts"] for file in files if file["file"].endswith(".exr")}


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folders = sys.argv[1:]
    first, second = (exr_files(folder) for folder in folders)
    total = 0
    for name in sorted(first.keys() ^ second.keys()):
        print(f"{name}: only in {folders[name in second]}")
        total += 1
    for name in [name for name in first if name in second]:
        sources = [oiio.ImageInput.open(os.path.join(folder, name)) for folder in folders]
        for index, part in enumerate(first[name]):
            a, b = (Part(source, index) for source in sources)
            for count, line in differences(a, b, folders):
                print(f"{name} {part} {line}")
                total += count
    print(f"{total} differences")
    sys.exit(1 if total else 0)


main()
