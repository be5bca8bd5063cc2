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

from browser import END, ENTER, LEFT, RIGHT, TAB, UP, Browser, check, summary

ROOT, BUILD = pathlib.Path(os.environ["COURSE_ROOT"]), pathlib.Path(os.environ["COURSE_BUILD"])
SCENE = """version 1
size 64 48
camera 0 0 4 0 0 0 0 1 0 45
ambient 0.1 0.1 0.1
point 2 5 5 1 1 1
diffuse {color}
sphere 0 0 0 1
"""


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


def open_page(browser, page):
    browser.open(page)
    browser.until('document.querySelector("#colors").textContent')  # the pictures are decoded by then


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
            open_page(browser, page)
            check_choosing(browser, data)
            check_slider(browser)
            check_for_screen_readers(browser)
            check_offline(browser)
            open_page(browser, both)
            check("both trees are shown, as text, and where they part", browser.text("#rays"),
                  lambda text: all(part in text for part in ("by your code\nmine <b>", "by the solutions\ntheirs", "First difference: t.")))
        finally:
            browser.close()
    sys.exit(summary())


main()
