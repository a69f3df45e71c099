#!/usr/bin/env python3
"""Three walls end with unchanged state hashes, so no change of build, layout or speed changed a bit.

They change only with the mechanics, and then CHANGELOG, "Numerical changes", gives the reason. They are the same with every set of
kernels, and since elementary functions are our own (src/core/elementary.h), on every machine.
"""
import json
import os
import unittest

from cli_test import SOURCE, Base, wythe

WALLS = [("tuff_wall", "stage.push.until=3 mm", "f7b75320489ebe38"),
         ("tuff_wall", "stage.push.until=6 mm", "6248b2492240990c"),
         ("wall_with_returns", "stage.force.factor=0.02", "53d5a48be3aab4ef")]
LONG = [("wall_with_returns", "stage.force.factor=1", "238dff04fbb6e4cf")]  # half a minute


class ReferenceHashes(Base):
    def test_walls_end_as_they_did(self):
        for number, (example, setting, hash_) in enumerate(WALLS + (LONG if os.environ.get("WYTHE_LONG") else [])):
            with self.subTest(example=example, setting=setting):
                out = self.folder / str(number)
                done = wythe("run", SOURCE / "examples" / example / "model.toml", "--out", out, "--set", setting, "--quiet")
                self.assertIn(done.returncode, (0, 3), done.stderr)
                self.assertEqual(json.loads((out / "summary.json").read_text())["state_hash"], hash_)


if __name__ == "__main__":
    unittest.main()
