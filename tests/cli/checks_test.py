"""tools/check_layers reads every kind of file with code, tools/check_sizes reports long files and functions, tools/build_times
counts cores, and tools/verification_table keeps its page where it has no rows."""
import os
import pathlib
import subprocess
import tempfile
import unittest

TOOLS = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])) / "tools"


def run(tool, name, text):
    """Exit status and output of a tool for a tree with one file."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "src/dynamics" / name
        path.parent.mkdir(parents=True)
        path.write_text(text, encoding="utf-8")
        done = subprocess.run([TOOLS / tool, folder], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout


def said(tool, name, text):
    """What a tool refuses; "" where it finds no fault."""
    status, output = run(tool, name, text)
    return output if status else ""


class Checks(unittest.TestCase):
    def test_an_include_that_points_upwards_is_refused(self):
        for name in ("a.h", "a.cpp"):
            self.assertIn(f"src/dynamics/{name}:1: dynamics (L3) includes campaign/store/store.h (L5): upwards",
                          said("check_layers", name, '#include "campaign/store/store.h"\n'))
            self.assertEqual("", said("check_layers", name, '#include "model/parts.h"\n'))

    def test_a_library_has_one_door(self):
        for name in ("a.h", "a.cpp"):
            self.assertIn("belongs to campaign", said("check_layers", name, "#include <sqlite3.h>\n"))

    def test_what_is_long_is_reported_and_not_refused(self):
        body = "void f() {\n" + "  g();\n" * 90 + "}\n"
        for name, text, report in (("a.h", body, "a.h:1: f has 92 lines"), ("a.cpp", "// word\n" * 601, "a.cpp: 601 lines"),
                                   ("b.cpp", "void f() { g(); }\n", "")):
            status, output = run("check_sizes", name, text)
            self.assertEqual(status, 0)
            self.assertIn(report, output)
            self.assertEqual("b.cpp" in output, False)

    def test_compilers_that_wait_for_each_other_count_once(self):
        cores = len(os.sched_getaffinity(0))
        with tempfile.TemporaryDirectory() as folder:
            jobs = [(0, 2000, f"busy{k}.o") for k in range(2 * cores)] + [(2000, 3000, "alone.o"), (2000, 9000, "linked")]
            text = "# ninja log v5\n" + "".join(f"{start}\t{end}\t0\t{output}\tx\n" for start, end, output in jobs)
            (pathlib.Path(folder) / ".ninja_log").write_text(text, encoding="utf-8")
            done = subprocess.run([TOOLS / "build_times", "--build", folder], capture_output=True, text=True, check=False)
        alone = 1.0 if cores > 1 else 0.5  # beside the linker
        self.assertIn(f"{2 * cores + alone:7.1f} s  in all, {2 * cores + 1} files", done.stdout, done.stderr)

    def test_rows_without_their_commit_leave_the_page_of_verification(self):
        row = 'CF01,"slope",m,1,1.1,1e-1,1e-2,relative,"exact",{}'
        with tempfile.TemporaryDirectory() as folder:
            rows, page = pathlib.Path(folder) / "rows.csv", pathlib.Path(folder) / "page.md"
            page.write_text("as it was\n", encoding="utf-8")
            for line, status, found in ((row.format("1"), 1, "as it was"), (row.format("1,abc123"), 0, "1 within their tolerance. wythe of commit abc123"),
                                        (row.format("0,abc123"), 1, "**+1.0e-01, missed**")):
                rows.write_text(line + "\n", encoding="utf-8")
                done = subprocess.run([TOOLS / "verification_table", rows, page], capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, status, done.stderr)
                self.assertIn(found, page.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
