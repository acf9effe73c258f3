#!/usr/bin/python3
"""The view as a person meets it: the link is opened, the scene runs, its look and its films are chosen, a run is gone through.

    tests/view/browser.py PROGRAM [--keep PICTURE.png]

Exit code 77, with a sentence, where there is no browser to do it with.
"""

import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from watching import By, Keys, Page, View, a_browser, check_log, go_through, picture_of, program_of  # noqa: E402


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


def check_film(file, window):
    """The scene beside the panel of 300 pixels; within 100 steps of 20 us of a picture every 10 ms, the one at their beginning."""
    if not shutil.which("ffprobe"):
        return print("the film is not looked into: ffprobe is not installed")
    told = subprocess.run(
        ["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v:0", "-show_entries", "stream=width,height,nb_read_frames", "-of", "csv=p=0", file],
        check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    width, height = window
    assert told == f"{(width - 300) // 2 * 2},{height // 2 * 2},1", (told, window)


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


def main():
    program = program_of(sys.argv)
    picture = sys.argv[sys.argv.index("--keep") + 1] if "--keep" in sys.argv else None
    with a_browser() as (driver, folder):
        page = Page(driver)
        with View(program, "shaken.toml", folder) as view:
            page.open(view.link)
            window = page.size()
            go_through((opens_and_runs, draws_over_the_bodies, films, resizes, outlives_no_size, rests_while_hidden), page)
            if picture:
                driver.save_screenshot(picture)
            check_log(driver)
        kept = list((folder / "kept").iterdir())
        assert [path.suffix for path in kept] == [".mp4"], kept
        check_film(kept[0], window)
        (folder / "thrown.toml").write_text((folder / "shaken.toml").read_text().replace("count = 40", "count = 40\nvelocity_m_s = [0, 20, 0]"))
        with View(program, "thrown.toml", folder) as view:
            page.open(view.link)
            go_through((outlives_the_simulation,), page)
            go_through((says_that_nobody_is_there,), page, view)
        subprocess.run([program, "run", "shaken.toml", "--duration", "0.2", "--quiet"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        with View(program, "out/shaken", folder) as view:
            page.open(view.link)
            go_through((scrubs,), page)


if __name__ == "__main__":
    main()
