#!/usr/bin/env python3
"""Hostile input on the command line: refused with file, cause and cure, in little memory, nothing written."""
import json
import os
import pathlib
import resource
import sqlite3
import struct
import subprocess
import sys
import unittest
import zlib

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from cli_test import SMALL, WYTHE, Base  # noqa: E402

MEMORY = 1_500_000_000  # address space of each command: far below what the files claim [bytes]

LAW = "[material.joint]\n" + SMALL.split("[material.joint]")[1].split("[material.unit]")[0]


def wythe(*arguments):
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    return subprocess.run([WYTHE, *map(str, arguments)], capture_output=True, text=True, timeout=120, preexec_fn=limit)


def bomb(header, size):
    """A report's data of `size` zero bytes behind its header, packed to a thousandth."""
    text = json.dumps(header).encode()
    head = b"WYTHE\0\0\2" + struct.pack("<I", len(text)) + text
    packer = zlib.compressobj(9)
    out = packer.compress(head) + packer.flush(zlib.Z_FULL_FLUSH)
    piece = 1 << 24
    packer.compress(bytes(piece)), packer.flush(zlib.Z_FULL_FLUSH)  # no window before: each piece packs alike
    same = packer.compress(bytes(piece)) + packer.flush(zlib.Z_FULL_FLUSH)
    return out + same * (size // piece)


class Hostile(Base):
    def refuses(self, *arguments, words=(), codes=(2,)):
        done = wythe(*arguments)
        self.assertIn(done.returncode, codes, done.stderr[:2000])
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertLess(len(done.stderr), 50_000)
        return done.stderr

    def test_what_is_no_file_is_refused_by_every_command(self):
        os.mkfifo(self.folder / "pipe")
        os.mkdir(self.folder / "folder")
        law = self.model(LAW, "law.toml")
        for path, kind in ((self.folder / "pipe", "a pipe"), (self.folder / "folder", "a folder"), ("/dev/zero", "a device")):
            for command in (["check", path], ["run", path, "--out", self.out], ["limit", path, "--out", self.out],
                            ["campaign", path, "--out", self.out], ["contact", path, "--path", path, "--out", self.out],
                            ["contact", law, "--path", path, "--out", self.out]):
                self.refuses(*command, words=(str(path), f"is {kind}, not a file; "))
        self.assertFalse(self.out.exists())

    def test_blocks_models_and_values_named_in_a_file_are_read_the_same_way(self):
        os.mkfifo(self.folder / "pipe")
        model = self.model(SMALL.replace("[wall]", '[wall]\nblocks = "pipe"', 1))
        self.refuses("check", model, words=("pipe: wall.blocks: is a pipe",))
        study = self.model('[study]\nmodel = "pipe"\nsamples = 4\nseed = 1\n', "study.toml")
        self.refuses("check", study, words=("study.toml:2: study.model", "is a pipe"))
        self.model()
        study = self.model('[study]\nmodel = "model.toml"\nsamples = 4\nseed = 1\n[variable.ft]\ndistribution = "empirical"\n'
                           'path = "material.joint.tensile_strength"\nfile = "pipe"\n', "study.toml")
        self.refuses("check", study, words=("study.toml:8: variable.ft.file", "is a pipe"))

    def test_deep_and_endless_texts(self):
        for text in ("a" + ".a" * 50_000 + " = 1\n", "[a" + ".a" * 50_000 + "]\n", "a = " + "[" * 100_000 + "]" * 100_000,
                     "".join(f"wall.k{i} = 1\n" for i in range(50_000))):
            self.refuses("check", self.model(text), words=("model.toml:", "limits.md"))
        model = self.model(SMALL.replace("[wall]", '[wall]\nblocks = "b.json"', 1))
        (self.folder / "b.json").write_text('{"units": "m", "blocks":' + "[" * 100_000 + "]" * 100_000 + "}")
        self.refuses("check", model, words=("b.json:1: wall.blocks: nests deeper than 32 levels",))
        (self.folder / "b.json").write_text('{"units": "m", "blocks": [' + "0," * 15_000_000 + "0]}")
        self.refuses("check", model, words=("b.json: wall.blocks.0", "mend these first"))
        self.refuses("check", model, "--set", "a" + ".a" * 50_000 + "=1", words=("--set", "50001 steps"))

    def test_a_bundle_of_four_gigabytes_in_four_million_bytes(self):
        os.mkdir(self.out)
        size = 1 << 32
        for count in (size, 8):  # that the header states, and hides
            header = {"kind": "run", "summary": {}, "arrays": {"x": {"type": "uint8", "at": 0, "count": count}}}
            data = bomb(header, size)
            self.assertLess(len(data), 5_000_000)
            (self.out / "report.data").write_bytes(data)
            self.refuses("report", self.out, words=("report.data: the data of a report", "run the model again"), codes=(4,))
        self.assertEqual(os.listdir(self.out), ["report.data"])

    def test_data_of_a_report_that_lack_their_parts(self):
        os.mkdir(self.out)
        for header in ({"kind": "run"}, {"kind": 3, "arrays": {}}, {"kind": "run", "arrays": {"x": 1}}, [], 1, "x",
                       {"kind": "run", "arrays": {"x": {"type": "uint8", "at": -8, "count": -1e300}}},
                       {"kind": "other", "arrays": {}}, {"kind": "limit", "arrays": {}},
                       {"kind": "campaign", "arrays": {}, "statistics": {"samples": "x"}}):
            text = json.dumps(header).encode()
            (self.out / "report.data").write_bytes(zlib.compress(b"WYTHE\0\0\2" + struct.pack("<I", len(text)) + text))
            self.refuses("report", self.out, words=("report.data: the data of a report are damaged",), codes=(4,))
        (self.out / "report.data").write_bytes(zlib.compress(b"WYTHE\0\0\2" + struct.pack("<I", 2**32 - 1)))
        self.refuses("report", self.out, words=("report.data",), codes=(4,))

    def test_a_link_among_results_is_not_followed(self):
        (self.folder / "mine").write_text("mine")
        os.mkdir(self.out)
        (self.out / "force_displacement.csv").write_text("old")
        os.symlink("../mine", self.out / "summary.json")
        self.refuses("run", self.model(), "--out", self.out, words=("summary.json: is a link to ../mine", "remove it"))
        os.symlink("mine", self.folder / "link.csv")
        path = self.model("opening_mm,slip_mm\n0,0\n", "path.csv")
        self.refuses("contact", self.model(LAW, "law.toml"), "--path", path, "--out", self.folder / "link.csv",
                     words=("link.csv: is a link",))
        self.assertEqual((self.folder / "mine").read_text(), "mine")

    def test_stores_that_are_none(self):
        os.mkdir(self.out)
        store = self.out / "campaign.db"
        for make, kind in ((os.mkfifo, "a pipe"), (os.mkdir, "a folder"), (lambda p: os.symlink("/dev/zero", p), "a device")):
            make(store)
            self.refuses("report", self.out, words=(f"campaign.db: is {kind}",))
            store.rmdir() if store.is_dir() else store.unlink()


if __name__ == "__main__":
    unittest.main(verbosity=1)
