"""A view at work and a real browser (Debian's chromium, headless) that looks at it: what the tests of the view share.

Exit code 77, with a sentence, where there is no browser to do it with.
"""

import contextlib
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
MOST_WAIT_S = 60  # only so that a broken view fails instead of hanging
FLAGS = (
    "--headless=new --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    "--disable-component-update --disable-sync --hide-scrollbars --window-size=1280,720"
).split()

# A box of balls over a floor that shakes; small enough to run on a busy machine.
SCENE = """
title = "A shaken box"
claim = "none"
duration_s = 60
time_step_s = 2e-5
[domain]
lo_m = [-0.03, -0.01, -0.03]
hi_m = [0.03, 0.12, 0.03]
[material.glass]
density_kg_m3 = 2500
youngs_modulus_Pa = 5e6
poisson_ratio = 0.25
[pair.glass-glass]
restitution = 0.6
friction = 0.4
[body.ball]
radius_mm = 4
material = "glass"
[[fill]]
body = "ball"
count = 40
region_lo_m = [-0.03, 0.005, -0.03]
region_hi_m = [0.03, 0.08, 0.03]
[[wall]]
name = "box"
shape = "box"
lo_m = [-0.03, 0, -0.03]
hi_m = [0.03, 0.12, 0.03]
open = ["+y"]
material = "glass"
[[wall.motion]]
kind = "harmonic"
axis = "y"
amplitude_m = 0.0005
frequency_Hz = 50
[observe]
every_s = 0.005
[render]
every_s = 0.01
"""


def skip(reason):
    print(f"skipped: {reason}")
    sys.exit(SKIPPED)


try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    skip("python3-selenium is not installed")


class View:
    """`tumble view WHAT` at work, and the link it printed."""

    def __init__(self, program, what, folder):
        self.process = subprocess.Popen(
            [program, "view", str(what), "--no-open", "--quiet", "--out", str(folder / "kept")],
            stdout=subprocess.PIPE,
            text=True,
            cwd=folder,
        )
        self.killed = False
        self.link = self.next_link()

    def next_link(self):
        """The first, and once it has been used the one for another browser."""
        link = self.process.stdout.readline().strip()
        assert link.startswith("http://127.0.0.1:"), link
        return link

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        code = self.process.wait(timeout=MOST_WAIT_S)
        self.process.stdout.close()
        assert code == (-signal.SIGKILL if self.killed else 0), f"the view ended with {code}"

    def kill(self):
        self.killed = True
        self.process.kill()


class Page:
    """What is seen, and hands."""

    def __init__(self, driver):
        self.driver = driver

    def open(self, link):
        self.driver.get(link)
        self.wait("a first frame of this window's size", lambda: self.state().get("shown") and self.size() == self.window())

    def state(self):
        return self.driver.execute_script("return window.tumble") or {}

    def wait(self, what, holds):
        begun = time.monotonic()
        while not holds():
            assert time.monotonic() - begun < MOST_WAIT_S, f"waited in vain for {what}: {self.state()}"
            time.sleep(0.02)

    def wait_for_rest(self):
        """What moved is drawn once more with smooth edges; then no frame comes any more."""
        self.wait("smooth edges", lambda: not self.state()["sketched"])

    def middle(self, name):
        places = self.state()["places"]
        assert name in places, f"no '{name}' among {sorted(places)}"
        left, top, right, bottom = places[name]
        return self.on_page((left + right) / 2, (top + bottom) / 2)

    def size(self):
        """Of the picture, in its pixels."""
        return tuple(self.driver.execute_script("const c = document.getElementById('picture'); return [c.width, c.height]"))

    def window(self):
        return tuple(self.driver.execute_script("return [innerWidth, innerHeight]"))

    def on_page(self, x, y):
        """A place of the picture, which stands in the middle of the window as large as fits and keeps its shape."""
        (width, height), (wide, high) = self.size(), self.window()
        scale = min(wide / width, high / height)
        return (wide - width * scale) / 2 + x * scale, (high - height * scale) / 2 + y * scale

    def drag(self, start, *stops):
        hands = ActionChains(self.driver, duration=50)
        pointer = hands.w3c_actions.pointer_action
        pointer.move_to_location(*(int(v) for v in start))
        pointer.pointer_down()
        for stop in stops:
            pointer.move_to_location(*(int(v) for v in stop))
        pointer.pointer_up()
        hands.perform()

    def click(self, name):
        self.drag(self.middle(name))

    def press(self, key):
        ActionChains(self.driver).send_keys(key).perform()


def picture_of(page):
    return page.driver.execute_script("return document.getElementById('picture').toDataURL()")


def browser(folder, *more):
    options = Options()
    options.binary_location = shutil.which("chromium")
    for flag in [*FLAGS, *more, f"--user-data-dir={folder / 'browser'}"]:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


@contextlib.contextmanager
def a_browser():
    """A driver and the folder that it and the views work in, which holds the scene as shaken.toml."""
    for needed in ("chromium", "chromedriver"):
        if not shutil.which(needed):
            skip(f"{needed} is not installed")
    try:
        socket.getaddrinfo("localhost", 80)
    except OSError:
        skip("this machine does not know the name localhost, by which chromedriver finds its browser: it belongs into /etc/hosts")
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        (folder / "shaken.toml").write_text(SCENE)
        driver = browser(folder)
        try:
            yield driver, folder
        finally:
            driver.quit()


def go_through(parts, *what):
    for part in parts:
        part(*what)
        print(f"{part.__name__}: fine", flush=True)


def check_log(driver):
    """The page has met no error."""
    wrong = [line for line in driver.get_log("browser") if line["level"] == "SEVERE"]
    assert not wrong, wrong


def program_of(arguments):
    return pathlib.Path(arguments[1]).resolve()
