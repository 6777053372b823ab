#!/usr/bin/env python3
"""Draws the buffers of a dump side by side: contact_sheet.py DUMP_FOLDER OUT.png [EVENT]

Needs OpenImageIO's Python module and NumPy (Debian: python3-openimageio python3-numpy), and a dump
of all buffers.
"""

import json
import sys

import numpy as np
import OpenImageIO as oiio

NONE = 4294967295  # "no primitive"


def part(folder, file, index=0):
    """The channels of one part by name, each in its own type: a conversion would scale integers."""
    source = oiio.ImageInput.open(folder + "/" + file)
    spec = source.spec(index, 0)
    return {
        name: source.read_image(index, 0, i, i + 1, str(spec.channelformat(i)))[:, :, 0]
        for i, name in enumerate(spec.channelnames)
    }


def vector(channels, name, letters):
    return np.stack([channels[name + "." + letter] for letter in letters], axis=2)


def grey(values):
    return np.repeat(values[:, :, None], 3, axis=2)


def ranged(values, valid):
    """From dark to light between the least and the greatest valid value; others black."""
    low, high = values[valid].min(), values[valid].max()
    return grey(np.where(valid, 0.1 + 0.9 * (values - low) / max(high - low, 1e-30), 0.0))


def hashed(ids):
    """A colour for each id; none is black."""
    keys = ids.astype(np.uint64)
    colours = [(keys * np.uint64(k) >> np.uint64(7)) % np.uint64(199) for k in (2654435761, 40503, 97)]
    return np.where(grey(ids == NONE), 0.0, 0.2 + 0.8 * np.stack(colours, axis=2) / 198.0)


def tiles(folder, manifest):
    """Nearest depth, range of depths and list entries of each tile, the six faces side by side."""
    near, span, entries = [], [], []
    source = oiio.ImageInput.open(folder + "/ids.exr")
    levels = next(f for f in manifest["files"] if f["buffer"] == "depth")["parts"]
    for view, frame in enumerate(manifest["view_frames"]):
        bounds = part(folder, "depth.exr", levels.index(frame["name"] + ".level0"))
        near.append(bounds["near.Z"])
        empty = bounds["near.Z"] > bounds["far.Z"]
        span.append(np.where(empty, 0.0, bounds["far.Z"] - np.where(empty, 0.0, bounds["near.Z"])))
        deep = source.read_native_deep_image(view, 0)
        counts = np.array([deep.samples(i) for i in range(deep.pixels)], dtype=np.float64)
        entries.append(counts.reshape(frame["tiles"][1], frame["tiles"][0]))
    join = lambda faces: np.concatenate(
        [np.concatenate(faces[i : i + 3], axis=1) for i in range(0, len(faces), 3)], axis=0
    )
    near, span, entries = join(near), join(span), join(entries)
    filled = near < 1e30
    return [
        ("depth: near", ranged(np.log(np.where(filled, np.maximum(near, 1e-6), 1.0)), filled)),
        ("depth: far - near", ranged(np.where(filled, span, 0.0), filled)),
        ("ids: entries of a tile", ranged(np.log1p(entries), entries > 0)),
    ]


def pictures(folder, event):
    manifest = json.load(open(folder + "/manifest.json", encoding="utf-8"))
    k = str(event)
    direct, rays = part(folder, "direct.exr"), part(folder, f"rays.{k}.exr")
    hits, shading = part(folder, f"hits.{k}.exr"), part(folder, f"shading.{k}.exr")
    seen, hit = direct["primitive.X"] != NONE, hits["primitive.X"] != NONE
    image = part(folder, f"image.{k}.exr")
    return tiles(folder, manifest) + [
        ("direct: primitive", hashed(direct["primitive.X"])),
        ("direct: position", vector(direct, "position", "XYZ") * 0.5 + 0.5),
        ("direct: shadingNormal", np.where(grey(seen), vector(direct, "shadingNormal", "XYZ") * 0.5 + 0.5, 0)),
        ("direct: diffuse", vector(direct, "diffuse", "RGB") ** 0.45),
        ("visibility.0", grey(part(folder, "visibility.0.exr")["visible.X"])),
        (f"mask.{k}", grey(part(folder, f"mask.{k}.exr")["alive.X"])),
        (f"rays.{k}: direction", vector(rays, "direction", "XYZ") * 0.5 + 0.5),
        (f"rays.{k}: throughput", vector(rays, "throughput", "RGB") ** 0.45),
        (f"hits.{k}: primitive", hashed(hits["primitive.X"])),
        (f"hits.{k}: t", ranged(np.log(np.where(hit, np.maximum(hits["t.X"], 1e-6), 1.0)), hit)),
        (f"shading.{k}: next.diffuse", vector(shading, "next.diffuse", "RGB") ** 0.45),
        (f"image.{k}", np.stack([image[c] for c in "RGB"], axis=2) ** 0.45),
    ]


def scaled(picture, width, height):
    rows = np.arange(height) * picture.shape[0] // height
    columns = np.arange(width) * picture.shape[1] // width
    return np.clip(picture[rows][:, columns], 0.0, 1.0)


def main():
    folder, out = sys.argv[1:3]
    event = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    width, height, label, across = 384, 192, 22, 3
    shown = pictures(folder, event)
    rows = (len(shown) + across - 1) // across
    sheet = oiio.ImageBuf(oiio.ImageSpec(across * width, rows * (height + label), 3, "float"))
    oiio.ImageBufAlgo.fill(sheet, (0.13, 0.13, 0.13))
    for i, (name, picture) in enumerate(shown):
        x, y = i % across * width, i // across * (height + label)
        region = oiio.ROI(x, x + width - 4, y + label, y + label + height - 4)
        sheet.set_pixels(region, scaled(picture, width - 4, height - 4).astype(np.float32))
        oiio.ImageBufAlgo.render_text(sheet, x + 2, y + 16, name, 14, "", (0.9, 0.9, 0.9))
    sheet.write(out, "uint8")


main()
