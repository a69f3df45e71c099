"""A wall as an UM-Bridge model: python3 -m wythe.umbridge MODEL.toml --input PATH=UNIT --output ANSWER

UM-Bridge (protocol 1.0) joins tools for uncertainty with models over HTTP. This server has one model, "wythe",
with one input vector (the inputs in the order given) and one output vector. It answers /Info, /ModelInfo,
/InputSizes, /OutputSizes and /Evaluate. Derivatives are not offered: a wall that cracks has no smooth ones.

Requests that come while walls are running wait and go together into the next batch, so that a client that asks
in parallel fills all cores. The answers do not depend on that.

It listens on this machine only, unless --host says otherwise; then anybody who reaches the port can run walls.
"""

from __future__ import annotations

import argparse
import json
import math
import queue
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Optional, Union

from ._errors import Fault, InputError, WytheError
from ._function import Choice, Follow, Function, Missing, Rows, add_options, parse_follow
from ._model import ModelLike
from ._types import Settings

NAME = "wythe"
_LARGEST_REQUEST = 1 << 20  # bytes
_DERIVATIVES = ("Gradient", "ApplyJacobian", "ApplyHessian")


class _Refused(Exception):
    """A request that gets an error in the words of the protocol."""

    def __init__(self, status: int, kind: str, message: str):
        self.status, self.kind, self.message = status, kind, message
        super().__init__(message)


class _Waiting:
    """One request on its way through a batch."""

    def __init__(self, row: list[float]):
        self.row = row
        self.done = threading.Event()
        self.answer: Optional[list[float]] = None
        self.problem = "the server was closed"


class _Row:
    """One row of a batch, as if it were the whole batch."""

    def __init__(self, batch: Rows, row: int):
        self.status, self.reason = [batch.status[row]], [batch.reason[row]]
        self.rate_judgement = [batch.rate_judgement[row]]
        self.answers = {name: batch.answers[name][row : row + 1] for name in batch.answers}


def _answer_all(of: Function, waiting: Sequence[_Waiting]) -> None:
    """Runs the rows of all requests as one batch and lets every request go on."""
    try:
        answers, batch = of.evaluate([request.row for request in waiting])
        for number, request in enumerate(waiting):
            try:
                request.answer = of.fill(answers[number : number + 1], _Row(batch, number))[0].tolist()
            except WytheError as error:
                request.problem = str(error)
    except Exception as error:  # whatever it was, nobody may wait for ever
        for request in waiting:
            request.problem = f"{type(error).__name__}: {error}"
    finally:
        for request in waiting:
            request.done.set()


class Server(ThreadingHTTPServer):
    """An UM-Bridge server of one wall; ``port`` 0 takes a free one, and ``.url`` says which.

        with wythe.umbridge.Server("model.toml", {"material.joint.cohesion": "MPa"}, ["peak_reaction_kN"]) as server:
            server.serve_forever()

    The options are those of `wythe.Function`. With ``missing="raise"`` a wall without an answer gets the error
    "NoAnswer" and its reason.
    """

    daemon_threads = True

    def __init__(
        self,
        model: ModelLike,
        inputs: Mapping[str, str],
        outputs: Union[str, Sequence[str]] = ("peak_reaction_kN",),
        *,
        host: str = "127.0.0.1",
        port: int = 4242,
        set: Settings = None,
        follow: Optional[Follow] = None,
        missing: Missing = "raise",
        bounds: Choice = "raise",
        rate: Choice = "raise",
        jobs: int = 0,
    ):
        self.function = Function(
            model, inputs, outputs, set=set, follow=follow, missing=missing, bounds=bounds, rate=rate, jobs=jobs
        )
        if self.function.missing is not None and not math.isfinite(self.function.missing):
            raise InputError([Fault(path="missing", value=str(self.function.missing),
                                    problem="is no number that JSON has", cure='write "raise" or a finite number')])
        self._requests: queue.SimpleQueue[Optional[_Waiting]] = queue.SimpleQueue()
        super().__init__((host, port), _Handler)
        self._worker = threading.Thread(target=self._work, name="wythe.umbridge", daemon=True)
        self._worker.start()

    @property
    def url(self) -> str:
        return f"http://{self.server_address[0]!s}:{self.server_address[1]}"

    def evaluate(self, row: list[float]) -> list[float]:
        """The answers to one row, from the batch in which it ran."""
        request = _Waiting(row)
        self._requests.put(request)
        request.done.wait()
        if request.answer is None:
            raise _Refused(500, "NoAnswer", request.problem)
        return request.answer

    def _work(self) -> None:
        while (first := self._requests.get()) is not None:
            waiting, closed = [first], False
            while not self._requests.empty():
                more = self._requests.get()
                if more is None:
                    closed = True
                    break
                waiting.append(more)
            _answer_all(self.function, waiting)
            if closed:
                return

    def server_close(self) -> None:
        super().server_close()
        self._requests.put(None)


class _Handler(BaseHTTPRequestHandler):
    server: Server
    protocol_version = "HTTP/1.1"
    server_version = "wythe"

    def log_message(self, format: str, *arguments: object) -> None:
        pass  # thousands of requests are usual

    def do_GET(self) -> None:
        self._reply(self._info)

    def do_HEAD(self) -> None:
        self._reply(lambda: {})

    def do_POST(self) -> None:
        self._reply(self._posted)

    def _info(self) -> dict[str, object]:
        if self.path != "/Info":
            raise _Refused(404, "InvalidInput", f"there is no {self.path}")
        return {"protocolVersion": 1.0, "models": [NAME]}

    def _posted(self) -> dict[str, object]:
        request = self._body()
        if request.get("name") != NAME:
            raise _Refused(400, "ModelNotFound", f"Model {request.get('name')!r} is not here, {NAME!r} is.")
        function = self.server.function
        if self.path == "/ModelInfo":
            return {"support": {"Evaluate": True, **{name: False for name in _DERIVATIVES}}}
        if self.path == "/InputSizes":
            return {"inputSizes": [len(function.inputs)]}
        if self.path == "/OutputSizes":
            return {"outputSizes": [len(function.outputs)]}
        if self.path == "/Evaluate":
            return {"output": [self.server.evaluate(self._row(request))]}
        if self.path.strip("/") in _DERIVATIVES:
            raise _Refused(400, "UnsupportedFeature", f"{self.path.strip('/')} is not supported by this model.")
        raise _Refused(404, "InvalidInput", f"there is no {self.path}")

    def _body(self) -> dict[str, object]:
        try:
            size = int(self.headers["Content-Length"])
        except (TypeError, ValueError):
            self.close_connection = True
            raise _Refused(411, "InvalidInput", "the request has no Content-Length") from None
        if not 0 <= size <= _LARGEST_REQUEST:
            self.close_connection = True  # what is not read would be taken for the next request
            raise _Refused(413, "InvalidInput", f"a request has at most {_LARGEST_REQUEST} bytes")
        try:
            request = json.loads(self.rfile.read(size))
        except (ValueError, RecursionError) as error:
            raise _Refused(400, "InvalidInput", f"the request is not JSON: {error}") from None
        if not isinstance(request, dict):
            raise _Refused(400, "InvalidInput", "the request is no JSON object")
        return request

    def _row(self, request: dict[str, object]) -> list[float]:
        inputs = self.server.function.inputs
        if request.get("config"):
            raise _Refused(400, "InvalidInput", "this model takes no config")
        vectors = request.get("input")
        if not isinstance(vectors, list) or len(vectors) != 1 or not isinstance(vectors[0], list):
            raise _Refused(400, "InvalidInput", "input has to be a list of one list of numbers")
        if len(vectors[0]) != len(inputs):
            raise _Refused(400, "InvalidInput", f"{len(inputs)} inputs are expected, in this order: {', '.join(inputs)}")
        for value in vectors[0]:
            if isinstance(value, bool) or not isinstance(value, (int, float)) or abs(value) > sys.float_info.max \
                    or value != value:
                raise _Refused(400, "InvalidInput", f"{value!r:.60} is no finite number")
        return [float(value) for value in vectors[0]]

    def _reply(self, of: Callable[[], dict[str, object]]) -> None:
        status: int = 200
        try:
            answer = of()
        except _Refused as refused:
            status, answer = refused.status, {"error": {"type": refused.kind, "message": refused.message}}
        body = json.dumps(answer, allow_nan=False).encode()
        try:
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            self.end_headers()
            if self.command != "HEAD":
                self.wfile.write(body)
        except ConnectionError:
            self.close_connection = True  # the client has gone


def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="python3 -m wythe.umbridge", description="a wall as an UM-Bridge model")
    parser.add_argument("model", help="model file")
    parser.add_argument("--input", action="append", required=True, metavar="PATH=UNIT",
                        help="one number of the input vector, e.g. material.joint.cohesion=MPa; again for the next")
    parser.add_argument("--output", action="append", metavar="ANSWER", help="one number of the output vector")
    parser.add_argument("--port", type=int, default=4242, help="0: a free one, which is printed")
    parser.add_argument("--host", default="127.0.0.1", help="address to listen on; the default is this machine alone")
    parser.add_argument("--missing", default="raise", metavar="NUMBER",
                        help="answer for a wall that has none; without it such a wall gets an error")
    add_options(parser)
    given = parser.parse_args(arguments)
    try:
        missing = given.missing if given.missing == "raise" else float(given.missing)
        server = Server(given.model, dict(text.rpartition("=")[::2] for text in given.input),
                        given.output or ("peak_reaction_kN",), host=given.host, port=given.port, set=given.set,
                        follow=parse_follow(given.follow), missing=missing, bounds=given.bounds, rate=given.rate, jobs=given.jobs)
    except (WytheError, ValueError, OSError) as error:
        print(error, file=sys.stderr)
        return 2
    with server:
        print(f"{NAME} listens at {server.url}", flush=True)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            pass
    return 0


if __name__ == "__main__":
    sys.exit(main())
