#!/usr/bin/env python3
"""Writes dumps for `dirt replay`, as another engine would: write_dump.py FOLDER

A subfolder for each dump: `right`, and others with one fault each; FOLDER/faults.json says of each
which pass is wrong, and where.
"""

import json
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True  # the folder is the source's
from engine import *


def text(x):
    """Words as they are; floats decimal, or hexadecimal where that is not short."""
    if isinstance(x, int):
        return str(x)
    return f"{x:.9g}" if single(float(f"{x:.9g}")) == x else x.hex()


def write_table(file, names, rows):
    lines = [names] + [",".join(text(x) for x in row) for row in rows]
    file.write_text("\n".join(lines) + "\n", encoding="ascii")


def write_dump(folder, scene, depth, entries, rays, hits, shadow_rays, blocking):
    folder.mkdir(parents=True)
    write_table(folder / "triangles.csv", "a.X,a.Y,a.Z,b.X,b.Y,b.Z,c.X,c.Y,c.Z",
                [sum(triangle, []) for triangle in scene])
    write_table(folder / "depth.csv", "view,level,column,row,near,far",
                [[*cell, *bounds] for cell, bounds in sorted(depth.items())])
    write_table(folder / "ids.csv", "view,column,row,bin,id", [list(e) for e in sorted(entries)])
    write_table(folder / "rays.1.csv",
                "origin.X,origin.Y,origin.Z,direction.X,direction.Y,direction.Z",
                [[float(x) for x in origin + direction] for origin, direction in rays])
    write_table(folder / "hits.1.csv", "primitive,t,u,v", hits)
    write_table(folder / "shadowrays.1.csv",
                "origin.X,origin.Y,origin.Z,direction.X,direction.Y,direction.Z,tMax,occluded,blocker",
                [[float(x) for x in origin + direction] + [1.0, *answer]
                 for (origin, direction), answer in zip(shadow_rays, blocking)])
    borders = [float(border(i)) for i in range(TILES + 1)]
    views = [
        {
            "name": name,
            "axes": [(face // 2 + 1) % 3, (face // 2 + 2) % 3, face // 2],
            "sign": 1 - 2 * (face % 2),
            "size": [VIEW_SIZE, VIEW_SIZE],
            "tiles": [TILES, TILES],
            "s": borders,
            "t": borders,
        }
        for face, name in enumerate(FACES)
    ]
    buffers = {"triangles": None, "depth": None, "ids": None, "rays": 1, "hits": 1,
               "shadowrays": 1}
    files = [
        {"file": name + (f".{event}" if event else "") + ".csv", "buffer": name, "event": event}
        for name, event in buffers.items()
    ]
    manifest = {"view": "full", "tile": TILE, "bins": BINS, "size": [WIDTH, HEIGHT],
                "view_frames": views, "at_eye": [], "files": files}
    (folder / "manifest.json").write_text(json.dumps(manifest, indent=1), encoding="ascii")


class Faults:
    """Writes a dump for each fault, and notes where it is."""

    def __init__(self, folder):
        self.folder, self.expected = folder, {}
        self.scene = make_scene()
        self.right = Structure(self.scene)
        self.rays = make_rays(self.scene)
        self.found = [cast(ray, self.scene) for ray in self.rays]
        self.shadow_rays = make_shadow_rays()
        self.between = [blockers(ray, self.scene) for ray in self.shadow_rays]
        # Occluded or not, and by what: any of those between.
        self.blocking = [[1, ids[-1]] if ids else [0, NONE] for ids in self.between]

    def write(self, name, where, depth=None, entries=None, found=None, hits=None, blocking=None):
        """where says the fault; None: there is none."""
        hits = hits or [record(hit) for hit in (found or self.found)]
        write_dump(self.folder / name, self.scene, depth or self.right.depth,
                   entries or self.right.entries, self.rays, hits, self.shadow_rays,
                   blocking or self.blocking)
        self.expected[name] = where

    def lies_well(self, cell, number):
        """Whether a part's ends are far from the borders of bins, so that its bins are certain."""
        places = [self.right.place(cell, depth) for depth in self.right.parts[cell][number]]
        return all(Fraction(1, 100) < p - int(p) < Fraction(99, 100) for p in places)

    def cell_where(self, holds):
        """The first (view, column, row) and id of which that holds, in the order of replay."""
        for view in range(6):
            for row in range(TILES):
                for column in range(TILES):
                    for number in sorted(self.right.parts[view, column, row]):
                        if holds((view, column, row), number):
                            return (view, column, row), number
        raise LookupError

    def where(self, name, cell=None, level=0, **more):
        place = {"pass": name}
        if cell:
            place |= {"view": FACES[cell[0]], "tile": list(cell[1:]), "level": level}
        return place | {"count": 1} | more

    def cut_bound(self):
        """The far bound of a tile ends before its farthest triangle does, by a thousandth."""
        def is_farthest_alone(cell, number):
            parts = self.right.parts[cell]
            others = [p[1] for i, p in parts.items() if i != number]
            end = parts[number][1] * Fraction(999, 1000)
            meets = depths_in([to_view(p, cell[0]) for p in self.scene[number]], *cell[1:], 0)
            return meets and meets[1] > end > max(others, default=0)
        cell, number = self.cell_where(is_farthest_alone)
        near, far = self.right.depth[(cell[0], 0) + cell[1:]]
        cut = self.right.with_bounds(cell, (near, single(far * 0.999)))
        self.write("cut-bound", self.where("FillDepth", cell, primitive=number, fault="cut short"),
                   depth=cut.depth, entries=cut.entries)

    def wide_bound(self):
        """Nearer by 17 ulp than what is within 1/64 of a tile."""
        cell, _ = self.cell_where(lambda cell, number: True)
        _, far = self.right.depth[(cell[0], 0) + cell[1:]]
        polygons = [[to_view(p, cell[0]) for p in t] for t in self.scene]
        parts = [depths_in(p, *cell[1:], Fraction(1, 64)) for p in polygons]
        least = below(min(p[0] for p in parts if p))
        wide = self.right.with_bounds(cell, (moved(least, -17), far))
        self.write("wide-bound", self.where("FillDepth", cell, fault="too wide"),
                   depth=wide.depth, entries=wide.entries)

    def without_guard_band(self):
        """Lists of what meets the tiles themselves, over the right bounds."""
        bare = Structure(self.scene, 0)
        bare.depth = self.right.depth
        bare.fill()
        due = Structure(self.scene, Fraction(1, 512))
        due.depth = self.right.depth
        due.fill()
        lacking = due.entries - bare.entries
        self.write("without-guard-band",
                   self.where("FillPrimitives", fault="incomplete in the guard band",
                              count=len(lacking), primitive=min(lacking)[4]),
                   entries=bare.entries)

    def wrong_pyramid(self):
        """A cell of level 1 that is not the nearest of its view: level 2 is right all the same."""
        depth = dict(self.right.depth)
        cell = next(c for c in sorted(depth)
                    if c[1] == 1 and depth[c[0], 2, 0, 0][0] < depth[c][0] <= depth[c][1])
        depth[cell] = (moved(depth[cell][0], 1), depth[cell][1])
        place = self.where("FillDepthMipmap", (cell[0], cell[2], cell[3]), level=1, fault="wrong")
        self.write("wrong-pyramid", place, depth=depth)

    def lacking(self):
        """A triangle is not in the last of its bins."""
        def spans(cell, number):
            own = depths_in([to_view(p, cell[0]) for p in self.scene[number]], *cell[1:], 0)
            bins = self.right.bins_of(cell, number)
            return own and len(bins) > 1 and self.lies_well(cell, number) and (
                self.right.place(cell, own[1]) > bins[-1] + Fraction(1, 100))
        cell, number = self.cell_where(spans)
        last = self.right.bins_of(cell, number)[-1]
        entries = self.right.entries - {(*cell, last, number)}
        self.write("lacking", self.where("FillPrimitives", cell, bin=last, primitive=number,
                                         fault="incomplete"), entries=entries)

    def far_away(self):
        """A triangle is listed where it is not: two tiles away, or more."""
        listed = {(c, n) for c, parts in self.right.parts.items() for n in parts}
        def is_alone(cell, number):
            return all(((cell[0], x, y), number) not in listed
                       for x in range(TILES) for y in range(TILES))
        number = len(self.scene) - 2  # in front of the last view
        cell = next((v, x, y) for v in range(6) for y in range(TILES) for x in range(TILES)
                    if is_alone((v, x, y), number))
        self.write("far-away", self.where("FillPrimitives", cell, bin=2, primitive=number,
                                          fault="loose"),
                   entries=self.right.entries | {(*cell, 2, number)})

    def wrong_depth(self):
        """A triangle is in a bin before its depths."""
        def starts_late(cell, number):
            return self.right.bins_of(cell, number)[0] > 1 and self.lies_well(cell, number)
        cell, number = self.cell_where(starts_late)
        self.write("wrong-depth", self.where("FillPrimitives", cell, bin=0, primitive=number,
                                             fault="loose"),
                   entries=self.right.entries | {(*cell, 0, number)})

    def pixel(self, number):
        return [number % WIDTH, number // WIDTH]

    def hit_pixel(self):
        return next(i for i in range(20, len(self.found)) if self.found[i])

    def missed(self):
        pixel = self.hit_pixel()
        found = list(self.found)
        found[pixel] = None
        self.write("missed", self.where("Trace 1", pixel=self.pixel(pixel), fault="missed",
                                        primitive=self.found[pixel][0]), found=found)

    def false_hit(self):
        pixel = self.found.index(None)
        found = list(self.found)
        found[pixel] = (5, 1.0, 0.25, 0.25)
        self.write("false-hit", self.where("Trace 1", pixel=self.pixel(pixel), fault="false",
                                           primitive=5), found=found)

    def wrong_primitive(self):
        """The one behind the nearest."""
        behind = [hit and cast(ray, self.scene, without=(hit[0],))
                  for ray, hit in zip(self.rays, self.found)]
        pixel = next(i for i, hit in enumerate(behind) if hit)
        found = list(self.found)
        found[pixel] = behind[pixel]
        self.write("wrong-primitive",
                   self.where("Trace 1", pixel=self.pixel(pixel), fault="wrong primitive",
                              primitive=self.found[pixel][0]), found=found)

    def wrong_t(self):
        """By two floats."""
        pixel = self.hit_pixel()
        hits = [record(hit) for hit in self.found]
        hits[pixel][1] = moved(hits[pixel][1], 2)
        self.write("wrong-t", self.where("Trace 1", pixel=self.pixel(pixel), fault="wrong t",
                                         primitive=hits[pixel][0]), hits=hits)

    def wrong_weights(self):
        pixel = self.hit_pixel()
        hits = [record(hit) for hit in self.found]
        hits[pixel][2:] = [single(hits[pixel][2] + 2**-22), hits[pixel][3]]
        self.write("wrong-weights",
                   self.where("Trace 1", pixel=self.pixel(pixel), fault="wrong weights",
                              primitive=hits[pixel][0]), hits=hits)

    def with_answer(self, pixel, answer):
        return self.blocking[:pixel] + [answer] + self.blocking[pixel + 1:]

    def write_shadow(self, name, pixel, answer, **where):
        self.write(name, self.where("Visibility 1", pixel=self.pixel(pixel), **where),
                   blocking=self.with_answer(pixel, answer))

    def missed_occlusion(self):
        """Of the last pixel that is in shadow."""
        pixel = max(i for i, ids in enumerate(self.between) if ids)
        self.write_shadow("missed-occlusion", pixel, [0, NONE], fault="missed occlusion",
                          primitive=self.between[pixel][0])

    def false_occlusion(self):
        """By a triangle that the ray meets beyond the light."""
        def beyond(ray):
            hit = cast(ray, self.scene)
            return hit and hit[1] > 1 and hit[0]
        pixel, number = next((i, beyond(ray)) for i, ray in enumerate(self.shadow_rays)
                             if beyond(ray))
        self.write_shadow("false-occlusion", pixel, [1, number], fault="false occlusion",
                          primitive=number)

    def wrong_blocker(self):
        """In shadow indeed, but of another triangle."""
        pixel = next(i for i, ids in enumerate(self.between) if ids)
        other = next(i for i in range(len(self.scene)) if i not in self.between[pixel])
        self.write_shadow("wrong-blocker", pixel, [1, other], fault="wrong blocker",
                          primitive=other)

    def lost(self):
        """A triangle is in no list, and rays that should hit it do not: one fault, three passes."""
        counts = [sum(1 for hit in self.found if hit and hit[0] == n)
                  for n in range(len(self.scene))]
        number = counts.index(max(counts))
        bare = Structure([self.scene[number]], 0)
        bare.depth = self.right.depth
        bare.fill()
        due = bare.entries
        found = [cast(ray, self.scene, without=(number,)) for ray in self.rays]
        assert sum(a != b for a, b in zip(found, self.found)) == counts[number] > 1
        lit = [ids == [number] for ids in self.between]
        blocking = [[0, NONE] if is_lit else [1, next(i for i in ids if i != number)] if ids
                    else [0, NONE] for ids, is_lit in zip(self.between, lit)]
        self.write("lost", self.where("FillPrimitives", inherited=counts[number],
                                      inherited_shadows=sum(lit), primitive=number,
                                      fault="incomplete", count=len(due)),
                   entries={e for e in self.right.entries if e[4] != number}, found=found,
                   blocking=blocking)


def main():
    faults = Faults(Path(sys.argv[1]))
    faults.write("right", None)
    for fault in (faults.cut_bound, faults.wide_bound, faults.wrong_pyramid, faults.lacking,
                  faults.without_guard_band, faults.far_away, faults.wrong_depth, faults.missed, faults.false_hit,
                  faults.wrong_primitive, faults.wrong_t, faults.wrong_weights, faults.missed_occlusion,
                  faults.false_occlusion, faults.wrong_blocker, faults.lost):
        fault()
    (faults.folder / "faults.json").write_text(json.dumps(faults.expected), encoding="ascii")


main()
