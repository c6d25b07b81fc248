#!/usr/bin/env python3
"""make.py [--check]: writes Meshes/Harbour, the coast, the breakwater and the materials of the scene Harbour Approach; with --check says whether the files there are, byte for byte, what it writes.

The scene itself is edited by hand. It refers to these assets by guid, which is a hash of the name here. x is east, y up and z north, in metres from the scene's origin, y from the mean level of the sea.
Land and breakwater come from Random, whose random() Python keeps the same for a seed. Numbers are computed in double precision and stored as float32. The form of a mesh's file is that of Meshes/Ship/Ship.asset.
"""
import functools, math, os, random, re, struct, sys, uuid

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../..')
MESHES = os.path.join(ROOT, 'Meshes')

# Of the coast's grid. Land outside of the radius is left out: the scene's outermost range ring is at 5,556 m.
STEP, RADIUS = 60, 6300
MAX_DEPTH = 12
BEACH_HEIGHT, BEACH_WIDTH = 2, 25
MAINLAND_HILLS, ISLAND_HILLS, HILL_DISTANCE = 95, 62, 420

# The breakwater's two arms, on both sides of the harbour's entrance: x, z of their ends.
ARMS = [((348.697384, 5347.6852), (1573.1201, 4905.93514)), ((1955.30961, 4767.35985), (3120.45304, 4338.19986))]
# Distance from the middle line and height, across an arm.
PROFILE = [(-16, -4), (-8, 1.5), (-3.5, 5), (3.5, 5), (8, 1.5), (16, -4)]
ROW_SPACING = 9
# What a stone lies off the even surface, across, along and up, at most.
STONES = 0.9, 1.5, 0.8


# The land.
@functools.lru_cache(maxsize=None)
def lattice(i, j, seed):
    return random.Random(i * 73856093 ^ j * 19349663 ^ seed * 83492791).random()


def noise(x, z, size, seed):
    """0 to 1, smooth between random values at points that are size apart (value noise)."""
    x, z = x / size, z / size
    i, j = math.floor(x), math.floor(z)
    u, w = smooth(x - i), smooth(z - j)
    near = lattice(i, j, seed) * (1 - u) + lattice(i + 1, j, seed) * u
    far = lattice(i, j + 1, seed) * (1 - u) + lattice(i + 1, j + 1, seed) * u
    return near * (1 - w) + far * w


def smooth(t):
    return t * t * (3 - 2 * t)


def hills(x, z):
    return 0.5 * noise(x, z, 900, 1) + 0.27 * noise(x, z, 400, 2) + 0.15 * noise(x, z, 170, 3) + 0.08 * noise(x, z, 80, 4)


def mainland(x, z, bend):
    """Metres inland of the shore in the west and north, negative at sea. The shore bends by noise."""
    west = -3300 - x + bend - 0.12 * abs(z - 900)
    north = z - 5330 + 0.36 * (x - 400) + 0.45 * bend
    if x < 400:
        north -= 0.16 * (400 - x)
    if x < 3400:
        bay = math.hypot(x - 1600, z - 5150) - 900 + 0.5 * bend
        north = min(north, bay)
    return max(west, north)


def island(x, z, bend):
    return 520 - math.hypot(x - 3500, (z - 2500) / 1.35) + 0.55 * bend


@functools.lru_cache(maxsize=None)
def height(x, z):
    bend = 700 * (noise(x, z, 1500, 5) - 0.5) + 260 * (noise(x, z, 420, 6) - 0.5)
    on_mainland, on_island = mainland(x, z, bend), island(x, z, bend)
    inland, top = (on_island, ISLAND_HILLS) if on_island >= on_mainland else (on_mainland, MAINLAND_HILLS)
    if inland <= 0:
        return max(-MAX_DEPTH, 0.12 * inland)
    beach = BEACH_HEIGHT * min(1, inland / BEACH_WIDTH)
    return beach + top * (1 - math.exp(-inland / HILL_DISTANCE)) * (0.35 + 1.3 * hills(x, z))


def coast():
    """Vertices and triangles of the squares of the grid that are not all under water."""
    numbers, vertices, triangles = {}, [], []
    cells = range(-RADIUS // STEP - 1, RADIUS // STEP + 1)
    for i in cells:
        for j in cells:
            corners = [(x * STEP, z * STEP) for x, z in ((i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j))]
            if min(math.hypot(x, z) for x, z in corners) > RADIUS or max(height(x, z) for x, z in corners) <= 0:
                continue
            for x, z in corners:
                if (x, z) not in numbers:
                    numbers[x, z] = len(vertices)
                    vertices.append((x, height(x, z), z))
            a, b, c, d = (numbers[corner] for corner in corners)
            triangles += [(a, b, c), (a, c, d)]
    return vertices, triangles


# The breakwater.
def breakwater():
    stones = random.Random(7)
    vertices, triangles = [], []
    for first, last in ARMS:
        triangles += rows(len(vertices), row_count(first, last))
        vertices += arm(first, last, stones)
    return vertices, [upwards(vertices, triangle) for triangle in triangles]


def row_count(first, last):
    return round(math.hypot(last[0] - first[0], last[1] - first[1]) / ROW_SPACING)


def arm(first, last, stones):
    """Rows of points across it. The rows at its ends are narrow and lie at its foot."""
    (x, z), (east, north) = first, (last[0] - first[0], last[1] - first[1])
    length, count = math.hypot(east, north), row_count(first, last)
    east, north = east / length, north / length
    for row in range(count + 1):
        for across, up in PROFILE:
            along = row * length / count
            offsets = [-size + 2 * size * stones.random() for size in STONES]
            if row in (0, count):
                across, up = across / 4, PROFILE[0][1]
            else:
                across, along, up = across + offsets[0], along + offsets[1], up + offsets[2]
            yield x + east * along - north * across, up, z + north * along + east * across


def rows(first, count):
    """Triangles between neighbouring rows of points, numbered from first."""
    width = len(PROFILE)
    for row in range(count):
        for column in range(width - 1):
            a = first + row * width + column
            yield a, a + width, a + 1
            yield a + 1, a + width, a + width + 1


def upwards(vertices, triangle):
    a, b, c = triangle
    return triangle if cross(*(vertices[k] for k in triangle))[1] > 0 else (a, c, b)


# Files.
def cross(a, b, c):
    """Of the triangle's sides: normal to it, and twice its area long."""
    u, w = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
    return u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]


def normals(vertices, triangles):
    sums = [[0, 0, 0] for _ in vertices]
    for triangle in triangles:
        normal = cross(*(vertices[k] for k in triangle))
        for k in triangle:
            for axis in range(3):
                sums[k][axis] += normal[axis]
    for normal in sums:
        length = math.sqrt(sum(part * part for part in normal))
        yield [part / length for part in normal]


def float32(value):
    return struct.unpack('<f', struct.pack('<f', value))[0]


def box(vertices):
    ends = [(min(axis), max(axis)) for axis in zip(*vertices)]

    def vector(parts):
        return '{{x: {:.7g}, y: {:.7g}, z: {:.7g}}}'.format(*map(float32, parts))
    return vector((low + high) / 2 for low, high in ends), vector((high - low) / 2 for low, high in ends)


def mesh(name, vertices, triangles):
    """Positions and normals of float32, indices of 16 bits, as Ship.asset has them."""
    vertices = [tuple(map(float32, vertex)) for vertex in vertices]
    data = b''.join(struct.pack('<6f', *position, *normal) for position, normal in zip(vertices, normals(vertices, triangles)))
    indices = b''.join(struct.pack('<3H', *triangle) for triangle in triangles)
    centre, extent = box(vertices)
    values = {
        'm_Name': name, 'indexCount': 3 * len(triangles), 'vertexCount': len(vertices), 'm_VertexCount': len(vertices),
        'm_IndexFormat': 0, 'm_IndexBuffer': indices.hex(), 'm_DataSize': len(data), '_typelessdata': data.hex(), 'm_Center': centre, 'm_Extent': extent,
    }
    with open(os.path.join(MESHES, 'Ship/Ship.asset'), encoding='utf-8') as file:
        text = file.read()
    for field, value in values.items():
        text = re.sub(rf'(?m)^( *{field}): .*$', rf'\g<1>: {value}', text)
    return text


def script_guid(component):
    with open(os.path.join(ROOT, 'Packages/com.glint.radar/Runtime/Components', component + '.cs.meta'), encoding='utf-8') as file:
        return re.search(r'guid: (\w+)', file.read())[1]


CONDUCTOR, PUBLISHED = 0, 2


def material(name, kind, published, slope, gamma_db):
    """A RadarMaterial; slope is the rms one, and gamma the diffuse echo in dB."""
    return f'''%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!114 &11400000
MonoBehaviour:
  m_ObjectHideFlags: 0
  m_CorrespondingSourceObject: {{fileID: 0}}
  m_PrefabInstance: {{fileID: 0}}
  m_PrefabAsset: {{fileID: 0}}
  m_GameObject: {{fileID: 0}}
  m_Enabled: 1
  m_EditorHideFlags: 0
  m_Script: {{fileID: 11500000, guid: {script_guid('RadarMaterial')}, type: 3}}
  m_Name: {name}
  m_EditorClassIdentifier: 
  _kind: {kind}
  _published: {published}
  _layers: []
  _halfSpace:
    _published: 
    _values:
    - Frequency: 0
      Permittivity: 1
      PermittivityLoss: 0
      Permeability: 1
      PermeabilityLoss: 0
  _slope: {slope}
  _gammaDb: {gamma_db}
'''


FOLDER = 'folderAsset: yes\nDefaultImporter:\n  externalObjects: {}\n'
MESH, MATERIAL = (f'NativeFormatImporter:\n  externalObjects: {{}}\n  mainObjectFileID: {object_id}\n' for object_id in (4300000, 11400000))


def meta(name, importer):
    guid = uuid.uuid5(uuid.NAMESPACE_URL, 'glint/harbour/' + name).hex
    return f'fileFormatVersion: 2\nguid: {guid}\n{importer}  userData: \n  assetBundleName: \n  assetBundleVariant: \n'


def files():
    """Path below Meshes, and text."""
    yield 'Harbour.meta', meta('folder', FOLDER)
    for name, kind, text in (
            ('Coast', MESH, mesh('Coast', *coast())),
            ('Breakwater', MESH, mesh('Breakwater', *breakwater())),
            ('Land', MATERIAL, material('Land', PUBLISHED, 'itu_wet_ground', 0.2, -12)),
            ('Rubble', MATERIAL, material('Rubble', PUBLISHED, 'itu_concrete', 0.3, -5)),
            ('Ship Steel', MATERIAL, material('Ship Steel', CONDUCTOR, '', 0.1, 0))):
        yield f'Harbour/{name}.asset', text
        yield f'Harbour/{name}.asset.meta', meta(name, kind)


def is_stored(path, data):
    if not os.path.exists(path):
        return False
    with open(path, 'rb') as file:
        return file.read() == data


def main():
    wrong = 0
    for name, text in files():
        path, data = os.path.join(MESHES, name), text.encode()
        if sys.argv[1:] == ['--check']:
            if not is_stored(path, data):
                print(f'Meshes/{name} is not what tools/harbour/make.py writes: run it')
                wrong = 1
        else:
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, 'wb') as file:
                file.write(data)
    return wrong


if __name__ == '__main__':
    sys.exit(main())
