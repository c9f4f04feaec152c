"""Draws the von Mises stress on the deformed surface of the bodies of a run, as a PNG file.

    python3 stress_picture.py bodies-0000.vtu OUT.png

Needs meshio.
"""

import struct
import sys
import zlib

import meshio
import numpy as np

WIDTH, HEIGHT, OVERSAMPLING = 1200, 600, 2
# Factor on the elastic displacements.
WARP = 100
# Upper limit of the colour scale, Pa: the mesh does not resolve contact stresses at nodes.
HIGHEST = 3e8
# Width of the visible section relative to the width of the bodies.
SECTION = 0.8
# The six faces of a hexahedron.
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
# A perceptually ordered scale from low to high stress, sRGB.
COLOURS = np.array([
    (196, 208, 222), (120, 170, 214), (80, 180, 170), (150, 205, 110), (240, 215, 80), (240, 140, 50), (200, 40, 40),
], dtype=float)


def surface(cells):
    """Faces that belong to one cell only, as corner indices."""
    faces = np.concatenate([cells[:, face] for face in FACES])
    _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    return faces[first[count == 1]]


def view():
    """Rotation into the picture: the axes of the gears lean towards the viewer."""
    tilt, turn = np.radians(-24), np.radians(10)
    about_x = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    about_y = np.array([[np.cos(turn), 0, np.sin(turn)], [0, 1, 0], [-np.sin(turn), 0, np.cos(turn)]])
    return about_x @ about_y


def draw(triangles, values, shades, width, height):
    """Fills triangles (x, y, depth) with interpolated colours; the nearest one wins."""
    image = np.full((height, width, 3), 255.0)
    depth = np.full((height, width), -np.inf)
    for corners, value, shade in zip(triangles, values, shades):
        low = np.floor(corners[:, :2].min(0)).astype(int).clip(0)
        high = np.ceil(corners[:, :2].max(0)).astype(int) + 1
        xs, ys = np.arange(low[0], min(high[0], width)), np.arange(low[1], min(high[1], height))
        (ax, ay, _), (bx, by, _), (cx, cy, _) = corners
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if area == 0 or len(xs) == 0 or len(ys) == 0:
            continue
        x, y = np.meshgrid(xs, ys)
        v = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
        w = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
        u = 1 - v - w
        z = u * corners[0, 2] + v * corners[1, 2] + w * corners[2, 2]
        seen = (u >= -1e-9) & (v >= -1e-9) & (w >= -1e-9) & (z > depth[y, x])
        level = (u * value[0] + v * value[1] + w * value[2])[seen].clip(0, 1) * (len(COLOURS) - 1)
        step = np.minimum(level.astype(int), len(COLOURS) - 2)
        part = (level - step)[:, None]
        image[y[seen], x[seen]] = ((1 - part) * COLOURS[step] + part * COLOURS[step + 1]) * shade
        depth[y[seen], x[seen]] = z[seen]
    return image


def png(image, path):
    """Writes 8-bit RGB."""
    height, width, _ = image.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), image.reshape(height, -1)], axis=1)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        file.write(chunk(b"IDAT", zlib.compress(rows.tobytes(), 9)) + chunk(b"IEND", b""))


def main(source, target):
    mesh = meshio.read(source)
    points = mesh.points + WARP * mesh.point_data["displacement"]
    stress = mesh.point_data["von_mises"] / HIGHEST
    faces = surface(np.concatenate([block.data for block in mesh.cells if block.type == "hexahedron"]))
    triangles = np.concatenate([faces[:, (0, 1, 2)], faces[:, (0, 2, 3)]])

    turned = points @ view().T
    width, height = WIDTH * OVERSAMPLING, HEIGHT * OVERSAMPLING
    zoom = width / (SECTION * np.ptp(turned[:, 0]))
    # Centres the image at high stresses: on the teeth in contact.
    centre = turned[stress > 0.8, :2].mean(0)
    turned[:, :2] = (turned[:, :2] - centre) * zoom
    screen = turned * (1, -1, zoom) + (0.5 * width, 0.5 * height, 0)

    corners = screen[triangles]
    sides = turned[triangles]
    sides[:, :, 2] *= zoom
    normals = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-30)
    light = np.array((-0.3, 0.5, 0.81))
    shades = 0.62 + 0.38 * np.abs(normals @ light)
    image = draw(corners, stress[triangles], shades, width, height)
    image = image.reshape(HEIGHT, OVERSAMPLING, WIDTH, OVERSAMPLING, 3).mean((1, 3))
    png(image.round().astype(np.uint8), target)


if __name__ == "__main__":
    main(*sys.argv[1:])
