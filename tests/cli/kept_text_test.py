"""Pages by tools with text that people added: this text is kept, or the page is not written."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
sys.path.insert(0, str(SOURCE / "tools"))
from kept_text import kept_text  # noqa: E402

KEPT = "<!-- kept -->\nby hand\n<!-- end of kept -->\n"


class KeptText(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.page = pathlib.Path(folder.name) / "page.md"

    def test_it_comes_back_with_its_marks_however_often(self):
        self.page.write_text("# A\n" + KEPT + "| table |\n")
        self.assertEqual(kept_text(self.page), KEPT)
        self.page.write_text("# B\n" + kept_text(self.page))
        self.assertEqual(kept_text(self.page), KEPT)

    def test_a_new_page_gets_empty_marks(self):
        self.assertEqual(kept_text(self.page), "<!-- kept -->\n<!-- end of kept -->\n")

    def test_a_page_without_its_marks_is_not_written_again(self):
        for text in ("# A\nby hand\n", "<!-- kept -->\nby hand\n", KEPT + KEPT, "<!-- kept -->\n" + KEPT):
            self.page.write_text(text)
            with self.assertRaises(SystemExit) as refused:
                kept_text(self.page)
            self.assertIn("page.md: not written", str(refused.exception))

    def test_parts_with_names_are_kept_apart(self):
        self.page.write_text(KEPT + KEPT.replace("kept -->\nby", "kept: two -->\nalso by"))
        self.assertEqual(kept_text(self.page), KEPT)
        self.assertIn("also by hand", kept_text(self.page, "two"))

    def test_every_kept_part_of_the_documents_is_found_by_its_tool(self):
        pages = [p for folder in ("docs", "validation") for p in sorted((SOURCE / folder).rglob("*.md")) if "<!-- kept" in p.read_text(encoding="utf-8")]
        self.assertGreater(len(pages), 5)
        for page in pages:
            for name in re.findall(r"<!-- kept(?:: (.*?))? -->", page.read_text(encoding="utf-8")):
                self.assertGreater(len(kept_text(page, name)), 200, page)

    def test_a_page_whose_data_are_here_is_written_as_it_stands(self):
        subprocess.run([str(SOURCE / "tools/failure_mode_agreement"), "page", "--page", str(self.copied("validation/failure_modes/README.md"))], check=True)
        self.assertEqual(self.page.read_text(encoding="utf-8"), (SOURCE / "validation/failure_modes/README.md").read_text(encoding="utf-8"))

    def copied(self, page):
        self.page.write_text((SOURCE / page).read_text(encoding="utf-8"), encoding="utf-8")
        return self.page


if __name__ == "__main__":
    unittest.main()
