"""How far a call is: a bar in a terminal, a bar in a notebook, or a function of the user's."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from html import escape
from typing import Optional, Union

from ._types import Hear, Progress

_SHOWN_AFTER = 0.5  # seconds: shorter calls show nothing
_WIDTH = 30


def _nothing() -> None:
    pass


def _in_notebook() -> bool:
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return shell is not None and type(shell).__name__ == "ZMQInteractiveShell"


def _left(share: float, since: float) -> str:
    if share < 0.02:
        return ""
    seconds = (time.monotonic() - since) * (1 - share) / share
    return f", {seconds:.0f} s left" if seconds < 90 else f", {seconds / 60:.0f} min left"


class _Terminal:
    def __init__(self) -> None:
        self._since = time.monotonic()
        self._drawn = False

    def hear(self, what: str, share: float, displacement_mm: float, force_kN: float) -> None:
        if time.monotonic() - self._since < _SHOWN_AFTER:
            return
        filled = int(share * _WIDTH)
        moved = f"  {displacement_mm:.2f} mm  {force_kN:.1f} kN" if displacement_mm or force_kN else ""
        bar = "#" * filled + "." * (_WIDTH - filled)
        sys.stderr.write(f"\r\x1b[K[{bar}] {100 * share:3.0f} %  {what}{moved}{_left(share, self._since)}")
        sys.stderr.flush()
        self._drawn = True

    def close(self) -> None:
        if self._drawn:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()


class _Notebook:
    def __init__(self) -> None:
        from IPython.display import HTML, display

        self._html = HTML
        self._handle = display(HTML(""), display_id=True)
        self._since = time.monotonic()

    def hear(self, what: str, share: float, displacement_mm: float, force_kN: float) -> None:
        if time.monotonic() - self._since >= _SHOWN_AFTER:
            label = escape(f"{what}{_left(share, self._since)}")
            self._handle.update(
                self._html(f'<progress value="{share:.3f}" max="1"></progress> {100 * share:.0f} % {label}')
            )

    def close(self) -> None:
        self._handle.update(self._html(""))


def listener(progress: Progress) -> tuple[Optional[Hear], Callable[[], None]]:
    """The function that hears of progress, or None; and one that clears what it drew."""
    if callable(progress):
        return progress, _nothing
    if progress is None:
        progress = _in_notebook() or sys.stderr.isatty()
    if not progress:
        return None, _nothing
    shown: Union[_Notebook, _Terminal] = _Notebook() if _in_notebook() else _Terminal()
    return shown.hear, shown.close
