#!/usr/bin/env python3
"""make.py [--check]: draws the icons of the components into Packages/com.glint.radar/Editor/Icons; with --check says whether those there are what it draws.

Each is a picture of 128 x 128 pixels on nothing, in colours that show on the grounds of Unity's dark and light skin: --check asks for a contrast of 2 at least, as WCAG 2 defines it. Shapes are given in units of an eighth of the picture,
y upwards, and drawn one over the other; a pixel is covered by as much as its middle lies inside.
"""
import math, os, struct, sys, zlib

SIZE = 128
UNIT = SIZE / 8
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Packages/com.glint.radar/Editor/Icons')

BLUE, DEEP, ORANGE, GREY = (30, 132, 200), (22, 107, 168), (208, 96, 24), (118, 126, 134)
GROUNDS = (56, 56, 56), (200, 200, 200)
MIN_CONTRAST = 2


# Distance to a shape in units, negative inside.
def disc(x, y, radius):
    return lambda px, py: math.hypot(px - x, py - y) - radius


def ring(x, y, radius, width):
    return lambda px, py: abs(math.hypot(px - x, py - y) - radius) - width / 2


def line(points, width):
    parts = [(ax, ay, bx - ax, by - ay, (bx - ax) ** 2 + (by - ay) ** 2) for (ax, ay), (bx, by) in zip(points, points[1:])]

    def distance(px, py):
        nearest = math.inf
        for ax, ay, dx, dy, square in parts:
            x, y = px - ax, py - ay
            along = x * dx + y * dy
            t = 0 if along <= 0 else 1 if along >= square else along / square
            x -= t * dx
            y -= t * dy
            nearest = min(nearest, x * x + y * y)
        return math.sqrt(nearest) - width / 2
    return distance


def area(points):
    outline = line(points + points[:1], 0)

    def distance(px, py):
        inside = False
        for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
            if (ay > py) != (by > py) and px < ax + (py - ay) / (by - ay) * (bx - ax):
                inside = not inside
        return -outline(px, py) if inside else outline(px, py)
    return distance


def arc(x, y, radius, first, last, steps=48):
    angles = [math.radians(first + (last - first) * i / steps) for i in range(steps + 1)]
    return [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in angles]


def wave(y, height, steps=64):
    return [(0.6 + 6.8 * i / steps, y + height * math.sin(2 * math.pi * 1.5 * i / steps)) for i in range(steps + 1)]


ICONS = {
    # A scope with its beam and an echo.
    'RadarController': [
        (disc(4, 4, 3.3), DEEP, 0.35),
        (area([(4, 4)] + arc(4, 4, 3.3, 20, 75)), BLUE, 0.9),
        (ring(4, 4, 3.3, 0.75), BLUE, 1),
        (line([(4, 4), (4 + 3 * math.cos(math.radians(20)), 4 + 3 * math.sin(math.radians(20)))], 0.5), BLUE, 1),
        (disc(2.7, 5.1, 0.65), ORANGE, 1),
    ],
    # A round screen with rings, the antenna's line and echoes.
    'RadarScreen': [
        (disc(4, 4, 3.4), DEEP, 0.35),
        (ring(4, 4, 3.35, 0.6), BLUE, 1),
        (ring(4, 4, 1.6, 0.4), BLUE, 0.9),
        (line([(4, 4), (5.7, 6.9)], 0.5), BLUE, 1),
        (disc(2.2, 5.2, 0.5), ORANGE, 1),
        (disc(5.9, 3.1, 0.65), ORANGE, 1),
    ],
    # The lobes of a polar plot.
    'RadarCrossSection': [
        (ring(4, 4, 3.35, 0.5), GREY, 1),
        (area([(4 + r * math.sin(a), 4 + r * math.cos(a)) for a, r in ((math.radians(d), 0.5 + 2.6 * abs(math.cos(math.radians(2 * d))) ** 1.5) for d in range(0, 360, 3))]), BLUE, 0.9),
        (disc(4, 4, 0.65), ORANGE, 1),
    ],
    # A target that is turned.
    'Sweep': [
        (line(arc(4, 4, 3, -40, 235), 0.8), BLUE, 1),
        (area([(4 + 3 * math.cos(math.radians(-40)) + dx, 4 + 3 * math.sin(math.radians(-40)) + dy) for dx, dy in ((-1.45, 0.35), (1.15, 0.75), (-0.5, -1.55))]), BLUE, 1),
        (area([(2.9, 2.9), (5.1, 2.9), (5.1, 5.1), (2.9, 5.1)]), ORANGE, 1),
    ],
    'Sea': [
        (line(wave(5.9, 0.65), 0.85), BLUE, 0.75),
        (line(wave(4, 0.65), 0.85), BLUE, 1),
        (line(wave(2.1, 0.65), 0.85), DEEP, 1),
    ],
    'Ship': [
        (line([(3.6, 4.5), (3.6, 7.2)], 0.5), GREY, 1),
        (area([(2.1, 3.4), (2.1, 5), (5.4, 5), (5.8, 3.4)]), GREY, 1),
        (area([(0.4, 3.7), (7.7, 3.9), (6.5, 1.8), (1.1, 1.8)]), BLUE, 1),
        (line([(0.7, 0.85), (7.3, 0.85)], 0.6), DEEP, 1),
    ],
    # A ray that bounces between two faces and comes back.
    'RayPaths': [
        (line([(7.2, 0.8), (7.2, 7.2)], 0.7), GREY, 1),
        (line([(2.2, 0.8), (7.2, 0.8)], 0.7), GREY, 1),
        (line([(0.8, 6.9), (6.6, 4.2), (4.4, 1.3), (1.4, 2.75)], 0.6), ORANGE, 1),
        (area([(0.3, 3.3), (2.3, 3.3), (1.6, 1.75)]), ORANGE, 1),
        (disc(0.9, 6.9, 0.65), BLUE, 1),
    ],
}


def draw(shapes):
    """Rows of red, green, blue, opacity, from the top."""
    rows = []
    for row in range(SIZE):
        pixels = bytearray()
        for column in range(SIZE):
            x, y = (column + 0.5) / UNIT, (SIZE - row - 0.5) / UNIT
            colour, opacity = (0.0, 0.0, 0.0), 0.0
            for shape, ink, strength in shapes:
                cover = strength * max(0.0, min(1.0, 0.5 - UNIT * shape(x, y)))
                below = opacity * (1 - cover)
                opacity = cover + below
                if opacity > 0:
                    colour = tuple((i * cover + c * below) / opacity for i, c in zip(ink, colour))
            pixels += bytes(int(c + 0.5) for c in colour) + bytes([int(255 * opacity + 0.5)])
        rows.append(bytes(pixels))
    return rows


def write(path, rows):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    header = struct.pack('>IIBBBBB', SIZE, SIZE, 8, 6, 0, 0, 0)
    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', header) + chunk(b'IDAT', zlib.compress(b''.join(b'\0' + row for row in rows), 9)) + chunk(b'IEND', b''))


def read(path):
    """The rows of a picture that write made: no filters, one chunk of data. How it is compressed may differ."""
    with open(path, 'rb') as file:
        data = file.read()
    at, packed = 8, b''
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        if kind == b'IDAT':
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, stride = zlib.decompress(packed), 1 + 4 * SIZE
    return [raw[row * stride + 1:(row + 1) * stride] for row in range(SIZE)]


def differ(some, others):
    """By more than the last digit: sines need not be the same everywhere."""
    return len(some) != len(others) or any(abs(a - b) > 1 for row, other in zip(some, others) for a, b in zip(row, other))


def luminance(colour):
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in (part / 255 for part in colour)]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    dark, light = sorted((luminance(a), luminance(b)))
    return (light + 0.05) / (dark + 0.05)


def main():
    wrong = 0
    for ink in sorted({ink for shapes in ICONS.values() for _, ink, _ in shapes}):
        for ground in GROUNDS:
            if contrast(ink, ground) < MIN_CONTRAST:
                print(f'{ink} has a contrast of {contrast(ink, ground):.2f} on {ground}: {MIN_CONTRAST} at least')
                wrong = 1
    for name, shapes in ICONS.items():
        path = os.path.join(FOLDER, name + '.png')
        rows = draw(shapes)
        if sys.argv[1:] == ['--check']:
            if not os.path.exists(path) or differ(read(path), rows):
                print(f'{name}.png is not what tools/icons/make.py draws: run it')
                wrong = 1
        else:
            write(path, rows)
    return wrong


if __name__ == '__main__':
    sys.exit(main())
