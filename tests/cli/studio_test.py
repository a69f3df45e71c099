"""wythe studio: the page beside the program, with a model in it."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

WYTHE = os.environ["WYTHE"]
SOURCE = pathlib.Path(os.environ["SOURCE"])
PAGE = (SOURCE / "web/studio.html").read_text().split("<body>")[0] + "<script id=\"wythe-model\"><!--wythe:model--></script>\n"
MODEL = '[wall]\nname = "dà </script> \U0001f9f1"\n'


class Studio(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        self.page = self.folder / "prefix/share/wythe/studio.html"
        self.page.parent.mkdir(parents=True)
        (self.folder / "prefix/bin").mkdir()
        os.link(WYTHE, self.folder / "prefix/bin/wythe") if os.stat(WYTHE).st_dev == os.stat(self.folder).st_dev else shutil.copy(
            WYTHE, self.folder / "prefix/bin/wythe")
        (self.folder / "model.toml").write_text(MODEL, encoding="utf-8")

    def studio(self, *words):
        return subprocess.run([self.folder / "prefix/bin/wythe", "studio", *words], cwd=self.folder, capture_output=True, text=True)

    def test_the_model_lies_in_the_page_and_cannot_end_its_element(self):
        self.page.write_text(PAGE)
        run = self.studio("model.toml", "--out", "wall.html")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertIn(f"open in a browser: {self.folder.resolve()}/wall.html", run.stdout)
        text = (self.folder / "wall.html").read_text()
        self.assertEqual(text, PAGE.replace("<!--wythe:model-->", MODEL.encode().hex()))
        # written again over its own page
        self.assertEqual(self.studio("--out", "wall.html").returncode, 0)
        self.assertEqual((self.folder / "wall.html").read_text(), PAGE.replace("<!--wythe:model-->", ""))

    def test_any_text_goes_in_as_it_is(self):
        self.page.write_text(PAGE)
        for name, text in (("Windows", MODEL.replace("\n", "\r\n")), ("tabs", "\t" + MODEL), ("mark", "\ufeff" + MODEL),
                           ("long lines", MODEL + "# " + "x" * 200_000 + "\n"), ("many", MODEL + "# é\n" * 40_000)):
            with self.subTest(name):
                (self.folder / "model.toml").write_bytes(text.encode())
                run = self.studio("model.toml", "--out", "wall.html")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertIn(text.encode().hex(), (self.folder / "wall.html").read_text())

    def test_faults_are_told_and_nothing_is_lost(self):
        for words, said in ((("model.toml",), "has no studio"), (("none.toml",), "")):
            run = self.studio(*words)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)
        self.page.write_text(PAGE)
        self.assertNotEqual(self.studio("none.toml").returncode, 0)
        run = self.studio("model.toml", "--out", "model.toml")
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertEqual((self.folder / "model.toml").read_text(encoding="utf-8"), MODEL)
        (self.folder / "letter.html").write_text("<p>mine</p>")
        self.assertEqual(self.studio("model.toml", "--out", "letter.html").returncode, 2)
        self.assertEqual((self.folder / "letter.html").read_text(), "<p>mine</p>")
        (self.folder / "photo.png").write_bytes(b"\x89PNG\r\n\x1a\n\0\0\xff\xfe")
        (self.folder / "study.toml").write_text('[study]\nbase = "model.toml"\n')
        for name, said in (("photo.png", "no UTF-8"), ("study.toml", "is a study")):
            run = self.studio(name, "--out", "new.html")
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(said, run.stderr)
            self.assertFalse((self.folder / "new.html").exists())
        # the page that all others are made from stays
        self.assertEqual(self.studio("model.toml", "--out", str(self.page)).returncode, 2)
        self.assertEqual(self.page.read_text(), PAGE)
        self.page.write_text("<title>wythe studio</title>")
        run = self.studio("model.toml")
        self.assertEqual(run.returncode, 4, run.stderr)
        self.assertIn("make studio builds it again", run.stderr)


if __name__ == "__main__":
    unittest.main()
