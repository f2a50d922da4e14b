# SPDX-License-Identifier: MIT
"""The HTML report read back with Python's own parsers: its structure, its tables, its charts."""

import html.parser
import re
import xml.etree.ElementTree

VOID = {"meta", "input", "br", "link", "img", "hr", "wbr"}
TEXT_ONLY = {"script", "style"}


class Page(html.parser.HTMLParser):
    """Reads a page, and notes in `faults` whatever is not well formed."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.text = text
        self.faults = []
        self.open = []
        self.ids = []
        self.scripts = []
        self.tables = []  # of the sections: lists of rows, each a list of cell texts; titles first
        self.sections = []  # (id, first table, index behind the last)
        self.links = []
        self._cell = None
        self.feed(text)
        self.close()
        if self.open:
            self.faults.append(f"never closed: {self.open}")

    def handle_starttag(self, tag, attrs):
        names = [name for name, _ in attrs]
        attributes = dict(attrs)
        if len(names) != len(set(names)):
            self.faults.append(f"<{tag}> has an attribute twice: {names}")
        self.ids += [attributes["id"]] if "id" in attributes else []
        self.links += [attributes["href"]] if "href" in attributes else []
        if any(name.startswith("on") for name in names):
            self.faults.append(f"<{tag}> has a handler: {names}")
        if tag not in VOID:
            self.open.append(tag)
        if tag == "section":
            self.sections.append([attributes.get("id"), len(self.tables), None])
        elif tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self._cell = ""
        elif tag == "script":
            self.scripts.append("")

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.faults.append(f"</{tag}> inside {self.open[-3:]}, line {self.getpos()[0]}")
            return
        self.open.pop()
        if tag in ("td", "th"):
            self.tables[-1][-1].append(self._cell)
            self._cell = None
        elif tag == "section":
            self.sections[-1][2] = len(self.tables)

    def handle_data(self, data):
        if self._cell is not None:
            self._cell += data
        if self.open and self.open[-1] == "script":
            self.scripts[-1] += data

    def section_text(self, name):
        """The HTML of one section."""
        start = self.text.index(f'id="{name}">')
        return self.text[start:self.text.index("</section>", start)]

    def section_tables(self, name):
        """The tables of one section, each a list of dictionaries by title."""
        for found, first, end in self.sections:
            if found == name:
                return [[dict(zip(table[0], row)) for row in table[1:]] for table in self.tables[first:end]]
        return []


def drawings(text):
    """Every <svg> of a page, through an XML parser: raises where one is not well formed."""
    return [xml.etree.ElementTree.fromstring(part) for part in re.findall(r"<svg.*?</svg>", text, re.DOTALL)]


def charts(section):
    """(error, cost) -> [(title, is_front, is_chosen)] of the charts of a section, in the order they are drawn."""
    found = {}
    for error, cost, svg in re.findall(r'<div class="e-(\w+) k-(\w+)">\s*(<svg.*?</svg>)', section, re.DOTALL):
        points = []
        for group in xml.etree.ElementTree.fromstring(svg).iter("g"):
            rings = [circle for circle in group.iter("circle") if circle.get("class") == "ch"]
            points.append((group.find("title").text, "f" in group.get("class").split(), bool(rings)))
        found[error, cost] = points
    return found
