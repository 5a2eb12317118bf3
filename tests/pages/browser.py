# SPDX-License-Identifier: MIT
"""A headless Chromium with one tab, by the DevTools protocol over a pipe."""
import json
import os
import select
import subprocess
import tempfile
import time

COMMAND = """chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run
--disable-background-networking --disable-component-update --disable-sync --disable-dev-shm-usage
--hide-scrollbars --remote-debugging-pipe""".split()
# Whatever a page asks for, no request leaves this machine.
COMMAND += ["--host-resolver-rules=MAP * ~NOTFOUND"]
PATIENCE = 60  # seconds to wait for an answer


class Browser:
    """Messages are JSON, each followed by a zero byte; the browser reads fd 3 and writes fd 4."""

    def __init__(self, log):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        browser_in, self.out = os.pipe()
        self.back, browser_out = os.pipe()
        # The caller has opened 3 and 4, so none of these four has such a number.
        os.dup2(browser_in, 3)
        os.dup2(browser_out, 4)
        self.process = subprocess.Popen(COMMAND + ["--user-data-dir=" + self.profile.name],
                                        stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                                        pass_fds=(3, 4))
        for fd in (3, 4, browser_in, browser_out):
            os.close(fd)
        self.buffer = b""
        self.events = []
        self.last = 0
        self.session = None
        tab = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=tab, flatten=True)["sessionId"]
        for domain in ("Page", "Network", "Runtime"):
            self.call(domain + ".enable")
        self.call("Emulation.setScriptExecutionDisabled", value=True)  # the page's own only

    def close(self):
        self.session = None
        try:
            self.call("Browser.close")
            self.process.wait(10)
        except (OSError, EOFError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        self.profile.cleanup()

    def receive(self):
        end = time.monotonic() + PATIENCE
        while b"\0" not in self.buffer:
            if not select.select([self.back], [], [], max(0, end - time.monotonic()))[0]:
                raise EOFError("chromium does not answer")
            data = os.read(self.back, 1 << 20)
            if not data:
                raise EOFError("chromium has ended")
            self.buffer += data
        message, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(message)

    def call(self, method, **params):
        """Sends one command; events that arrive meanwhile go to self.events."""
        self.last += 1
        message = {"id": self.last, "method": method, "params": params}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.out, data):]
        while True:
            answer = self.receive()
            if answer.get("id") == self.last:
                if "error" in answer:
                    raise EOFError(method + ": " + answer["error"]["message"])
                return answer["result"]
            self.events.append(answer)

    def open(self, url):
        """Returns the URLs requested until the page is complete."""
        self.events.clear()
        self.call("Page.navigate", url=url)
        while not any(e.get("method") == "Page.loadEventFired" for e in self.events):
            self.events.append(self.receive())
        return [e["params"]["request"]["url"] for e in self.events
                if e.get("method") == "Network.requestWillBeSent"]

    def evaluate(self, expression):
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True)
        if "exceptionDetails" in answer:
            raise EOFError(answer["exceptionDetails"]["exception"].get("description", "exception"))
        return answer["result"].get("value")
