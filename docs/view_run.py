#!/usr/bin/python3
"""Makes docs/pictures/view-run.png: what a browser shows of a run of the full bowl that is over.

    docs/view_run.py build/release/tumble out/bowl
"""
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/view"))
import browser as eyes  # noqa: E402

SIZE = (1280, 720)  # pixels of the page
BEGIN = 0.7  # share of the run from which on the way is drawn
FRAMES = 60  # one by one, so that none is passed over


def press(page, name):
    page.wait(name, lambda: name in page.state()["places"])
    page.click(name)


def main():
    program, run = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    eyes.MOST_WAIT_S = 600
    with tempfile.TemporaryDirectory() as place:
        driver = eyes.browser(pathlib.Path(place))
        try:
            page = eyes.Page(driver)
            with eyes.View(program, run, pathlib.Path(place)) as view:
                page.open(view.link)
                wide, high = page.window()
                driver.set_window_size(2 * SIZE[0] - wide, 2 * SIZE[1] - high)  # the window's frame takes some
                page.wait("a picture of that size", lambda: page.window() == SIZE and page.size() == SIZE)
                left, top, right, bottom = page.state()["places"]["time"]
                page.drag(page.on_page(left + BEGIN * (right - left), (top + bottom) / 2))
                for name in ("tab Look", "trail", "trail sensor"):
                    press(page, name)
                eyes.ActionChains(driver, duration=0).move_by_offset(0, 300).perform()  # away from what tells its key
                for _ in range(FRAMES):
                    before = page.state()["time"]
                    page.press(".")
                    page.wait("the next frame", lambda: page.state()["time"] > before)
                page.wait_for_rest()
                driver.save_screenshot(str(ROOT / "docs/pictures/view-run.png"))
        finally:
            driver.quit()


if __name__ == "__main__":
    main()
