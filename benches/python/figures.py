"""Job i: three of the lecture's figures drawn with matplotlib and by `nyquist figures`, to SVG, PNG and PDF.

The same panels, curves, number of points and size (1600 x 900) as f20-closer, f27-overlap and f28-leak.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib

from race import Contender, race, save

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

matplotlib.rcParams.update({"font.size": 17, "font.family": "DejaVu Sans", "svg.hashsalt": "nyquist"})
PIECES = 801


def gaussian(a):
    width = np.sqrt(a / np.pi)
    return (lambda x: np.exp(-np.pi * (x / width) ** 2) / width), (lambda nu: np.exp(-a * nu**2))


def raised_cosine(band):
    return lambda nu: np.where(np.abs(nu) < band, np.cos(np.pi * nu / (2 * band)) ** 2, 0.0)


def closer():
    figure, axes = plt.subplots(4, 1, figsize=(16, 9))
    spectrum, nu = raised_cosine(0.5), np.linspace(-2.5, 2.5, PIECES)
    for axis, step in zip(axes, [0.5, 1.0, 1.5, 2.0]):
        order = int(np.ceil((0.5 + 2.5) * step))
        copies = [spectrum(nu - k / step) for k in range(-order, order + 1)]
        for copy in copies:
            axis.plot(nu, copy, lw=1)
        axis.plot(nu, sum(copies), lw=3, label="sum")
        axis.set(title=f"T = {step}", xlabel="ν", ylabel="F(ν)", ylim=(0, 2))
        axis.legend()
    return figure


def overlap():
    figure, axis = plt.subplots(figsize=(16, 9))
    _, spectrum = gaussian(8)
    nu = np.linspace(-1.5, 1.5, PIECES)
    copies = [spectrum(nu - k) for k in range(-4, 5)]
    for copy in copies:
        axis.plot(nu, copy, lw=1, color="C0")
    axis.plot(nu, sum(copies), lw=4, color="C3", label="their sum: all that the samples know")
    axis.axvline(-0.5, ls="--", color="grey")
    axis.axvline(0.5, ls="--", color="grey")
    axis.set(title="Aliasing: the copies overlap", xlabel="ν", ylabel="F(ν)", ylim=(0, 1.25))
    axis.legend()
    return figure


def leak():
    figure, (left, right) = plt.subplots(1, 2, figsize=(16, 9))
    f, spectrum = gaussian(8)
    nu = np.linspace(-1.25, 1.25, PIECES)
    inside = np.abs(nu) < 0.5
    kept = np.where(inside, sum(spectrum(nu - k) for k in range(-4, 5)), 0)
    left.fill_between(nu[inside], spectrum(nu[inside]), kept[inside], alpha=0.4, label="leaked")
    left.plot(nu, spectrum(nu), label="signal")
    left.plot(nu, kept, lw=4, label="reconstruction")
    left.set(title="in frequency", xlabel="ν", ylabel="F(ν)")
    left.legend()
    x = np.linspace(-2.5, 2.5, PIECES)
    k = np.arange(-12, 13)
    right.plot(x, f(x), label="signal")
    right.plot(x, np.sinc(x[:, None] - k) @ f(k), lw=4, label="reconstruction")
    right.plot(k[10:15], f(k[10:15]), "o", label="samples")
    right.set(title="in space", xlabel="x", ylabel="f(x)")
    right.legend()
    return figure


def draw(out):
    for build in [closer, overlap, leak]:
        figure = build()
        figure.tight_layout()
        for extension in ["svg", "png", "pdf"]:
            figure.savefig(out / f"{build.__name__}.{extension}", dpi=100)
        plt.close(figure)


def peak_of_process(command):
    """Megabytes that another process holds at most, its code too: the last that it says before it ends."""
    process, peak = subprocess.Popen(command, stdout=subprocess.DEVNULL), 0.0
    while process.poll() is None:
        lines = Path(f"/proc/{process.pid}/status").read_text().splitlines()
        peak = max([peak, *(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM:"))])
    return peak


def main(rounds):
    with tempfile.TemporaryDirectory() as folder:
        theirs, ours = Path(folder, "theirs"), Path(folder, "ours")
        theirs.mkdir()
        command = [os.environ["NYQUIST"], "f20-closer", "f27-overlap", "f28-leak", "--lang", "en", "--jobs", "1"]
        contenders = [
            Contender(
                "nyquist (the whole process)",
                lambda: lambda: subprocess.run([*command, "--out", ours], check=True, capture_output=True),
                lambda _: 0,
                ours=True,
            ),
            Contender(
                f"matplotlib {matplotlib.__version__} (without start and imports)",
                lambda: lambda: draw(theirs),
                lambda _: 0,
            ),
        ]
        contenders[0].memory = peak_of_process([*command, "--out", ours])
        # nothing is compared: both draw the panels, curves and points that are named above
        save("figures", [race("i", "three figures, nine panels, SVG, PNG and PDF", 1, 0, contenders, None, rounds)])


if __name__ == "__main__":
    main(int(sys.argv[1]))
