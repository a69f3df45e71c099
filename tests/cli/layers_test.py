#!/usr/bin/env python3
"""tools/check_layers finds each kind of fault, and nothing in a tree without faults."""
import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()

GOOD = {
    "include/wythe/model.h": '#include "wythe/parts/model.h"\n',
    "include/wythe/parts/model.h": "#include <vector>\n",
    "src/model/model.cpp": '#include "wythe/parts/model.h"\ndouble turn(const State& s) { return s.theta[0]; }\n',
    "src/reading/joints.cpp": '#include "model/fields.h"\nnamespace wythe::study {\nstruct Piece {\n};\nstruct Piece::Whole {\n};\n}  // namespace wythe::study\n'
                              "namespace wythe {\nnamespace {\nstruct Fit {\n};\n}  // namespace\nstruct Piece {\n};\n}  // namespace wythe\n",
    "src/reading/zones.cpp": "namespace wythe {\nnamespace {\nstruct Fit {\n};\n}  // namespace\n}  // namespace wythe\n",
    "src/judge/modes.cpp": '#include "model/parts.h"\n// s.theta and n_face_point are the plane\'s\n',
    "src/report/arrays.cpp": 'const char* kColumn = "frame.theta, wall.half_x";\n',
    "apps/main.cpp": '#include "wythe/model.h"\n',
}
BAD = [  # file, a line put at its end, what must be said
    ("src/model/model.cpp", '#include "judge/modes.h"', "src/model/model.cpp:3: model (L2) includes"),
    ("src/model/model.cpp", '#include "reading/zones.h"', "model includes its sibling reading/zones.h"),
    ("src/report/arrays.cpp", '#include "io/results/vtu.h"', "report includes its sibling io/results/vtu.h"),
    ("src/judge/modes.cpp", "#include <sqlite4.h>\n#include <zlib.h>", "<zlib.h> belongs to report"),
    ("apps/main.cpp", '#include "model/parts.h"', "only wythe/*.h may be seen from apps"),
    ("src/judge/modes.cpp", "double t = state.theta[b];",
     "src/judge/modes.cpp:3: theta is the plane's: ask wythe/parts/reading.h"),
    ("src/report/arrays.cpp", "double e = model->half_y[j];", "half_y is the plane's"),
    ("src/io/results/vtu.cpp", "auto t = &Model::tangent_x;", "tangent_x is the plane's"),
    ("src/model/parts.h", "double t = std::tan(phi);", "std::tan has other bits on other machines"),
    ("src/model/parts.h", "double n = std::stod(text);", "std::stod follows the locale"),
    ("apps/main.cpp", "double n = strtod(text, nullptr);", "strtod follows the locale"),
    ("python/module.cpp", "char c = std::toupper(letter);", "std::toupper follows the locale"),
    ("src/report/arrays.cpp", "std::ostringstream text;", "ostringstream follows the locale"),
    ("src/report/arrays.cpp", 'snprintf(text, 9, "%g", x);', "snprintf follows the locale"),
    ("src/report/arrays.cpp", "int n = stoi(text);", "stoi follows the locale"),
    ("apps/main.cpp", "int p = joint * model.n_face_point;", "n_face_point is the plane's"),
    ("src/judge/modes.cpp", "namespace wythe {\nnamespace study {\nstruct Piece {\n};\n}  // namespace study\n}  // namespace wythe",
     "src/reading/joints.cpp:3: wythe::study::Piece is also the type of src/judge/modes.cpp:5"),
    ("src/judge/modes.cpp", "namespace wythe::study {\nclass Piece final : public Whole {\n};\n}  // namespace wythe::study",
     "wythe::study::Piece is also the type of src/judge/modes.cpp:4"),
]


WORDS = {"include/wythe/parts/fit.h": 'inline constexpr Word<Fit> kFitWords[] = {{"cut", Fit::kCut}};\n',
         "src/api/word_tables.cpp": "static_assert(names_all(kFitWords));\n"}


def check(tree):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        run = subprocess.run([str(SOURCE / "tools/check_layers"), folder], text=True, check=False,
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return run.returncode, run.stdout


class Layers(unittest.TestCase):
    def test_a_tree_without_faults_passes(self):
        self.assertEqual(check(GOOD), (0, "layers: includes point downwards\n"))

    def test_each_kind_of_fault_is_found(self):
        for name, line, said in BAD:
            with self.subTest(line):
                status, output = check({**GOOD, name: GOOD.get(name, "") + line + "\n"})
                self.assertEqual(status, 1, output)
                self.assertEqual(len(output.splitlines()), 1, output)
                self.assertIn(said, output)

    def test_a_table_of_words_is_checked_where_it_is_compiled(self):
        self.assertEqual(check({**GOOD, **WORDS})[0], 0)
        status, output = check({**GOOD, **WORDS, "src/api/word_tables.cpp": "static_assert(names_all(kFitWords2));\n"})
        self.assertEqual(status, 1)
        self.assertIn("include/wythe/parts/fit.h:1: kFitWords is a table of words without its static_assert", output)


if __name__ == "__main__":
    unittest.main()
