#!/usr/bin/env python3
"""gallery.py BEFORE AFTER CROPS -- measures the difference of the pictures in two folders of `make gallery`.

For each picture the script prints the mean difference of a colour value (0 to 255), the share of the pixels that
differ by more than 24 in one colour, and the largest mean difference of a tile of 16x16 pixels. CROPS gets a file for
each picture: the part of 480x270 pixels that differs most, at 100 %, before on the left and after on the right."""
import pathlib
import struct
import sys
import zlib

TILE, PART_X, PART_Y, VISIBLE = 16, 480, 270, 24


def read_png(path):
    """Returns the width, the height and the rows of an RGB picture as bytes."""
    data, at, packed = path.read_bytes(), 8, b''
    while at < len(data):
        size, kind = struct.unpack('>I4s', data[at:at + 8])
        if kind == b'IHDR':
            width, height, depth, colours = struct.unpack('>IIBB', data[at + 8:at + 18])
        elif kind == b'IDAT':
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    if (depth, colours) != (8, 2):
        sys.exit(f'gallery: {path}: not an RGB picture of 8 bits')
    raw, stride, rows = zlib.decompress(packed), width * 3, []
    above = bytes(stride)
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        unfilter(kind, row, above)
        rows.append(bytes(row))
        above = row
    return width, height, rows


def unfilter(kind, row, above):
    """Applies the inverse of a PNG row filter to `row` (section 9 of the PNG specification)."""
    if kind == 2:
        row[:] = bytes((a + b) & 255 for a, b in zip(row, above))
        return
    for i in range(len(row) if kind else 0):
        left, up, corner = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
        if kind == 1:
            add = left
        elif kind == 3:
            add = (left + up) // 2
        else:
            base = left + up - corner
            add = min((abs(base - left), 0, left), (abs(base - up), 1, up), (abs(base - corner), 2, corner))[2]
        row[i] = (row[i] + add) & 255


def write_png(path, width, rows):
    def chunk(kind, data):
        return struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
    packed = zlib.compress(b''.join(b'\0' + row for row in rows))
    path.write_bytes(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, len(rows), 8, 2, 0, 0, 0)) +
                     chunk(b'IDAT', packed) + chunk(b'IEND', b''))


def compare(name, before, after, crops):
    width, height, old = before
    if (width, height) != after[:2]:
        sys.exit(f'gallery: {name}: the pictures have different sizes')
    total, visible = 0, 0
    tiles = [[0] * (width // TILE + 1) for _ in range(height // TILE + 1)]
    for y, (a, b) in enumerate(zip(old, after[2])):
        if a == b:
            continue
        difference = [abs(p - q) for p, q in zip(a, b)]
        total += sum(difference)
        visible += sum(max(difference[x:x + 3]) > VISIBLE for x in range(0, width * 3, 3))
        for tile in range(width // TILE):
            tiles[y // TILE][tile] += sum(difference[tile * TILE * 3:(tile + 1) * TILE * 3])
    across, down = PART_X // TILE, PART_Y // TILE
    _, top, left = max((sum(sum(row[x:x + across]) for row in tiles[y:y + down]), y, x)
                       for y in range(0, max(1, height // TILE - down), 2) for x in range(0, max(1, width // TILE - across), 2))
    cut = [[row[left * TILE * 3:(left * TILE + PART_X) * 3] for row in rows[top * TILE:top * TILE + PART_Y]]
           for rows in (old, after[2])]
    write_png(crops / f'{name}.png', len(cut[0][0] + cut[1][0]) // 3, [a + b for a, b in zip(*cut)])
    print(f'{name:15} mean {total / (width * height * 3):6.3f}   visible {100 * visible / (width * height):6.2f} %   '
          f'worst tile {max(map(max, tiles)) / (TILE * TILE * 3):6.1f}')


def main():
    before, after, crops = map(pathlib.Path, sys.argv[1:4])
    crops.mkdir(parents=True, exist_ok=True)
    for path in sorted(after.glob('*.png')):
        if (before / path.name).exists():
            compare(path.stem, read_png(before / path.name), read_png(path), crops)


if __name__ == '__main__':
    main()
