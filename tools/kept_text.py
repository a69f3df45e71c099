"""Keeps text that people wrote on a page by a tool, so that readers have one page.

The text stands between `<!-- kept -->` and `<!-- end of kept -->` (`<!-- kept: NAME -->` where a page has several). An existing page
without these marks is not written again, because its text would be lost.
"""
import pathlib
import re
import sys


def kept_text(page, name=""):
    """The kept part of the file `page`, with its marks; empty marks for a page that is not there yet."""
    mark = f"<!-- kept{': ' + name if name else ''} -->"
    end = "<!-- end of kept -->"
    path = pathlib.Path(page)
    if not path.exists():
        return f"{mark}\n{end}\n"
    found = re.findall(re.escape(mark) + r"\n(.*?)" + re.escape(end) + r"\n", path.read_text(encoding="utf-8"), re.S)
    if len(found) != 1 or "<!-- kept" in found[0]:
        sys.exit(f"{page}: not written: it needs exactly one part between '{mark}' and '{end}', which is kept")
    return f"{mark}\n{found[0]}{end}\n"
