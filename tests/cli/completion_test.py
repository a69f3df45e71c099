#!/usr/bin/env python3
"""Completion in bash, zsh and fish, and the manual page, beside the program's own help: every command, every option, and what a value may
be (tools/shell_words.py). The help is read here in another way than there."""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

SOURCE = pathlib.Path(os.environ.get("SOURCE", ".")).resolve()
WYTHE = pathlib.Path(os.environ.get("WYTHE", SOURCE / "build/release/wythe")).resolve()
DONE = "<completed>"
# a command line, and what may stand at its end: the words that it may be, whatever files lie around
VALUES = [("ca", {"campaign"}), ("store ", {"check", "rescue"}), ("report DIR --lang ", {"en", "it"}), ("new p", {"pier", "portal"}),
          ("drawing a.dxf --unit f", {"ft"}), ("campaign a.toml --device ", {"cpu", "gpu"}), ("limit --only macro", {"macro_block_1", "macro_block_2"}),
          ("materials tuff", {"tuff_pozzolanic"}), ("store rescue DIR --lang i", {"it"}), ("run --lang en --quie", {"--quiet"}),
          ("run --set stage.push.until=1 --resu", {"--resume"})]


def call(*command, **options):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True, **options).stdout


def commands(words=()):
    """Words of each command, and what its help has: [((), {"run", ...}, {"--help", ...}), ...]."""
    text = call(WYTHE, *words, "--help")
    below = text.split("Subcommands:\n")[1].split("\n\n")[0] if "Subcommands:\n" in text else ""
    names = re.findall(r"^  (\w+)  ", below + "\n", re.M)
    options = set(re.findall(r"^ +(?:-\w,)?(--[a-z0-9-]+)", text, re.M))
    return [(words, set(names), options), *(c for name in names for c in commands((*words, name)))]


class Words(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        for shell, name in (("bash", "wythe"), ("zsh", "_wythe"), ("fish", "wythe.fish"), ("man", "wythe.1")):
            (cls.folder / name).write_text(call(SOURCE / "tools/command_line", WYTHE, f"--{shell}"))
        cls.here = cls.folder / "here"
        for name in ("model.toml", "my house.toml", "path.csv", "notes.txt", "out/campaign.db", "run/report.html"):
            (cls.here / name).parent.mkdir(parents=True, exist_ok=True)
            (cls.here / name).touch()
        cls.commands = commands()

    def bash(self, line):
        """What the function offers; `=` is a word of its own, as readline gives it."""
        words = [part for word in line.split(" ") for part in re.split(r"(=)", word) if part or "=" not in word]
        script = f'. "{self.folder}/wythe"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _wythe; printf "%s\\n" "${{COMPREPLY[@]}}"'
        return set(call("bash", "-c", script, "bash", "wythe", *words, cwd=self.here).splitlines()) - {""}

    def test_the_help_is_read_whole(self):
        self.assertIn((("store", "rescue"), set(), {"--help", "--out", "--lang", "--study", "--samples", "--seed", "--set", "--shard"}), self.commands)
        self.assertGreaterEqual(self.commands[0][1], {"run", "check", "campaign", "merge", "store", "picture"})

    def test_bash_offers_every_command_and_every_option(self):
        for words, names, options in self.commands:
            line = " ".join([*words, ""])
            if names:
                self.assertEqual(self.bash(line), names)
            self.assertEqual(self.bash(line + "--"), options, words)

    def test_bash_offers_the_words_that_a_value_may_be(self):
        for line, expected in VALUES:
            self.assertEqual(self.bash(line), expected, line)

    def test_bash_offers_files_where_files_are_meant(self):
        folders = {"out", "run"}
        for line, expected in (("run ", {"model.toml", "my house.toml", *folders}), ("run my", {"my house.toml"}), ("report ", folders),
                               ("run model.toml --out ", folders), ("run model.toml --out=", folders), ("run --out=o", {"out"}),
                               ("contact model.toml --path ", {"path.csv", *folders}), ("new arch ", folders), ("merge out ", folders),
                               ("store check ", folders), ("picture out --out n", {"notes.txt"}), ("run --threads ", set())):
            self.assertEqual(self.bash(line), expected, line)

    @unittest.skipUnless(shutil.which("fish"), "needs fish")
    def test_fish_offers_the_same(self):
        lines = [(" ".join([*words, ""]) + "--", options) for words, _, options in self.commands]
        lines += [(" ".join([*words, ""]), names) for words, names, _ in self.commands if names] + VALUES
        script = f'source "{self.folder}/wythe.fish"; for line in $argv; echo "{DONE}"; complete -C $line; end'
        said = call("fish", "--no-config", "-c", script, *(f"wythe {line}" for line, _ in lines), cwd=self.here, env=dict(os.environ, HOME=str(self.folder)))
        for (line, expected), found in zip(lines, said.split(f"{DONE}\n")[1:], strict=True):
            self.assertEqual({row.split("\t")[0] for row in found.splitlines()}, expected, line)

    @unittest.skipUnless(shutil.which("zsh"), "needs zsh")
    def test_zsh_offers_every_command_and_every_option(self):
        self.assertEqual(call("zsh", "-n", self.folder / "_wythe"), "")
        shell = Zsh(self.folder, self.here)
        self.addCleanup(shell.close)
        for words, names, options in self.commands:
            shown = shell.shown(" ".join(["wythe", *words, "--"]))
            for name in options:
                self.assertRegex(shown, rf"(?m)^{name}( |$)|--{name[2:]}", words)
            if names:
                shown = shell.shown(" ".join(["wythe", *words, ""]))
                self.assertEqual(set(re.findall(r"^(\w+) +-- ", shown, re.M)), names)
        self.assertRegex(shell.shown("wythe report out --lang "), r"(?m)^en +it")

    @unittest.skipUnless(shutil.which("man"), "needs man")
    def test_the_manual_page_has_all_and_no_fault(self):
        page = self.folder / "wythe.1"
        done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", str(page)], check=True, capture_output=True, text=True,
                              env=dict(os.environ, MANPAGER="cat", PAGER="cat", MANWIDTH="200", MAN_KEEP_FORMATTING=""))
        self.assertEqual(done.stderr, "")
        text = re.sub(r".\x08|\x1b\[[0-9;]*m", "", done.stdout)
        for words, _, options in self.commands[1:]:
            part = text.split(f"   wythe {' '.join(words)}\n")[1].split("\n   wythe ")[0]
            for name in options - {"--help"}:
                self.assertRegex(part, rf"(?m)^ +{name}\b", words)
        for code in "0234":
            self.assertRegex(text, rf"(?m)^ +{code} +\w")

    @unittest.skipUnless(shutil.which("mandoc"), "needs mandoc")
    def test_a_second_reader_finds_no_fault_in_the_manual_page(self):
        page = self.folder / "dated.1"
        page.write_text((self.folder / "wythe.1").read_text().replace('.TH WYTHE 1 ""', '.TH WYTHE 1 "2026-11-24"'))
        done = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", str(page)], check=False, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, ""))


class Zsh:
    """An interactive zsh, asked by the tabulator; it waits for the prompt, not for a time."""

    def __init__(self, folder, here):
        self.pid, self.file = pty.fork()
        if self.pid == 0:
            os.chdir(here)
            os.environ.update(TERM="dumb", HOME=str(folder), COLUMNS="300", LINES="100", ZDOTDIR=str(folder))
            os.execvp("zsh", ["zsh", "-f", "-i"])
        self.send(f"PS1=; unsetopt prompt_cr; stty columns 300 rows 100 -echo; fpath=({folder} $fpath); autoload -U compinit; compinit -u -D; "
                  "LISTMAX=999; setopt no_beep list_packed; unsetopt menu_complete auto_menu; "
                  f"finish() {{ zle -I; print -r -- '{DONE}'; zle kill-buffer }}; zle -N finish; bindkey '^X' finish; print -r -- '{DONE}'\n")
        self.read()

    def send(self, text):
        os.write(self.file, text.encode())

    def read(self):
        said, until = "", time.monotonic() + 60
        while f"\n{DONE}" not in said.replace("\r", "\n") and time.monotonic() < until:
            if select.select([self.file], [], [], 1)[0]:
                said += os.read(self.file, 65536).decode(errors="replace")
        return re.sub(r"\x1b\[[0-9;?]*[A-Za-z]", "", said).replace("\r", "\n").split(f"\n{DONE}")[0]

    def shown(self, line):
        self.send(f"{line}\t\t\x18")
        return self.read()

    def close(self):
        os.close(self.file)
        os.waitpid(self.pid, 0)


if __name__ == "__main__":
    if not WYTHE.exists():
        print(f"no program {WYTHE}")
        sys.exit(77)
    unittest.main(verbosity=1)
