"""The site of docs builds without a warning; every link and anchor in it and in README.md leads
somewhere, and its pages load nothing from the network. Exit code 77: mkdocs is not installed."""

import html.parser
import os
import re
import shutil
import subprocess
import tempfile
import urllib.parse

import support

if shutil.which("mkdocs") is None or not os.path.isdir("/usr/share/mkdocs/themes/material"):
    support.skip("no mkdocs with its material theme (Debian: mkdocs mkdocs-material)")


class Page(html.parser.HTMLParser):
    """Anchors of a page, its links, and what it loads."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loads = {""}, [], []
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors.add(given.get("id", ""))
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if tag in ("img", "script") and given.get("src"):
            self.loads.append(given["src"])
        if tag == "link" and given.get("rel") != "canonical" and given.get("href"):
            self.loads.append(given["href"])


def check(site):
    pages = {}
    for folder, _, names in os.walk(site):
        for name in names:
            if name.endswith(".html") and name != "404.html":  # which is for a server
                path = os.path.join(folder, name)
                pages[path] = Page(path)
    bad = []
    for path, page in pages.items():
        for link in page.links + page.loads:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme == "data":  # within the page itself
                continue
            if parts.scheme or parts.netloc:
                if link in page.loads:
                    bad.append((path, link, "loaded from the network"))
                continue
            target = os.path.normpath(os.path.join(os.path.dirname(path),
                                                   urllib.parse.unquote(parts.path)))
            target = path if not parts.path else target
            if os.path.isdir(target):
                target = os.path.join(target, "index.html")
            if not os.path.exists(target):
                bad.append((path, link, "no such page"))
            elif target in pages and parts.fragment not in pages[target].anchors:
                bad.append((path, link, "no such heading"))
    for path, link, reason in bad:
        print(f"{os.path.relpath(path, site)}: {link}: {reason}")
    assert not bad
    return len(pages)


def check_readme(site):
    """Files of the sources, and headings of the pages in the site."""
    with open(os.path.join(support.SOURCE, "README.md"), encoding="utf-8") as file:
        links = re.findall(r"\]\(([^)#]*)(?:#([^)]*))?\)", file.read())
    assert len(links) > 10, links
    for path, anchor in links:
        assert os.path.exists(os.path.join(support.SOURCE, path)), path
        if anchor:
            page = re.sub(r"^docs/(.*)[.]md$", r"\1.html", path)
            assert anchor in Page(os.path.join(site, page)).anchors, f"{path}#{anchor}"


def check_start(site):
    """The start page has what README.md says."""
    with open(os.path.join(site, "index.html"), encoding="utf-8") as file:
        start = file.read()
    for told in ("Install and first run", "What it does not do", "images/icu_ventilator_shake.png"):
        assert told in start, told


with tempfile.TemporaryDirectory() as site:
    built = subprocess.run(["mkdocs", "build", "--strict", "--site-dir", site, "-f",
                            os.path.join(support.SOURCE, "docs/site/mkdocs.yml")],
                           capture_output=True, text=True)
    report = built.stdout + built.stderr
    assert built.returncode == 0 and "WARNING" not in report, report
    assert "not included in the \"nav\"" not in report, report
    check_readme(site)
    check_start(site)
    print(f"{check(site)} pages, every link leads somewhere")
