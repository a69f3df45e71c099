#!/usr/bin/env python3
"""README, tutorials, how-to's and the pages of the examples: every command runs, and its output is that of the page.

A page is followed from top to bottom in an empty folder. A fence of commands is run as a shell script. A comment above a fence says
how the test treats it; a reader does not see it:

  <!-- test: file pier.toml -->                 the fence is this file
  <!-- test: adds house/model.toml -->          the fence is added to this file
  <!-- test: said -->                           the last commands printed these lines; their numbers within 2 %
  <!-- test: short --samples 2 -->              the runs, campaigns and comparisons of models below take these options too, because they take minutes
  <!-- test: first wythe run ... -->            run this before, with the options of `short`: the page needs its results
  <!-- test: long -->                          run only by make test-long, with the output of the next fence
  <!-- test: long --samples 2 -->              the same; make test runs it with these options, without a comparison of its output
  <!-- test: exit 3 -->                         the commands below end with this code
  <!-- test: needs pandas -->                   run where this Python module is installed
  <!-- test: not run: it needs a graphics card -->   with the reason
"""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
import unittest.mock

WYTHE = str(pathlib.Path(os.environ.get("WYTHE", "build/release/wythe")).resolve())
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
PAGES = [SOURCE / "README.md", *sorted((SOURCE / "docs/tutorial").glob("*.md")), *sorted((SOURCE / "docs/howto").glob("*.md")),
         *sorted((SOURCE / "examples").glob("*/README.md"))]
FENCE = re.compile(r"((?:<!-- test: [^\n]* -->\n)*)^```([a-z]*)\n(.*?)^```$", re.S | re.M)
MARK = re.compile(r"<!-- test: (file|adds|said|short|first|long|exit|needs|not run:) ?(.*?) ?-->")
COMMAND = re.compile(r"(?:build/release/)?wythe |make |cmake |python3 |sed |cp ")
SETTING = re.compile(r"[a-z]+=\S")  # of the shell, for the commands below it
SHELL = ("sh", "bash", "console", "shell")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
# Stands in the place of the program: gives the options of `short` to what takes long, in the place of those of the same name.
STAND_IN = """#!%s
import os, shlex, sys
words, short = sys.argv[1:], shlex.split(os.environ["SHORT"])
if (words[:1] in (["run"], ["campaign"], ["assess"]) and words[1:2] != ["--resume"]
        or words[:1] == ["compare"] and words[1].endswith(".toml")):
    for option in short:
        if option.startswith("--") and option != "--set" and option in words:
            del words[words.index(option):words.index(option) + 2]
    words += ["--quiet", *short]
os.execv("%s", ["wythe", *words])
""" % (sys.executable, WYTHE)


def about_the_package(page):
    """Whether a page's Python blocks use the package: tests/python/pages_test.py follows such a page."""
    return any(language == "python" and "import wythe" in text for _, language, text in fences(page))


def fences(text):
    """(marks, language, text) of each fence."""
    for match in FENCE.finditer(text):
        yield dict(MARK.findall(match.group(1))), match.group(2), match.group(3)


def commands_in(text):
    """(lines that are commands, lines that are not) of a fence."""
    lines = [l for l in re.sub(r"\\\n", "", text).splitlines() if l.strip() and not l.startswith("#")]
    found = [l for l in lines if COMMAND.match(l.removeprefix("$ "))]
    return found, [l for l in lines if l not in found and not SETTING.match(l)]


def same_line(stated, printed):
    """Whether a line of a page is a printed one: its words, and its numbers within 2 %. It may end early."""
    if NUMBER.sub("#", stated.rstrip(" .…")) != NUMBER.sub("#", printed)[:len(NUMBER.sub("#", stated.rstrip(" .…")))]:
        return False
    pairs = zip(NUMBER.findall(stated), NUMBER.findall(printed))
    return all(abs(float(a) - float(b)) <= 0.02 * abs(float(b)) for a, b in pairs)


class Reader:
    """Follows a page in a folder of its own."""

    def __init__(self, folder):
        self.folder, self.short, self.printed = pathlib.Path(folder), "", ""
        for name in ("examples", "validation"):
            (self.folder / name).symlink_to(SOURCE / name)
        (self.folder / "build/release").mkdir(parents=True)
        stand_in = self.folder / "build/release/wythe"
        stand_in.write_text(STAND_IN)
        stand_in.chmod(0o755)

    def run(self, script, expected=0):
        path = f"{self.folder / 'build/release'}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run(["bash", "-eu"], input=script, cwd=self.folder, text=True, check=False, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, env=dict(os.environ, PATH=path, SHORT=self.short))
        self.printed = done.stdout + done.stderr
        return "" if done.returncode == expected else f"ended with {done.returncode}, not {expected}:\n{script}\n{done.stdout}{done.stderr}"

    def follow(self, marks, language, text):
        """What is wrong with a fence, or nothing."""
        if "not run:" in marks:
            return "" if marks["not run:"] else "not run, and no reason"
        if "needs" in marks and importlib.util.find_spec(marks["needs"]) is None:
            print(f"not run: a fence that needs {marks['needs']}, which is not installed")
            return ""
        stands_in = "long" in marks and "WYTHE_LONG" not in os.environ
        if stands_in and not marks["long"]:
            self.printed = None
            return ""
        self.short = marks["long"] if stands_in else marks.get("short", "")
        if "file" in marks or "adds" in marks:
            path = self.folder / (marks.get("file") or marks["adds"])
            path.write_text((path.read_text() + "\n" if "adds" in marks else "") + text)
            return ""
        if "said" in marks and self.printed is None:
            return ""
        if "said" in marks:
            missing = [l for l in text.splitlines() if l.strip() and not any(same_line(l, p) for p in self.printed.splitlines())]
            return "not printed: " + "\n".join(missing) + "\nbut:\n" + self.printed if missing else ""
        if language == "toml":
            tomllib.loads(text)
            return ""
        if language == "python":
            return self.run(f"{sys.executable} - <<'END'\n{text}END\n")
        commands, others = commands_in(text)
        if language not in ("", *SHELL) or not commands and language == "":
            return ""
        if others:
            return "commands and other lines in one fence: " + "\n".join(others)
        fault = (self.run(marks["first"]) if "first" in marks else "") or self.run(text, int(marks.get("exit", 0)))
        self.printed = None if stands_in else self.printed
        return fault


class Guides(unittest.TestCase):
    maxDiff = None

    def follow(self, page):
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(folder)
            for marks, language, text in fences(page.read_text(encoding="utf-8")):
                self.assertEqual(reader.follow(marks, language, text), "")

    def test_every_command_of_the_gallery_is_taken(self):
        commands = re.findall(r"^\|.*\| `(wythe [^`]*)` \|", (SOURCE / "examples/README.md").read_text(encoding="utf-8"), re.M)
        self.assertGreaterEqual(len(commands), len([p for p in (SOURCE / "examples").iterdir() if p.is_dir()]))
        with tempfile.TemporaryDirectory() as folder:
            reader = Reader(folder)
            for command in commands:  # the file is read and compiled; tests/cli/starters_test.py and the pages run them
                command = re.sub(r"^wythe compare (\S+) (\S+) --out \S+$", r"wythe check \1 && wythe check \2", command)
                self.assertEqual(reader.run(re.sub(r"^wythe (run|campaign|assess) (\S+) --out \S+$", r"wythe check \2", command)), "")

    def test_every_mark_is_one_that_the_test_knows(self):
        for page in PAGES:
            text = page.read_text(encoding="utf-8")
            known = sum(m.group(1).count("<!-- test:") for m in FENCE.finditer(text))
            self.assertEqual(text.count("<!-- test:"), known, f"{page}: a mark that stands above no fence")
            self.assertEqual(text.count("<!-- test:"), len(MARK.findall(text)), f"{page}: a mark that the test does not know")

    def test_tutorials_and_howtos_have_commands(self):
        for page in PAGES:
            found = [text for marks, _, text in fences(page.read_text(encoding="utf-8")) if commands_in(text)[0]]
            self.assertTrue(found, page)


for _page in PAGES:  # Guides.test_docs_howto_campaign_md follows docs/howto/campaign.md
    if not about_the_package(_page.read_text(encoding="utf-8")):
        setattr(Guides, "test_" + re.sub(r"\W", "_", str(_page.relative_to(SOURCE))), lambda self, page=_page: self.follow(page))


class Follows(unittest.TestCase):
    """The reader sees what does not work."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.reader = Reader(folder.name)

    def fault(self, page):
        return "".join(self.reader.follow(*fence) for fence in fences(page))

    def test_a_command_that_fails_is_seen(self):
        self.assertIn("ended with 2", self.fault("```\nwythe check nothing.toml\n```\n"))
        self.assertIn("ended with", self.fault("```\nwythe check nothing.toml\nwythe --version\n```\n"))
        self.assertEqual(self.fault("<!-- test: exit 2 -->\n```\nwythe check nothing.toml\n```\n"), "")

    def test_an_option_that_the_program_does_not_have_is_seen(self):
        self.assertNotEqual(self.fault("```\nwythe check examples/brick_pier/model.toml --fast\n```\n"), "")

    def test_a_file_of_the_page_is_used(self):
        self.assertIn("ended with 2", self.fault("<!-- test: file a.toml -->\n```toml\nname = 'x'\n```\n```\nwythe check a.toml\n```\n"))

    def test_other_words_and_other_numbers_than_printed_are_seen(self):
        for stated, good in [("peak 10.1 kN at 2 mm", True), ("peak 10.1 kN", True), ("peak 10.1 kN ...", True), ("peak 10.3 kN", False),
                             ("peek 10.1 kN", False), ("peak none", False)]:
            self.reader.printed = "status completed\npeak 10.0 kN at 2.00 mm\n"
            self.assertEqual(self.fault(f"<!-- test: said -->\n```\n{stated}\n```\n") == "", good, stated)

    def test_no_fence_of_commands_is_passed_over(self):
        for language in ("", "sh", "bash", "console"):
            self.assertIn("ended with", self.fault(f"```{language}\nwythe check nothing.toml\n```\n"), language)
        for page in ("```\n$ wythe check nothing.toml\nvalid\n```\n", "```\nwythe --version\nprinted\n```\n"):
            self.assertIn("commands and other lines", self.fault(page))

    def test_a_long_fence_is_run_by_test_long_alone(self):
        said = "```\nwythe run nothing.toml --out out\n```\n<!-- test: said -->\n```\nvalid\n```\n"
        for mark, fault in (("long", ""), ("long --help", ""), ("long --no-such-option", "ended with")):
            page = f"<!-- test: {mark} -->\n{said}"
            with unittest.mock.patch.dict(os.environ):
                os.environ.pop("WYTHE_LONG", None)
                self.assertEqual(self.fault(page)[:10], fault, mark)
                os.environ["WYTHE_LONG"] = "1"
                self.assertIn("there is no such file", self.fault(page), mark)

    def test_what_is_not_run_has_a_reason(self):
        self.assertNotEqual(self.fault("<!-- test: not run: -->\n```\nwythe x\n```\n"), "")

    def test_a_toml_fence_that_is_none_is_seen(self):
        with self.assertRaises(tomllib.TOMLDecodeError):
            self.fault("```toml\nname = \n```\n")


def cases(tests):
    for test in tests:
        yield from cases(test) if isinstance(test, unittest.TestSuite) else [test]


def load_tests(_, tests, __):
    """unittest's protocol. Each n-th case from the i-th on, where PART is "i/n", as tools/run_tests asks; without PART every case."""
    part, of = map(int, os.environ.get("PART", "0/1").split("/"))
    return unittest.TestSuite(list(cases(tests))[part::of])


if __name__ == "__main__":
    if shutil.which("bash") is None:
        print("bash is not installed")
        sys.exit(77)
    unittest.main()
