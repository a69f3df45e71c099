#!/usr/bin/env python3
"""Campaigns as arrays of Slurm: the scripts, the remaining tasks, and a cluster of one node that runs them."""
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import socket
import sqlite3
import subprocess
import tempfile
import time
import unittest

from campaign_test import Base
from cli_test import SOURCE, WYTHE, wythe
from store_commands_test import hold_lock, tree

PROGRAM = pathlib.Path(WYTHE).resolve()
LONG = 600  # [s], for what does not come: no test waits for a time


def wait_for(event, what):
    end = time.monotonic() + LONG
    while time.monotonic() < end:
        found = event()
        if found:
            return found
        time.sleep(0.1)
    raise AssertionError(f"{what}: not within {LONG} s")


def designs(out):
    """Sizes of the designs that each store below a folder holds."""
    found = {}
    for path in sorted(out.rglob("campaign.db")):
        with sqlite3.connect(path) as store:
            found[str(path.parent.relative_to(out))] = store.execute(
                "SELECT value FROM study WHERE key = 'samples'").fetchone()[0].split("\n")
        store.close()
    return found


def commands(folder, **bodies):
    """Programs of these names in front of PATH; each writes its folder and its words into NAME.log, then runs its lines."""
    folder.mkdir()
    for name, body in bodies.items():
        file = folder / name
        file.write_text(f"""#!/usr/bin/python3
import json, os, subprocess, sys
with open(__file__ + ".log", "a") as log:
    log.write(json.dumps([os.getcwd()] + sys.argv[1:]) + "\\n")
{body}
""")
        file.chmod(0o755)
    return dict(os.environ, PATH=f"{folder}:{os.environ['PATH']}")


def words(folder, name):
    log = folder / f"{name}.log"
    return [json.loads(line) for line in log.read_text().splitlines()] if log.exists() else []


# sbatch that runs each task of an array at once, as Slurm would, then the join
SBATCH = """
import re
script = [w for w in sys.argv[1:] if w.endswith(".sh")][0]
text = open(script).read()
array = re.search(r"^#SBATCH --array=(.*)$", text, re.M)
for part in array.group(1).split(",") if array else []:
    first, _, last = part.partition("-")
    for task in range(int(first), int(last or first) + 1):
        subprocess.run(["sh", script], env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(task)), stdout=subprocess.DEVNULL, check=True)
if not array:
    subprocess.run(["sh", script] + sys.argv[sys.argv.index(script) + 1:], stdout=subprocess.DEVNULL, check=True)
print("17;cluster" if "--parsable" in sys.argv else "Submitted batch job 18")
"""


class Scripts(Base):
    """Without a cluster: the scripts are run as Slurm would."""

    def hand_in(self, *more, out=None, study=None):
        return wythe("campaign", study or self.study, "--out", out or self.out(), "--slurm", "3", *more)

    def written(self, *more, out=None, study=None):
        done = self.hand_in(*more, out=out, study=study)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def run_task(self, task, out=None, **more):
        script = (out or self.out()) / "slurm" / "array.sh"
        return subprocess.run(["sh", script], env=dict(os.environ, SLURM_ARRAY_TASK_ID=str(task), **more),
                              capture_output=True, text=True, check=False)

    def run_tasks(self, *tasks, out=None):
        for task in tasks:
            done = self.run_task(task, out)
            self.assertEqual(done.returncode, 0, done.stderr)

    def join(self, out=None):
        done = subprocess.run(["sh", (out or self.out()) / "slurm" / "merge.sh"], capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def array(self):
        found = re.search(r"^#SBATCH --array=(.*)$", (self.out() / "slurm/array.sh").read_text(), re.M)
        return found.group(1) if found else ""

    def own_study(self, name="own"):
        """A study and a model that a test may change."""
        folder = self.folder / f"{self._testMethodName}_{name}"
        folder.mkdir()
        (folder / "model.toml").write_text(self.model)
        (folder / f"{name}.toml").write_text(self.study_text)
        return folder / f"{name}.toml"

    def changed(self, study, old, new):
        self.assertIn(old, study.read_text())
        study.write_text(study.read_text().replace(old, new))

    def test_tasks_and_their_join_give_the_bytes_of_the_whole(self):
        said = self.written("--cores", "1")
        self.assertIn("3 of 3 tasks have samples left: 1-3", said)
        self.run_tasks(3, 1, 2)
        self.join()
        self.assert_equals_whole(self.out())
        self.assertIn("all samples have run", self.written("--cores", "1"))
        self.assertEqual(self.array(), "")

    def test_workstation_runs_the_tasks_without_slurm(self):
        self.written("--cores", "1")
        script = shlex.quote(str(self.out() / "slurm/array.sh"))
        for _ in range(2):  # a second time there is nothing to do
            done = subprocess.run(["sh", "-c", f"seq 3 | xargs -P 2 -I{{}} env SLURM_ARRAY_TASK_ID={{}} sh {script}"],
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.join()
        self.assert_equals_whole(self.out())

    def test_only_what_is_missing_is_handed_in_again(self):
        self.written()
        self.run_task(2)
        self.assertIn("2 of 3 tasks have samples left: 1,3", self.written())
        self.assertEqual(self.array(), "1,3")

    def test_stores_of_all_shards_are_there_at_hand_in(self):
        self.written()
        self.assertEqual(designs(self.out()), {f"shards/{i}": ["6"] for i in (1, 2, 3)})
        done = wythe("status", self.out())
        self.assertEqual(done.returncode, 3)
        self.assertEqual(done.stdout.splitlines(), [
            f"shard {i}: 0 of 2 samples, not begun; time left not known yet" for i in (1, 2, 3)] + [
            "all: 0 of 6 samples, 3 not running; time left not known yet"])

    def test_study_changed_after_hand_in_is_refused_by_the_tasks(self):
        study = self.own_study()
        self.written(study=study)
        self.run_tasks(1)
        self.changed(study, 'mean = "0.15 MPa"', 'mean = "0.20 MPa"')
        before = tree(self.out())
        self.refused(self.run_task(2), 2, "variable.ft.mean", "was 150000 Pa", "is 200000 Pa now")
        self.refused(self.hand_in(study=study), 2, "variable.ft.mean", "was 150000 Pa", "is 200000 Pa now")
        self.assertEqual(tree(self.out()), before)
        self.changed(study, "0.20 MPa", "0.15 MPa")
        self.changed(study.parent / "model.toml", "velocity", "# slow\nvelocity")
        self.run_tasks(2, 3)
        self.join()
        self.assert_equals_whole(self.out())

    def test_task_needs_its_store_alone(self):
        study = self.own_study()
        self.written(study=study)
        shutil.rmtree(study.parent)
        done = self.run_task(1)
        self.assertIn("own.toml is not there; the study that", done.stderr)
        self.run_tasks(2, 3)
        self.join()
        self.assert_equals_whole(self.out())
        shutil.rmtree(self.out() / "shards/2")
        self.refused(self.run_task(2), 2, "--stored", "holds no store", "hand the array in again")
        self.assertFalse((self.out() / "shards/2").exists())

    def test_variants_are_fixed_at_hand_in_too(self):
        study = self.own_study()
        option = '\n[[variant]]\nname = "%s"\nset = ["material.joint.friction_angle=%s"]\n'
        text = study.read_text().replace("samples = 6", "samples = 3") + option % ("Rough", "40 deg")
        study.write_text(text)
        self.written(study=study)
        self.assertEqual(len(designs(self.out())), 6)
        study.write_text(text + option % ("Smooth", "35 deg"))
        self.refused(self.run_task(1), 2, "variant", "was Rough when the array was handed in, is Rough, Smooth now")
        self.assertEqual(len(designs(self.out())), 6)
        self.written(study=study)  # one more for all shards
        self.assertEqual(len(designs(self.out())), 9)
        study.write_text(text)
        before = tree(self.out())
        self.refused(self.hand_in(study=study), 2, "variant", "base, rough", "was base, rough, smooth")
        study.write_text(self.study_text.replace("samples = 6", "samples = 3"))
        self.refused(self.hand_in(study=study), 2, "variant")
        self.assertEqual(tree(self.out()), before)
        study.unlink()
        self.run_tasks(1, 2, 3)
        self.join()
        self.assertTrue((self.out() / "comparison.html").exists())
        self.assertIn("all: 9 of 9 samples", wythe("status", self.out()).stdout)

    def test_another_study_in_the_folder_is_refused_with_what_differs(self):
        self.written()
        self.run_tasks(1)
        before = tree(self.out())
        self.refused(self.hand_in("--seed", "8"), 2, "seed", "was 7", "is 8 now")
        self.refused(self.hand_in("--set", "stage.push.velocity=5 mm/s"), 2, "settings", "not given", "5 mm/s")
        other = self.own_study()
        self.changed(other, "cov = 0.2", "cov = 0.3")
        done = self.hand_in(study=other)
        self.refused(done, 2, "variable.ft.cov", "was 0.2", "is 0.3 now")
        self.assertEqual(done.stderr.count("is 0.3 now"), 1)  # once for all shards
        done = wythe("campaign", self.study, "--out", self.out(), "--slurm", "2")
        self.refused(done, 2, "--slurm", "2", "shards/1, which is one of 3 shards", "write --slurm 3")
        self.assertEqual(tree(self.out()), before)
        shard = self.out() / "shards/2"  # by hand
        shutil.rmtree(shard)
        wythe("campaign", self.study, "--out", shard, "--shard", "2/2", "--quiet")
        self.refused(wythe("status", self.out()), 4, "one of 2 shards", "no campaign")

    def test_campaign_of_another_study_at_the_join_is_refused_before_it_runs(self):
        shutil.copytree(self.whole, self.out())
        self.refused(self.hand_in("--seed", "8"), 2, "campaign.db", "seed", "was 7", "is 8 now")
        self.assertFalse((self.out() / "shards").exists())

    def test_campaign_of_the_laptop_goes_on_in_its_folder(self):
        shutil.copytree(self.whole, self.out())
        self.written("--samples", "9")
        self.assertEqual(designs(self.out())["shards/1"], ["6", "3"])
        self.run_tasks(1, 2, 3)
        self.join()
        self.assertEqual(len(self.rows(self.out())), 9)

    def test_joined_folder_takes_late_shards_in(self):
        self.written()
        self.run_task(1)
        said = self.join().stderr
        self.assertIn("the array is not complete: 4 of 6 samples have not run", said)
        self.assertIn("--slurm 3", said)
        self.run_tasks(2, 3)
        self.join()
        self.assert_equals_whole(self.out())

    def test_array_of_which_nothing_ran_joins_to_nothing(self):
        self.written()
        self.assertIn("6 of 6 samples have not run", self.join().stderr)

    def test_more_samples_later_are_more_work_for_each_task(self):
        self.written()
        self.run_tasks(1, 2)
        self.assertIn("3 of 3 tasks", self.written("--samples", "9"))
        self.assertEqual(set(map(tuple, designs(self.out()).values())), {("6", "3")})
        self.run_tasks(2)
        self.join()  # in between
        self.run_tasks(1, 3)
        self.join()
        whole = self.folder / "nine"
        shutil.copytree(self.whole, whole)
        self.assertEqual(self.resume(whole, "--samples", "9").returncode, 0)
        self.assertEqual((self.out() / "samples.csv").read_bytes(), (whole / "samples.csv").read_bytes())

    def test_shards_that_grew_apart_come_to_one_design(self):
        self.written()
        shard = self.out() / "shards/2"  # by hand, or by a hand-in that was killed half-way
        self.assertEqual(self.resume(shard, "--shard", "2/3", "--samples", "8").returncode, 0)
        self.refused(self.hand_in("--samples", "9"), 2, "samples", "adds one sample to the 8", "--samples 10")
        self.written("--samples", "10")
        self.assertEqual(set(map(tuple, designs(self.out()).values())), {("6", "2", "2")})
        self.run_tasks(1, 2, 3)
        self.join()
        self.assertEqual(len(self.rows(self.out())), 10)

    def test_fewer_samples_are_no_smaller_design(self):
        self.written("--samples", "9")
        before = tree(self.out())
        self.refused(self.hand_in("--samples", "5"), 2, "samples", "5", "fewer than the 9", "--samples 9 or more")
        self.assertEqual(tree(self.out()), before)
        done = self.hand_in()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("holds a design of 9 samples", done.stderr)
        self.assertIn("asks for 6: all 9 are run", done.stderr)
        self.assertEqual(set(map(tuple, designs(self.out()).values())), {("9",)})

    def test_shards_that_run_are_left_alone(self):
        self.written()
        held = hold_lock(self, self.out() / "shards/2", "process 17 on node9\n4 workers\n")
        said = self.written()
        self.assertIn("task 2 is left alone: process 17 on node9 runs it", said)
        self.assertIn("2 of 3 tasks have samples left: 1,3", said)
        self.assertEqual(self.array(), "1,3")
        before = tree(self.out())
        self.refused(self.hand_in("--samples", "9"), 2, "shards/2", "process 17 on node9", "runs its 6 samples now",
                     "scancel")
        self.assertEqual(tree(self.out()), before)
        self.run_tasks(1, 3)
        self.assertIn("nothing to hand in: what is left runs already", self.written())
        fake = commands(self.folder / "none", sbatch="sys.exit(1)")
        done = subprocess.run(["sh", self.out() / "slurm/submit.sh"], env=fake, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, "nothing to hand in: what is left runs already\n"))
        held.close()  # the process is gone, its file is still there
        self.written()
        self.assertEqual(self.array(), "2")

    def test_folders_of_any_name_reach_the_program_whole(self):
        names = ["an odd; folder", "it's \"quoted\"", "two\nlines\n", "-dash", "$(touch x) `touch x`", "100%a %j", "a\\b", "ü*?"]
        for k, name in enumerate(names):
            with self.subTest(name=name):
                home = self.folder / f"home_{k}" / name
                home.mkdir(parents=True)
                study = home / f"{name} study.toml".replace("/", "")
                study.write_text(self.study_text)
                (home / "model.toml").write_text(self.model)
                fake = self.folder / f"bin_{k}"
                environment = commands(fake, sbatch=SBATCH, squeue="")
                done = subprocess.run(
                    [PROGRAM, "campaign", study, "--out=out", "--slurm=2", "--samples=2", "--submit",
                     "--set", "stage.push.until = '0.5 mm'"],
                    cwd=home, env=environment, capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                slurm = str(home / "out/slurm")
                self.assertEqual(words(fake, "sbatch"), [[slurm, "--parsable", "array.sh"],
                                                         [slurm, "--dependency=afterany:17", "merge.sh", "17"]])
                self.assertEqual(len(self.rows(home / "out")), 2)
                self.assertFalse(list(self.folder.rglob("x")))
                done = subprocess.run(  # the words it printed are right too
                    ["sh", "-c", re.search(r"how far it is: (wythe .*)", done.stdout, re.S).group(1)],
                    env=dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}"), cwd="/",
                    capture_output=True, text=True, check=False)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_script_names_are_found_from_elsewhere(self):
        self.written()
        environment = commands(self.folder / "cd_bin", sbatch="print(17)", squeue="")
        environment["CDPATH"] = "/usr"
        relative = os.path.relpath(self.out() / "slurm/submit.sh", self.folder)
        done = subprocess.run(["sh", relative], env=environment, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(words(self.folder / "cd_bin", "sbatch")[0][0], str(self.out() / "slurm"))

    def test_tasks_get_the_options_that_they_need(self):
        fake = self.folder / "record"
        commands(fake, program="")
        self.written("--seed", "7", "--samples", "6", "--set", "stage.push.until=1 mm", "--set", "material.joint.friction_angle=35 deg",
                     "--lang", "it", "--cores", "2", "--partition", "long,short", "--time", "1-12:30",
                     "--resume", "--quiet")
        self.assertEqual(self.run_task(2, WYTHE=str(fake / "program")).returncode, 0)
        got = words(fake, "program")[0][1:]
        self.assertEqual(got, ["campaign", str(self.study), f"--out={self.out()}/shards/2", "--shard=2/3", "--seed=7",
                               "--set=stage.push.until=1 mm", "--set=material.joint.friction_angle=35 deg", "--jobs=2", "--lang=it",
                               "--resume", "--stored", "--quiet"])
        for line in ("--partition=long,short", "--time=1-12:30", "--cpus-per-task=2"):
            self.assertIn(f"#SBATCH {line}\n", (self.out() / "slurm/array.sh").read_text())
        self.run_tasks(1)
        self.assertIn("<html lang=\"it\"", (self.out() / "shards/1/report.html").read_text()[:300])
        done = self.run_task(9)
        self.refused(done, 2, "no task 9: they are 1 to 3")
        done = subprocess.run(["sh", self.out() / "slurm/array.sh"], capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("SLURM_ARRAY_TASK_ID", done.stderr)

    def test_several_studies_share_an_array(self):
        other = self.folder / "other.toml"
        other.write_text(self.study.read_text().replace("seed = 7", "seed = 8"))
        done = wythe("campaign", self.study, other, "--out", self.out(), "--slurm", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.run_tasks(1, 2, 3, 4)
        self.join()
        self.assert_equals_whole(self.out() / "study")
        self.assertNotEqual((self.out() / "other/samples.csv").read_bytes(),
                            (self.whole / "samples.csv").read_bytes())
        self.refused(self.hand_in(), 2, "--out", "array of several studies")
        self.refused(wythe("campaign", self.study, other, "--out", self.whole, "--slurm", "2"), 2, "--out", "one study")

    def test_join_ends_as_the_merges_do_and_runs_all(self):
        other = self.folder / "late.toml"
        other.write_text(self.study_text)
        done = wythe("campaign", self.study, other, "--out", self.out(), "--slurm", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        fake = self.folder / "merges"
        commands(fake, program="sys.exit(4 if sys.argv[2].endswith('study') else 0)")
        done = subprocess.run(["sh", self.out() / "slurm/merge.sh"], env=dict(os.environ, WYTHE=str(fake / "program")), check=False)
        self.assertEqual(done.returncode, 4)
        self.assertEqual([w[2] for w in words(fake, "program")], [str(self.out() / "study"), str(self.out() / "late")])

    def test_join_waits_for_requeued_tasks_but_not_for_ever(self):
        self.written()
        fake = self.folder / "queue"
        environment = commands(fake, squeue="print('17_2 RUNNING')", sbatch="print('18')", program="")
        environment["WYTHE"] = str(fake / "program")
        folder = self.out() / "slurm"

        def merge(*more, **change):
            return subprocess.run(["sh", "merge.sh", *more], cwd=folder, env=dict(environment, **change), check=False).returncode
        self.assertEqual(merge("17"), 0)
        self.assertEqual(words(fake, "sbatch")[0][1:], ["--dependency=afterany:17", "--begin=now+0", "merge.sh", "17", "2"])
        self.assertEqual(words(fake, "program"), [])
        for _ in range(50):  # Slurm starts it again and again
            if words(fake, "program"):
                break
            self.assertEqual(merge(*words(fake, "sbatch")[-1][4:]), 0)
        self.assertEqual(len(words(fake, "program")), 1)
        (fake / "sbatch").write_text("#!/bin/sh\nexit 1\n")  # nodes that may not hand in
        self.assertEqual(merge("17"), 0)
        self.assertEqual(len(words(fake, "program")), 2)

    def test_submit_says_what_slurm_refuses(self):
        fake = self.folder / "bin"
        environment = commands(fake, sbatch="print('Invalid partition', file=sys.stderr); sys.exit(1)")
        arguments = [WYTHE, "campaign", self.study, "--out", self.out(), "--slurm", "2", "--submit"]
        done = subprocess.run(arguments, env=environment, capture_output=True, text=True, check=False)
        self.refused(done, 4, "Invalid partition", "Slurm did not take the jobs", "submit.sh")

    def test_times_are_read_as_slurm_reads_them(self):
        for text in ("5", "90", "5:00", "00:05:00", "12:00:00", "1-0", "2-12", "1-12:30", "1-12:30:10", "0-0:05", "200:00:00", "UNLIMITED"):
            out = self.folder / "times" / text.replace(":", "_")
            self.written("--time", text, out=out)
            self.assertIn(f"#SBATCH --time={text}\n", (out / "slurm/array.sh").read_text())
        for text in ("12h", "1:2:3:4", "1-2:3:4:5", "-5", "5-", "1--2", ":5", "5:", "1.5", "1 2", "noon", "5m", "12:00:00\n#SBATCH --mem=0"):
            self.refused(self.hand_in(f"--time={text}"), 2, "--time", "is no time that Slurm reads", "--time 12:00:00")
        for text, seconds in (("0", 0), ("4", 240), ("4:59", 299), ("0:04:00", 240), ("0-0", 0), ("0-0:04:59", 299)):
            self.refused(self.hand_in("--time", text), 2, "--time", f"is {seconds} s", "stop 120 s before", "5 minutes at least")
        self.assertFalse(self.out().exists())

    def test_what_slurm_would_read_otherwise_is_refused(self):
        def said(*more):
            return wythe("campaign", self.study, "--out", self.out(), *more)
        self.refused(said("--slurm", "7"), 2, "--slurm", "more than the 6 samples", "fewer tasks")
        self.refused(said("--slurm", "0"), 2, "--slurm", "whole number from 1 to 1000")
        self.refused(said("--slurm", "2", "--partition", "a b\n#SBATCH --mem=0"), 2, "--partition")
        self.refused(said("--slurm", "2", "--cores", "0"), 2, "--cores")
        self.refused(said("--slurm", "2", "--shard", "1/2"), 2, "--shard", "leave it out")
        self.refused(said("--slurm", "2", "--stored"), 2, "--stored", "leave it out")
        self.refused(said("--slurm", "2", "--jobs", "4"), 2, "--jobs", "write --cores 4")
        self.refused(said("--slurm", "2", "--lang", "xx"), 2, "--lang")
        self.refused(said("--slurm", "2", "--until", "relative_interval(peak_reaction) < 1 %"), 2,
                     "sees only its own")
        self.refused(said("--cores", "2"), 2, "--cores", "for --slurm alone")
        self.refused(said("--stored"), 2, "--stored", "add --resume")
        self.refused(wythe("campaign", self.study, self.study, "--out", self.out()), 2, "second study")
        self.refused(wythe("status", self.folder / "nowhere"), 2, "holds no campaign")
        self.assertFalse(self.out().exists())

    def test_studies_whose_folders_would_collide_are_refused(self):
        def said(*names):
            for name in names:
                (self.folder / name).write_text(self.study_text)
            return wythe("campaign", *[self.folder / n for n in names], "--out", self.out(), "--slurm", "2")
        for name in ("slurm.toml", "shards.toml", "Slurm.toml", "base.toml", "campaign.db.toml", "report.html.toml", "SHARDS..toml"):
            self.refused(said("fine.toml", name), 2, name, "which wythe uses itself", "rename")
        for name in ("..toml", "...toml", "....toml"):
            self.refused(said("fine.toml", name), 2, "gives no name for its folder", "rename")
        for other in ("Fine.toml", "fine..toml", "fine.study", "FINE. .toml", "fine.toml"):
            self.refused(said("fine.toml", other), 2, "has the name of another study", "rename one")
        self.assertFalse(self.out().exists())
        self.assertEqual(said("wall.1.toml", "wall.2.toml").returncode, 0)


CONF = (SOURCE / "tests/data/slurm.conf").read_text()


def free_port():
    with socket.socket() as s:
        s.bind(("127.0.0.1", 0))
        return s.getsockname()[1]


class Cluster:
    """Slurm on this machine, with a configuration, keys, ports and folders of its own: it shares nothing with another one, and its
    daemons are children of this process, so that each is seen to end."""

    def __init__(self, folder):
        self.folder, self.daemons, self.address = folder, [], None
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"))

    def call(self, *command, **options):
        return subprocess.run([str(c) for c in command], env=self.environment, capture_output=True,
                              text=True, check=False, timeout=LONG, **options)

    def daemon(self, *command):
        with (self.folder / f"{command[0]}.out").open("a") as out:
            self.daemons.append(subprocess.Popen([str(c) for c in command], env=self.environment, stdin=subprocess.DEVNULL,
                                                 stdout=out, stderr=subprocess.STDOUT))

    def start(self):
        """Returns why it cannot be had, or None."""
        routes = self.call("ip", "-4", "addr", "show", "scope", "global").stdout
        if "inet " not in routes:  # with loopback alone Slurm's clients find no address at all
            self.address = "10.99.0.1/32"
            self.call("ip", "addr", "add", self.address, "dev", "lo")
        for _ in range(3):  # a port may be taken between its choice and its use
            why = self.start_daemons()
            if why is None:
                return None
            self.end_daemons()
        return why

    def start_daemons(self):
        folder, key, socket_path = self.folder, self.folder / "munge.key", self.folder / "munge.socket"
        (folder / "slurm.conf").write_text(CONF.format(host=socket.gethostname().split(".")[0], folder=folder, port=free_port(),
                                                       node_port=free_port(), munge=socket_path))
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(128))
        self.daemon("munged", "--foreground", "--force", f"--socket={socket_path}", f"--key-file={key}", f"--pid-file={folder}/munge.pid",
                    f"--log-file={folder}/munge.log", f"--seed-file={folder}/munge.seed")
        for event, following in ((socket_path.exists, "slurmctld"), (self.answers, "slurmd"), (self.is_idle, None)):
            if not wait_for(lambda: event() or self.ended(), f"Slurm ({event.__name__})") or self.ended():
                return f"{self.ended()} ended: " + "\n".join(f"{log.name}:\n{log.read_text()[-2000:]}" for log in
                                                             [*folder.glob("*.out"), *folder.glob("*.log")])
            if following:
                self.daemon(following, "-D", "-c", "-f", folder / "slurm.conf")
        return None

    def ended(self):
        return next((d.args[0] for d in self.daemons if d.poll() is not None), None)

    def answers(self):
        return self.call("sinfo", "-h").returncode == 0

    def is_idle(self):
        return "idle" in self.call("sinfo", "-h", "-o", "%T").stdout

    def end_daemons(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(60)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
        self.daemons = []

    def stop(self):
        """Ends with the daemons: until then they write into the folder."""
        self.end_daemons()
        if self.address:
            self.call("ip", "addr", "del", self.address, "dev", "lo")


class RealSlurm(Base):
    """An array of four over 24 samples on a cluster of one node; a task is told to stop and handed in again."""
    study_text = Base.study_text.replace("samples = 6", "samples = 24")

    def setUp(self):
        for program in ("slurmctld", "slurmd", "sbatch", "munged", "ip"):
            if shutil.which(program) is None:
                self.skipTest(f"needs {program}, which is not installed")
        if os.geteuid() != 0:
            self.skipTest("needs root to start Slurm")
        self.cluster = Cluster(self.folder)
        self.addCleanup(self.cluster.stop)
        why = self.cluster.start()
        if why:
            self.skipTest(why)

    def out(self):  # a name that Slurm would read otherwise
        return self.folder / f"{self._testMethodName} %a 'x' $(date)"

    def state_of(self, job):
        return self.cluster.call("squeue", "-h", "-j", job, "-o", "%T").stdout.strip()

    def test_array_with_a_task_that_gives_way_equals_the_campaign_here(self):
        # the first time, task 2 takes one sample after the other, and waits after its second until it is told to stop
        pipe, wrapper = self.folder / "pipe", self.folder / "program"
        os.mkfifo(pipe)
        wrapper.write_text(f"""#!/bin/sh
if [ "$SLURM_ARRAY_TASK_ID" = 2 ] && [ -z "$SLURM_RESTART_COUNT" ]; then
  WYTHE_LANES=1 WYTHE_TEST_HOLD="sample 2" exec {PROGRAM} "$@" <> {pipe}
fi
exec {PROGRAM} "$@"
""")
        wrapper.chmod(0o755)
        self.cluster.environment["WYTHE"] = str(wrapper)
        done = self.cluster.call(WYTHE, "campaign", self.study, "--out", self.out(), "--slurm", "4",
                                 "--cores", "1", "--submit")
        self.assertEqual(done.returncode, 0, done.stderr)
        array = re.search(r"array job (\d+)", done.stdout).group(1)
        self.assertRegex(done.stdout, r"Submitted batch job \d+")
        log = self.out() / "slurm/2.log"
        wait_for(lambda: log.exists() and "held at sample 2" in log.read_text(), "the second sample of task 2")
        said = wythe("status", self.out()).stdout
        self.assertRegex(said, r"shard 2: [12] of 6 samples, process \d+ on \S+ writes with 1 worker; about ")
        self.assertIn("task 2 is left alone", wythe("campaign", self.study, "--out", self.out(), "--slurm", "4").stdout)
        done = self.cluster.call("scontrol", "requeue", f"{array}_2")
        self.assertEqual(done.returncode, 0, done.stderr)
        wait_for(lambda: self.state_of(f"{array}_2") == "PENDING", "task 2 back in the queue")
        self.assertIn("of 6 samples are stored", log.read_text())  # it stored what it had, in time
        # not in the second in which it was stopped: a node refuses such a task, for its times are whole seconds ("credential revoked")
        self.cluster.call("scontrol", "update", f"JobId={array}_2", "StartTime=now+3seconds")
        wait_for(lambda: not self.cluster.call("squeue", "-h").stdout.strip(), "the array, and the join of all of it")
        logs = "".join(f"{path.name}:\n{path.read_text()}" for path in sorted((self.out() / "slurm").glob("*.log")))
        self.assertIn("all: 24 of 24 samples", wythe("status", self.out()).stdout, logs)
        self.assertEqual((self.out() / "samples.csv").read_bytes().count(b"\n"), 25, logs)
        self.assert_equals_whole(self.out())
        self.assertIn("all: 24 of 24 samples", wythe("status", self.out()).stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
