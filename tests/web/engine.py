#!/usr/bin/env python3
"""Answers questions as the studio's worker does, from libwythe.so: one question a line, answers as lines of JSON.

  engine.py BUILD/libwythe.so      {"id": 1, "task": "check", "texts": {"model": "..."}, "numbers": {}, "want": ["svg"], "tables": []}
"""
import ctypes
import json
import sys

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


def answer(question):
    job = library.wythe_new(question["task"].encode())
    for name, given in question.get("texts", {}).items():
        for one in given if isinstance(given, list) else [given]:
            library.wythe_set_text(job, name.encode(), one.encode(), len(one.encode()))
    for name, number in question.get("numbers", {}).items():
        library.wythe_set_number(job, name.encode(), number)

    def progress(_, what, share, displacement, reaction):
        say({"id": question["id"], "progress": {"what": what.decode(), "share": share, "displacement_mm": displacement, "reaction_kN": reaction}})
        return 0

    heard = PROGRESS(progress)
    code = library.wythe_do(job, ctypes.cast(heard, ctypes.c_void_p), None)
    # faults first: to ask for a text that there is not is a fault of its own
    texts = {name: text(job, name) for name in ["faults", "error", *(question.get("want", []) if code == 0 else [])]}
    tables, rows = {}, ctypes.c_size_t()
    for name in question.get("tables", []) if code == 0 else []:
        tables[name] = {}
        for column in json.loads(text(job, f"columns of {name}")):
            values = library.wythe_column(job, name.encode(), column.encode(), ctypes.byref(rows))
            tables[name][column] = values[:rows.value]
    say({"id": question["id"], "code": code, "texts": {k: v for k, v in texts.items() if v is not None}, "tables": tables})
    library.wythe_free(job)


for line in sys.stdin:
    answer(json.loads(line))
