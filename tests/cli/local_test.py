#!/usr/bin/env python3
"""wythe limit --assessment of parts out of plane: output, refusals, and results that must not be signed."""
import json
import pathlib
import tempfile
import unittest

from cli_test import SOURCE, wythe

WALL = """
name = "front"
[wall]
length = "2 m"
height = "3 m"
thickness = "{thickness}"
[wall.unit]
length = "500 mm"
height = "250 mm"
split = "none"
density = "1800 kg/m^3"
[material.joint]
normal_stiffness = "20 GPa/m"
shear_stiffness = "8 GPa/m"
tensile_strength = "0 MPa"
cohesion = "0 MPa"
residual_cohesion = "0 MPa"
friction_angle = "40 deg"
residual_friction_angle = "40 deg"
compressive_strength = "{fc}"
[[stage]]
name = "gravity"
[[stage]]
name = "push"
at = {{ x = "0 m", y = "0.4 m", courses = 1 }}
velocity = "10 mm/s"
until = "1 mm"
[assessment]
code = "circolare_2019"
[assessment.spectrum]
kind = "ntc2018"
ground_acceleration = "{ag}"
amplification = 2.5
corner_period = "0.3 s"
"""
FLOOR = '[[floor]]\nname = "roof"\ny = "3 m"\nload = "{load}"\n{bearing}'
PART = '[[assessment.part]]\nname = "front"\n'
SPACE = """
[wall]
height = "1 m"
thickness = "0.2 m"
[wall.unit]
length = "500 mm"
height = "250 mm"
split = "none"
density = "1800 kg/m^3"
[[plan_wall]]
name = "front"
line = [["0 m", "0 m"], ["2 m", "0 m"]]
""" + WALL[WALL.index("[material.joint]"):WALL.index("[[stage]]\nname = \"push\"")] + """
[[stage]]
name = "force"
{direction}
rate = "0.1 1/s"
factor = 1.0
""" + WALL[WALL.index("[assessment]"):]


def wall(rest="", thickness="0.3 m", fc="unlimited", ag="0.5 m/s^2"):
    return WALL.format(thickness=thickness, fc=fc, ag=ag) + rest


class Local(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def limit(self, text, *arguments, code=0):
        model = self.folder / f"{self._testMethodName}.toml"
        model.write_text(text)
        self.out = self.folder / f"{self._testMethodName}_out"
        done = wythe("limit", model, "--out", self.out, "--assessment", *(arguments or ("--only", "parts")))
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.done = done
        return json.loads((self.out / "mechanisms.json").read_text()) if code != 2 else None

    def only(self, text, *arguments):
        data = self.limit(text, *arguments)
        parts = self.named(data) or data["local"]
        self.assertEqual(len(parts), 1, data)
        return parts[0]

    @staticmethod
    def named(data):  # beside those that rules find
        return [part for part in data["local"] if part["by"] != "found"]

    def refused(self, text, *arguments, code=3):
        data = self.limit(text, *arguments, code=code)
        self.assertEqual(self.named(data), [])
        return data["refused"][0]["why"]

    def test_a_wall_that_holds_and_one_that_does_not(self):
        part = self.only(wall())
        self.assertEqual((part["verdict"], part["may_be_signed"], part["by"]), ("holds", True, "found"), part)
        self.assertAlmostEqual(part["alpha0"], 0.1, places=12)
        self.assertIn("carried", part["sentence"])
        self.assertTrue(part["verified"])
        self.assertNotIn("recalled", self.done.stdout + (self.out / "mechanisms.json").read_text())
        self.assertIn("alpha0 0.1000", self.done.stdout)
        self.assertIn("life_safety", self.done.stdout)
        self.assertIn("as a local mechanism", (self.out / "report.html").read_text())
        part = self.only(wall(ag="3 m/s^2"))
        self.assertEqual((part["verdict"], part["may_be_signed"]), ("fails", True))

    def test_rules_look_for_what_named_parts_leave_uncovered(self):
        def names(*parts, code=0):
            text = "".join(f'[[assessment.part]]\nname = "{k}"\n{keys}' for k, keys in enumerate(parts))
            return [(part["name"], part["by"]) for part in self.limit(wall(text), code=code)["local"]]
        self.assertEqual(names('foot = "2.5 m"\n'), [("0", "part"), ("wall", "found")])  # a harmless one
        self.assertEqual(names(""), [("0", "part")])
        halves = ('right = "0.5 m"\n', 'left = "0.5 m"\n')
        self.assertEqual(names(halves[0]), [("0", "part"), ("wall", "found")])
        self.assertEqual(names(*halves), [("0", "part"), ("1", "part")])
        # harmless strips side by side at the head, and a low one all along the foot, say nothing of the wall
        strips = [f'foot = "2.75 m"\nleft = "{0.08 * k:.2f} m"\nright = "{0.08 * k + 0.08:.2f} m"\n' for k in range(12)]
        self.assertIn(("wall", "found"), names(*strips))
        self.assertIn(("wall", "found"), names('head = "0.5 m"\n', code=3))
        # a floor's depth between two parts is none of its own
        self.assertEqual(names('head = "1.4 m"\nhead_held = true\n', 'foot = "1.6 m"\n'), [("0", "part"), ("1", "part")])

    def test_words_of_the_page_are_italian_too(self):
        self.limit(wall(), "--only", "parts", "--lang", "it")
        self.assertIn("verificata come meccanismo locale", (self.out / "report.html").read_text())

    def test_what_asks_for_it_alone(self):
        self.assertEqual(self.limit(wall(), "--only", "lp")["local"], [])

    def test_thickness_gives_the_answer_and_none_is_refused(self):
        self.assertAlmostEqual(self.only(wall(thickness="0.6 m"))["alpha0"], 0.2, places=12)
        self.limit(wall(thickness="0 m"), code=2)
        self.assertIn("thickness", self.done.stderr)

    def test_without_weight_nothing_is_answered(self):
        self.assertIn("gravity is 0", self.refused(wall("[solve]\ngravity = \"0 m/s^2\"\n"), code=0))
        self.limit(wall(PART).replace('density = "1800 kg/m^3"', 'density = "0 kg/m^3"'), code=2)
        self.assertIn("density", self.done.stderr)
        why = self.refused(wall(PART + 'left = "0 m"\nright = "5 m"\n'))
        self.assertIn("assessment.part.front.right", why)
        self.assertIn("write left and right within the wall", why)
        why = self.refused(wall(PART + 'foot = "2 m"\nhead = "4 m"\n'))
        self.assertIn("assessment.part.front.head", why)

    def test_a_part_under_others_has_a_held_head_or_is_refused(self):
        why = self.refused(wall(PART + 'head = "2 m"\n'))
        self.assertIn("would fall along", why)
        self.assertIn("assessment.part.front.head", why)
        part = self.only(wall(PART + 'head = "2 m"\nhead_held = true\n'))
        self.assertTrue(any("press its head" in note for note in part["notes"]))

    def test_ends_in_the_wrong_order_are_faults(self):
        self.limit(wall(PART + 'foot = "2 m"\nhead = "1 m"\n'), code=2)
        self.assertIn("is not above foot", self.done.stderr)
        self.limit(wall(PART + 'left = "1 m"\nright = "1 m"\n'), code=2)
        self.assertIn("is not right of left", self.done.stderr)

    def test_a_tie_without_strength_is_a_fault(self):
        hold = PART + '[[assessment.part.hold]]\nname = "tie"\nheight = "2.5 m"\n'
        self.limit(wall(hold), code=2)
        self.assertIn("what holds needs a strength", self.done.stderr)
        self.limit(wall(hold + 'force = "0 kN"\n'), code=2)
        self.assertIn("force", self.done.stderr)
        why = self.refused(wall(hold.replace("2.5 m", "3.5 m") + 'force = "5 kN"\n'))
        self.assertIn("assessment.part.front.hold.tie.height", why)
        part = self.only(wall(hold + 'force = "500 kN"\ntravel = "1 m"\n'))
        self.assertAlmostEqual(part["alpha0_to_the_end"], part["alpha0"], places=12, msg="it carries the wall until it lets go")
        self.assertAlmostEqual(part["displacement0_mm"], 600, places=9)
        self.assertGreater(part["alpha0"], 10)
        self.assertTrue(any("d0* = 600 mm what holds it fails" in note for note in part["notes"]), part["notes"])
        self.assertIn("where nothing holds it", part["sentence"], "another mechanism comes first")

    def test_a_wall_that_leans_already(self):
        upright, leans = self.only(wall(PART)), self.only(wall(PART + 'lean = "2 deg"\n'))
        self.assertLess(leans["alpha0"], upright["alpha0"])
        part = self.only(wall(PART + 'lean = "6 deg"\n'))  # beyond atan(0.1) = 5.7 degrees
        self.assertLess(part["alpha0"], 0)
        self.assertEqual((part["verdict"], part["may_be_signed"]), ("fails", False))
        self.assertIn("falls by itself", part["sentence"])
        self.assertIn("not to be signed", part["sentence"])

    def test_without_a_spectrum_there_is_capacity_and_no_verdict(self):
        text = wall()
        part = self.only(text[:text.index("[assessment.spectrum]")])
        self.assertEqual((part["verdict"], part["may_be_signed"], part["limit_states"]), ("no demand", False, []))
        self.limit(wall(ag="0 m/s^2"), code=2)
        self.assertIn("ground_acceleration", self.done.stderr)

    def test_floors_take_part_with_their_mass_or_are_asked_for_their_bearing(self):
        floor = FLOOR.format(load="6 kN/m", bearing='bearing = "150 mm"\n')
        bare, loaded = self.only(wall()), self.only(wall(floor))
        self.assertEqual(loaded["floors_kN"], 12)
        self.assertLess(loaded["alpha0"], bare["alpha0"] * 1.2)
        self.assertTrue(any("no floor" in note for note in bare["notes"]))
        why = self.refused(wall(FLOOR.format(load="6 kN/m", bearing="")), code=0)
        self.assertIn("how deep it bears", why)
        self.assertIn("floor roof", why)
        heavy = self.only(wall(FLOOR.format(load="60 kN/m", bearing='bearing = "150 mm"\n')))
        self.assertFalse(heavy["may_be_signed"])
        self.assertIn("depends on where they bear", heavy["sentence"])

    def test_a_piece_of_a_wall_gets_its_own_stretch_of_a_floor(self):
        floor = FLOOR.format(load="12 kN/m", bearing='bearing = "100 mm"\n')
        piece = self.only(wall(floor + PART + 'left = "0.55 m"\nright = "0.95 m"\n'))
        self.assertAlmostEqual(piece["floors_kN"], 12 * 0.4, places=9)
        whole = self.only(wall(floor))["floors_kN"]
        for at in ("0.5 m", "0.75 m", "0.83 m"):
            for load in (floor, floor + 'joists = ["0.5 m", "1.25 m"]\n'.replace("joists", "x = \"0.2 m\"\nwidth = \"1.6 m\"\njoists")):
                load = load.replace('bearing = "100 mm"\n', "") if "joists" in load else load
                bearing = 'bearing = "100 mm"\n'
                halves = [self.only(wall(load + PART + bearing + ends))["floors_kN"] for ends in (f'right = "{at}"\n', f'left = "{at}"\n')]
                self.assertAlmostEqual(sum(halves), whole if "joists" not in load else 12 * 1.6, places=9, msg=(at, halves))
        two = self.only(wall(floor + floor.replace('"roof"', '"snow"').replace("12 kN", "4 kN").replace("100 mm", "200 mm")))
        weight = 1800 * 9.81 * 2 * 3 * 0.3
        self.assertAlmostEqual(two["alpha0"], (weight * 0.15 + 24e3 * 0.25 + 8e3 * 0.2) / (weight * 1.5 + 32e3 * 3), places=9)
        # loads of one size at one place: each floor takes its own, and no more
        two = self.only(wall(floor + floor.replace('"roof"', '"snow"').replace("100 mm", "200 mm")))
        self.assertAlmostEqual(two["alpha0"], (weight * 0.15 + 24e3 * 0.25 + 24e3 * 0.2) / (weight * 1.5 + 48e3 * 3), places=9)
        pressed = wall(floor).replace('[[stage]]\nname = "push"', '[[stage]]\nname = "floors"\npressure = "0.04 MPa"\n[[stage]]\nname = "push"')
        self.assertEqual(self.only(pressed)["floors_kN"], 24)

    def test_heavy_loads_that_are_no_floors_are_not_signed(self):
        pressed = wall().replace('[[stage]]\nname = "push"', '[[stage]]\nname = "floors"\npressure = "{}"\n[[stage]]\nname = "push"')
        light = self.only(pressed.replace("{}", "0.02 MPa"))
        self.assertTrue(light["may_be_signed"], light["cautions"])
        heavy = self.only(pressed.replace("{}", "0.2 MPa"))
        self.assertFalse(heavy["may_be_signed"])
        self.assertIn("loads that are no floors, 120 kN", heavy["sentence"])

    def test_a_steel_frame_is_no_masonry(self):
        door = '[[wall.opening]]\nname = "door"\nx = "0.5 m"\ny = "0 m"\nwidth = "1 m"\nheight = "2 m"\n'
        frame = ('[[frame]]\nname = "F"\nround = "door"\nfeet = "fixed"\nprofile = "HEB 120"\nbeam_profile = "HEB 140"\ncount = 2\n'
                 'grade = "S275"\njoint = "joint"\n')
        for part in (PART, PART + "head_held = true\n"):
            bare, steel = self.only(wall(door + part)), self.only(wall(door + frame + part))
            for key in ("alpha0", "masonry_kN", "hinge_m", "displacement0_mm"):
                self.assertEqual(bare[key], steel[key], key)
            self.assertTrue(any("steel frames are no masonry" in note for note in steel["notes"]))

    def test_a_part_that_falls_inwards_keeps_its_floor(self):
        floor = FLOOR.format(load="6 kN/m", bearing='bearing = "20 mm"\n')
        lost = self.only(wall(floor + PART))
        self.assertTrue(any("off its bearing" in note for note in lost["notes"]))
        kept = self.only(wall(floor + PART + 'falls = "inwards"\n'))
        self.assertFalse(any("off its bearing" in note for note in kept["notes"]))
        state = kept["limit_states"][0]
        self.assertAlmostEqual(state["displacement_mm"], 0.4 * kept["displacement0_mm"], places=9)

    def test_a_state_that_fails_comes_before_one_without_an_answer(self):
        text = wall()
        text = text[:text.index("[assessment.spectrum]")] + """
[assessment.spectrum]
kind = "table"
corner_period = "0.3 s"
periods = ["0 s", "0.1 s", "0.5 s"]
accelerations = ["1.2 m/s^2", "3 m/s^2", "2 m/s^2"]
[assessment.spectra.near_collapse]
kind = "ntc2018"
ground_acceleration = "9 m/s^2"
amplification = 2.5
corner_period = "0.5 s"
"""
        part = self.only(text)
        self.assertEqual((part["verdict"], part["may_be_signed"]), ("fails", False))
        self.assertIn("near collapse", part["sentence"])

    def test_a_building_without_damping_is_refused(self):
        text = wall(PART + 'foot = "1 m"\n').replace('corner_period = "0.3 s"', 'corner_period = "0.3 s"\ndamping = 0')
        self.assertIn("assessment.spectrum.damping", self.refused(text))

    def test_a_wall_that_is_drawn_alone_stands_where_the_building_has_it(self):
        building = "building = {{ height = \"11 m\", storeys = 3{} }}\n".format
        alone = wall(PART).replace('[assessment.spectrum]', building("") + "[assessment.spectrum]")
        part = self.only(alone)
        self.assertEqual(part["building"]["part_at_m"], 0)
        self.assertTrue(any("building.base" in note for note in part["notes"]))
        part = self.only(alone.replace("storeys = 3", 'storeys = 3, base = "8 m"'))
        self.assertEqual((part["building"]["part_at_m"], part["building"]["height_m"]), (8, 11))
        self.assertFalse(any("building.base" in note for note in part["notes"]))
        self.assertAlmostEqual(part["building"]["share_of_first_mode"], 9 / 7 * 8 / 11, places=9)

    def test_ties_let_go_one_at_a_time(self):
        tie = '[[assessment.part.hold]]\nname = "{}"\nheight = "{}"\nforce = "{}"\ntravel = "{}"\n'
        long, short = tie.format("B", "1 m", "3 kN", "200 mm"), tie.format("A", "2.8 m", "12 kN", "20 mm")
        one, both = self.only(wall(PART + long)), self.only(wall(PART + short + long))
        self.assertGreater(one["alpha0_to_the_end"], 0.15, "it holds to the end")
        self.assertEqual(both["alpha0_to_the_end"], one["alpha0_to_the_end"])
        self.assertEqual(both["displacement0_mm"], one["displacement0_mm"])

    def test_parts_of_one_name_and_teeth_beyond_the_part_are_refused(self):
        self.limit(wall(PART + PART), code=2)
        self.assertIn("two parts have this name", self.done.stderr)
        teeth = PART + 'teeth = {{ corners = 2, length = "{}", course = "250 mm", friction = 0.5 }}\n'
        self.assertIn("assessment.part.front.teeth.length", self.refused(wall(teeth.format("1.1 m"))))
        self.only(wall(teeth.format("0.9 m")))

    def test_masonry_that_crushes_moves_the_line_and_asks_for_a_factor(self):
        crushing = '{}"\ncompressive_energy = "40000 N/m'
        soft = self.only(wall(fc=crushing.format("0.2 MPa")))
        weight = 1800 * 9.81 * 2 * 3 * 0.3
        inset = weight / (2 * 0.85 * 0.2e6 * 2)
        self.assertAlmostEqual(soft["inset_mm"], 1e3 * inset, places=6)
        self.assertAlmostEqual(soft["alpha0"], (0.15 - inset) / 1.5, places=9)
        self.assertFalse(soft["may_be_signed"], "no confidence factor is stated")
        stated = wall(fc=crushing.format("0.2 MPa")).replace("[assessment]\n", "[assessment]\nconfidence_factor = 1.2\n")
        self.assertTrue(self.only(stated)["may_be_signed"])
        self.assertIn("crushes under its load", self.refused(wall(fc=crushing.format("0.02 MPa")), code=0))

    def test_in_space_the_mechanism_is_that_of_the_body_force(self):
        part = self.only(SPACE.format(direction='direction = "-z"', fc="unlimited", ag="0.5 m/s^2"), "--only", "lp")
        self.assertAlmostEqual(part["alpha0"], 0.2, places=6)
        self.assertAlmostEqual(part["participating_mass_share"], 1, places=6)
        self.assertTrue(part["may_be_signed"], part["cautions"])
        askew = self.only(SPACE.format(direction="along = [0.7, 0, -0.7]", fc="unlimited", ag="0.5 m/s^2"), "--only", "lp")
        self.assertFalse(askew["may_be_signed"])
        self.assertIn("45 degrees off", askew["sentence"])
        self.limit(SPACE.format(direction='direction = "-z"', fc="unlimited", ag="0.5 m/s^2") + PART, "--only", "lp", "parts", code=3)
        self.assertIn("in space the mechanism comes from a body force", self.done.stderr)

    def test_of_several_pieces_the_onset_is_without_the_share_of_mass(self):
        model = pathlib.Path(SOURCE) / "examples/wall_with_returns/model.toml"
        self.out = self.folder / "returns"
        done = wythe("limit", model, "--out", self.out, "--assessment", "--only", "lp")
        self.assertEqual(done.returncode, 0, done.stderr)
        part = json.loads((self.out / "mechanisms.json").read_text())["local"][0]
        self.assertAlmostEqual(part["acceleration0_m_per_s2"], part["alpha0"] * 9.81 / 1.35, places=9)
        self.assertLess(part["participating_mass_share"], 1)
        self.assertIsNone(part["displacement0_mm"])
        self.assertTrue(any("pieces move against each other" in note for note in part["notes"]))
        self.assertEqual((part["verdict"], part["may_be_signed"]), ("no demand", False))

    def test_loads_in_space_are_pushed_with_the_wall(self):
        text = SPACE.format(direction='direction = "-z"', fc="unlimited", ag="0.5 m/s^2")
        floor = '[[floor]]\nname = "roof"\nload = "6 kN/m"\nfrom = { x = "0 m", y = "1 m", z = "0 m" }\nto = { x = "2 m", y = "1 m", z = "0 m" }\n'
        data = self.limit(text + floor, "--only", "lp")
        part = data["local"][0]
        self.assertEqual(part["by"], "dry, loads are masses")
        weight, load = 1800 * 9.81 * 2 * 0.2, 12e3
        self.assertAlmostEqual(part["alpha0"], (weight + load) * 0.1 / (weight * 0.5 + load * 1), places=6)
        loads = {l["name"]: l["static"] for l in data["limit_loads"]}
        self.assertLess(loads["dry, loads are masses"], loads["dry"])
        self.assertTrue(any("press the wall and are not pushed" in note for note in data["notes"]), data["notes"])
        data = self.limit(text + floor.replace('load = "6 kN/m"', 'mass = "600 kg/m"'), "--only", "lp")
        self.assertTrue(any("1200 kg without a load" in note for note in data["notes"]), data["notes"])
        self.assertFalse(data["local"][0]["may_be_signed"])


if __name__ == "__main__":
    unittest.main()
