#!/usr/bin/python3
"""The view as a person meets it: a real browser (Debian's chromium, headless) opens the link that `tumble view` prints.

    tests/view/browser.py PROGRAM [--keep PICTURE.png]

Exit code 77, with a sentence, where there is no browser to do it with.
"""

import http.client
import http.server
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
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


def opens_and_runs(page):
    state = page.state()
    assert state["title"] == "A shaken box" and state["step"] == 0, state
    assert page.driver.current_url.endswith("/"), "the token still stands in the address"
    assert "A shaken box" in page.driver.title
    before = picture_of(page)
    page.click("play")
    page.wait("the simulation to run", lambda: page.state()["step"] > 0 and page.state()["playing"])
    page.wait("another frame", lambda: picture_of(page) != before)
    page.press(Keys.SPACE)
    page.wait("a pause", lambda: not page.state()["playing"])


def drags_the_camera(page):
    page.wait_for_rest()
    before, eye = picture_of(page), page.state()["camera"]["eye"]
    page.drag((800, 300), (860, 280), (900, 260))
    page.wait("the camera to move", lambda: page.state()["camera"]["eye"] != eye)
    page.wait("another picture", lambda: picture_of(page) != before)


def moves_a_slider(page):
    """Gravity that is tilted by up to 60 degrees pulls the balls along x, steeper than friction (22 degrees) can hold
    them: at 8.5 m/s2 less 2 of friction 100 steps of 20 us give those that are free to go 13 mm/s."""
    page.click("tab Change")
    page.wait("the sliders", lambda: "tilt towards x" in page.state()["places"])
    x, y = page.middle("tilt towards x")
    page.drag((x, y), (x + 138, y))
    page.wait("the slider to move", lambda: page.state()["values"]["tilt towards x"] > 50)
    before = page.state()
    page.click("steps")
    page.wait("100 steps", lambda: page.state()["step"] == before["step"] + 100)
    gained = page.state()["mean_velocity"][0] - before["mean_velocity"][0]
    assert gained > 2e-3, gained
    page.click("save scene")
    page.wait("a scene, named beside the button", lambda: page.state()["saved"].endswith(".toml") and "saved" in page.state()["places"])


def draws_over_the_bodies(page):
    page.click("tab Look")
    page.wait("the tab", lambda: "arrows" in page.state()["places"])
    for box, choice in (("arrows", "arrows bodies"), ("trail", "trail ball"), (None, "force chains")):
        page.wait_for_rest()
        before = picture_of(page)
        if box:
            page.click(box)
            page.wait("the choice", lambda: choice in page.state()["places"])
        page.click(choice)
        if box:  # until the list has closed the places are those of before
            page.wait("the list to close", lambda: choice not in page.state()["places"])
        page.wait("another picture", lambda: picture_of(page) != before)


def films(page):
    page.click("tab Keep")
    page.wait("the tab", lambda: "film" in page.state()["places"])
    page.click("film")
    page.click("steps")
    page.click("film")
    page.wait("a film", lambda: page.state()["filmed"].endswith("pictures"))


def resizes(page):
    page.driver.set_window_size(700, 500)
    page.wait("a smaller picture", lambda: page.driver.execute_script("return document.getElementById('picture').width") < 800)
    page.driver.set_window_size(1280, 720)
    page.wait("a larger picture", lambda: page.driver.execute_script("return document.getElementById('picture').width") == 1280)


def outlives_no_size(page):
    """A window that is folded away says that it is 0 x 0: the picture keeps its size, and hands go on to be heard."""
    size, step = page.size(), page.state()["step"]
    page.driver.execute_script(
        """window.sides = ['innerWidth', 'innerHeight'].map((side) => [side, Object.getOwnPropertyDescriptor(window, side)]);
        for (const [side] of sides) Object.defineProperty(window, side, { configurable: true, get: () => 0 });
        window.dispatchEvent(new Event('resize'));""")
    page.press(".")
    page.wait("one step", lambda: page.state()["step"] == step + 1)
    assert page.size() == size, page.size()
    page.driver.execute_script("for (const [side, kept] of sides) Object.defineProperty(window, side, kept); window.dispatchEvent(new Event('resize'));")
    page.press(".")
    page.wait("one more step, in the window's size", lambda: page.state()["step"] == step + 2 and page.size() == page.window())


def obeys_keys(page):
    """Each key of docs/view.md that moves the camera does so, R takes it all back, H hides the panel and shows it."""
    page.wait_for_rest()
    moved = page.state()["camera"]
    page.press("r")
    page.wait("the scene's own camera", lambda: page.state()["camera"] != moved)
    page.wait_for_rest()
    first = page.state()["camera"]
    for key in (Keys.ARROW_LEFT, Keys.ARROW_RIGHT, Keys.ARROW_UP, Keys.ARROW_DOWN, "+", "-"):
        before = page.state()["camera"]
        page.press(key)
        page.wait(f"the camera to follow {key!r}", lambda: page.state()["camera"] != before)
    before = page.state()["camera"]["target"]
    ActionChains(page.driver).key_down(Keys.SHIFT).send_keys(Keys.ARROW_LEFT).key_up(Keys.SHIFT).perform()
    page.wait("the target to move", lambda: page.state()["camera"]["target"] != before)
    page.press("r")
    page.wait("the scene's own camera", lambda: page.state()["camera"] == first)
    for shown in (False, True):
        page.press("h")
        page.wait("the panel", lambda: page.state()["panel"] == shown)
    step = page.state()["step"]
    page.press(".")
    page.wait("one step", lambda: page.state()["step"] == step + 1)


class Fingers:
    """Touches as a screen reports them; places in pixels of the page."""

    def __init__(self, driver):
        self.driver = driver

    def tell(self, kind, *places):
        points = [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)]
        self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def go(self, *ways):
        """A way for each finger, all equally long."""
        steps = list(zip(*ways))
        self.tell("touchStart", *steps[0])
        for places in steps[1:]:
            self.tell("touchMove", *places)
        self.tell("touchEnd")


def fits_a_phone(page):
    """Held upright, two pixels a pixel: the scene alone; a finger turns it, two zoom; the button brings the panel."""
    driver = page.driver
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True})
    driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
    width = "return document.getElementById('picture').width"
    page.wait("the phone's pixels", lambda: driver.execute_script(width) == 780)
    if page.state()["panel"]:  # a hand had asked for it before
        driver.find_element(By.ID, "panel").click()
        page.wait("the scene", lambda: not page.state()["panel"])
    fingers = Fingers(driver)
    eye = page.state()["camera"]["eye"]
    fingers.go([(100, 400), (140, 400), (180, 410), (220, 420)])
    page.wait("the camera to turn", lambda: page.state()["camera"]["eye"] != eye)
    distance = lambda: sum((a - b) ** 2 for a, b in zip(page.state()["camera"]["eye"], page.state()["camera"]["target"]))
    before = distance()
    fingers.go([(180, 380), (150, 340), (120, 300)], [(210, 420), (240, 460), (270, 500)])
    page.wait("a nearer view", lambda: distance() < 0.5 * before)
    driver.find_element(By.ID, "panel").click()
    page.wait("the panel", lambda: page.state()["panel"])
    step = page.state()["step"]
    fingers.go([page.middle("step")])
    page.wait("one step", lambda: page.state()["step"] == step + 1)
    driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    page.wait("the window as before", lambda: driver.execute_script(width) != 780)


def shares(page, view, folder):
    """A second browser takes the next link; what one of them does both see, and one that goes leaves the other."""
    other = browser(folder / "second")
    try:
        second = Page(other)
        second.open(view.next_link())
        eye = page.state()["camera"]["eye"]
        second.drag((800, 300), (850, 310), (900, 320))
        page.wait("what the other browser did", lambda: page.state()["camera"]["eye"] != eye)
        page.wait("both to see the same", lambda: page.state()["camera"] == second.state()["camera"])
    finally:
        other.quit()
    eye = page.state()["camera"]["eye"]
    page.drag((800, 300), (830, 310))
    page.wait("the camera to go on moving", lambda: page.state()["camera"]["eye"] != eye)


def shares_between_sizes(page, view, folder):
    """Two windows of other shapes see one picture whole and unstretched; hands meet in both what they aim at, and the
    window that is used gets its own size again. Sent as events at places: a real pointer would ask for the size first."""
    other = browser(folder / "third", "--window-size=700,650")
    try:
        second = Page(other)
        second.open(view.next_link())
        second.wait("the second window's size", lambda: second.size() == second.window())
        assert second.size() != page.window()
        page.wait("the same picture here", lambda: page.size() == second.size())
        for each in (page, second):
            each.wait("one picture", lambda: page.size() == second.size())
            each.wait("the panel", lambda: "step" in each.state()["places"])
            step = each.state()["step"]
            x, y = each.middle("step")
            each.driver.execute_script(
                """const canvas = document.getElementById('picture');
                canvas.setPointerCapture = () => {}; // there is no such pointer
                for (const kind of ['pointerdown', 'pointerup'])
                  canvas.dispatchEvent(new PointerEvent(kind, { clientX: arguments[0], clientY: arguments[1], button: 0, pointerType: 'mouse' }));
                delete canvas.setPointerCapture;""",
                x, y)
            each.wait("one step", lambda: each.state()["step"] == step + 1)
            each.wait("its own size after that", lambda: each.size() == each.window())
        page.drag((800, 300), (830, 310))
        page.wait("the size of the window that is used", lambda: page.size() == page.window() == second.size())
        # A window that is smaller than any picture shows it whole.
        second.driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 300, "height": 190, "deviceScaleFactor": 1, "mobile": False})
        second.wait("the smallest picture", lambda: second.size() == (320, 200))
        assert second.window() == (300, 190)
        if not second.state()["panel"]:
            second.press("h")
        second.wait("the panel", lambda: second.state()["panel"] and "step" in second.state()["places"])
        step = second.state()["step"]
        second.click("step")
        second.wait("one step", lambda: second.state()["step"] == step + 1)
    finally:
        other.quit()
    page.drag((800, 300), (830, 310))
    page.wait("its size again", lambda: page.size() == page.window())


def says_why(page, view):
    """Eight may watch: this page and seven that are only connections; the ninth is told why it sees nothing."""
    driver = page.driver
    port = view.link.split(":")[2].split("/")[0]
    name = f"tumble_{port}"
    cookie = next(each["value"] for each in driver.get_cookies() if each["name"] == name)
    others = [socket.create_connection(("127.0.0.1", int(port))) for _ in range(7)]
    try:
        for each in others:
            each.sendall((
                f"GET /frames HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                f"Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nCookie: {name}={cookie}\r\nOrigin: http://127.0.0.1:{port}\r\n\r\n").encode())
            assert each.recv(12) == b"HTTP/1.1 101"
        first = driver.current_window_handle
        driver.switch_to.new_window("tab")
        driver.get(f"http://127.0.0.1:{port}/")
        page.wait("the reason", lambda: "as many browsers as may watch" in driver.find_element(By.ID, "notice").text.lower())
        others.pop().close()
        page.wait("frames after all", lambda: page.state().get("shown"))
        driver.close()
        driver.switch_to.window(first)
        driver.get_log("browser")  # the refusals that were meant
    finally:
        for each in others:
            each.close()


def rests_while_hidden(page):
    """Nothing is drawn for a page that nobody sees, while the simulation goes on; what it held it lets go of."""
    hide = """Object.defineProperty(document, 'hidden', { configurable: true, get: () => arguments[0] });
              document.dispatchEvent(new Event('visibilitychange'));"""
    page.click("play")
    page.wait("the simulation to run", lambda: page.state()["playing"])
    page.driver.execute_script(hide.replace("arguments[0]", "true"))
    unsaid = lambda: page.driver.execute_script("return unsaid.length")
    page.wait("the two frames that are under way at most", lambda: unsaid() == 2)
    before = page.state()
    time.sleep(0.5)  # a view that knew nothing of it would show some more
    assert (unsaid(), page.state()["shown"]) == (2, before["shown"]), (unsaid(), before["shown"], page.state()["shown"])
    page.driver.execute_script(hide.replace("arguments[0]", "false"))
    page.wait("frames again, of a later time", lambda: page.state()["shown"] > before["shown"] and page.state()["time"] > before["time"])
    page.press(Keys.SPACE)
    page.wait("a pause", lambda: not page.state()["playing"])


def lets_go_of_keys(page):
    said = page.driver.execute_script(
        """const said = [], send = WebSocket.prototype.send;
        WebSocket.prototype.send = function (words) { said.push(words); return send.call(this, words); };
        document.getElementById('picture').dispatchEvent(new KeyboardEvent('keydown', { code: 'KeyB', key: 'b' }));
        window.dispatchEvent(new Event('blur'));
        window.dispatchEvent(new Event('blur'));
        WebSocket.prototype.send = send;
        return said.filter((words) => words.startsWith('key'));""")
    assert said == ["key KeyB 1 0 0", "key KeyB 0 0 0"], said


def outlives_the_simulation(page):
    """The balls are thrown through the box' open side: the run ends with a problem, which is said; the rest goes on."""
    page.click("play")
    page.wait("the end", lambda: page.state()["trouble"])
    assert page.state()["trouble"].startswith("the simulation cannot go on"), page.state()["trouble"]
    assert "the simulation cannot go on" in page.driver.find_element(By.ID, "notice").text
    eye = page.state()["camera"]["eye"]
    page.drag((800, 300), (860, 280))
    page.wait("the camera to move", lambda: page.state()["camera"]["eye"] != eye)


def says_that_nobody_is_there(page, view):
    """The program itself dies: the page says so, and what to do."""
    view.kill()
    page.wait("a word about it", lambda: "does not answer" in page.driver.find_element(By.ID, "notice").text)
    assert "start it again and open its new link" in page.driver.find_element(By.ID, "notice").text


def picture_of(page):
    return page.driver.execute_script("return document.getElementById('picture').toDataURL()")


class Elsewhere:
    """A page on another port of this machine, and what its visitors bring."""

    def __enter__(self):
        brought = self.brought = []

        class Host(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                brought.append(self.headers.get("Cookie", ""))
                self.send_response(200)
                self.send_header("Content-Type", "text/html")
                self.end_headers()
                self.wfile.write(b"<title>elsewhere</title>")

            def log_message(self, *_):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Host)
        self.page = f"http://127.0.0.1:{self.server.server_port}"
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()

    def cookie(self, name):
        found = next((part for part in self.brought[0].split("; ") if part.startswith(name + "=")), None)
        assert found, f"the browser brought no {name}: {self.brought}"
        return found


def asked_for_frames(port, cookie, origin):
    """Status and words of the answer to a request of a WebSocket that comes from a page of that origin."""
    connection = http.client.HTTPConnection("127.0.0.1", int(port), timeout=MOST_WAIT_S)
    try:
        connection.request("GET", "/frames", headers={
            "Upgrade": "websocket", "Connection": "Upgrade", "Sec-WebSocket-Version": "13",
            "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==", "Cookie": cookie, "Origin": origin})
        answer = connection.getresponse()
        return answer.status, "" if answer.status == 101 else answer.read().decode()
    finally:
        connection.close()


def keeps_strangers_out(driver, link):
    """A page of another port, whose requests carry the cookie, gets no frames and no word; a used link without it none."""
    driver.get(link)  # used, but by this browser
    assert "<canvas" in driver.page_source
    port = link.split(":")[2].split("/")[0]
    with Elsewhere() as elsewhere:
        driver.get(elsewhere.page)
        # Same host, same site: the strict cookie comes along, so that nothing but the origin can keep this page out.
        cookie = elsewhere.cookie(f"tumble_{port}")
        assert asked_for_frames(port, cookie, f"http://127.0.0.1:{port}") == (101, ""), "its own page is let in"
        status, words = asked_for_frames(port, cookie, elsewhere.page)
        assert (status, "other pages have no say here" in words) == (403, True), (status, words)
        driver.get_log("browser")
        heard = driver.execute_async_script(
            """const done = arguments[1];
            const socket = new WebSocket('ws://127.0.0.1:' + arguments[0] + '/frames');
            socket.onopen = () => done('open');
            socket.onclose = () => done('closed');""",
            port,
        )
        said = [line["message"] for line in driver.get_log("browser")]
        assert heard == "closed", heard
        assert any("Unexpected response code: 403" in line for line in said), said  # answered, and refused
        heard = driver.execute_async_script(
            """const done = arguments[1];
            fetch('http://127.0.0.1:' + arguments[0] + '/', { credentials: 'include' }).then(
              (answer) => done('read ' + answer.status), (error) => done(error.name));""",
            port,
        )
        said = [line["message"] for line in driver.get_log("browser")]
        assert heard == "TypeError", heard
        assert any("blocked by CORS policy" in line for line in said), said  # a view that has ended would refuse the connection
    driver.get(link)
    driver.delete_all_cookies()
    driver.get(link)
    assert "this link has been used" in driver.page_source


def scrubs(page):
    assert page.state()["time"] == 0
    x, y = page.middle("time")
    page.drag((x - 100, y), (x + 60, y), (x + 40, y))
    page.wait("a later frame", lambda: page.state()["time"] > 0.1)
    later = page.state()["time"]
    page.press(",")
    page.wait("the frame before", lambda: page.state()["time"] < later)
    page.click("tab Look")
    page.wait("the tab", lambda: "trail" in page.state()["places"])
    assert "force chains" not in page.state()["places"], "this run has kept no contacts"
    page.click("trail")
    page.wait("the choice", lambda: "trail ball" in page.state()["places"])
    page.wait_for_rest()
    before = picture_of(page)
    page.click("trail ball")
    page.wait("the way of a ball", lambda: picture_of(page) != before)
    page.press(Keys.SPACE)
    page.wait("the end", lambda: page.state()["ended"])


def browser(folder, *more):
    options = Options()
    options.binary_location = shutil.which("chromium")
    for flag in [*FLAGS, *more, f"--user-data-dir={folder / 'browser'}"]:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    picture = sys.argv[sys.argv.index("--keep") + 1] if "--keep" in sys.argv else None
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
            page = Page(driver)
            with View(program, "shaken.toml", folder) as view:
                page.open(view.link)
                for part in (opens_and_runs, drags_the_camera, obeys_keys, moves_a_slider, draws_over_the_bodies, films, resizes, outlives_no_size, fits_a_phone, rests_while_hidden, lets_go_of_keys):
                    part(page)
                    print(f"{part.__name__}: fine", flush=True)
                shares(page, view, folder)
                print("shares: fine", flush=True)
                shares_between_sizes(page, view, folder)
                print("shares_between_sizes: fine", flush=True)
                if picture:
                    driver.save_screenshot(picture)
                wrong = [line for line in driver.get_log("browser") if line["level"] == "SEVERE"]
                assert not wrong, wrong
                says_why(page, view)
                print("says_why: fine", flush=True)
                keeps_strangers_out(driver, view.link)
                print("keeps_strangers_out: fine", flush=True)
            saved = sorted(path.suffix for path in (folder / "kept").iterdir())
            assert saved == [".mp4", ".toml"], saved
            (folder / "thrown.toml").write_text(SCENE.replace("count = 40", "count = 40\nvelocity_m_s = [0, 20, 0]"))
            with View(program, "thrown.toml", folder) as view:
                page.open(view.link)
                outlives_the_simulation(page)
                print("outlives_the_simulation: fine", flush=True)
                says_that_nobody_is_there(page, view)
                print("says_that_nobody_is_there: fine", flush=True)
            subprocess.run([program, "run", "shaken.toml", "--duration", "0.2", "--quiet"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
            with View(program, "out/shaken", folder) as view:
                page.open(view.link)
                scrubs(page)
                print("scrubs: fine", flush=True)
        finally:
            driver.quit()


if __name__ == "__main__":
    main()
