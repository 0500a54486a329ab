"""Drives a headless Chromium over pipes, by the DevTools protocol, with Python alone."""

import base64
import fcntl
import json
import os
import queue
import subprocess
import tempfile
import threading

LOADED = "document.readyState === 'complete' ? location.href : ''"


class Browser:
    """Starts the browser; commands may be sent from several threads, each with tabs of its own."""

    def __init__(self, command="chromium"):
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        read_commands, self._write = os.pipe()
        self._read, write_events = os.pipe()
        # The browser reads descriptor 3 and writes 4. The pipes move to higher descriptors first,
        # so that neither overwrites the other.
        ends = [fcntl.fcntl(end, fcntl.F_DUPFD, 10) for end in (read_commands, write_events)]

        def take_ends():
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        self._process = subprocess.Popen(
            [command, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
             "--no-first-run", "--disable-extensions", "--disable-background-networking",
             "--disable-background-timer-throttling", "--disable-renderer-backgrounding",
             "--disable-backgrounding-occluded-windows",  # every tab works, not only the first
             "--allow-file-access-from-files", "--hide-scrollbars", "--remote-debugging-pipe",
             f"--user-data-dir={self._profile.name}", "about:blank"],
            preexec_fn=take_ends, pass_fds=(3, 4), stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in [read_commands, write_events, *ends]:
            os.close(end)
        self._lock = threading.Lock()
        self._last_id = 0
        self._answers = {}  # id -> queue of a single answer
        self._events = {}   # session -> queue of events
        threading.Thread(target=self._listen, daemon=True).start()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._process.terminate()
        self._process.wait()
        self._profile.cleanup()

    def _listen(self):
        buffer = b""
        while chunk := os.read(self._read, 1 << 20):
            *messages, buffer = (buffer + chunk).split(b"\0")
            for message in map(json.loads, messages):
                if "id" in message:
                    self._answers.pop(message["id"]).put(message)
                elif message.get("sessionId") in self._events:
                    self._events[message["sessionId"]].put(message)

    def send(self, method, session=None, timeout=60, **parameters):
        """Sends a command and waits for its answer."""
        answer = queue.Queue()
        with self._lock:
            self._last_id += 1
            message = {"id": self._last_id, "method": method, "params": parameters}
            if session:
                message["sessionId"] = session
            self._answers[self._last_id] = answer
            os.write(self._write, json.dumps(message).encode() + b"\0")
        received = answer.get(timeout=timeout)
        if "error" in received:
            raise RuntimeError(f"{method}: {received['error']['message']}")
        return received["result"]

    def tab(self):
        return Tab(self)


class Tab:
    """Shows one page at a time, and collects the messages of its console."""

    def __init__(self, browser):
        self._browser = browser
        target = browser.send("Target.createTarget", url="about:blank")["targetId"]
        self._session = browser.send("Target.attachToTarget", targetId=target,
                                     flatten=True)["sessionId"]
        self._events = browser._events[self._session] = queue.Queue()
        for domain in ["Page", "Runtime", "Log"]:
            self.send(f"{domain}.enable")
        self.send("Emulation.setFocusEmulationEnabled", enabled=True)

    def send(self, method, **parameters):
        return self._browser.send(method, self._session, **parameters)

    def look(self, width, height, dark=False, scale=1, still=False):
        """Sets the size of the screen, and whether the reader prefers dark or still pages."""
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=scale, mobile=width < 500)
        self.send("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
            {"name": "prefers-reduced-motion", "value": "reduce" if still else "no-preference"}])

    def open(self, url):
        """Loads a page, and returns the errors of its console so far."""
        while not self._events.empty():
            self._events.get()
        failure = self.send("Page.navigate", url=url).get("errorText")
        errors = [failure] if failure else []
        while not failure:
            event = self._events.get(timeout=60)
            errors += console_errors(event)
            # The empty page that a tab starts with may report itself first.
            if event["method"] == "Page.loadEventFired" and self.evaluate(LOADED) == url:
                break
        return errors

    def save_picture(self, path):
        """Saves what the screen shows as a PNG."""
        path.write_bytes(base64.b64decode(self.send("Page.captureScreenshot", format="png")["data"]))

    def errors(self):
        """Returns further errors since open()."""
        found = []
        while not self._events.empty():
            found += console_errors(self._events.get())
        return found

    def evaluate(self, expression):
        """Returns the value of a JavaScript expression, or the value that a promise resolves to."""
        result = self.send("Runtime.evaluate", expression=expression, awaitPromise=True,
                           returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"].get("exception", {}).get("description"))
        return result["result"].get("value")


def console_errors(event):
    parameters = event["params"]
    if event["method"] == "Runtime.exceptionThrown":
        details = parameters["exceptionDetails"]
        return [details.get("exception", {}).get("description") or details["text"]]
    if event["method"] == "Runtime.consoleAPICalled" and parameters["type"] == "error":
        return [" ".join(str(argument.get("value", "")) for argument in parameters["args"])]
    if event["method"] == "Log.entryAdded" and parameters["entry"]["level"] == "error":
        return [f"{parameters['entry']['text']} {parameters['entry'].get('url', '')}"]
    return []
