"""What the program's help says, as data: its commands, their options, their words (tools/command_line, tools/shell_words.py)."""
import dataclasses
import re
import subprocess

EXIT_CODES = [
    ("0", "done. A wall that collapsed is a result too"),
    ("2", "the input is wrong. All faults are listed, each with its place, value and cure; nothing was written"),
    ("3", "the computation did not end as it should. What it got is written, and the status says what happened"),
    ("4", "the machine or a file refused (no space, no permission). What is whole is kept"),
]


@dataclasses.dataclass
class Entry:
    """One option or positional: `--out TEXT REQUIRED` and its meaning."""
    name: str
    said: str
    known: list = dataclasses.field(default_factory=list)  # words that its value may be, where the program lists them

    @property
    def flags(self):
        """The option's names, `--out`; none for a positional."""
        return re.findall(r"(?<!\S|\w)-{1,2}[A-Za-z][\w-]*", self.name.split(" ")[0].replace(",", " "))

    @property
    def word(self):
        return self.name.split(" ")[0]

    @property
    def takes_value(self):
        return " " in self.name or not self.flags

    @property
    def many(self):
        return "..." in self.name

    @property
    def kind(self):
        """What its value is: a list of words, or "toml", "csv", "file", "folder", "text"."""
        if self.known:
            return self.known
        if listed := re.search(r"\{([^}]*)\}", self.name):
            return listed.group(1).split(",")
        if listed := re.match(r"(?:language of [\w.]+: )?((?:\w+, )*\w+),? or (\w+)(?:$|, in | in )", self.said):
            return [*listed.group(1).split(", "), listed.group(2)]
        for kind, pattern in (("folder", r"^folders? |in this folder"), ("toml", r"\w+\.toml"), ("csv", r"CSV\b(?! to)"),
                              ("file", r"\bfile to write|CSV to write")):
            if re.search(pattern, self.said):
                return kind
        return "text" if self.flags else "file"


@dataclasses.dataclass
class Command:
    """One command, `wythe store check`: its words, meaning and what it takes."""
    words: tuple
    meaning: str
    text: str
    commands: list
    known: dict = dataclasses.field(default_factory=dict)

    @property
    def name(self):
        return " ".join(self.words)

    @property
    def usage(self):
        return re.search(r"^Usage: (.*)$", self.text, re.M).group(1)

    @property
    def positionals(self):
        return [Entry(*e, self.known.get(e[0].split(" ")[0], [])) for e in entries(self.text, "Positionals")]

    @property
    def options(self):
        return [Entry(*e) for e in entries(self.text, "Options")]

    @property
    def footer(self):
        after = re.split(r"\n\n", self.text.strip())[-1]
        return "" if re.match(r"(Options|Positionals|Subcommands|Usage):", after) else after

    @property
    def example(self):
        found = re.search(r"^examples?: (.*)$", self.text, re.M)
        return found.group(1) if found else ""

    def all(self):
        """This command and those below it."""
        return [self, *(c for below in self.commands for c in below.all())]


def help_of(program, *words):
    text = subprocess.run([program, *words, "--help"], check=True, capture_output=True, text=True).stdout
    return text.replace(str(program), "wythe")


def entries(text, title):
    """(name, meaning) of each entry below `title:`."""
    part = re.search(rf"^{title}:\n((?:  .*\n?)+)", text, re.M)
    found = []
    for line in part.group(1).splitlines() if part else []:
        begins = re.match(r"  (\S.*?)(?:\s{2,}(\S.*))?$", line)
        if begins:
            found.append([begins.group(1), begins.group(2) or ""])
        else:
            found[-1][1] = f"{found[-1][1]} {line.strip()}".strip()
    return found


def read(program, words=(), meaning=""):
    """The whole tree of commands."""
    text = help_of(program, *words)
    below = [read(program, (*words, name), said) for name, said in entries(text, "Subcommands")]
    known = {"name": names_of_materials(program)} if tuple(words) == ("materials",) else {}
    return Command(tuple(words), meaning, text, below, known)


def names_of_materials(program):
    said = subprocess.run([program, "materials"], check=True, capture_output=True, text=True).stdout
    return re.findall(r"^  ([a-z]\w+) {2,}\S", said, re.M)


def version_of(program):
    """The version alone: 0.1.0."""
    said = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
    return re.search(r"wythe (\S+)", said).group(1)
