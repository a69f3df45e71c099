"""Drawings (DXF) from another program: read with the same result, or refused with the reason.

Exit 77 where ezdxf or wythe is absent."""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest

try:
    import ezdxf
    from ezdxf.math import bulge_to_arc
except ImportError:
    # the distribution's own python has the package where another one comes first in PATH
    if sys.executable != "/usr/bin/python3" and os.path.exists("/usr/bin/python3"):
        os.execv("/usr/bin/python3", ["/usr/bin/python3", __file__, *sys.argv[1:]])
    print("python3-ezdxf is not installed")
    sys.exit(77)

WYTHE = os.environ.get("WYTHE", "")
if not os.path.exists(WYTHE):
    print("WYTHE names no program")
    sys.exit(77)

MODEL = """
stage = [{ name = "gravity" }]
[wall]
blocks = "stones.dxf"
thickness = "0.3 m"
unit = { density = "2000 kg/m^3" }
%s
[material.tuff]
density = "1500 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "35 deg"
residual_friction_angle = "35 deg"
compressive_strength = "unlimited"
"""
# Two courses on a support, in millimetres; by layer.
STONES = [("fixed", [(0, -100), (1000, -100), (1000, 0), (0, 0)]),
          ("0", [(0, 0), (412.5, 0), (390.25, 200), (0, 200)]),
          ("tuff", [(412.5, 0), (1000, 0), (1000, 200), (390.25, 200)]),
          ("0", [(0, 200), (1000, 200), (1000, 400), (500, 450.125), (0, 400)])]
RELEASES = ["R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"]


def drawing(release="R2010", insunits=4):
    doc = ezdxf.new(release)
    doc.header["$INSUNITS"] = insunits
    return doc


def draw(doc, layer, corners, close=True):
    space = doc.modelspace()
    if doc.dxfversion == "AC1009":
        return space.add_polyline2d(corners, close=close, dxfattribs={"layer": layer})
    return space.add_lwpolyline(corners, close=close, dxfattribs={"layer": layer})


class Drawings(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.at = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def wythe(self, *arguments):
        return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True,
                              cwd=self.at, check=False)

    def stones(self, doc, more=""):
        doc.saveas(self.at / "stones.dxf")
        (self.at / "model.toml").write_text(MODEL % more)
        return self.wythe("run", "model.toml", "--out", "out", "--quiet")

    def read_again(self):
        """Polygons by layer as ezdxf reads the file."""
        found = []
        for entity in ezdxf.readfile(self.at / "stones.dxf").modelspace():
            if entity.dxftype() == "LWPOLYLINE":
                corners = [(x, y) for x, y in entity.get_points("xy")]
            else:
                corners = [(v.dxf.location.x, v.dxf.location.y) for v in entity.vertices]
            found.append((entity.dxf.layer, corners))
        return found

    def test_stones_are_those_that_another_reader_finds(self):
        for release in RELEASES:
            with self.subTest(release):
                doc = drawing(release)
                for layer, corners in STONES:
                    draw(doc, layer, corners)
                done = self.stones(doc, 'blocks_unit = "mm"' if release == "R12" else "")
                self.assertEqual(done.returncode, 0, done.stderr)
                blocks = json.loads((self.at / "out" / "blocks.json").read_text())["blocks"]
                again = self.read_again()
                self.assertEqual(len(blocks), len(again))
                for block, (layer, corners) in zip(blocks, again):
                    self.assertEqual(block["fixed"], layer == "fixed")
                    self.assertEqual(block["material"], {"0": "masonry"}.get(layer, layer))
                    self.assertEqual(block["polygon"], [[x / 1000, y / 1000] for x, y in corners])

    def test_units_are_metres_by_the_file_or_by_the_key(self):
        for insunits, key, per_metre in [(6, "", 1), (5, "", 100), (4, "", 1000), (0, "mm", 1000),
                                         (4, "mm", 1000), (1, "", 1 / 0.0254)]:
            doc = drawing(insunits=insunits)
            for layer, corners in STONES:
                draw(doc, layer, [(x / 1000 * per_metre, y / 1000 * per_metre) for x, y in corners])
            done = self.stones(doc, f'blocks_unit = "{key}"' if key else "")
            self.assertEqual(done.returncode, 0, done.stderr)
            summary = json.loads((self.at / "out" / "blocks.json").read_text())
            self.assertAlmostEqual(summary["blocks"][0]["polygon"][1][0], 1, places=9)
        done = self.stones(drawing(insunits=6), 'blocks_unit = "mm"')
        self.assertEqual(done.returncode, 2)
        self.assertIn("the drawing, which states m", done.stderr)
        done = self.stones(drawing(insunits=0))
        self.assertEqual(done.returncode, 2)
        self.assertIn("does not say its unit", done.stderr)
        self.assertIn("blocks_unit", done.stderr)

    def notes(self, doc):
        self.assertEqual(self.stones(doc).returncode, 0)
        return self.wythe("check", "model.toml").stdout

    def thick(self, thickness, insunits=4, per_metre=1000):
        doc = drawing(insunits=insunits)
        for layer, corners in STONES:
            corners = [(x / 1000 * per_metre, y / 1000 * per_metre) for x, y in corners]
            draw(doc, layer, corners).dxf.thickness = thickness
        return doc

    def test_a_thickness_of_the_drawing_is_told(self):
        self.assertIn("outlines have a thickness of their own (4, the first 450 mm); it is left aside, and the wall is 0.3 m thick",
                      self.notes(self.thick(450)))
        self.assertIn("the first 0.45 m", self.notes(self.thick(0.45, 6, 1)))
        for same in (0, 300, -300):
            self.assertNotIn("thickness of their own", self.notes(self.thick(same)))

    def test_a_drawing_in_millimetres_that_says_metres(self):
        said = self.notes(self.thick(0, 6))
        self.assertIn("the wall is 450.1 m high, more than any masonry wall: if stones.dxf is drawn in millimetres, set that as its unit", said)
        self.assertNotIn("in a blocks file", said)

    def test_an_outline_that_is_drawn_twice_is_one_fault(self):
        for again in (STONES[1:2], STONES[1:], STONES):
            doc = drawing()
            for layer, corners in STONES + again:
                draw(doc, layer, corners)
            done = self.stones(doc)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn("given twice", done.stderr)

    def test_what_is_no_outline_is_named_with_layer_and_line(self):
        spoilers = {
            "SPLINE": lambda s, a: s.add_spline([(0, 0), (1, 1), (2, 0)], dxfattribs=a),
            "LINE": lambda s, a: s.add_line((0, 0), (1, 1), dxfattribs=a),
            "CIRCLE": lambda s, a: s.add_circle((0, 0), 1, dxfattribs=a),
            "ARC": lambda s, a: s.add_arc((0, 0), 1, 0, 90, dxfattribs=a),
            "ELLIPSE": lambda s, a: s.add_ellipse((0, 0), (1, 0), 0.5, dxfattribs=a),
            "INSERT": lambda s, a: s.add_blockref("STONE", (0, 0), dxfattribs=a),
            "HATCH": lambda s, a: s.add_hatch(dxfattribs=a),
            "3DFACE": lambda s, a: s.add_3dface([(0, 0), (1, 0), (1, 1)], dxfattribs=a),
            "POLYLINE": lambda s, a: s.add_polyline3d([(0, 0, 0), (1, 0, 1), (1, 1, 0)], dxfattribs=a),
            "is open": lambda s, a: s.add_lwpolyline([(0, 0), (1, 0), (1, 1)], dxfattribs=a),
            "more than 360 chords": lambda s, a: s.add_lwpolyline(
                [(0, 0, 0.5), (8e6, 0, 0), (1, 1, 0)], format="xyb", close=True, dxfattribs=a),
            "another plane": lambda s, a: s.add_lwpolyline(
                [(0, 0), (1, 0), (1, 1)], close=True, dxfattribs={**a, "extrusion": (0, -1, 0)}),
        }
        for words, add in spoilers.items():
            with self.subTest(words):
                doc = drawing()
                doc.blocks.new("STONE")
                for layer, corners in STONES:
                    draw(doc, layer, corners)
                entity = add(doc.modelspace(), {"layer": "odd ones"})
                done = self.stones(doc)
                self.assertEqual(done.returncode, 2, done.stdout)
                for word in [words, "odd ones", entity.dxf.handle, "stones.dxf:"]:
                    self.assertIn(word, done.stderr)

    def test_arcs_of_a_polyline_are_chords_within_a_millimetre_of_what_another_reader_finds(self):
        """An arch stone of two arcs on its bed, in R12 and later; the two share the lower arc."""
        extrados, intrados = [(0, 400, -0.41), (1000, 400, 1e-15)], [(800, 200, 0.2), (200, 200, 0)]
        lower = [(200, 200, -0.2), (800, 200, 0), (800, 0, 0), (200, 0, 0)]
        for release in ["R12", "R2010"]:
            with self.subTest(release):
                doc = drawing(release)
                for points in (extrados + intrados, lower):
                    if release == "R12":
                        doc.modelspace().add_polyline2d(points, format="xyb", close=True)
                    else:
                        doc.modelspace().add_lwpolyline(points, format="xyb", close=True)
                done = self.stones(doc, 'blocks_unit = "mm"' if release == "R12" else "")
                self.assertEqual(done.returncode, 0, done.stderr)
                arch, bed = json.loads((self.at / "out" / "blocks.json").read_text())["blocks"]
                for points, block in ((extrados + intrados, arch), (lower, bed)):
                    self.compare_arcs(points, [(1e3 * x, 1e3 * y) for x, y in block["polygon"]])
                shared = lambda b: sorted((round(x, 9), round(y, 9)) for x, y in b["polygon"]
                                          if 0.2 <= x <= 0.8 and y >= 0.2 - 1e-9 and y < 0.3)
                self.assertEqual(shared(arch), shared(bed))
                self.assertGreater(len(shared(arch)), 4)

    def compare_arcs(self, points, corners):
        """Every corner lies on the arc that ezdxf makes of the bulge, every chord within 1 mm of it."""
        found = 0
        turn = lambda p: sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(p, p[1:] + p[:1])) > 0
        if turn(points) != turn(corners):
            corners = corners[::-1]
        for (x0, y0, bulge), (x1, y1, _) in zip(points, points[1:] + points[:1]):
            start = min(range(len(corners)), key=lambda i: math.dist(corners[i], (x0, y0)))
            chain = [corners[start]]
            while math.dist(chain[-1], (x1, y1)) > 1e-6:
                chain.append(corners[(start + len(chain)) % len(corners)])
            found += len(chain) - 1
            if abs(bulge) < 1e-9:
                self.assertEqual(len(chain), 2)
                continue
            centre, _, _, radius = bulge_to_arc((x0, y0), (x1, y1), bulge)
            for x, y in chain:
                self.assertAlmostEqual(math.dist((x, y), centre), radius, places=6)
            for a, b in zip(chain, chain[1:]):
                middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
                self.assertLess(radius - math.dist(middle, centre), 1.0 + 1e-6)
        self.assertEqual(found, len(corners))

    def test_texts_dimensions_and_sheets_are_left_aside(self):
        doc = drawing()
        for layer, corners in STONES:
            draw(doc, layer, corners)
        doc.modelspace().add_text("Mauerwerk, Süd")
        doc.modelspace().add_mtext("two\nlines")
        doc.modelspace().add_point((3, 3))
        doc.layout("Layout1").add_line((0, 0), (1, 1))
        self.assertEqual(self.stones(doc).returncode, 0)

    def facade(self, change=None, **options):
        doc = drawing()
        draw(doc, "OUTLINE", [(100, 50), (9700, 50), (9700, 6450), (100, 6450)])
        draw(doc, "openings", [(1300, 850), (2400, 850), (2400, 2350), (1300, 2350)])
        draw(doc, "openings", [(4300, 50), (5500, 50), (5500, 2350), (4300, 2350), (4300, 50)], close=False)
        draw(doc, "lintels", [(1100, 2350), (2600, 2350), (2600, 2550), (1100, 2550)])
        draw(doc, "furniture", [(0, 0), (1, 0), (1, 1)])
        if change:
            change(doc)
        doc.saveas(self.at / "facade.dxf")
        return self.wythe("drawing", "facade.dxf", *[t for o in options.items() for t in (f"--{o[0]}", o[1])])

    def test_a_facade_becomes_a_wall_with_its_openings(self):
        done = self.facade()
        self.assertEqual(done.returncode, 0, done.stderr)
        wall = tomllib.loads(done.stdout)["wall"]
        self.assertEqual((wall["length"], wall["height"], wall["fit"]), ("9.6 m", "6.4 m", "cut"))
        door, window = wall["opening"]
        self.assertEqual([door[k] for k in ("x", "y", "width", "height")],
                         ["4.2 m", "0.0 m", "1.2 m", "2.3 m"])
        self.assertEqual([window[k] for k in ("x", "y", "width", "height")],
                         ["1.2 m", "0.8 m", "1.1 m", "1.5 m"])
        self.assertEqual((window["lintel"]["depth"], window["lintel"]["bearing"]), ("0.2 m", "0.2 m"))
        self.assertIn("layer furniture, 1 closed", done.stdout)

    def test_a_facade_that_cannot_be_read_says_where_and_how_to_cure_it(self):
        faults = {
            "up to its springing": lambda d: draw(d, "openings", [(6000, 900), (7000, 900), (7000, 2000), (6500, 2300), (6000, 2000)]),
            "reaches outside": lambda d: draw(d, "openings", [(9000, 900), (9900, 900), (9900, 2000), (9000, 2000)]),
            "lies on no opening": lambda d: draw(d, "lintels", [(7000, 3000), (8000, 3000), (8000, 3200), (7000, 3200)]),
            "second outline": lambda d: draw(d, "outline", [(0, 0), (100, 0), (100, 100), (0, 100)]),
            "SPLINE": lambda d: d.modelspace().add_spline([(0, 0), (1, 1), (2, 0)], dxfattribs={"layer": "openings"}),
        }
        for words, change in faults.items():
            done = self.facade(change)
            self.assertEqual(done.returncode, 2, words)
            self.assertIn(words, done.stderr)
        done = self.facade(openings="windows")
        self.assertEqual(done.returncode, 2)
        for word in ["windows", "OUTLINE", "furniture", "--openings"]:
            self.assertIn(word, done.stderr)


if __name__ == "__main__":
    unittest.main()
