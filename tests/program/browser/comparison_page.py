"""The page of `course compare --page` in a browser: the slider, the pixel that is chosen and its rays, by mouse and by
keyboard; what a screen reader is told; and that nothing is loaded. With Chromium and its driver, which `.ci/run`
installs. COURSE_ROOT and COURSE_BUILD say where the repository and the program are."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import urllib.request

ROOT, BUILD = pathlib.Path(os.environ["COURSE_ROOT"]), pathlib.Path(os.environ["COURSE_BUILD"])
SCENE = """version 1
size 64 48
camera 0 0 4 0 0 0 0 1 0 45
ambient 0.1 0.1 0.1
point 2 5 5 1 1 1
diffuse {color}
sphere 0 0 0 1
"""
passed = failed = 0


def check(name, what, expected):
    global passed, failed
    good = expected(what) if callable(expected) else what == expected
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
        for _ in range(200):  # ten seconds; the pictures are decoded by then
            if self.text("#colors"):
                return
            time.sleep(0.05)

    def close(self):
        self.ask_delete()
        self.driver.terminate()
        self.driver.wait()

    def ask_delete(self):
        with urllib.request.urlopen(urllib.request.Request(self.url, method="DELETE")):
            pass


TAB, LEFT, UP, RIGHT, ENTER, END = "\ue004", "\ue012", "\ue013", "\ue014", "\ue007", "\ue010"


def make_pages(directory):
    """Of a red ball against a blue one; and one whose rays are by a student's code, too."""
    course = BUILD / "bin" / "course"
    for name, color in (("red", "0.8 0.1 0.1"), ("blue", "0.1 0.1 0.8")):
        (directory / f"{name}.scene").write_text(SCENE.format(color=color))
        subprocess.run([course, "render", f"{name}.scene", "--solutions", "--quiet"], cwd=directory, check=True)
    made = subprocess.run([course, "compare", "red.png", "blue.png", "--page", "page.html", "--scene", "red.scene"],
                          cwd=directory, stdout=subprocess.PIPE, text=True)
    check("compare's status", made.returncode, 1)
    page = directory / "page.html"
    text = page.read_text()
    found = re.search(r'(?<=id="data">).*?(?=</script>)', text)
    data = json.loads(found[0])
    data["rays"][0].update({"mine": "mine <b>", "theirs": "theirs", "difference": "First difference: t."})
    both = directory / "both.html"
    both.write_text(text[:found.start()] + json.dumps(data).replace("<", "\\u003c") + text[found.end():])
    return page, both, data


def check_slider(browser):
    clip = 'return getComputedStyle(document.querySelector(".over")).clipPath'
    check("half of each is seen at first", browser.run(clip), lambda value: "50%" in value)
    browser.run('document.querySelector("#split").focus()')
    browser.keys(RIGHT * 3)
    check("the keys move the slider", browser.run(clip), lambda value: "47%" in value)
    browser.keys(END)
    check("to the end", browser.run(clip), "inset(0px 0% 0px 0px)")
    check("what a screen reader says of it", browser.run('return split.getAttribute("aria-valuetext")'), "100 % of the width")
    check("its role", browser.ask(browser.element("#split") + "/computedrole"), "slider")
    check("its name", browser.ask(browser.element("#split") + "/computedlabel"), lambda name: "red.png" in name)


def check_choosing(browser, data):
    check("the worst pixel is chosen at first", browser.text("#colors"), lambda text: text.startswith(f"Pixel {data['x']}, {data['y']}: "))
    browser.click("#stage", 5, 5)  # a pixel is 15 of the page's
    check("a click chooses a pixel", browser.text("#colors"), lambda text: text.startswith("Pixel 32, 24: picture"))
    check("its colours are told apart", browser.text("#colors"), lambda text: text.endswith("/255 apart"))
    check("and its rays", browser.text("#rays"), lambda text: "hits the sphere of line 7" in text)
    browser.keys(LEFT + UP)
    check("then the keys move on", browser.text("#colors"), lambda text: text.startswith("Pixel 31, 23: "))
    browser.run('document.querySelector("#x").focus(); document.querySelector("#x").select()')
    browser.keys("999")
    check("the fields choose, too, inside the picture", browser.text("#colors"), lambda text: text.startswith("Pixel 63, 23: "))
    check("what is not in the page is said", browser.text("#rays"), lambda text: "./course trace red.scene 63 23" in text)
    browser.run('document.querySelector("button[data-x]").focus()')
    browser.keys(ENTER)
    check("and the worst places", browser.text("#colors"), lambda text: text.startswith(f"Pixel {data['x']}, {data['y']}: "))


def check_for_screen_readers(browser):
    check("what is chosen is announced", browser.ask(browser.element("#colors") + "/computedrole"), "status")
    check("pictures are described", browser.run("return [...document.images].filter(i => !i.hasAttribute('alt')).length"), 0)
    check("fields are named", browser.ask(browser.element("#x") + "/computedlabel"), "x")
    check("the page's language is told", browser.run("return document.documentElement.lang"), "en")
    check("it has one head", browser.run("return document.querySelectorAll('h1').length"), 1)
    reached = set()
    browser.run("document.activeElement.blur()")
    for _ in range(40):  # all of them, and round
        browser.keys(TAB)
        reached.add(browser.run("return document.activeElement.id"))
    check("the keyboard reaches all that can be worked with", reached, lambda ids: {"stage", "split", "x", "y"} <= ids)


def check_offline(browser):
    loaded = browser.run("return performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'))")
    check("nothing is loaded from elsewhere", loaded, [])
    check("nor is anything wrong", browser.ask("/se/log", {"type": "browser"}), [])


def main():
    with tempfile.TemporaryDirectory() as name:
        page, both, data = make_pages(pathlib.Path(name))
        browser = Browser()
        try:
            browser.open(page)
            check_choosing(browser, data)
            check_slider(browser)
            check_for_screen_readers(browser)
            check_offline(browser)
            browser.open(both)
            check("both trees are shown, as text, and where they part", browser.text("#rays"),
                  lambda text: all(part in text for part in ("by your code\nmine <b>", "by the solutions\ntheirs", "First difference: t.")))
        finally:
            browser.close()
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed > 0)


main()
