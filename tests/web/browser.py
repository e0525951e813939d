"""Drives Chromium by the WebDriver protocol of its chromedriver, with Python's own library alone."""

import base64
import json
import re
import subprocess
import urllib.error
import urllib.request


class Browser:
    """A window of headless Chromium without a network: its proxy leads nowhere."""

    def __init__(self, chromedriver, chromium, width=1200, height=900, dark=False, webgl=True):
        self._driver = subprocess.Popen([chromedriver, "--port=0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        port = None
        for line in self._driver.stdout:
            found = re.search(r"on port (\d+)", line)
            if found and int(found.group(1)) > 0:
                port = found.group(1)
                break
        if port is None:
            raise RuntimeError("chromedriver does not start")
        self._url = f"http://127.0.0.1:{port}"
        arguments = ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--mute-audio",
                     "--proxy-server=127.0.0.1:9", f"--window-size={width},{height}", "--force-device-scale-factor=1"]
        arguments += ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] if webgl else ["--disable-gpu", "--disable-3d-apis"]
        if dark:
            arguments.append("--blink-settings=preferredColorScheme=0")
        session = self._call("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome",
            "goog:loggingPrefs": {"browser": "ALL"},
            "goog:chromeOptions": {"binary": chromium, "args": arguments}}}})
        self._session = "/session/" + session["sessionId"]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self._call("DELETE", self._session)
        finally:
            self._driver.terminate()
            self._driver.wait()

    def _call(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self._url + path, data, {"Content-Type": "application/json"}, method=method)
        opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        try:
            with opener.open(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from error

    def open(self, url):
        self._call("POST", self._session + "/url", {"url": url})

    def run(self, script, *arguments):
        """The value of a script's return; a script that returns a promise is awaited."""
        return self._call("POST", self._session + "/execute/sync", {"script": script, "args": list(arguments)})

    def screenshot(self, file):
        with open(file, "wb") as picture:
            picture.write(base64.b64decode(self._call("GET", self._session + "/screenshot")))

    def command(self, name, **parameters):
        """A command of the DevTools protocol."""
        return self._call("POST", self._session + "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def messages(self):
        """What the page has said on the console since the last call."""
        return [entry["message"] for entry in self._call("POST", self._session + "/se/log", {"type": "browser"})]
