#!/usr/bin/env python3
"""Checkpoints of `wythe run`: killed at any point and resumed, a run ends with the files and the hash of an undisturbed
one. A checkpoint that cannot be used is refused with its name, and nothing is overwritten."""
import json
import os
import re
import signal
import struct
import subprocess
import unittest
import zlib

from cli_test import SMALL, SOURCE, Base, Held, wythe

FILE = "checkpoint.wythe"
HEAD = struct.Struct("<16sIIQQQ")  # magic, format, bytes of program, bytes of content, model, others
# Due whenever the run looks, every 500 steps; a disk takes its time for each. And due when the test is over.
ALWAYS, NEVER = ("--checkpoint", "1 ns"), ("--checkpoint", "1 h")


def hash_of(head, rest):
    """FNV-1a of the head with its own hash as 0, and of the rest."""
    value = 0xcbf29ce484222325
    for byte in HEAD.pack(*head[:5], 0) + rest:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return value


def without_seconds(json_value):
    if isinstance(json_value, dict):
        return {key: without_seconds(value) for key, value in json_value.items() if key != "wall_seconds"}
    return [without_seconds(value) for value in json_value] if isinstance(json_value, list) else json_value


class Checkpoint(Base):
    def setUp(self):
        super().setUp()
        self.path = self.out / FILE

    def begin(self, *options):
        return ("run", self.model(), "--out", self.out, "--quiet", *options)

    def killed(self, point="checkpoint 2 written", *options):
        Held(point, *self.begin(*ALWAYS, *options)).kill()

    def results(self, folder):
        """Every file; of those that say how many seconds the run took, all else."""
        files = {p.name: p.read_bytes() for p in folder.iterdir()}
        summary = without_seconds(json.loads(files.pop("summary.json")))
        data = zlib.decompress(files.pop("report.data"))  # src/report/bundle.cpp
        header_end = 12 + struct.unpack_from("<I", data, 8)[0]
        header = without_seconds(json.loads(data[12:header_end]))
        self.assertGreater(len(files.pop("report.html")), 100_000)  # the same data in a page
        return files, summary, header, data[header_end:]

    def undisturbed(self, *options):
        free = self.folder / "free"
        done = wythe("run", self.model(), "--out", free, "--quiet", *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.results(free)

    def assert_resumes(self, *options, to=None):
        done = wythe("run", "--resume", self.out, "--quiet", *NEVER, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.results(self.out), to or self.undisturbed())

    def test_a_killed_run_ends_as_an_undisturbed_one(self):
        whole = self.undisturbed()
        for point in ("checkpoint 1 ready", "checkpoint 1 written"):
            self.killed(point)
            if point == "checkpoint 1 ready":  # killed before there was one
                self.assertFalse(self.path.exists())
        for point in ("checkpoint 2 ready", "checkpoint 20 written"):  # and killed again after it went on
            Held(point, "run", "--resume", self.out, "--quiet").kill()
            self.assertTrue(self.path.exists())
        self.assert_resumes("--threads", "2", to=whole)

    def test_a_killed_write_leaves_the_last_good_one(self):
        self.killed("checkpoint 3 ready")
        kept = self.path.read_bytes()
        (self.out / ".wythe_new" / f"{FILE}.part1").write_bytes(kept[:1000])  # as a write cut short leaves it
        self.assert_resumes()

    def test_overrides_are_those_of_the_run(self):
        settings = ("--set", "stage.push.until=1 mm", "--set", 'stage.push.targets=["1 mm", "-0.5 mm"]')
        whole = self.undisturbed(*settings)
        self.killed("checkpoint 3 written", *settings)
        self.model().write_text("gone")
        self.assert_resumes(to=whole)

    def test_of_a_blocks_file_none_is_needed(self):
        blocks = [{"id": "base", "polygon": [[0, 0], [0.2, 0], [0.2, 0.2], [0, 0.2]]},
                  {"id": "top", "polygon": [[0, 0.2], [0.2, 0.2], [0.2, 0.4], [0, 0.4]]}]
        file = self.folder / "blocks.json"
        file.write_text(json.dumps({"units": "m", "thickness": 0.2, "blocks": blocks}))
        text = re.sub(r'\[wall\].*?\[material.joint\]',
                      '[wall]\nblocks = "blocks.json"\n[wall.unit]\ndensity = "2000 kg/m^3"\n[material.joint]',
                      SMALL[:SMALL.index("[[stage]]")], count=1, flags=re.S)
        push = '[[stage]]\nname = "gravity"\n[[stage]]\nname = "push"\nat = { block = "top" }\ndirection = "+x"\n' \
               'velocity = "2 mm/s"\nuntil = "0.5 mm"\n'
        model = self.model(text + push, "blocks.toml")
        free = self.folder / "free"
        self.assertEqual(wythe("run", model, "--out", free, "--quiet").returncode, 0)
        Held("checkpoint 3 written", "run", model, "--out", self.out, "--quiet", *ALWAYS).kill()
        file.unlink()
        self.assert_resumes(to=self.results(free))

    def test_an_interrupt_keeps_results_and_checkpoint_and_says_how_to_go_on(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            command = self.begin(*NEVER) if not self.path.exists() else \
                ("run", "--resume", self.out, "--quiet")
            process = subprocess.Popen([os.environ.get("WYTHE", "build/release/wythe"), *map(str, command)], text=True,
                                       stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       env=os.environ | {"WYTHE_TEST_HOLD": "stage push"})
            self.assertEqual(process.stderr.readline(), "held at stage push\n")
            process.send_signal(how)
            said = process.communicate(timeout=300)[0]
            self.assertEqual(process.returncode, 3)
            self.assertIn(f"go on with: wythe run --resume {self.out}", said)
            self.assertEqual(json.loads((self.out / "summary.json").read_text())["status"], "interrupted")
            self.assertTrue(self.path.exists())
        self.assert_resumes()

    def test_a_run_that_ends_leaves_no_checkpoint(self):
        short = ("--set", "stage.push.until=0.1 mm")
        done = wythe(*self.begin(*ALWAYS, *short))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.results(self.out), self.undisturbed(*short))
        done = wythe("run", "--resume", self.out)
        self.assertEqual(done.returncode, 2)
        for words in (FILE, "there is no checkpoint", "came to its end", "--checkpoint"):
            self.assertIn(words, done.stderr)

    def test_a_checkpoint_that_cannot_be_written_does_not_end_the_run(self):
        held = Held("checkpoint 1 written", *self.begin(*ALWAYS, "--set", "stage.push.until=0.1 mm"))
        (self.out / ".wythe_new" / FILE).mkdir()
        said = held.go_on()
        self.assertEqual(held.process.returncode, 0, said)
        self.assertIn("warning: ", said)
        self.assertIn("the run goes on", said)

    def test_a_new_run_or_campaign_does_not_throw_it_away(self):
        self.killed()
        kept = self.path.read_bytes()
        for command in (self.begin(), ("campaign", SOURCE / "examples/tuff_wall/study.toml", "--out", self.out)):
            done = wythe(*command)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(f"wythe run --resume {self.out}", done.stderr)
        self.assertEqual(self.path.read_bytes(), kept)

    def test_a_run_under_way_is_not_resumed_beside_it(self):
        held = Held("checkpoint 2 written", *self.begin(*ALWAYS))
        done = wythe("run", "--resume", self.out)
        held.kill()
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("another wythe is writing its results there", done.stderr)

    def refused_resume(self, *words, options=(), folder=None):
        before = {p.name: p.read_bytes() for p in self.out.iterdir() if p.is_file()}
        done = wythe("run", "--resume", folder or self.out, *options)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertLess(len(done.stderr), 2000)
        self.assertEqual({p.name: p.read_bytes() for p in self.out.iterdir() if p.is_file()}, before)

    def test_options_that_would_change_the_run_are_refused(self):
        self.killed()
        self.refused_resume("--out", "leave it out", options=("--out", self.folder / "other"))
        self.refused_resume("--set", "leave it out", options=("--set", "stage.push.until=1 mm"))
        self.refused_resume("--checkpoint", "1 m", options=("--checkpoint", "1 m"))
        self.refused_resume("--checkpoint", "-1 s", options=("--checkpoint", "-1 s"))
        self.refused_resume("--lang", "xx", options=("--lang", "xx"))
        for command in (("run", self.model()), ("run", "--out", self.out), ("run",)):
            done = wythe(*command)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("--resume DIR", done.stderr)

    def test_another_model_is_refused(self):
        self.killed()
        other = self.model(SMALL.replace('until = "3 mm"', 'until = "2 mm"'), "other.toml")
        done = wythe("run", other, "--resume", self.out)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn(f"{FILE}: is of another model than {other}", done.stderr)
        done = wythe("run", other, "--resume", self.out, "--quiet", *NEVER, "--set",
                     "stage.push.until=3 mm")  # the same
        self.assertEqual(done.returncode, 0, done.stderr)

    def rewritten(self, change, honest=True):
        """The checkpoint with another head or content; `honest`: with a hash that fits."""
        head = list(HEAD.unpack(self.good[:HEAD.size]))
        program = bytearray(self.good[HEAD.size:HEAD.size + head[2]])
        content = bytearray(self.good[HEAD.size + head[2]:])
        change(head, program, content)
        rest = bytes(program + content)
        if honest:
            head[5] = hash_of(head, rest)
        self.path.write_bytes(HEAD.pack(*head) + rest)

    def test_bad_files_are_refused_by_name(self):
        self.killed("checkpoint 1 written", "--set", "wall.length=0.4 m", "--set", "wall.height=0.3 m",
                    "--set", "stage.push.at={ x = \"0 m\", y = \"0.25 m\" }")
        self.good = self.path.read_bytes()
        self.assertEqual(hash_of(HEAD.unpack(self.good[:HEAD.size]), self.good[HEAD.size:]),
                         HEAD.unpack(self.good[:HEAD.size])[5])
        cure = "start the run again"
        for size in (0, 1, 47, 48, 100, len(self.good) // 2, len(self.good) - 1):
            self.path.write_bytes(self.good[:size])
            self.refused_resume(str(self.path), "is empty" if size == 0 else "is cut short", cure)
        self.path.write_bytes(self.good + b"more")
        self.refused_resume("more in it", cure)
        self.path.write_bytes(b"x" * len(self.good))
        self.refused_resume("is no checkpoint of wythe", cure)
        for place in range(HEAD.size, len(self.good), len(self.good) // 40):  # one bit, anywhere
            flipped = bytearray(self.good)
            flipped[place] ^= 1 << place % 8
            self.path.write_bytes(flipped)
            self.refused_resume(f"{self.path}: is damaged", cure)

        def with_format(head, program, content):
            head[1] += 1
        self.rewritten(with_format)
        self.refused_resume("has format 3, this program reads 2")

        def with_program(head, program, content):
            program[:11] = b"wythe 9.9.9"
        self.rewritten(with_program)
        self.refused_resume("was written by wythe 9.9.9", "this is wythe", "go on with that program")

        def with_model(head, program, content):
            head[4] ^= 1
        self.rewritten(with_model)
        self.refused_resume("is of another model than it says", cure)

        # Counts and numbers that no writer writes: after the texts of the order the first of the state is its stage.
        lengths, place, content = [], 0, self.good[HEAD.size + HEAD.unpack(self.good[:HEAD.size])[2]:]
        for _ in range(4):
            lengths.append(place)
            place += 8 + struct.unpack_from("<Q", content, place)[0]
        stage = place + 8

        def with_long_text(head, program, content):
            struct.pack_into("<Q", content, lengths[1], 1 << 60)
        self.rewritten(with_long_text)
        self.refused_resume("is damaged: it says to hold more than there is", cure)

        def with_stage(head, program, content):
            struct.pack_into("<i", content, stage, -1)
        self.rewritten(with_stage)
        self.refused_resume("is damaged: it is in no stage", cure)

        def without_end(head, program, content):
            del content[-8:]
            head[3] -= 8
        self.rewritten(without_end)
        self.refused_resume("is damaged: it ", cure)

    def test_what_is_no_file_is_refused_and_not_waited_for(self):
        self.killed()
        good = self.folder / "good"
        self.path.rename(good)
        self.path.mkdir()
        self.refused_resume(f"{self.path}: is a folder")
        self.path.rmdir()
        os.mkfifo(self.path)
        self.refused_resume(f"{self.path}: is a pipe")
        self.path.unlink()
        self.path.symlink_to(good)
        self.refused_resume(f"{self.path}: is a link")
        self.path.unlink()
        self.path.symlink_to("/dev/zero")
        self.refused_resume(f"{self.path}: is a link")
        self.path.unlink()
        self.refused_resume("there is no checkpoint", folder=self.folder / "nowhere")


if __name__ == "__main__":
    unittest.main(verbosity=1)
