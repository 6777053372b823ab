"""An engine that shares nothing with dirt: a made scene, clipped to tiles and met by rays in
rational arithmetic; bounds, lists and hits rounded to float32 at the end.
"""

import random
import struct
from fractions import Fraction

VIEW_SIZE, TILE, BINS = 64, 16, 4
WIDTH, HEIGHT = 12, 8
TILES = VIEW_SIZE // TILE
NONE = 4294967295
FACES = ["+X", "-X", "+Y", "-Y", "+Z", "-Z"]


def single(x):
    """x rounded to float32."""
    return struct.unpack("f", struct.pack("f", float(x)))[0]


def moved(x, floats):
    """The float32 so many after x >= 0."""
    bits = struct.unpack("i", struct.pack("f", x))[0]
    return struct.unpack("f", struct.pack("i", bits + floats))[0]


def below(x):
    f = single(x)
    return moved(f, -1) if Fraction(f) > x else f


def above(x):
    f = single(x)
    return moved(f, 1) if Fraction(f) < x else f


def subtract(a, b):
    return [p - q for p, q in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def make_scene():
    """Scattered triangles around the eye, the largest coordinate in [1, 2); in front of each face a
    long one that passes through several tiles and bins; and one that ends a thousandth of a tile
    before a border."""
    draw = random.Random(7)
    triangles = []
    for _ in range(18):
        centre = [draw.uniform(-1.2, 1.2) for _ in range(3)]
        triangles.append([[single(c + draw.uniform(-0.4, 0.4)) for c in centre] for _ in "abc"])
    for face in range(6):
        axis, sign = face // 2, 1 - 2 * (face % 2)
        corners = [(0.25, (-0.2, -0.1)), (1.5, (1.1, 0.4)), (1.1, (-0.7, 0.9))]
        triangle = []
        for depth, (x, y) in corners:
            point = [0.0] * 3
            point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = sign * depth, x, y
            triangle.append([single(c) for c in point])
        triangles.append(triangle)
    corners = [[0.5, 0.00025, 0.1], [0.6, 0.2, 0.1], [0.6, 0.2, 0.2]]
    triangles.append([[single(c) for c in corner] for corner in corners])
    largest = max(abs(c) for t in triangles for p in t for c in p)
    assert 1 <= largest < 2
    return triangles


def to_view(point, face):
    axis = face // 2
    w = Fraction(point[axis]) * (1 - 2 * (face % 2))
    return [Fraction(point[(axis + 1) % 3]), Fraction(point[(axis + 2) % 3]), w]


def border(i):
    return Fraction(2 * i * TILE - VIEW_SIZE, VIEW_SIZE)


def clip(polygon, planes):
    """The convex polygon where all planes (a, b, c) have a x + b y + c w >= 0."""
    for plane in planes:
        kept = []
        values = [dot(plane, point) for point in polygon]
        for i, (point, value) in enumerate(zip(polygon, values)):
            previous, other = polygon[i - 1], values[i - 1]
            if (value > 0) != (other > 0) and value != 0 and other != 0:
                t = value / (value - other)
                kept.append([p + t * (q - p) for p, q in zip(point, previous)])
            if value >= 0:
                kept.append(point)
        polygon = kept
    return polygon


def depths_in(polygon, column, row, part):
    """Least and greatest depth within that part of a tile around the tile; None: they do not meet."""
    guard = Fraction(2 * TILE, VIEW_SIZE) * part
    s0, s1 = border(column) - guard, border(column + 1) + guard
    t0, t1 = border(row) - guard, border(row + 1) + guard
    cut = clip(polygon, [(0, 0, 1), (1, 0, -s0), (-1, 0, s1), (0, 1, -t0), (0, -1, t1)])
    depths = [point[2] for point in cut]
    return (min(depths), max(depths)) if depths and max(depths) > 0 else None


class Structure:
    """Bounds, pyramid and lists of an engine whose guard band is that part of a tile."""

    def __init__(self, triangles, guard=Fraction(1, 100)):
        self.parts = {}  # (view, column, row) -> {id: exact depths}
        for view in range(6):
            for row in range(TILES):
                for column in range(TILES):
                    self.parts[view, column, row] = {}
            for number, triangle in enumerate(triangles):
                polygon = [to_view(point, view) for point in triangle]
                for row in range(TILES):
                    for column in range(TILES):
                        depths = depths_in(polygon, column, row, guard)
                        if depths:
                            self.parts[view, column, row][number] = depths
        self.depth = {}  # (view, level, column, row) -> (near, far)
        for (view, column, row), parts in self.parts.items():
            near = below(min(p[0] for p in parts.values())) if parts else 1.0
            far = above(max(p[1] for p in parts.values())) if parts else 0.0
            self.depth[view, 0, column, row] = (near, far)
        self.fill()

    def with_bounds(self, cell, bounds):
        """The same, with other bounds of a tile, and what follows from them."""
        other = Structure.__new__(Structure)
        other.parts = self.parts
        other.depth = self.depth | {(cell[0], 0) + cell[1:]: bounds}
        other.fill()
        return other

    def fill(self):
        self.fill_pyramid()
        self.entries = set()  # (view, column, row, bin, id)
        for cell, parts in self.parts.items():
            for number in parts:
                self.entries |= {(*cell, b, number) for b in self.bins_of(cell, number)}

    def fill_pyramid(self):
        for view in range(6):
            level, size = 0, TILES
            while size > 1:
                level, size = level + 1, (size + 1) // 2
                for row in range(size):
                    for column in range(size):
                        self.depth[view, level, column, row] = self.reduced(view, level, column, row)

    def reduced(self, view, level, column, row):
        below_it = [
            self.depth[view, level - 1, x, y]
            for x in (2 * column, 2 * column + 1)
            for y in (2 * row, 2 * row + 1)
        ]
        filled = [bounds for bounds in below_it if bounds[0] <= bounds[1]]
        if not filled:
            return (1.0, 0.0)
        return (min(b[0] for b in filled), max(b[1] for b in filled))

    def place(self, cell, depth):
        """Where a depth is among the bins, exactly."""
        near, far = (Fraction(x) for x in self.depth[(cell[0], 0) + cell[1:]])
        return (depth - near) * BINS / (far - near) if far > near else Fraction(0)

    def bins_of(self, cell, number):
        first, last = (
            max(0, min(BINS - 1, int(self.place(cell, depth))))
            for depth in self.parts[cell][number]
        )
        return range(first, last + 1)


def meet(ray, triangle):
    """t, u and v where a ray meets a triangle."""
    origin, direction = ray
    a, b, c = triangle
    ab, ac = subtract(b, a), subtract(c, a)
    normal = cross(ab, ac)
    along = dot(normal, direction)
    if along == 0:
        return None
    t = dot(normal, subtract(a, origin)) / along
    if t < 0:
        return None
    point = subtract([o + t * d for o, d in zip(origin, direction)], a)
    whole = dot(normal, normal)
    u, v = dot(normal, cross(point, ac)) / whole, dot(normal, cross(ab, point)) / whole
    return (t, u, v) if u >= 0 and v >= 0 and u + v <= 1 else None


def cast(ray, triangles, without=()):
    """The nearest hit (id, t, u, v) with an exact t; None: there is none."""
    hits = [(meet(ray, t), i) for i, t in enumerate(triangles) if i not in without]
    hits = [(*hit, i) for hit, i in hits if hit]
    if not hits:
        return None
    t, u, v, number = min(hits, key=lambda hit: (hit[0], hit[3]))
    return (number, t, u, v)


def make_rays(triangles):
    """From random places to points of triangles, and some to nowhere."""
    draw = random.Random(3)
    rays = []
    for pixel in range(WIDTH * HEIGHT):
        origin = [single(draw.uniform(-1, 1)) for _ in range(3)]
        if pixel % 8 == 0:
            direction = [single(draw.uniform(-1, 1)) for _ in range(3)]
        else:
            a, b, c = draw.choice(triangles)
            u, v = draw.uniform(0, 0.5), draw.uniform(0, 0.5)
            aim = [p + u * (q - p) + v * (r - p) for p, q, r in zip(a, b, c)]
            direction = [single(x - o) for x, o in zip(aim, origin)]
        rays.append(([Fraction(x) for x in origin], [Fraction(x) for x in direction]))
    return rays


def record(found):
    """A hit as it is dumped."""
    if not found:
        return [NONE, 0.0, 0.0, 0.0]
    number, t, u, v = found
    return [number, single(t), single(u), single(v)]


LIGHT = [single(x) for x in (0.15, 0.2, 0.1)]


def make_shadow_rays():
    """From random places to the light, which is at t = 1; of every eighth pixel none."""
    draw = random.Random(5)
    rays = []
    for pixel in range(WIDTH * HEIGHT):
        origin = [single(draw.uniform(-1.2, 1.2)) for _ in range(3)]
        direction = [single(p - o) for p, o in zip(LIGHT, origin)] if pixel % 8 else [0.0] * 3
        rays.append(([Fraction(x) for x in origin], [Fraction(x) for x in direction]))
    return rays


def blockers(ray, triangles):
    """The ids of all that is hit before t = 1, nearest first."""
    hits = [(meet(ray, t), i) for i, t in enumerate(triangles)]
    hits = sorted((hit[0], i) for hit, i in hits if hit)
    assert all(abs(t - 1) > Fraction(1, 10000) for t, _ in hits)  # not as rounding decides
    return [i for t, i in hits if t < 1]
