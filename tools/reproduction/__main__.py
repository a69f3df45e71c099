"""The reproduction page: the paper's numbers beside those of one campaign, with intervals, and what moves them.

  python3 tools/reproduction CAMPAIGN_DIR [--paired out/paired] [--slow SLOW_DIR] [--binary build/release/wythe]

CAMPAIGN_DIR is the folder of `wythe campaign examples/tuff_wall/study.toml --out CAMPAIGN_DIR`, finished. Writes
docs/reproduction.md and its figures, docs/figures/reproduction, from the template page.md, whose {{names}} become
numbers, tables and figures. --paired names the runs of `tools/paired_samples run`; variants not run yet are named as
missing; --slow the same campaign pushed at the paper's 1 mm/s. Exit 1 if a number of statistics.json does not come out again from samples.csv.
Python's standard library (3.11 or newer) and libzstd only.
"""
import argparse
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import causes
import compare
import paired
import rate
import recompute
from campaign import Campaign
from paper import CITATION


def head(campaign):
    s, push = campaign.statistics, campaign.push()
    program = (campaign.study["provenance"] or "").split(" (")[0]
    return {"answered": s["samples"]["answered"], "asked": s["samples"]["asked"], "design": s["design"], "seed": s["seed"],
            "velocity": push["velocity"], "damping": push["damping"], "citation": CITATION, "program": program,
            "read at": f"{s['read_modes_at_mm']:g}"}


def said_of(checked):
    if checked.faults:
        return f"{len(checked.faults)} of {checked.compared} numbers **disagree** ({'; '.join(checked.faults[:3])})"
    return (f"{checked.compared} numbers agree, ends of bootstrap intervals within {checked.worst_bootstrap:.2f} standard errors,\n"
            "  all else to rounding")


def filled(template, values):
    def value(match):
        if match[1] not in values:
            sys.exit(f"page.md: no value called {match[1]!r}")
        return str(values[match[1]])
    return re.sub(r"\{\{(.*?)\}\}", value, template)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("campaign", help="folder of the campaign")
    parser.add_argument("--paired", default="out/paired")
    parser.add_argument("--slow", help="folder of the same campaign at the paper's rate")
    parser.add_argument("--binary", default="build/release/wythe", help="draws the wall; an empty name keeps the pictures")
    parser.add_argument("--page", default="docs/reproduction.md")
    parser.add_argument("--figures", default="docs/figures/reproduction")
    arguments = parser.parse_args()
    try:
        campaign = Campaign(arguments.campaign)
        slow = Campaign(arguments.slow) if arguments.slow else None
    except FileNotFoundError as error:
        sys.exit(f"{error.filename}: not there; `wythe report FOLDER` makes it from a finished campaign")
    page, runs = compare.Page(campaign, arguments.page, arguments.figures), paired.Paired(arguments.paired, campaign, arguments.binary or "build/release/wythe")
    checked = recompute.check(campaign)
    values = head(campaign) | compare.values(page) | causes.values(page, arguments.binary) | paired.values(page, runs)
    values |= rate.values(page, slow, arguments.binary or "build/release/wythe")
    template = pathlib.Path(__file__).with_name("page.md").read_text(encoding="utf-8")
    pathlib.Path(arguments.page).write_text(filled(template, values | {"check": said_of(checked)}), encoding="utf-8")
    print(f"{arguments.page}: {values['inside']} inside, {values['outside']} outside; of {checked.compared} numbers computed again "
          f"{len(checked.faults)} disagree; variants run: {len(runs.changed)}, missing: {len(runs.missing)}")
    for fault in checked.faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if checked.faults else 0)


if __name__ == "__main__":
    main()
