"""Writes ice_floe.msh: a floe of ice with a polygonal outline, in quadrilaterals of 4 to 11 m.

    python3 meshes/ice_floe.py

A square of SIDE × SIDE elements is bent onto the polygon: its rings of elements become rings around the centre, square
at first, then more and more of the polygon's shape. Every corner of the polygon is a node; edges are straight.
"""

import math
import pathlib

# Corners in turn [m]
OUTLINE = [(102, -8), (88, 46), (51, 84), (-6, 92), (-58, 78), (-96, 38), (-104, -14), (-80, -62), (-28, -90), (34, -86), (79, -55)]
SIDE = 24


def perimeter_points(count):
    """`count` points around the polygon, its corners among them, beginning on the ray at -135°."""
    lengths = [math.dist(a, b) for a, b in zip(OUTLINE, OUTLINE[1:] + OUTLINE[:1])]
    shares = [max(1, round(count * length / sum(lengths))) for length in lengths]
    while sum(shares) != count:
        longest = max(range(len(shares)), key=lambda i: lengths[i] / shares[i] if sum(shares) < count else -lengths[i] / shares[i])
        shares[longest] += 1 if sum(shares) < count else -1
    points = []
    for (x0, y0), (x1, y1), share in zip(OUTLINE, OUTLINE[1:] + OUTLINE[:1], shares):
        points += [(x0 + (x1 - x0) * i / share, y0 + (y1 - y0) * i / share) for i in range(share)]
    start = min(range(count), key=lambda i: abs(math.remainder(math.atan2(points[i][1], points[i][0]) + 0.75 * math.pi, 2 * math.pi)))
    return points[start:] + points[:start]


def place(i, j, outline):
    """Node (i, j) of the square, -SIDE/2 … SIDE/2."""
    half = SIDE // 2
    ring = max(abs(i), abs(j))
    if ring == 0:
        return 0.0, 0.0
    # The same direction on the outermost ring: u, v on the square, and its place along the perimeter
    u, v = i / ring * half, j / ring * half
    if v == -half and u < half:
        along = u + half
    elif u == half and v < half:
        along = SIDE + v + half
    elif v == half and u > -half:
        along = 2 * SIDE + half - u
    else:
        along = 3 * SIDE + half - v
    first = math.floor(along)
    (x0, y0), (x1, y1) = outline[first % (4 * SIDE)], outline[(first + 1) % (4 * SIDE)]
    x, y = x0 + (along - first) * (x1 - x0), y0 + (along - first) * (y1 - y0)
    share = ring / half
    size = 60.0  # half the side of the square in the middle, if it stayed one [m]
    square = (u / half * size, v / half * size)
    return tuple(share * (share * p + (1 - share) * s) for p, s in zip((x, y), square))


def main():
    half = SIDE // 2
    outline = perimeter_points(4 * SIDE)
    nodes = [place(i, j, outline) for j in range(-half, half + 1) for i in range(-half, half + 1)]
    number = lambda i, j: 1 + j * (SIDE + 1) + i
    quads = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)) for j in range(SIDE) for i in range(SIDE)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes))]
    lines += [f"{n} {x:.6g} {y:.6g} 0" for n, (x, y) in enumerate(nodes, 1)]
    lines += ["$EndNodes", "$Elements", str(len(quads))]
    lines += [f"{n} 3 2 1 1 {a} {b} {c} {d}" for n, (a, b, c, d) in enumerate(quads, 1)] + ["$EndElements", ""]
    (pathlib.Path(__file__).parent / "ice_floe.msh").write_text("\n".join(lines), encoding="ascii")


if __name__ == "__main__":
    main()
