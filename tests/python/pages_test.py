#!/usr/bin/python3
"""Pages about Python: the blocks of a page run one after another in one interpreter, in a
folder with the examples, and its commands run between them. tests/cli/guides_test.py leaves these pages to this test.
"""
import importlib.util
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
PACKAGE = str(BUILD / "python")
os.environ["WYTHE"] = str(BUILD / "wythe")

_spec = importlib.util.spec_from_file_location("guides_test", SOURCE / "tests/cli/guides_test.py")
guides = importlib.util.module_from_spec(_spec)
_spec.loader.exec_module(guides)

PAGES = [page for page in guides.PAGES if guides.about_the_package(page.read_text(encoding="utf-8"))]


class Interpreter:
    """Runs blocks one after another, each with the names of those before; what a block prints is kept."""

    MARK = "--- end of a block ---"
    LOOP = f"""
import sys, traceback
names = {{"__name__": "__main__"}}
for number, size in enumerate(map(int, iter(sys.stdin.readline, "")), 1):
    good = True
    try:
        exec(compile(sys.stdin.read(size), f"<block {{number}}>", "exec"), names)
    except BaseException:
        good = False
        traceback.print_exc(file=sys.stdout)
    print({MARK!r}, good, flush=True)
"""

    def __init__(self, folder):
        self.process = subprocess.Popen(
            ["/usr/bin/python3", "-c", self.LOOP], cwd=folder, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL, env={**os.environ, "PYTHONPATH": PACKAGE, "MPLBACKEND": "Agg"})

    def run(self, block):
        """(whether it ran, what it printed)."""
        self.process.stdin.write(f"{len(block)}\n{block}")
        self.process.stdin.flush()
        printed = []
        for line in self.process.stdout:
            if line.startswith(self.MARK):
                return line.split()[-1] == "True", "".join(printed)
            printed.append(line)
        return False, "".join(printed) + "the interpreter ended"

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()


def follow(page, folder):
    """What is wrong with a page, or nothing."""
    reader, interpreter = guides.Reader(folder), Interpreter(folder)
    os.environ["PYTHONPATH"] = PACKAGE
    (pathlib.Path(folder) / "build/release/python3").symlink_to("/usr/bin/python3")
    try:
        for marks, language, text in guides.fences(page):
            if language != "python" or "not run:" in marks:
                wrong = reader.follow(marks, language, text)
                if wrong:
                    return wrong
            elif "needs" not in marks or importlib.util.find_spec(marks["needs"]):
                good, reader.printed = interpreter.run(text)
                if not good:
                    return f"{text}\n{reader.printed}"
    finally:
        interpreter.close()
    return ""


class Pages(unittest.TestCase):
    maxDiff = None

    def test_every_page_about_the_package_runs(self):
        self.assertGreaterEqual(len(PAGES), 2)
        for page in PAGES:
            with self.subTest(str(page.relative_to(SOURCE))), tempfile.TemporaryDirectory() as folder:
                self.assertEqual(follow(page.read_text(encoding="utf-8"), folder), "")

    def test_the_line_of_the_readme_prints_the_summary(self):
        line = re.search(r"""^python3 (-c "import wythe.*)$""", (SOURCE / "README.md").read_text(encoding="utf-8"), re.M)
        self.assertIsNotNone(line, "README.md has no line that runs a wall from Python")
        model = (SOURCE / "examples/tuff_wall/model.toml").read_text(encoding="utf-8")
        self.assertEqual(model.count('until = "50 mm"'), 1)
        with tempfile.TemporaryDirectory() as folder:  # the same file, pushed by a millimetre
            short = pathlib.Path(folder, "examples/tuff_wall/model.toml")
            short.parent.mkdir(parents=True)
            short.write_text(model.replace('until = "50 mm"', 'until = "1 mm"'), encoding="utf-8")
            done = subprocess.run(["bash", "-c", f"/usr/bin/python3 {line.group(1)}"], cwd=folder, capture_output=True, text=True,
                                  check=False, env={**os.environ, "PYTHONPATH": PACKAGE})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("'peak_reaction_kN'", done.stdout)


class Follows(unittest.TestCase):
    """The test sees what does not work."""

    def fault(self, page):
        with tempfile.TemporaryDirectory() as folder:
            return follow(page, folder)

    def test_names_live_on_and_prints_are_compared(self):
        page = "```python\na = 2\n```\n```python\nprint('a is', a)\n```\n<!-- test: said -->\n```\na is {}\n```\n"
        self.assertEqual(self.fault(page.format(2)), "")
        self.assertIn("not printed", self.fault(page.format(3)))

    def test_a_block_that_raises_is_seen(self):
        self.assertIn("ZeroDivisionError", self.fault("```python\n1 / 0\n```\n"))
        self.assertIn("NameError", self.fault("```python\nnothing\n```\n"))
        self.assertIn("SystemExit", self.fault("```python\nraise SystemExit(0)\n```\n"))
        self.assertIn("the interpreter ended", self.fault("```python\nimport os\nos._exit(0)\n```\n"))

    def test_a_command_that_fails_is_seen(self):
        self.assertIn("ended with", self.fault("```\npython3 -c 'import wyth'\n```\n"))


class Reference(unittest.TestCase):
    """docs/reference/python.md has every public name with its signature."""

    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, PACKAGE)
        cls.page = (SOURCE / "docs/reference/python.md").read_text(encoding="utf-8")

    def test_every_public_name_is_there_with_its_arguments(self):
        import inspect

        import wythe
        import wythe.dakota
        import wythe.openturns
        import wythe.umbridge

        missing = []
        members = {f"wythe.{name}": getattr(wythe, name) for name in wythe.__all__}
        members |= {f"wythe.openturns.{name}": getattr(wythe.openturns, name) for name in ("function", "field_function")}
        members["wythe.umbridge.Server"] = wythe.umbridge.Server
        for name, thing in list(members.items()):
            if inspect.isclass(thing) and not issubclass(thing, BaseException):
                own = {attribute: value for attribute, value in vars(thing).items() if not attribute.startswith("_")}
                members |= {f"{name.rpartition('.')[2]}.{attribute}": value for attribute, value in own.items()}
        for name, thing in members.items():
            head = re.search(rf"`{re.escape(name)}[`(]", self.page)
            if head is None:
                missing.append(name)
            elif inspect.isfunction(thing):
                stated = self.page[head.start():].split("`")[1]
                missing += [f"{name}: argument {argument}" for argument in inspect.signature(thing).parameters
                            if argument not in ("self", "cls") and not re.search(rf"\b{argument}\b", stated)]
        self.assertEqual(missing, [])

    def test_no_name_is_there_that_the_package_does_not_have(self):
        import wythe
        import wythe.answers
        import wythe.openturns
        import wythe.umbridge
        for name in re.findall(r"^\| `wythe\.([\w.]+)", self.page, re.M):
            thing = wythe
            for part in name.split("."):
                self.assertTrue(hasattr(thing, part), name)
                thing = getattr(thing, part)


if __name__ == "__main__":
    unittest.main()
