#!/usr/bin/python3
"""What hands do to the view in a real browser: drags, sliders, keys, fingers, two browsers at once, and what ends their holding.

    tests/view/hands.py PROGRAM

Exit code 77, with a sentence, where there is no browser to do it with.
"""

import sys

sys.dont_write_bytecode = True
from watching import ActionChains, By, Keys, Page, View, a_browser, browser, check_log, go_through, picture_of, program_of  # noqa: E402


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


def fits_a_huge_window(page):
    """Wider than four times the widest picture: it asks for less than a quarter of a pixel a pixel, and goes on."""
    driver = page.driver
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 12000, "height": 1200, "deviceScaleFactor": 1, "mobile": False})
    page.wait("the widest picture", lambda: page.size() == (2560, 256))
    driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
    page.wait("the window as before", lambda: page.size() == page.window())


def told_while(page, do):
    """The words of buttons and keys that the page sends meanwhile."""
    page.driver.execute_script(
        """window.said = []; window.plainSend = WebSocket.prototype.send;
        WebSocket.prototype.send = function (words) { said.push(words); return plainSend.call(this, words); };""")
    do()
    said = page.driver.execute_script("WebSocket.prototype.send = plainSend; return said;")
    return [words for words in said if words.split()[0] in ("down", "up", "key")]


CANVAS = "document.getElementById('picture')"


def lets_go_of_keys(page):
    script = f"""{CANVAS}.dispatchEvent(new KeyboardEvent('keydown', {{ code: 'KeyB', key: 'b' }}));
        window.dispatchEvent(new Event('blur'));
        window.dispatchEvent(new Event('blur'));"""
    said = told_while(page, lambda: page.driver.execute_script(script))
    assert said == ["key KeyB 1 0 0", "key KeyB 0 0 0"], said


def lets_go_of_buttons(page):
    """However the holding of a button ends, the view is told, once."""

    def pointer(*steps):
        hands = ActionChains(page.driver, duration=50)
        for name, *place in steps:
            getattr(hands.w3c_actions.pointer_action, name)(*place)
        hands.perform()

    def held_until(script):
        pointer(("move_to_location", 800, 300), ("pointer_down",))
        page.driver.execute_script(script)
        pointer(("move_to_location", 820, 300), ("pointer_up",))

    holder = f"const id = [...pressed.values()][0]; {CANVAS}"
    hidden = "Object.defineProperty(document, 'hidden', { configurable: true, get: () => %s }); document.dispatchEvent(new Event('visibilitychange'));"
    for end in (
        "",
        "window.dispatchEvent(new Event('blur'));",
        f"{holder}.dispatchEvent(new PointerEvent('pointercancel', {{ pointerId: id, button: -1 }}));",
        f"{holder}.releasePointerCapture(id);",
        hidden % "true" + hidden % "false",
    ):
        said = told_while(page, lambda: held_until(end))
        assert [words.split()[:2] for words in said] == [["down", "0"], ["up", "0"]], (end, said)


def follows_two_buttons(page):
    """Only the last of two that is let go has an event of its own, and one that is let go of elsewhere has none."""
    script = f"""const canvas = {CANVAS};
        canvas.setPointerCapture = () => {{}}; // there is no such pointer
        const tell = (kind, button, buttons) => canvas.dispatchEvent(new PointerEvent(kind, {{
          clientX: 800, clientY: 300, button, buttons, pointerId: 7, pointerType: 'mouse' }}));
        tell('pointerdown', 2, 2); tell('pointermove', 0, 3); tell('pointermove', 2, 1); tell('pointerup', 0, 0);
        tell('pointerdown', 0, 1); tell('pointermove', -1, 0); tell('pointerup', 0, 0);
        delete canvas.setPointerCapture;"""
    said = told_while(page, lambda: page.driver.execute_script(script))
    wanted = [["down", "2"], ["down", "0"], ["up", "2"], ["up", "0"], ["down", "0"], ["up", "0"]]
    assert [words.split()[:2] for words in said] == wanted, said


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


def main():
    program = program_of(sys.argv)
    with a_browser() as (driver, folder), View(program, "shaken.toml", folder) as view:
        page = Page(driver)
        page.open(view.link)
        go_through((drags_the_camera, obeys_keys, moves_a_slider, fits_a_phone, fits_a_huge_window, lets_go_of_keys, lets_go_of_buttons, follows_two_buttons), page)
        go_through((shares, shares_between_sizes), page, view, folder)
        check_log(driver)
        kept = list((folder / "kept").iterdir())
        assert [path.suffix for path in kept] == [".toml"], kept


if __name__ == "__main__":
    main()
