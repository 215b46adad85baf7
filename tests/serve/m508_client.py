#!/usr/bin/env python3
"""A driver for the frame buffer in another language, written from docs/protocol.md alone.

    m508_client.py unix:PATH | tcp:HOST:PORT

Draws a picture with every way of writing pixels, computes for itself what the screen must show, and checks
image, checksum, overlay and screen against that. Exit code 0: all as expected.
"""

import socket
import struct
import sys
import zlib

SIZE = 512
IDENTIFY, RESET, STATUS, MARK, WINDOW, PIXELS, FILL, RUNS = 0x01, 0x02, 0x03, 0x05, 0x10, 0x11, 0x13, 0x14
READ, CHECKSUM, READ_SCREEN, READ_LUT, READ_OVERLAY = 0x20, 0x21, 0x22, 0x23, 0x24
LUT, OVERLAY, OVERLAY_BITS, OVERLAY_FILL = 0x30, 0x40, 0x41, 0x42
REPLY = 0x80


def connect(address):
    scheme, _, place = address.partition(":")
    if scheme == "unix":
        connection = socket.socket(socket.AF_UNIX)
        connection.settimeout(10)
        connection.connect(place)
        return connection
    host, _, port = place.rpartition(":")
    connection = socket.create_connection((host.strip("[]"), int(port)), timeout=10)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


class Device:
    def __init__(self, connection):
        self.connection = connection
        self.stream = connection.makefile("rb")
        self.sequence = 0

    def tell(self, opcode, payload=b""):
        self.sequence += 1
        head = struct.pack(">2sBIH", b"M5", opcode, self.sequence, len(payload)) + payload
        self.connection.sendall(head + struct.pack(">I", zlib.crc32(head)))

    def reply(self, opcode):
        head = self.stream.read(9)
        sync, found, sequence, length = struct.unpack(">2sBIH", head)
        payload = self.stream.read(length)
        (checksum,) = struct.unpack(">I", self.stream.read(4))
        expect("sync word", sync, b"M5")
        expect("checksum of a reply", checksum, zlib.crc32(head + payload))
        expect("opcode of a reply", found, opcode | REPLY)
        expect("sequence number of a reply", sequence, self.sequence)
        return payload

    def ask(self, opcode, payload=b""):
        self.tell(opcode, payload)
        return self.reply(opcode)

    def read_rows(self, opcode, x, y, width, height):
        self.tell(opcode, struct.pack(">4H", x, y, width, height))
        rows = []
        for row in range(height):
            payload = self.reply(READ)  # both kinds of reading are answered by "row"
            expect("place of a row", struct.unpack(">2H", payload[:4]), (x, y + row))
            rows.append(payload[4:])
        return b"".join(rows)


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"m508_client.py: {what}: expected {wanted!r:.100}, found {found!r:.100}")


def put(image, x, y, color):
    at = (y * SIZE + x) * 3
    image[at : at + 3] = bytes(color)


def main(address):
    device = Device(connect(address))

    identity = device.ask(IDENTIFY)
    profile, version, width, height = struct.unpack(">BBHH", identity[:6])
    expect("profile, version and size", (profile, version, width, height), (0, 1, SIZE, SIZE))
    print("device:", identity[6:].decode("ascii"))

    device.tell(RESET)
    device.tell(MARK, b"foreign client")
    image = bytearray(SIZE * SIZE * 3)

    # A gradient, row by row.
    device.tell(WINDOW, struct.pack(">4H", 56, 68, 400, 300))
    for y in range(300):
        row = [(x * 255 // 399, y * 255 // 299, 128) for x in range(400)]
        device.tell(PIXELS, b"".join(map(bytes, row)))
        for x, color in enumerate(row):
            put(image, 56 + x, 68 + y, color)

    # A filled rectangle.
    device.tell(FILL, struct.pack(">4H3B", 100, 400, 50, 20, 255, 200, 0))
    for y in range(400, 420):
        for x in range(100, 150):
            put(image, x, y, (255, 200, 0))

    # Runs that go on from one row of their window to the next: 3 rows of 100 pixels.
    device.tell(WINDOW, struct.pack(">4H", 300, 450, 100, 3))
    runs = [(150, (0, 255, 0)), (1, (255, 255, 255)), (149, (0, 0, 255))]
    device.tell(RUNS, b"".join(bytes((length - 1, *color)) for length, color in runs))
    colors = [color for length, color in runs for _ in range(length)]
    for place, color in enumerate(colors):
        put(image, 300 + place % 100, 450 + place // 100, color)

    expect("image", device.read_rows(READ, 0, 0, SIZE, SIZE), bytes(image))
    part = b"".join(image[(y * SIZE + 90) * 3 : (y * SIZE + 190) * 3] for y in range(390, 430))
    expect("part of the image", device.read_rows(READ, 90, 390, 100, 40), part)
    (checksum,) = struct.unpack(">I", device.ask(CHECKSUM, struct.pack(">4H", 0, 0, SIZE, SIZE)))
    expect("checksum of the image", checksum, zlib.crc32(image))

    # Red is shown inverted; the overlay lies above it in yellow: a block, and 12 pixels of a row.
    inverse = bytes(range(255, -1, -1))
    device.tell(LUT, b"\x01\x00" + inverse)
    expect("red table", device.ask(READ_LUT, b"\x00"), b"\x00" + inverse)
    device.tell(OVERLAY_FILL, struct.pack(">4HB", 32, 100, 16, 16, 1))
    device.tell(OVERLAY_BITS, struct.pack(">BH", 10, 108) + b"\xff\xf0")
    device.tell(OVERLAY, bytes((1, 0, 255, 255, 0)))
    overlay = [(x, y) for y in range(100, 116) for x in range(32, 48)] + [(x, 108) for x in range(80, 92)]
    bits = bytearray(64)
    bits[4:6] = bits[10:12] = b"\xff\xff"
    bits[11] = 0xF0
    expect("overlay", device.ask(READ_OVERLAY, struct.pack(">2H", 108, 1)), struct.pack(">H", 108) + bits)

    screen = bytearray(image)
    screen[0::3] = bytes(image[0::3]).translate(inverse)
    for x, y in overlay:
        put(screen, x, y, (255, 255, 0))
    expect("screen", device.read_rows(READ_SCREEN, 0, 0, SIZE, SIZE), bytes(screen))

    error, _, errors, commands, skipped, _ = struct.unpack(">B5I", device.ask(STATUS))
    expect("error, errors, skipped", (error, errors, skipped), (0, 0, 0))
    expect("commands since the reset", commands, 1 + 1 + 300 + 1 + 2 + 1 + 3)
    print("screen:", f"{zlib.crc32(screen):08X}")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
