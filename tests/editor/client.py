"""A client of rust-analyzer: the requests of an editor, at the places of a file that are marked in it.

A mark is a comment `/*name*/` behind which the cursor stands.
"""

import json
import queue
import re
import subprocess
import threading
import time


class Editor:
    """Runs the server on a package until `close`."""

    def __init__(self, root, settings):
        self.server = subprocess.Popen(
            ["rust-analyzer"], cwd=root, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL)
        self.messages, self.settings, self.last, self.is_ready = queue.Queue(), settings, 0, False
        threading.Thread(target=self.read, daemon=True).start()
        ask = {
            "textDocument": {
                "completion": {"completionItem": {"snippetSupport": False}},
                "hover": {"contentFormat": ["markdown"]},
            },
            "experimental": {"serverStatusNotification": True},
            "window": {"workDoneProgress": True},
        }
        self.request("initialize", {
            "processId": None, "rootUri": f"file://{root}", "capabilities": ask,
            "initializationOptions": settings})
        self.notify("initialized", {})

    def read(self):
        """Puts whole messages into the queue."""
        out = self.server.stdout
        while line := out.readline():
            length = int(line.split(b":")[1])
            while out.readline().strip():
                pass
            self.messages.put(json.loads(out.read(length)))

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.server.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.server.stdin.flush()

    def notify(self, method, params):
        self.send({"method": method, "params": params})

    def take(self, seconds):
        """One message; what the server asks is answered."""
        message = self.messages.get(timeout=max(seconds, 0.01))
        if "method" in message and "id" in message:
            is_setting = message["method"] == "workspace/configuration"
            asked = message["params"]["items"] if is_setting else None
            self.send({"id": message["id"], "result": [self.settings for _ in asked] if asked else None})
        if message.get("method") == "experimental/serverStatus":
            status = message["params"]
            self.is_ready = status["quiescent"]
            assert status["health"] != "error", status
        return message

    def request(self, method, params, seconds=60):
        """The answer, asked for again where the server says that something changed below it."""
        until = time.monotonic() + seconds
        while True:
            self.last += 1
            number = self.last
            self.send({"id": number, "method": method, "params": params})
            while True:
                answer = self.take(until - time.monotonic())
                if answer.get("id") == number and "method" not in answer:
                    break
            if "error" not in answer:
                return answer["result"]
            assert answer["error"]["code"] in (-32801, -32802), (method, answer["error"])

    def wait(self, seconds):
        """Until everything is loaded and macros can be expanded."""
        until = time.monotonic() + seconds
        while not self.is_ready:
            self.take(until - time.monotonic())

    def open(self, path):
        return File(self, path)

    def close(self):
        self.request("shutdown", None)
        self.notify("exit", None)
        self.server.wait(timeout=10)


class File:
    """An open file."""

    def __init__(self, editor, path):
        self.editor, self.uri, self.text = editor, f"file://{path}", path.read_text()
        editor.notify("textDocument/didOpen", {"textDocument": {
            "uri": self.uri, "languageId": "rust", "version": 1, "text": self.text}})

    def place(self, mark):
        """The place behind a mark, as the protocol counts it."""
        found = list(re.finditer(r"/\*%s\*/" % re.escape(mark), self.text))
        assert len(found) == 1, f"{len(found)} marks `{mark}`"
        return self.position(found[0].end())

    def position(self, offset):
        before = self.text[:offset]
        return {"line": before.count("\n"), "character": len(before.rsplit("\n", 1)[-1])}

    def ask(self, what, mark, **more):
        return self.editor.request(f"textDocument/{what}", {
            "textDocument": {"uri": self.uri}, "position": self.place(mark), **more})

    def completions(self, mark):
        """The names that are offered, without the rest of a line."""
        items = self.ask("completion", mark)
        items = items["items"] if isinstance(items, dict) else items
        return [re.split(r"[(\s]", item["label"])[0] for item in items or []]

    def hover(self, mark):
        answer = self.ask("hover", mark)
        return answer["contents"]["value"] if answer else ""

    def definition(self, mark):
        """The tokens that a definition is found at."""
        answer = self.ask("definition", mark) or []
        answer = answer if isinstance(answer, list) else [answer]
        return [self.words(place) for place in answer]

    def words(self, place):
        """The text of a place, with its line."""
        uri = place.get("targetUri") or place["uri"]
        span = place.get("targetSelectionRange") or place["range"]
        if uri != self.uri:
            return uri, None
        line = self.text.split("\n")[span["start"]["line"]]
        return line[span["start"]["character"]:span["end"]["character"]], line.strip()

    def renamed(self, mark, name):
        """The lines that a new name changes."""
        answer = self.ask("rename", mark, newName=name)
        edits = [edit for change in answer.get("documentChanges", []) for edit in change["edits"]]
        edits += [edit for change in answer.get("changes", {}).values() for edit in change]
        places = {(edit["range"]["start"]["line"], edit["range"]["start"]["character"]) for edit in edits}
        return sorted(places)
