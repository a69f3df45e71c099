"""Manual page and shell completions of wythe, from the tree of commands that program_help reads."""
import program_help

GLOB = {"toml": "*.toml", "csv": "*.csv"}


# --- the manual page ---------------------------------------------------------------------------------

def roff(text):
    """Plain text for a man page: no letter of it is a command."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("`", "\\(ga")
    return "\n".join("\\&" + line if line[:1] == "." else line for line in text.splitlines())


def sentence(text):
    return f"{text[:1].upper()}{text[1:]}."


def entry(name, said):
    return [".TP", ".B " + roff(name), roff(said) or "\\&"]


def man_page(tree, version, date):
    lines = [f'.TH WYTHE 1 "{date}" "wythe {version}" "User Commands"', ".SH NAME",
             "wythe \\- strength, drift and failure of masonry walls, with their uncertainty", ".SH SYNOPSIS",
             ".B wythe", r"\fICOMMAND\fR [\fIOPTIONS\fR]", ".SH DESCRIPTION",
             "Pushes walls of masonry until they fail, by discrete rigid block analysis. The result goes to the standard output,",
             "progress and errors to the standard error output.", ".SH OPTIONS"]
    for option in tree.options:
        lines += entry(option.name, option.said)
    lines += [".SH COMMANDS"]
    for command in tree.all()[1:]:
        lines += [f".SS wythe {command.name}", roff(sentence(command.meaning))]
        for e in command.positionals + command.options:
            if "--help" not in e.name:
                lines += entry(e.name, e.said)
        if command.example:
            lines += [".PP", "Example:", ".PP", ".nf", roff(command.example), ".fi"]
    lines += [".SH EXIT STATUS"]
    for code, meaning in program_help.EXIT_CODES:
        lines += entry(code, meaning + ".")
    lines += [".SH FILES", ".TP", ".I /usr/share/doc/wythe/examples", "models and studies to begin with, explained in README.md there",
              ".TP", ".I /usr/share/doc/wythe/docs", "tutorials, how\\-to pages and the reference of keys and columns",
              ".SH SEE ALSO", ".BR paraview (1),", ".BR sqlite3 (1)"]
    return "\n".join(lines) + "\n"


# --- bash --------------------------------------------------------------------------------------------

def case(command, place, kind):
    what = f'words="{" ".join(kind)}"' if isinstance(kind, list) else f"kind={kind}"
    return f'    "{f"{command.name} {place}".strip()}") {what} ;;'


def bash_cases(command):
    """What follows the words of this command: its options, and what each value and place is."""
    lines = [case(command, "options", [flag for option in command.options for flag in option.flags])]
    for option in command.options:
        if option.takes_value:
            lines += [case(command, flag, option.kind) for flag in option.flags]
    for i, place in enumerate(command.positionals):
        lines.append(case(command, i, place.kind))
        if place.many:
            lines.append(case(command, "many", place.kind))
    if command.commands:
        lines.append(case(command, 0, [c.words[-1] for c in command.commands]))
    return lines


BASH = r"""# bash completion of wythe, made from its help (tools/shell_words.py)

# What may stand at a place: sets `words` or `kind` of the caller.
_wythe_at() {
  words="" kind=""
  case $1 in
@CASES@
  esac
}

_wythe() {
  local word=${COMP_WORDS[COMP_CWORD]} command="" option="" past="" words kind found i n=0
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    past=${COMP_WORDS[i]}
    if [ "$past" = "=" ]; then
      continue
    elif [ -n "$option" ]; then
      option=""
    elif [[ $past == -* ]]; then
      _wythe_at "${command:+$command }$past"
      [ -z "$words$kind" ] || option=$past
    else
      if [ "$n" -eq 0 ] && [[ " @GROUPS@ " == *" ${command:-wythe} "* ]]; then
        command="${command:+$command }$past"
      else
        n=$((n + 1))
      fi
    fi
  done
  [ "$word" != "=" ] || word=""
  if [ -n "$option" ]; then
    _wythe_at "${command:+$command }$option"
  elif [[ $word == -* ]]; then
    _wythe_at "${command:+$command }options"
  else
    _wythe_at "${command:+$command }$n"
    [ -n "$words$kind" ] || _wythe_at "$command many"
  fi
  case $kind in
    toml) found=$(compgen -f -X '!*.toml' -- "$word"; compgen -d -- "$word") ;;
    csv) found=$(compgen -f -X '!*.csv' -- "$word"; compgen -d -- "$word") ;;
    file) found=$(compgen -f -- "$word") ;;
    folder) found=$(compgen -d -- "$word") ;;
    *) found=$(compgen -W "$words" -- "$word") ;;
  esac
  [ -z "$found" ] || mapfile -t COMPREPLY <<<"$found"
  case $kind in "" | text) return ;; esac
  compopt -o filenames 2>/dev/null
}
complete -o bashdefault -o default -F _wythe wythe
"""


def bash(tree):
    groups = [command.name or "wythe" for command in tree.all() if command.commands]
    cases = [line for command in tree.all() for line in bash_cases(command)]
    return BASH.replace("@CASES@", "\n".join(cases)).replace("@GROUPS@", " ".join(groups))


# --- zsh ---------------------------------------------------------------------------------------------

def zsh_text(text):
    """A description inside single quotes and brackets."""
    for letter in "\\[]:":
        text = text.replace(letter, "\\" + letter)
    return text.replace("'", "'\\''")


def zsh_action(kind):
    if isinstance(kind, list):
        return f"({' '.join(kind)})"
    return {"folder": "_files -/", "file": "_files", "text": " "}.get(kind) or f'_files -g "{GLOB[kind]}"'


def zsh_function(command):
    name = "_".join(["_wythe", *command.words])
    specs = []
    for option in command.options:
        for flag in option.flags:
            value = f":{option.flags[-1].lstrip('-')}:{zsh_action(option.kind)}" if option.takes_value else ""
            equals = "=" if value and flag.startswith("--") else ""
            specs.append(f"'*{flag}{equals}[{zsh_text(option.said)}]{value}'")
    if command.commands:
        listed = "\n".join(f"      '{c.words[-1]}:{zsh_text(c.meaning)}'" for c in command.commands)
        cases = "\n".join(f"      {c.words[-1]}) {'_'.join(['_wythe', *c.words])} ;;" for c in command.commands)
        specs += ["'1:command:->command'", "'*::argument:->argument'"]
        after = f"""
  case $state in
    command)
      local -a commands=(
{listed}
      )
      _describe -t commands command commands ;;
    argument)
      case $words[1] in
{cases}
      esac ;;
  esac"""
    else:
        specs += [f"'{'*' if place.many else i + 1}:{place.word}:{zsh_action(place.kind)}'" for i, place in enumerate(command.positionals)]
        after = ""
    joined = " \\\n    ".join(specs)
    return f"{name}() {{\n  local curcontext=$curcontext state line\n  typeset -A opt_args\n  _arguments -C \\\n    {joined}{after}\n}}\n"


def zsh(tree):
    return ("#compdef wythe\n# zsh completion of wythe, made from its help (tools/shell_words.py)\n"
            + "\n".join(zsh_function(command) for command in reversed(tree.all())) + '\n_wythe "$@"\n')


# --- fish --------------------------------------------------------------------------------------------

def fish_text(text):
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def fish_value(kind):
    if isinstance(kind, list):
        return f"-x -a {fish_text(' '.join(kind))}"
    suffix = f"__fish_complete_suffix {GLOB[kind][1:]}" if kind in GLOB else ""
    return {"folder": "-x -a '(__fish_complete_directories)'", "file": "-r -F", "text": "-x"}.get(kind) or f"-x -a '({suffix})'"


FISH = """# fish completion of wythe, made from its help (tools/shell_words.py)

# True when the command line begins with these words; with --only when it is these words.
function __wythe_at
    set -l given (commandline -opc)
    set -e given[1]
    if test "$argv[1]" = --only
        test "$given" = "$argv[2..-1]"
        return
    end
    set -l last (count $argv)
    test "$given[1..$last]" = "$argv"
end

complete -c wythe -f
"""


def fish(tree):
    lines = [FISH]
    for command in tree.all():
        here = f"-n '__wythe_at {command.name}'" if command.words else "-n '__wythe_at --only'"
        for below in command.commands:
            only = f"__wythe_at --only {command.name}".strip()
            lines.append(f"complete -c wythe -n '{only}' -a {below.words[-1]} -d {fish_text(below.meaning)}")
        for option in command.options:
            names = " ".join(f"-l {flag[2:]}" if flag.startswith("--") else f"-s {flag[1:]}" for flag in option.flags)
            value = f" {fish_value(option.kind)}" if option.takes_value else ""
            lines.append(f"complete -c wythe {here} {names}{value} -d {fish_text(option.said)}")
        for place in command.positionals:
            value = fish_value(place.kind).removeprefix("-x ").replace("-r -F", "-F")
            lines.append(f"complete -c wythe {here} {value}")
    return "\n".join(lines) + "\n"
