#!/usr/bin/env python3
"""Counts the values that differ between two dumps: compare_dumps.py FOLDER FOLDER

Compares bits, channel by channel, of the EXR files that both manifests name. (ids.csv only says
again what is in ids.exr. Tools that compare images scale integers to floats and let small
differences pass.) Needs OpenImageIO's Python module and NumPy (Debian: python3-openimageio
python3-numpy). Ends with status 1 where anything differs.
"""

import json
import sys

import numpy as np
import OpenImageIO as oiio


def values(folder, file, part, channel):
    """The values of one channel in its own type; of deep files, of all samples in order."""
    source = oiio.ImageInput.open(folder + "/" + file)
    spec = source.spec(part, 0)
    index = list(spec.channelnames).index(channel)
    kind = str(spec.channelformat(index)) if spec.channelformats else str(spec.format)
    if not spec.deep:
        return source.read_image(part, 0, index, index + 1, kind).view(np.uint32).ravel()
    deep = source.read_native_deep_image(part, 0)
    get = deep.deep_value_uint if kind == "uint" else deep.deep_value
    counts = [deep.samples(pixel) for pixel in range(deep.pixels)]
    samples = [get(pixel, index, i) for pixel, count in enumerate(counts) for i in range(count)]
    return np.array(counts + samples)


def main():
    folders = sys.argv[1:3]
    manifests = [json.load(open(f + "/manifest.json", encoding="utf-8"))["files"] for f in folders]
    manifests = [[file for file in m if file["file"].endswith(".exr")] for m in manifests]
    known = {file["file"]: file for file in manifests[1]}
    different = 0
    for file in manifests[0]:
        if file["file"] not in known:
            print(f"{file['file']}: only in {folders[0]}")
            continue
        for part, name in enumerate(file["parts"]):
            for channel in file["channels"]:
                a, b = (values(f, file["file"], part, channel["name"]) for f in folders)
                count = int(np.sum(a != b)) if a.shape == b.shape else max(a.size, b.size)
                if count:
                    print(f"{file['file']} {name} {channel['name']}: {count} of {a.size} differ")
                different += count
    print(f"{different} values differ")
    sys.exit(1 if different else 0)


main()
