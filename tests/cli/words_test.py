#!/usr/bin/env python3
"""tools/check_words finds each kind of name that does not exist, long sentences, old names, lists that run together, and nothing in a tree without faults."""
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()

GOOD = {
    "Makefile": "docs: build\n",
    "src/law.h": "// The law (3.2), decision 0001. Calls `find_root`, see apps/main.cpp.\ndouble find_root();\n",
    "src/README.md": "| `law` | the law |\n",
    "apps/README.md": "`main.cpp`\n",
    "apps/main.cpp": '#include "law.h"\nconst char* kOption = "--until";\n',
    "docs/theory/law.md": "```\nsigma = kn w      (3.2)\n```\n`find_root` in `law.h`\n",
    "docs/decisions/0001-points.md": "`--until`, `make docs`, `src/law.*`, [law](../theory/law.md)\n",
}
BAD = [  # file, a line put at its end, what must be said
    ("docs/theory/law.md", "`src/law.cpp`", "docs/theory/law.md:5: src/law.cpp: no such file"),
    ("docs/theory/law.md", "`tools/check`", "tools/check: no such file or folder"),
    ("docs/theory/law.md", "`lane.*`", "lane.*: no such files"),
    ("docs/theory/law.md", "wythe run --fast", "--fast: no program here takes this option"),
    ("docs/theory/law.md", "decision 0002", "0002: no such decision"),
    ("docs/theory/law.md", "`make cake`", "cake: the Makefile has no such target"),
    ("docs/theory/law.md", "`Model::weight`", "Model::weight: no such name in the code"),
    ("docs/theory/law.md", "- One. - Two.", "docs/theory/law.md:5: - Two.: an item of a list begins a line of its own"),
    ("src/law.h", "// drive.cpp", "src/law.h:3: drive.cpp: no such file"),
    ("src/law.h", "// by (3.9)", "3.9: no such equation in docs/theory"),
    ("src/law.h", "// find_zero() does it", "find_zero: no such name in the code"),
]


def check(tree):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        run = subprocess.run([str(SOURCE / "tools/check_words"), folder], text=True, check=False,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return run.returncode, run.stdout


class Words(unittest.TestCase):
    def test_a_tree_without_faults_passes(self):
        self.assertEqual(check(GOOD), (0, "words: what documents and comments name exists\n"))

    def test_each_kind_of_missing_name_is_found(self):
        for name, line, said in BAD:
            with self.subTest(line):
                status, output = check({**GOOD, name: GOOD[name] + line + "\n"})
                self.assertEqual(status, 1, output)
                self.assertEqual(len(output.splitlines()), 1, output)
                self.assertIn(said, output)

    def test_a_file_that_no_room_names_is_found(self):
        for path, said in (("src/lane.cpp", "src/lane.cpp: not named in src/README.md"), ("src/deep/law_2.h", "not named in src/README.md"),
                           ("web/src/main.ts", "web/src/main.ts: no folder above it has a README.md")):
            with self.subTest(path):
                status, output = check({**GOOD, path: "int n;\n"})
                self.assertEqual((status, len(output.splitlines())), (1, 1), output)
                self.assertIn(said, output)

    def test_a_name_that_two_files_have_is_one_files_name(self):
        two = {**GOOD, "src/plane/joints.h": "int a;\n", "src/space/joints.h": "int b;\n"}
        rooms = GOOD["src/README.md"]
        for names, missing in (("`joints`", 2), ("`plane/joints`", 1), ("`plane/joints.h`, `space/joints.*`", 0),
                               ("\n## `plane/`\n| `joints` | |\n## `space/`\n| `joints` | |", 0),
                               ("\n## `plane/`\n| `joints` | |", 1), ("`wythe/joints.h`, `joints/`", 2)):
            with self.subTest(names):
                output = check({**two, "src/README.md": rooms + names + "\n"})[1]
                self.assertEqual(output.count("joints.h: not named in src/README.md"), missing, output)

    def test_a_long_sentence_of_a_page_is_found(self):
        words = lambda n: "This " + "and " * (n - 2) + "ends"
        for name, text, found in (("README.md", words(33) + ".", 1), ("README.md", words(32) + ".", 0), ("docs/howto/a.md", "Good.\n\n" + words(33), 1),
                                  ("docs/howto/a.md", f"- {words(20)}\n- {words(20)}", 0), ("README.md", f"{words(20)}. {words(20)}. `law.h` {words(20)}", 0),
                                  ("README.md", f"```\n{words(40)}\n```\n| {words(40)} |\n# {words(40)}\n<!-- {words(40)} -->", 0),
                                  ("README.md", f"{words(30)} `a b c` 1 2 3.", 0), ("docs/theory/a.md", words(40), 1),
                                  ("docs/theory/a.md", f"    a = {words(40)}", 0), ("src/law/README.md", words(40), 1), ("docs/decisions/0002-a.md", words(40), 1)):
            with self.subTest(f"{name}: {text}"):
                status, output = check({**GOOD, name: text + "\n"})
                self.assertEqual((status, output.count("words, 32 at most")), (found, found), output)

    def test_an_old_name_of_decision_0033_is_found_in_code(self):
        renames = {"docs/decisions/0033-names.md": "| | old | new |\n|---|---|---|\n| 1 | rub, brake (executors), put_... | update_slip |\n| 2 | look | poll |\n"}
        for name, code, found in (("src/law.h", "int rub;", 1), ("tests/law.h", "x.brake();", 1), ("apps/main.cpp", "int look, executors, put_;", 0),
                                  ("src/law.h", 'const char* kText = "rub";  // rub', 0), ("benchmarks/law.h", "int rub;", 0), ("src/law.h", 'const char* kPage = R"css(rub "rub")css";', 0)):
            with self.subTest(f"{name}: {code}"):
                rooms = {f"{name.split('/')[0]}/README.md": f"`{name.split('/')[1]}`\n", **GOOD, **renames}
                output = check({**rooms, name: GOOD.get(name, "") + code + "\n"})[1]
                self.assertEqual(output.count("an old name of decision 0033, update_slip now"), found, output)
                self.assertEqual(len(output.splitlines()), 1, output)

    def test_code_is_not_taken_for_a_comment(self):
        tree = {**GOOD, "src/law.h": GOOD["src/law.h"] + 'const char* kName = "// (9.9) drive.cpp";\n'}
        self.assertEqual(check(tree)[0], 0)


if __name__ == "__main__":
    unittest.main()
