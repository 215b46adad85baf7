#!/usr/bin/env python3
"""browser.py URL PICTURE.png WIDTH HEIGHT: a page in headless Chromium, and ever newer pictures of it in a file.

Until it is ended, and Chromium with it. Chromium's own --screenshot is taken before a page has heard from its
WebSocket; this asks for pictures through the DevTools protocol, whose messages go through two pipes and end in a zero
byte."""

import base64
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time

url, picture, width, height = sys.argv[1:]
profile = tempfile.mkdtemp()
to_read, questions = os.pipe()
answers, to_write = os.pipe()


def take_pipes():
    """What Chromium expects as descriptors 3 and 4, whatever numbers they had."""
    ends = os.dup(to_read), os.dup(to_write)
    high = [os.dup2(end, 100 + i) for i, end in enumerate(ends)]
    os.dup2(high[0], 3)
    os.dup2(high[1], 4)


signal.signal(signal.SIGTERM, lambda *_: sys.exit(0))
chromium = subprocess.Popen(
    ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--remote-debugging-pipe",
     f"--user-data-dir={profile}", "about:blank"],
    stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, close_fds=False,
    preexec_fn=take_pipes)
os.close(to_read)
os.close(to_write)
received = bytearray()
count = 0


def ask(method, session=None, **parameters):
    """The result of a command; events on the way are of no interest."""
    global count
    count += 1
    message = {"id": count, "method": method, "params": parameters}
    if session:
        message["sessionId"] = session
    os.write(questions, json.dumps(message).encode() + b"\0")
    while True:
        while b"\0" not in received:
            more = os.read(answers, 1 << 16)
            if not more:
                sys.exit("browser.py: Chromium has ended")
            received.extend(more)
        text, _, rest = bytes(received).partition(b"\0")
        received[:] = rest
        answer = json.loads(text)
        if answer.get("id") == count:
            if "error" in answer:
                sys.exit(f"browser.py: {method}: {answer['error']['message']}")
            return answer["result"]


try:
    page = ask("Target.createTarget", url=url)["targetId"]
    session = ask("Target.attachToTarget", targetId=page, flatten=True)["sessionId"]
    # The page's own size, without the frame of a window.
    ask("Emulation.setDeviceMetricsOverride", session, width=int(width), height=int(height), deviceScaleFactor=1,
        mobile=False)
    while True:
        data = base64.b64decode(ask("Page.captureScreenshot", session)["data"])
        with open(picture + ".new", "wb") as file:
            file.write(data)
        os.replace(picture + ".new", picture)
        time.sleep(0.2)
finally:
    chromium.terminate()
    try:
        chromium.wait(timeout=5)
    except subprocess.TimeoutExpired:
        chromium.kill()
    shutil.rmtree(profile, ignore_errors=True)
