#!/usr/bin/env python3
"""The site (make site): it builds without a warning, with valid links and known words; and the checks themselves fail on faults.

Skips, with the reason, where the packages of deps/site.txt are not installed.
"""
import importlib.machinery
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
SITE = SOURCE / "build/site"  # tests/web/site_test.mjs asks for the same one


def tool():
    """tools/site as a module."""
    loader = importlib.machinery.SourceFileLoader("site_tool", str(SOURCE / "tools/site"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("site_tool", loader))
    loader.exec_module(module)
    return module


class Built(unittest.TestCase):
    def page(self, name):
        return (SITE / name).read_text(encoding="utf-8")

    def test_it_builds_and_nothing_is_found_wrong(self):
        self.assertEqual(RUN.returncode, 0, RUN.stdout)

    def test_the_start_page_has_one_picture_and_three_sentences(self):
        article = re.search(r'<section id="wythe">(.*?)<div class="cards', self.page("index.html"), re.S).group(1)
        self.assertEqual(article.count("<img"), 1)
        text = re.sub(r"<[^>]*>", "", article.split("</h1>")[1])
        self.assertEqual(len(re.findall(r"\.(?:\s|$)", text.strip())), 3, text)

    def test_the_first_card_opens_the_studio_where_it_is_built(self):
        card = self.page("index.html").split('<div class="card')[2]  # after the box of all cards
        lead = re.search(r'href="([^"]*)"', card).group(1)
        self.assertEqual(lead, "studio.html" if TOOL.STUDIO.is_file() else "docs/howto/studio.html")
        self.assertTrue((SITE / lead).is_file())

    def test_each_example_has_a_card_with_its_command_its_file_and_its_time(self):
        cards = self.page("gallery.html").split('<div class="card')[1:]
        folders = sorted(p.name for p in (SOURCE / "examples").iterdir() if p.is_dir())
        self.assertGreaterEqual(len(cards), len(folders))
        for folder in folders:
            with self.subTest(folder):
                card = next((c for c in cards if f'examples/{folder}/README.html' in c), "")
                self.assertRegex(card, r"<pre>.*(wythe|python3 examples/)")
                self.assertRegex(card, r"href=\"[^\"]*\.(toml|py)\"")
                self.assertRegex(card, r"\d (s|min|h)\b")
                self.assertTrue((SITE / f"examples/{folder}/README.html").is_file())

    def test_no_reader_meets_a_text_that_a_tool_puts_into_a_page(self):
        self.assertFalse((SITE / "validation/OVERVIEW.html").exists())

    def test_search_needs_no_server(self):
        self.assertIn("Search.setIndex(", self.page("searchindex.js"))
        self.assertIn("lobatto", self.page("searchindex.js"))


class Checks(unittest.TestCase):
    """What the checks are for is found; a site without it passes."""

    def faults(self, **pages):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in pages.items():
                (pathlib.Path(folder) / f"{name}.html").write_text(text, encoding="utf-8")
            return list(TOOL.faults_of_links(pathlib.Path(folder)))

    def test_links_that_lead_somewhere_pass(self):
        self.assertEqual(self.faults(a='<p id="x"><a href="b.html#y"></a><a href="#x"></a><a href="https://example.org">',
                                     b='<p id="y">'), [])

    def test_a_link_to_nothing_is_found(self):
        self.assertEqual(self.faults(a='<a href="b.html">'), ["a.html: b.html: no such file"])

    def test_a_link_to_a_folder_is_found(self):
        self.assertEqual(self.faults(a='<a href="./">'), ["a.html: ./: no such file"])

    def test_an_anchor_that_is_not_there_is_found(self):
        self.assertEqual(self.faults(a='<a href="b.html#y">', b="<p>"), ["a.html: b.html#y: no such anchor"])

    def test_a_picture_that_is_not_there_is_found(self):
        self.assertEqual(self.faults(a='<img src="x.png">'), ["a.html: x.png: no such file"])

    def test_what_a_page_would_fetch_from_the_network_is_found(self):
        for text in ('<script src="https://example.org/x.js">', '<link rel="stylesheet" href="//example.org/x.css">'):
            self.assertIn("without a network", "".join(self.faults(a=text)))

    def test_styles_that_ask_for_a_file_elsewhere_are_found(self):
        with tempfile.TemporaryDirectory() as folder:
            style = pathlib.Path(folder) / "a.css"
            style.write_text("@import url(/javascript/a.css); p { background: url('data:x') }")
            self.assertEqual(list(TOOL.faults_of_links(pathlib.Path(folder))), ["a.css: /javascript/a.css: no such file"])

    def test_a_misspelt_word_is_found_in_prose_alone(self):
        known = {"wythe"}
        good = "# A wall\nwythe pushes `wrongg` walls\n```\nwrongg\n```\n[see](wrongg.md)\n"
        self.assertEqual(list(TOOL.faults_of_spelling({"a.md": good}, known)), [])
        found = list(TOOL.faults_of_spelling({"a.md": good + "a wrongg word, half-wrongg\n"}, known))
        self.assertEqual([f.split(":")[:2] for f in found], [["a.md", " wrongg"]])

    def test_names_of_pages_become_links_and_code_stays(self):
        tree = TOOL.Tree()
        tree.add("docs/x.md", "# X\nSee `docs/theory/zones.md`, decision 0003, `model.toml`.\n```\n`docs/theory/zones.md`\n```\n")
        text = TOOL.linked(tree, "docs/x.md")
        self.assertRegex(text, r"See \[8 Deformable blocks: zones\]\(theory/zones\.md\), \[decision 0003\]\(decisions/0003-[^)]*\), `model\.toml`")
        self.assertIn("```\n`docs/theory/zones.md`\n```", text)


if __name__ == "__main__":
    RUN = subprocess.run([str(SOURCE / "tools/site"), "--check"], text=True, check=False,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if RUN.returncode == 77:
        print(RUN.stdout.strip())
        sys.exit(77)
    TOOL = tool()
    unittest.main()
