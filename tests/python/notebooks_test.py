#!/usr/bin/python3
"""The notebooks of examples/python run from top to bottom in Jupyter's own kernel, and show the expected output."""
import json
import os
import pathlib
import unittest

import nbclient
import nbformat

BUILD = pathlib.Path(os.environ.get("BUILD", "build/release")).resolve()
SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
NOTEBOOKS = sorted((SOURCE / "examples/python").glob("*.ipynb"))


def run(notebook):
    """The cells of code with their outputs; raises what a cell raises."""
    os.environ["PYTHONPATH"] = str(BUILD / "python")
    os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"
    client = nbclient.NotebookClient(notebook, timeout=600, kernel_name="python3", resources={"metadata": {"path": str(SOURCE)}})
    client.execute()
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def shown(cell, kind):
    return "".join(output.data[kind] for output in cell.outputs if kind in output.get("data", {}))


class Notebooks(unittest.TestCase):
    def test_they_are_kept_without_outputs(self):
        self.assertTrue(NOTEBOOKS)
        for path in NOTEBOOKS:
            for cell in nbformat.read(path, as_version=4).cells:
                self.assertFalse(cell.get("outputs"), path)

    def test_a_wall_rocks_or_slides_as_by_hand(self):
        self.assertEqual([path.name for path in NOTEBOOKS], ["rocks_or_slides.ipynb"], "a test of what another one shows")
        check, result, table, hand = run(nbformat.read(SOURCE / "examples/python/rocks_or_slides.ipynb", as_version=4))
        self.assertIn("<svg", shown(check, "text/html"))
        self.assertEqual(shown(result, "text/html").count("<svg"), 2)  # the curve and the wall
        self.assertIn("sliding", shown(table, "text/html"))
        self.assertIn("rocking", shown(table, "text/html"))
        shares = json.loads(shown(hand, "text/plain"))  # of the force by hand, at 16, 20, ... 36 degrees
        self.assertTrue(all(0.98 < share < 1.01 for share in shares[:2]), shares)
        self.assertTrue(all(0.88 < share < 1.0 for share in shares[2:]), shares)

    def test_a_long_call_shows_a_bar_and_takes_it_away(self):
        heard = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(
            "import wythe, wythe._progress as p\n"
            "p._SHOWN_AFTER = 0\n"
            "drawn, update = [], p._Notebook.hear\n"
            "def hear(self, *args):\n"
            "    update(self, *args)\n"
            "    drawn.append(args)\n"
            "p._Notebook.hear = hear\n"
            "wythe.run('validation/lourenco_dry_stone_wall/model.toml', set={'stage.push.until': '1 mm'})\n"
            "len(drawn) > 0")])
        cell = run(heard)[0]
        self.assertEqual(shown(cell, "text/plain").splitlines()[-1][-4:], "True")
        bars = [o for o in cell.outputs if o.output_type == "display_data"]
        self.assertEqual([o.data["text/html"] for o in bars], [""])  # cleared when the call ended

    def test_a_cell_that_is_stopped_keeps_what_is_done(self):
        stopped = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(
            "import signal, wythe\n"
            "def soon(*heard):\n"
            "    signal.raise_signal(signal.SIGINT)\n"
            "try:\n"
            "    wythe.run('validation/lourenco_dry_stone_wall/model.toml', progress=soon)\n"
            "except wythe.Interrupted as stop:\n"
            "    print(stop.result.status)")])
        cell = run(stopped)[0]
        self.assertEqual(cell.outputs[0].text.strip(), "interrupted")


if __name__ == "__main__":
    unittest.main()
