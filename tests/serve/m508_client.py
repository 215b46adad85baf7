#!/usr/bin/env python3
"""A driver for the frame buffer in another language, written from docs/protocol.md alone.

    m508_client.py unix:PATH | tcp:HOST:PORT [CHECKS.toml]

Sends every command there is, keeps a model of what each must do, and checks replies, images, overlay, tables and
screen against it. With CHECKS.toml, writes what the model came to, for m508 assert (docs/assert.md). Exit code 0:
all as expected.
"""

import socket
import struct
import sys
import zlib

SIZE = 512
WHOLE = (0, 0, SIZE, SIZE)
OPCODES = {
    "identify": 0x01, "reset": 0x02, "status": 0x03, "wait": 0x04, "mark": 0x05,
    "window": 0x10, "pixels": 0x11, "clear": 0x12, "fill": 0x13, "runs": 0x14, "repeat": 0x15, "copy": 0x16,
    "write_mask": 0x17, "buffers": 0x18,
    "read": 0x20, "checksum": 0x21, "read_screen": 0x22, "read_lut": 0x23, "read_overlay": 0x24,
    "lut": 0x30, "ramp": 0x31, "read_mask": 0x32, "pan": 0x33, "zoom": 0x34, "blank": 0x35, "border": 0x36,
    "overlay": 0x40, "overlay_bits": 0x41, "overlay_fill": 0x42, "cursor": 0x43, "cursor_pattern": 0x44,
}  # fmt: skip
QUERIES = {"identify", "status", "read", "checksum", "read_screen", "read_lut", "read_overlay"}
ROW, BITS = 0xA0, 0xA4


def expect(what, found, wanted):
    if found != wanted:
        sys.exit(f"m508_client.py: {what}: expected {wanted!r:.100}, found {found!r:.100}")


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
    """The wire: frames there and back, and a count of them."""

    def __init__(self, connection):
        self.connection = connection
        self.stream = connection.makefile("rb")
        self.sequence = 0
        self.sent = dict.fromkeys(OPCODES, 0)

    def frame(self, opcode, payload):
        self.sequence += 1
        head = struct.pack(">2sBIH", b"M5", opcode, self.sequence, len(payload)) + payload
        self.connection.sendall(head + struct.pack(">I", zlib.crc32(head)))

    def tell(self, name, form=">", *operands):
        self.frame(OPCODES[name], struct.pack(form, *operands))
        self.sent[name] += 1

    def reply(self, opcode):
        head = self.stream.read(9)
        sync, found, sequence, length = struct.unpack(">2sBIH", head)
        payload = self.stream.read(length)
        (checksum,) = struct.unpack(">I", self.stream.read(4))
        expect("sync word", sync, b"M5")
        expect("checksum of a reply", checksum, zlib.crc32(head + payload))
        expect("opcode of a reply", found, opcode)
        expect("sequence number of a reply", sequence, self.sequence)
        return payload

    def ask(self, name, form=">", *operands):
        self.tell(name, form, *operands)
        return self.reply(OPCODES[name] | 0x80)

    def status(self):
        names = ("error", "error_sequence", "errors", "commands", "skipped", "fields")
        return dict(zip(names, struct.unpack(">B5I", self.ask("status"))))

    def rows(self, name, x, y, width, height):
        self.tell(name, ">4H", x, y, width, height)
        rows = []
        for row in range(height):
            payload = self.reply(ROW)  # read and read_screen are both answered by "row"
            expect("place of a row", struct.unpack(">2H", payload[:4]), (x, y + row))
            rows.append(payload[4:])
        return b"".join(rows)


class Model:
    """What the device must hold after the same commands, one pixel at a time."""

    def __init__(self):
        self.images = [bytearray(SIZE * SIZE * 3), bytearray(SIZE * SIZE * 3)]
        self.written = self.shown = 0
        self.window, self.position = WHOLE, (0, 0)
        self.write_mask = self.read_mask = (255, 255, 255)
        self.tables = [bytearray(range(256)) for _ in range(3)]
        self.pan, self.zoom = (0, 0), 0
        self.border = (0, 0, 0, 0)
        self.overlay, self.overlay_color = bytearray(SIZE * SIZE), None
        self.cursor, self.cursor_color, self.pattern = (0, 0), None, bytes(32)

    def get(self, buffer, x, y):
        at = (y * SIZE + x) * 3
        return tuple(self.images[buffer][at : at + 3])

    def put(self, x, y, color):
        old = self.get(self.written, x, y)
        at = (y * SIZE + x) * 3
        self.images[self.written][at : at + 3] = bytes(
            o & ~mask | new & mask for o, new, mask in zip(old, color, self.write_mask)
        )

    def set_window(self, *window):
        self.window, self.position = window, window[:2]

    def stream(self, colors):
        x, y, width, height = self.window
        place = (self.position[1] - y) * width + self.position[0] - x
        for color in colors:
            self.put(x + place % width, y + place // width, color)
            place = (place + 1) % (width * height)
        self.position = (x + place % width, y + place // width)

    def fill(self, x, y, width, height, *color):
        for row in range(y, y + height):
            for column in range(x, x + width):
                self.put(column, row, color)

    def copy(self, x, y, width, height, to_x, to_y, source):
        block = [self.get(source, x + i % width, y + i // width) for i in range(width * height)]
        for i, color in enumerate(block):
            self.put(to_x + i % width, to_y + i // width, color)

    def part(self, buffer, x, y, width, height):
        image = self.images[buffer]
        return b"".join(image[(row * SIZE + x) * 3 : (row * SIZE + x + width) * 3] for row in range(y, y + height))

    def seen(self, x, y):
        thickness, *border = self.border
        if min(x, y, SIZE - 1 - x, SIZE - 1 - y) < thickness:
            return bytes(border)
        column, row = x - self.cursor[0], y - self.cursor[1]
        if self.cursor_color and 0 <= column < 16 and 0 <= row < 16:
            if int.from_bytes(self.pattern[2 * row : 2 * row + 2], "big") >> (15 - column) & 1:
                return bytes(self.cursor_color)
        if self.overlay_color and self.overlay[y * SIZE + x]:
            return bytes(self.overlay_color)
        pixel = self.get(self.shown, (self.pan[0] + (x >> self.zoom)) % SIZE, (self.pan[1] + (y >> self.zoom)) % SIZE)
        return bytes(table[value & mask] for table, value, mask in zip(self.tables, pixel, self.read_mask))

    def screen(self, x, y, width, height):
        return b"".join(self.seen(column, row) for row in range(y, y + height) for column in range(x, x + width))


def make_errors(device):
    """Each kind of error once: it is told, and nothing else happens."""
    device.tell("mark", "6s", b"errors")
    device.tell("fill", ">4H3B", 500, 0, 13, 1, 255, 255, 255)
    beyond = device.sequence
    device.sent["fill"] -= 1  # m508 assert counts what was executed
    device.frame(0x7F, b"")
    device.frame(OPCODES["zoom"], b"\1\1")
    device.connection.sendall(b"M5 no frame")  # a length beyond the limit
    state = device.status()
    del state["fields"]
    expect("errors", state, dict(error=4, error_sequence=beyond, errors=4, commands=1, skipped=11))
    expect("image after errors", device.ask("checksum", ">4H", *WHOLE), struct.pack(">I", zlib.crc32(bytes(3 << 18))))


def paint(device, model):
    """Every way of writing pixels."""
    device.tell("reset")
    device.tell("mark", "8s", b"painting")
    window = (56, 68, 400, 300)
    device.tell("window", ">4H", *window)
    model.set_window(*window)
    for y in range(300):
        row = [(x * 255 // 399, y * 255 // 299, 128) for x in range(400)]
        device.tell("pixels", ">1200s", b"".join(map(bytes, row)))
        model.stream(row)

    block = (100, 400, 50, 20, 255, 200, 0)
    device.tell("fill", ">4H3B", *block)
    model.fill(*block)

    # Runs that go on from one row of their window to the next, and the rest of it in one colour.
    window = (300, 450, 100, 4)
    device.tell("window", ">4H", *window)
    model.set_window(*window)
    runs = [(150, (0, 255, 0)), (1, (255, 255, 255)), (149, (0, 0, 255))]
    device.tell("runs", ">12s", b"".join(bytes((length - 1, *color)) for length, color in runs))
    model.stream(color for length, color in runs for _ in range(length))
    device.tell("repeat", ">I3B", 90, 9, 8, 7)
    model.stream([(9, 8, 7)] * 90)

    # Through a mask: the upper bits of red, all of green, nothing of blue.
    device.tell("mark", "4s", b"mask")
    device.tell("write_mask", ">3B", 0xF0, 0xFF, 0)
    model.write_mask = (0xF0, 0xFF, 0)
    block = (200, 200, 40, 30, 0x5A, 0x12, 0xFF)
    device.tell("fill", ">4H3B", *block)
    model.fill(*block)
    device.tell("write_mask", ">3B", 255, 255, 255)
    model.write_mask = (255, 255, 255)

    # From one image into the other, and onto itself.
    device.tell("mark", "4s", b"copy")
    device.tell("buffers", ">2B", 1, 0)
    model.written = 1
    device.tell("fill", ">4H3B", 0, 0, 9, 9, 1, 2, 3)
    device.tell("clear")
    for rectangle in ((180, 190, 120, 60, 20, 30, 0), (20, 30, 120, 60, 27, 35, 1)):
        device.tell("copy", ">6HB", *rectangle)
        model.copy(*rectangle)

    for buffer in (1, 0):
        if buffer != model.written:
            device.tell("buffers", ">2B", buffer, 0)
            model.written = buffer
        image = bytes(model.images[buffer])
        expect(f"image {buffer}", device.rows("read", *WHOLE), image)
        expect("a part of it", device.rows("read", 90, 40, 100, 40), model.part(buffer, 90, 40, 100, 40))
        expect("its checksum", device.ask("checksum", ">4H", *WHOLE), struct.pack(">I", zlib.crc32(image)))


def show(device, model):
    """Everything between the memory and the screen."""
    device.tell("mark", "7s", b"showing")
    inverse = bytes(range(255, -1, -1))
    device.tell("lut", ">2B256s", 1, 0, inverse)
    model.tables[0][:] = inverse
    device.tell("ramp", ">2BH2B", 4, 10, 101, 200, 0)
    model.tables[2][10:111] = (200 - 2 * i for i in range(101))
    for channel in range(3):
        expect("table", device.ask("read_lut", ">B", channel), bytes([channel]) + model.tables[channel])
    device.tell("read_mask", ">3B", 255, 0xFE, 255)
    model.read_mask = (255, 0xFE, 255)

    device.tell("overlay_fill", ">4HB", 32, 100, 16, 16, 1)
    device.tell("overlay_bits", ">BH2s", 10, 108, b"\xff\xf0")
    device.tell("overlay", ">5B", 1, 0, 255, 255, 0)
    model.overlay_color = (255, 255, 0)
    for x, y in [(x, y) for y in range(100, 116) for x in range(32, 48)] + [(x, 108) for x in range(80, 92)]:
        model.overlay[y * SIZE + x] = 1
    expect("row of the overlay", device.ask("read_overlay", ">2H", 108, 1), struct.pack(">H64s", 108, bits(model, 108)))

    model.pattern = bytes.fromhex("8001" "4002" "2004" "1008" "0810" "0420" "0240" "0180") * 2
    device.tell("cursor_pattern", ">32s", model.pattern)
    device.tell("cursor", ">2H5B", 40, 104, 1, 0, 250, 251, 252)
    model.cursor, model.cursor_color = (40, 104), (250, 251, 252)
    expect("screen", device.rows("read_screen", *WHOLE), model.screen(*WHOLE))

    device.tell("buffers", ">2B", 0, 1)
    model.shown = 1
    device.tell("pan", ">2H", 500, 8)
    device.tell("zoom", ">B", 2)
    model.pan, model.zoom = (500, 8), 2
    device.tell("border", ">4B", 6, 64, 65, 66)
    model.border = (6, 64, 65, 66)
    device.tell("blank", ">B", 1)
    expect("blank screen", device.rows("read_screen", 0, 0, 60, 3), bytes(540))
    device.tell("blank", ">B", 0)
    expect("screen, zoomed", device.rows("read_screen", *WHOLE), model.screen(*WHOLE))

    # The cursor blinks by the field: shown in the even ones.
    device.tell("cursor", ">2H5B", 40, 104, 1, 1, 250, 251, 252)
    for _ in range(2):
        device.tell("wait", ">H", 1)
        model.cursor_color = None if device.status()["fields"] % 2 else (250, 251, 252)
        expect("blinking", device.rows("read_screen", 40, 104, 16, 2), model.screen(40, 104, 16, 2))
    device.tell("cursor", ">2H5B", 40, 104, 1, 0, 250, 251, 252)
    model.cursor_color = (250, 251, 252)


def bits(model, y):
    row = "".join(map(str, model.overlay[y * SIZE : (y + 1) * SIZE]))
    return int(row, 2).to_bytes(64, "big")


def checks(device, model):
    """What m508 assert should find in a recording of all that."""
    planes = {"screen": model.screen(*WHOLE), "overlay": model.overlay}
    planes.update({f"image{buffer}": model.images[buffer] for buffer in (0, 1)})
    for plane, content in planes.items():
        yield f'[[check]]\nname = "{plane}"\nplane = "{plane}"\nchecksum = 0x{zlib.crc32(content):08X}\n'
    registers = {
        "window": model.window, "position": model.position, "write_mask": model.write_mask,
        "read_mask": model.read_mask, "written": model.written, "shown": model.shown, "pan": model.pan,
        "zoom": model.zoom, "blank": 0, "border": model.border, "overlay": (1, 0, *model.overlay_color),
        "cursor": (*model.cursor, 1, 0, *model.cursor_color), "error": 0, "errors": 0,
    }  # fmt: skip
    for name, value in registers.items():
        value = list(value) if isinstance(value, tuple) else value
        yield f'[[check]]\nname = "register {name}"\nregisters = {{ {name} = {value} }}\n'
    for name, count in device.sent.items():
        yield f'[[check]]\nname = "count of {name}"\ncounts = {{ {name} = {count} }}\n'
    before = f'at = "copy"\nplane = "image1"\nrectangle = {list(WHOLE)}\ncolor = [0, 0, 0]'
    yield f'[[check]]\nname = "image1 before the copies"\n{before}\n'


def main(address, file=None):
    device = Device(connect(address))
    model = Model()

    identity = device.ask("identify")
    profile, version, width, height = struct.unpack(">BBHH", identity[:6])
    expect("profile, version and size", (profile, version, width, height), (0, 1, SIZE, SIZE))
    print("device:", identity[6:].decode("ascii"))

    make_errors(device)
    before = sum(count for name, count in device.sent.items() if name not in QUERIES)
    paint(device, model)
    show(device, model)

    state = device.status()
    expect("error, errors, skipped", (state["error"], state["errors"], state["skipped"]), (0, 0, 0))
    told = sum(count for name, count in device.sent.items() if name not in QUERIES)
    expect("commands since the reset", state["commands"], told - before - 1)  # the reset itself is not counted
    expect("opcodes that were never sent", [name for name, count in device.sent.items() if not count], [])
    if file:
        with open(file, "w", encoding="ascii") as text:
            text.write("\n".join(checks(device, model)))
    print("screen:", f"{zlib.crc32(model.screen(*WHOLE)):08X}")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(*sys.argv[1:])
