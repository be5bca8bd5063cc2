"""The book of `course book` in a browser: its links and anchors, pictures and formulas; search, turning pages, dark and
light; wide, on a phone and printed; and that nothing is loaded from elsewhere. With Chromium and its driver, which
`.ci/run` installs. COURSE_ROOT and COURSE_BUILD say where the repository and the program are."""

import html.parser
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import urllib.parse

from browser import ENTER, RIGHT, TAB, Browser, check, summary

ROOT, BUILD = pathlib.Path(os.environ["COURSE_ROOT"]), pathlib.Path(os.environ["COURSE_BUILD"])


class Page(html.parser.HTMLParser):
    """What a page links to, shows and loads, its anchors and its headings."""

    def __init__(self, file):
        super().__init__()
        self.links, self.loaded, self.anchors, self.headings, self.undescribed = [], [], set(), 0, 0
        self.twice = []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values:
            if values["id"] in self.anchors:
                self.twice.append(values["id"])
            self.anchors.add(values["id"])
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        if tag in ("img", "script", "source") and "src" in values:
            self.loaded.append(values["src"])
        if tag == "link":
            self.loaded.append(values.get("href", ""))
        self.undescribed += tag == "img" and "alt" not in values
        self.headings += tag == "h1"


def check_links(site):
    """By the files alone: every link within the book leads somewhere, to an anchor that is there."""
    pages = {file: Page(file) for file in site.rglob("*.html")}
    broken = []
    for file, page in pages.items():
        for link in page.links + page.loaded:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            target = file if not parts.path else (file.parent / urllib.parse.unquote(parts.path)).resolve()
            if not target.exists() or (parts.fragment and parts.fragment not in pages[target].anchors):
                broken.append(f"{file.relative_to(site)}: {link}")
    name = lambda file: str(file.relative_to(site))
    check("links that lead nowhere", broken, [])
    check("what is loaded from elsewhere", [f for page in pages.values() for f in page.loaded if "//" in f], [])
    check("anchors that are twice on a page", {name(f): p.twice for f, p in pages.items() if p.twice}, {})
    check("pictures without a description", {name(f): p.undescribed for f, p in pages.items() if p.undescribed}, {})
    check("pages without one title", [name(f) for f, p in pages.items() if p.headings != 1 and f.name != "whole.html"], [])
    return pages


def check_reading(browser, site):
    chapter = json.loads((ROOT / "chapters/02_spheres/chapter.json").read_text())
    steps = [step["id"] for step in chapter["steps"]]
    found = []
    for part in ("02_spheres_part_2_the_surface.html", "02_spheres.html"):
        browser.open(site / part)
        found = browser.run("return [...document.querySelectorAll('.task')].map(t => t.id)") + found
    check("each step stands out", found, [f"step-{s}" for s in steps])
    check("its title", browser.run("return document.title"), lambda title: title.startswith("2 "))
    check("formulas are typeset", browser.run("return document.querySelectorAll('math').length"), lambda count: count > 20)
    check("with a font for formulas", browser.until("document.fonts.check('16px \"STIX Math\"')"), True)
    check("code has colours", browser.run("return new Set([...document.querySelectorAll('pre span')].map(s => getComputedStyle(s).color)).size"), lambda count: count >= 3)
    check("figures have captions", browser.run("return [...document.querySelectorAll('main img')].filter(i => !i.closest('.figure')).length"), 0)
    check("pictures are there", browser.run("document.querySelectorAll('img').forEach(i => i.loading = 'eager')") or
          browser.until("[...document.images].every(i => i.complete) && [...document.images].filter(i => !i.naturalWidth).length === 0"), True)
    check("where one is, is told", browser.run("return document.querySelectorAll('[aria-current=page]').length"), 1)
    browser.keys(RIGHT)
    check("a key turns the page", browser.until("!location.pathname.endsWith('02_spheres.html') && location.pathname"), lambda path: path and path.endswith("02_spheres_part_2_the_surface.html"))


def check_search(browser, site):
    browser.open(site / "index.html")
    browser.keys("/")
    check("a key leads to the search", browser.run("return document.activeElement.id"), "query")
    browser.keys("discriminant")
    first = "document.querySelector('#found a') && document.querySelector('#found a').href"
    check("what is found first", browser.until(first), lambda href: href and "02_spheres.html#" in href)
    check("that is announced", browser.ask(browser.element("#found") + "/computedrole"), "status")
    browser.keys(TAB + ENTER)
    check("it is opened by keys", browser.until("location.hash && location.pathname"), lambda path: path and path.endswith("02_spheres.html"))
    browser.run("const q = document.getElementById('query'); q.value = 'xyzzy'; q.dispatchEvent(new Event('input'))")
    check("what is not there is said", browser.until("document.querySelector('#found p')?.textContent"), "Nothing found.")


def check_shade(browser, site):
    ground = "return getComputedStyle(document.body).backgroundColor"
    browser.open(site / "index.html")
    light = browser.run(ground)
    browser.run("document.getElementById('shade').click()")
    dark = browser.run(ground)
    check("a button makes it dark", (light, dark), lambda both: both[0] != both[1])
    browser.open(site / "02_spheres.html")
    check("and it stays so", browser.run(ground), dark)
    browser.run("document.getElementById('shade').click()")
    check("and light again", browser.run(ground), light)


def check_widths(browser, site, pages):
    for width in (360, 900, 1500):
        browser.ask("/window/rect", {"width": width, "height": 900})
        wide = []
        for file in sorted(site.glob("*.html")):
            if file.name == "whole.html":
                continue
            browser.open(file)
            if browser.run("return document.documentElement.scrollWidth > document.documentElement.clientWidth"):
                wide.append(file.name)
        check(f"pages that are too wide for {width} pixels", wide, [])
    check("on the widest the contents stand beside the text",
          browser.run("return document.querySelector('aside').getBoundingClientRect().right <= document.querySelector('main').getBoundingClientRect().left"), True)


def check_print(site, directory):
    file = directory / "book.pdf"
    subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer",
                    f"--print-to-pdf={file}", (site / "whole.html").as_uri()], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120)
    text = file.read_bytes()
    check("it prints to one PDF", text[:5], b"%PDF-")
    check("of many pages", text.count(b"/Type /Page\n") + text.count(b"/Type /Page "), lambda count: count > 50)


def main():
    with tempfile.TemporaryDirectory() as name:
        directory = pathlib.Path(name).resolve()
        site = directory / "site"
        made = subprocess.run([BUILD / "bin" / "course", "book", "-o", site, "--json"], stdout=subprocess.PIPE, text=True)
        check("book's status", made.returncode, 0)
        told = json.loads(made.stdout)
        check("where it begins", told["page"], str(site / "index.html"))
        pages = check_links(site)
        browser = Browser()
        try:
            check_reading(browser, site)
            check_search(browser, site)
            check_shade(browser, site)
            check_widths(browser, site, pages)
            check("nothing is wrong", browser.ask("/se/log", {"type": "browser"}), [])
        finally:
            browser.close()
        check_print(site, directory)
    sys.exit(summary())


main()
