#!/usr/bin/env python3
"""Standard streams that are closed or full: no result is damaged, no run stops, and lost output is reported."""
import os
import pathlib
import signal
import sys
import subprocess
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from campaign_test import MODEL, STUDY  # noqa: E402
from cli_test import WYTHE  # noqa: E402


class Streams(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "model.toml").write_text(MODEL)
        (self.folder / "study.toml").write_text(STUDY)

    def shell(self, redirection, *arguments):
        """Of the shell, because it can close a stream."""
        return subprocess.run(["sh", "-c", f'exec "$@" {redirection}', "sh", WYTHE, *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True, timeout=300, check=False)

    def test_a_reader_that_has_left_stops_no_computation(self):
        for stream, code in (("stderr", 0), ("stdout", -signal.SIGPIPE)):
            with self.subTest(stream=stream):
                reader, writer = os.pipe()
                os.close(reader)
                self.addCleanup(os.close, writer)
                other = {"stdout": "stderr", "stderr": "stdout"}[stream]
                done = subprocess.run([WYTHE, "campaign", "study.toml", "--samples", "2", "--out", stream], cwd=self.folder,
                                      timeout=300, check=False, **{stream: writer, other: subprocess.PIPE})
                self.assertEqual(done.returncode, code)
                self.assertTrue((self.folder / stream / "report.html").exists())

    def campaign(self, out, redirection=""):
        return self.shell(redirection, "campaign", "study.toml", "--samples", "2", "--out", out)

    def test_closed_streams_give_their_numbers_to_no_file(self):
        self.assertEqual(self.campaign("whole").returncode, 0)
        for number, closed in enumerate((">&-", "2>&-", "<&- >&- 2>&-")):
            with self.subTest(closed=closed):
                out = f"closed_{number}"
                self.assertEqual(self.campaign(out, closed).returncode, 0)
                for name in ("samples.csv", "statistics.json"):
                    self.assertEqual((self.folder / out / name).read_bytes(), (self.folder / "whole" / name).read_bytes(), name)
                self.assertEqual(self.shell("", "store", "check", out).returncode, 0)

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_messages_that_do_not_arrive_stop_nothing(self):
        self.assertEqual(self.campaign("out", "2>/dev/full").returncode, 0)
        self.assertTrue((self.folder / "out/samples.csv").exists())
        wrong = self.shell("2>/dev/full", "check", "none.toml")
        self.assertEqual(wrong.returncode, 2)

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_result_that_does_not_arrive_is_said(self):
        for arguments in (("check", "model.toml"), ("materials",), ("--help",), ("--version",), ("campaign", "study.toml", "--samples", "2", "--out", "out")):
            with self.subTest(arguments=arguments):
                done = self.shell(">/dev/full", *arguments)
                self.assertEqual(done.returncode, 4, done.stderr)
                self.assertIn("standard output: not all could be written", done.stderr)
                self.assertNotIn("mistake of its own", done.stderr)
        self.assertTrue((self.folder / "out/samples.csv").exists())


if __name__ == "__main__":
    unittest.main(verbosity=1)
