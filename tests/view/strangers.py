#!/usr/bin/python3
"""Who is kept out of the view, in a real browser: a ninth watcher, another page, a link that has been used.

    tests/view/strangers.py PROGRAM

Exit code 77, with a sentence, where there is no browser to do it with.
"""

import http.client
import http.server
import socket
import sys
import threading

sys.dont_write_bytecode = True
from watching import MOST_WAIT_S, By, Page, View, a_browser, check_log, go_through, program_of  # noqa: E402


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


def main():
    program = program_of(sys.argv)
    with a_browser() as (driver, folder), View(program, "shaken.toml", folder) as view:
        page = Page(driver)
        page.open(view.link)
        check_log(driver)
        go_through((says_why,), page, view)
        go_through((keeps_strangers_out,), driver, view.link)


if __name__ == "__main__":
    main()
