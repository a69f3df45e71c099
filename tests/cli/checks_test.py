"""tools/check_layers and tools/check_sizes see every kind of file that holds code, .cu among them."""
import os
import pathlib
import subprocess
import tempfile
import unittest

TOOLS = pathlib.Path(os.environ.get("SOURCE", pathlib.Path(__file__).resolve().parents[2])) / "tools"


def said(tool, name, text):
    """What a tool says of a tree with one file; "" where it finds no fault."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "src/dynamics" / name
        path.parent.mkdir(parents=True)
        path.write_text(text, encoding="utf-8")
        done = subprocess.run([TOOLS / tool, folder], capture_output=True, text=True, check=False)
        return done.stdout if done.returncode else ""


class Checks(unittest.TestCase):
    def test_an_include_that_points_upwards_is_refused(self):
        for name in ("a.h", "a.cpp", "a.cu"):
            self.assertIn(f"src/dynamics/{name}:1: dynamics (L3) includes campaign/store/store.h (L4): upwards",
                          said("check_layers", name, '#include "campaign/store/store.h"\n'))
            self.assertEqual("", said("check_layers", name, '#include "model/parts.h"\n'))

    def test_a_library_has_one_door(self):
        for name in ("a.cpp", "a.cu"):
            self.assertIn("belongs to study", said("check_layers", name, "#include <sqlite3.h>\n"))

    def test_a_long_function_is_refused(self):
        body = "void f() {\n" + "  g();\n" * 90 + "}\n"
        kernel = "__global__ " + body
        for name, text in (("a.h", body), ("a.cpp", body), ("a.cu", kernel)):
            self.assertIn(f"src/dynamics/{name}:1: f has 92 lines, cap 80",
                          said("check_sizes", name, text))
        self.assertIn("601 lines, cap 600", said("check_sizes", "a.cu", "// word\n" * 601))
        self.assertEqual("", said("check_sizes", "a.cu", "__global__ void f() { g(); }\n"))


if __name__ == "__main__":
    unittest.main()
