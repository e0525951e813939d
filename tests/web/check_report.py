"""Opens a report in Chromium: it plays, its parts answer, it says nothing on the console, it looks as it did.

    check_report.py CHROMEDRIVER CHROMIUM REPORT PICTURE [RENEW]
"""

import base64
import io
import sys
import time
from pathlib import Path

import matplotlib.image
import numpy as np

from browser import Browser

chromedriver, chromium, report, picture, renew = sys.argv[1:6]
address = Path(report).resolve().as_uri()

until_ready = """return new Promise((resolve, refuse) => {
    const look = () => document.documentElement.dataset.ready ? resolve(true)
        : performance.now() > 20000 ? refuse("not ready: " + document.body.innerText) : setTimeout(look, 5);
    look();
});"""
choose = """const [id, value] = arguments;
    const control = document.getElementById(id);
    control.value = value;
    control.dispatchEvent(new Event(control.tagName === "INPUT" ? "input" : "change"));
    return new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(() =>
        resolve(document.querySelector(".view").innerText))));"""
pixels = "return document.querySelector('.view canvas').toDataURL('image/png')"
hover = """const box = document.querySelector(".view").getBoundingClientRect();
    return arguments[0].map(([x, y]) => {
        document.querySelector(".view").dispatchEvent(new PointerEvent("pointermove",
            {clientX: box.left + x * box.width, clientY: box.top + y * box.height, bubbles: true}));
        return document.querySelector(".tip").textContent;
    });"""
kind = "return document.querySelector('.view canvas').dataset.kind"
phases = "const { shown, ready } = document.documentElement.dataset; return [Number(shown), Number(ready)]"
when = "return document.querySelector('.when').textContent"


def view(browser):
    """The drawing as an array of red, green, blue and opacity from 0 to 1."""
    return matplotlib.image.imread(io.BytesIO(base64.b64decode(browser.run(pixels).split(",")[1])))


def difference(one, other):
    """Part of the pixels that differ clearly."""
    assert one.shape == other.shape, (one.shape, other.shape)
    return float((np.abs(one - other).max(axis=2) > 0.25).mean())


def check_page(browser):
    text = browser.run("return document.body.innerText")
    for words in ("The run is complete: 2 blocks", "Point 'block' moved farthest", "Displacement from the base",
                  "Response spectrum of the base", "friction_angle 25 deg", "The energy balance closes", "SHA-256",
                  "friction took"):
        assert words in text, f"no '{words}' in: {text}"
    assert browser.run("return document.querySelectorAll('.uplot canvas').length") == 3
    assert browser.run("return performance.getEntriesByType('resource').length") == 0, "the page loads something"


def check_controls(browser):
    # It begins at the end; the slider, the colours and the exaggeration change what is drawn.
    assert browser.run(when) == "shake: 2.00 s", browser.run(when)
    last = view(browser)
    assert "shake: 0.0" in browser.run(choose, "time", "0.05")
    assert difference(last, view(browser)) > 0.001, "the slider changes nothing"
    assert "slip of joints" in browser.run(choose, "field", "slip")
    assert "largest compression" in browser.run(choose, "field", "stress")
    browser.run(choose, "time", "1.5")
    before = view(browser)
    browser.run(choose, "exaggeration", "1")
    assert difference(before, view(browser)) > 0.005, "the exaggeration changes nothing"
    browser.run(choose, "exaggeration", "0")
    tip = browser.run(hover, [[0.4, 0.75]])[0]
    assert tip.startswith("block 0, rock"), tip
    places = [[x, y] for x in (0.3, 0.33, 0.36) for y in np.linspace(0.1, 0.4, 60)]
    names = {tip.split("\n")[0] for tip in browser.run(hover, places)}
    assert any(name.startswith("block 1, rock") for name in names), names
    assert any(name.startswith("joint 'plane', plane, between blocks 0 and 1") for name in names), names


def check_playing(browser):
    browser.run(choose, "time", "0.1")
    browser.run(choose, "speed", "0.5")
    browser.run("document.getElementById('play').click()")
    seen = set()
    for _ in range(6):
        time.sleep(0.12)
        seen.add(browser.run(when))
    assert len(seen) > 3, f"the label stands still: {seen}"
    mark = browser.run("return parseFloat(document.querySelector('#history .now').style.left)")
    browser.run("document.getElementById('play').click()")
    time.sleep(0.1)
    stopped = browser.run(when)
    time.sleep(0.3)
    assert browser.run(when) == stopped, "it does not pause"
    assert mark > 0, "the history has no mark of the time"
    value = browser.run("return document.querySelector('#history .u-legend .u-value').textContent")
    assert abs(float(value) - float(stopped.split()[1])) < 0.05, (value, stopped)


def check_lost_context(browser):
    """A graphics card that stops working leaves a view that a canvas draws."""
    browser.run("""const lost = new Event("webglcontextlost");
        document.querySelector(".view canvas").dispatchEvent(lost);""")
    assert browser.run(kind) == "canvas"
    assert "shake: 0.0" in browser.run(choose, "time", "0.05")


def check_policy(browser):
    browser.run("""const script = document.createElement("script");
        script.textContent = "window.intruded = true";
        document.body.append(script);
        const picture = new Image();
        picture.src = "http://127.0.0.1:9/picture.png";
        document.body.append(picture);""")
    assert browser.run("return window.intruded") is None, "a script that is not the page's runs"
    time.sleep(0.1)
    refused = browser.messages()
    assert sum("Content Security Policy" in message for message in refused) >= 2, refused


with Browser(chromedriver, chromium) as browser:
    browser.open(address)
    browser.run(until_ready)
    assert browser.run(kind) == "webgl2"
    shown, ready = browser.run(phases)
    assert 0 < shown < ready, (shown, ready)
    check_page(browser)
    picture_shown = view(browser)
    if renew:
        matplotlib.image.imsave(picture, picture_shown)
    changed = difference(picture_shown, matplotlib.image.imread(picture))
    assert changed < 0.01, f"{100 * changed:.2f} % of the pixels differ from {picture}"
    check_controls(browser)
    check_playing(browser)
    check_lost_context(browser)
    assert browser.messages() == [], browser.messages()
    check_policy(browser)

# The same in a browser without WebGL, in the dark.
with Browser(chromedriver, chromium, dark=True, webgl=False) as browser:
    browser.open(address)
    browser.run(until_ready)
    assert browser.run("return document.createElement('canvas').getContext('webgl2')") is None, "the browser has WebGL"
    assert browser.run(kind) == "canvas"
    assert difference(picture_shown, view(browser)) < 0.03, "the two ways to draw differ"
    assert browser.run("return getComputedStyle(document.body).backgroundColor") == "rgb(22, 24, 28)", "it is not dark"
    check_controls(browser)
    check_playing(browser)
    assert browser.messages() == [], browser.messages()
