#!/usr/bin/env python3
"""Answers requests like the studio's worker, with libwythe.so: one request in each line, answers as lines of JSON.

  engine.py BUILD/libwythe.so      {"id": 1, "task": "check", "texts": {"model": "..."}, "numbers": {}, "want": ["svg"], "tables": []}
"""
import ctypes
import json
import queue
import sys
import threading
import time

library = ctypes.CDLL(sys.argv[1])
for name, answer, words in [("new", ctypes.c_void_p, [ctypes.c_char_p]),
                            ("free", None, [ctypes.c_void_p]),
                            ("set_text", ctypes.c_int, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_size_t]),
                            ("set_number", ctypes.c_int, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double]),
                            ("do", ctypes.c_int, [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_void_p]),
                            ("text", ctypes.c_char_p, [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p]),
                            ("column", ctypes.POINTER(ctypes.c_double),
                             [ctypes.c_void_p, ctypes.c_char_p, ctypes.c_char_p, ctypes.POINTER(ctypes.c_size_t)])]:
    function = getattr(library, f"wythe_{name}")
    function.restype, function.argtypes = answer, words
PROGRESS = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_double, ctypes.c_double)


def say(message):
    print(json.dumps(message), flush=True)


def text(job, name):
    found = library.wythe_text(job, name.encode(), None)
    return None if found is None else found.decode()


PIECE = 0.35  # of a run in pieces, as in apps/wasm/worker.js [s]
STOPPED = 3
asked = queue.Queue()  # lines that nobody has read yet


def listen():
    for line in sys.stdin:
        asked.put(json.loads(line))
    asked.put(None)


def pause():
    """Between two pieces: waits where the page has said so."""
    while not asked.empty():
        said = asked.get()
        while said is not None and said.get("pause"):
            said = asked.get()
        if said is None:
            sys.exit()


def answer(question):
    job = library.wythe_new(question["task"].encode())
    for name, given in question.get("texts", {}).items():
        for one in given if isinstance(given, list) else [given]:
            library.wythe_set_text(job, name.encode(), one.encode(), len(one.encode()))
    pieces = question.get("pieces", False)
    for name, number in {**question.get("numbers", {}), **({"goes_on": 1} if pieces else {})}.items():
        library.wythe_set_number(job, name.encode(), number)
    last, begun = {}, time.monotonic()

    def progress(_, what, share, displacement, reaction):
        last.update(what=what.decode(), share=share, displacement_mm=displacement, reaction_kN=reaction)
        say({"id": question["id"], "progress": last})
        return 1 if pieces and time.monotonic() > begun + PIECE else 0

    call = PROGRESS(progress)
    heard = ctypes.cast(call, ctypes.c_void_p)
    code = library.wythe_do(job, heard, None)
    while pieces and code == STOPPED:
        say({"id": question["id"], "progress": {**last, "svg": text(job, "svg") or ""}})
        pause()
        begun = time.monotonic()
        code = library.wythe_do(job, heard, None)
    first = {name: text(job, name) for name in question.get("first", [])} if code == 0 else {}
    if "first" in question:
        say({"id": question["id"], "progress": {**last, "texts": {k: v for k, v in first.items() if v is not None}}})
    texts = {**first, **{name: text(job, name) for name in ["faults", "error", *([*question.get("want", []), *question.get("bytes", [])] if code == 0 else [])]}}
    tables, rows = {}, ctypes.c_size_t()
    for name in question.get("tables", []) if code == 0 else []:
        tables[name] = {}
        for column in json.loads(text(job, f"columns of {name}")):
            values = library.wythe_column(job, name.encode(), column.encode(), ctypes.byref(rows))
            tables[name][column] = values[:rows.value]
    say({"id": question["id"], "code": code, "texts": {k: v for k, v in texts.items() if v is not None}, "tables": tables})
    library.wythe_free(job)


threading.Thread(target=listen, daemon=True).start()
while True:
    line = asked.get()
    if line is None:
        break
    if "task" in line:
        answer(line)
