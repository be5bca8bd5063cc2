"""A headless Chromium, by its driver, and how the tests of pages count what passes."""

import json
import re
import subprocess
import time
import urllib.request

passed = failed = 0


def summary():
    print(f"{passed} passed, {failed} failed")
    return failed > 0


def check(name, what, expected):
    global passed, failed
    good = bool(expected(what)) if callable(expected) else what == expected
    passed, failed = passed + good, failed + (not good)
    if not good:
        print(f"FAILED: {name}: {what!r}" + ("" if callable(expected) else f", expected {expected!r}"))


class Browser:
    """As much of WebDriver (W3C) as is needed here."""

    ELEMENT = "element-6066-11e4-a52e-4f735466cecf"

    def __init__(self):
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        for line in self.driver.stdout:
            if found := re.search(r"successfully on port (\d+)", line):
                self.url = f"http://127.0.0.1:{found[1]}/session"
                break
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1200,2000"]}
        self.url += "/" + self.ask("", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}}})["sessionId"]

    def ask(self, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        with urllib.request.urlopen(urllib.request.Request(self.url + path, data)) as answer:
            return json.load(answer)["value"]

    def run(self, script):
        return self.ask("/execute/sync", {"script": script, "args": []})

    def element(self, css):
        return "/element/" + self.ask("/element", {"using": "css selector", "value": css})[self.ELEMENT]

    def text(self, css):
        return self.ask(self.element(css) + "/text")

    def keys(self, text):
        self.ask("/actions", {"actions": [{"type": "key", "id": "keys", "actions": [
            {"type": kind, "value": key} for key in text for kind in ("keyDown", "keyUp")]}]})

    def click(self, css, x, y):
        """At a place that is so many CSS pixels from the element's middle."""
        element = {self.ELEMENT: self.element(css).rsplit("/", 1)[1]}
        self.ask("/actions", {"actions": [{"type": "pointer", "id": "mouse", "actions": [
            {"type": "pointerMove", "origin": element, "x": x, "y": y},
            {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]}]})

    def open(self, page):
        self.ask("/url", {"url": page.as_uri()})

    def until(self, script):
        """What the script returns, as soon as that is something; ten seconds at most."""
        for _ in range(200):
            if answer := self.run("return " + script):
                return answer
            time.sleep(0.05)
        return None

    def close(self):
        self.ask_delete()
        self.driver.terminate()
        self.driver.wait()

    def ask_delete(self):
        with urllib.request.urlopen(urllib.request.Request(self.url, method="DELETE")):
            pass


TAB, LEFT, UP, RIGHT, ENTER, END = "\ue004", "\ue012", "\ue013", "\ue014", "\ue007", "\ue010"
