#!/usr/bin/env python3
"""Values between samples, and spectra of irregular samples, beside NumPy, SciPy and Astropy, on signals known in closed form.

    cargo build --release
    python3 tests/peers/table.py target/release/nyquist [VENV]

Installs numpy, scipy and astropy by name into VENV (a temporary one if it is not given), prints three tables in Markdown, and
fails where something is beyond its tolerance. ε is 2⁻⁵².

The definition: `interpolate --method periodic` beside `scipy.signal.resample` to more samples; both are the trigonometric
polynomial through all of them, here of noise up to the Nyquist frequency. The new times are written to 17 digits, off by ε/2 of
the last one, and the polynomial's slope is at most 2π·(Nyquist frequency)·max|p| (Bernstein). Tolerance: π·ε·t·max|p| for
the times of either, and 8·ε·log₂(n)·max|p| for their transforms, of either side four.

Values between samples: 2000 samples of five tones up to 0.7 of the Nyquist frequency (Nyquist frequency 1), asked for at 20011
times between them; the largest difference from the closed form, over the whole record and over its middle nine tenths, in dB of
the sum of the amplitudes, and the seconds it took (for nyquist with start, reading and writing):

- period: the tones fit into the record; otherwise they do not, as in any record of the world;
- lost: every 17th sample is missing; jitter: positions stray by up to 0.3 steps.

Kernels must keep in the middle the error that they print. Of a period the polynomial and least squares that wrap are exact but
for the rounding of phases, 2π·ε·f·t at the fastest tone. Where the truth is no such function there is no tolerance; nyquist's
default has to be closer than all of SciPy's and NumPy's that are told no more, in the middle and over the whole.

Spectra: amplitudes of two tones (2 and 0.02) among 400 random times of a record, in noise of 0.01; what each finds at the
best frequency of its own near the truth. nyquist fits under Hann's window w, so the deviations of what it finds are those of
the Cramér–Rao bound, σ√(2/N) of an amplitude A and √6·σ/(π·A·T·√N) of its frequency, times √1.5 (1.5 = ∫w²/(∫w)²) and
√2.34 (2.34 = ∫t²·∫w²t²/(∫wt²)²). Tolerance: five of them. Amplitudes of single frequencies are Astropy's by definition:
tolerance ε·N·A_max, sums of N rounded products.
"""

import json
import os
import subprocess
import sys
import tempfile
import time

import beside


def main():
    import astropy
    import numpy as np
    import scipy
    from astropy.timeseries import LombScargle
    from scipy import interpolate, optimize, signal

    binary = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp()
    source, wanted, target = (os.path.join(folder, name) for name in ("in.csv", "at.csv", "out.csv"))
    failed = []
    promised = {}

    def ours(*options):
        def between(t, v, at):
            np.savetxt(source, np.stack([t, v], axis=1), delimiter=",", fmt="%.17g")
            np.savetxt(wanted, at, fmt="%.17g")
            args = [binary, "interpolate", source, "--at", wanted, "-o", target, "--force", "--json", *options]
            done = subprocess.run(args, check=True, capture_output=True)
            way = json.loads(done.stdout)["pieces"][0]["way"]
            promised[way["method"].split(":")[0]] = way.get("error")
            return np.loadtxt(target, delimiter=",")[:, 1]

        return between

    def fourier(t, v, at):
        """scipy.signal.resample to 64 times the rate, and a cubic spline through that."""
        dense = signal.resample(v, 64 * len(v))
        step = (t[-1] - t[0]) / (len(t) - 1)
        grid = t[0] + np.arange(len(dense)) * step / 64
        return interpolate.CubicSpline(grid, dense)(at)

    def numpy_fft(t, v, at):
        """The trigonometric polynomial through the samples, by its sum."""
        n = len(v)
        period = (t[-1] - t[0]) * n / (n - 1)
        c = np.fft.rfft(v) / n
        k = np.arange(len(c))
        weight = np.where((k == 0) | (2 * k == n), 1.0, 2.0)
        out = np.empty(len(at))
        for i in range(0, len(at), 500):
            turns = np.outer((at[i : i + 500] - t[0]) / period, k)
            out[i : i + 500] = (np.exp(2j * np.pi * turns) @ (weight * c)).real
        return out

    def spline(t, v, at):
        return interpolate.CubicSpline(t, v)(at)

    def linear(t, v, at):
        return np.interp(at, t, v)

    def akima(t, v, at):
        return interpolate.Akima1DInterpolator(t, v)(at)

    peers = {
        "nyquist kaiser": ours("--method", "kaiser"),
        "nyquist regularised": ours("--method", "regularised"),
        "nyquist periodic": ours("--method", "periodic"),
        "nyquist least-squares": ours("--method", "least-squares"),
        "nyquist least-squares, wrap": ours("--method", "least-squares", "--edge", "wrap"),
        "NumPy FFT, by its sum": numpy_fft,
        "scipy.signal.resample ×64 + CubicSpline": fourier,
        "scipy CubicSpline": spline,
        "scipy Akima1DInterpolator": akima,
        "numpy.interp": linear,
    }
    regular = ["nyquist kaiser", "nyquist regularised", "nyquist periodic", "NumPy FFT, by its sum"]
    regular.append("scipy.signal.resample ×64 + CubicSpline")

    n = 2000
    rng = np.random.default_rng(1)
    step = 0.5
    even = np.arange(n) * step
    amplitudes = np.array([1.0, 0.7, 0.5, 0.3, 0.2])
    phases = rng.uniform(0, 2 * np.pi, 5)
    fitting = np.round(np.array([0.013, 0.11, 0.29, 0.5, 0.7]) * n * step) / (n * step)
    free = fitting + 0.37 / (n * step)

    def tones(frequencies, t):
        return sum(a * np.cos(2 * np.pi * f * t + p) for a, f, p in zip(amplitudes, frequencies, phases))

    def decibels(v):
        return f"{20 * np.log10(max(v, 1e-20)):.0f}"

    cases = [
        ("a period", even, fitting),
        ("no period", even, free),
        ("lost", even[np.arange(n) % 17 != 5], free),
        ("jitter", even + step * rng.uniform(-0.3, 0.3, n), free),
    ]
    print(f"NumPy {np.__version__}, SciPy {scipy.__version__}, Astropy {astropy.__version__}\n")
    eps = np.finfo(float).eps
    print("| samples | to | largest difference from scipy.signal.resample | allowed |")
    print("| ---: | ---: | ---: | ---: |")
    for count, more in [(2000, 4800), (2000, 3001), (2001, 3001), (2001, 4000)]:
        values = rng.uniform(-1, 1, count)
        theirs = signal.resample(values, more)
        at = np.arange(more) * (count * step / more)
        at, theirs = at[at <= (count - 1) * step], theirs[at <= (count - 1) * step]
        off = np.abs(peers["nyquist periodic"](np.arange(count) * step, values, at) - theirs).max()
        allowed = (2 * np.pi * eps * count * step + 8 * eps * np.log2(count)) * np.abs(theirs).max()
        print(f"| {count} | {more} | {off:.1e} | {allowed:.1e} |", flush=True)
        if not off <= allowed:
            failed.append(f"resample of {count} to {more}: {off}")

    print("\n| samples | who | worst, dB | worst in the middle, dB | s |")
    print("| --- | --- | ---: | ---: | ---: |")
    for name, t, frequencies in cases:
        at = np.sort(rng.uniform(t[0], t[-1], 20011))
        truth = tones(frequencies, at)
        phase = 2 * np.pi * eps * frequencies[-1] * t[-1]
        errors = {}
        middle = (at > t[0] + 0.05 * (t[-1] - t[0])) & (at < t[-1] - 0.05 * (t[-1] - t[0]))
        for who, between in peers.items():
            if who in regular and name in ("lost", "jitter"):
                continue
            start = time.perf_counter()
            off = np.abs(between(t, tones(frequencies, t), at) - truth) / amplitudes.sum()
            took = time.perf_counter() - start
            errors[who] = worst, inner = off.max(), off[middle].max()
            print(f"| {name} | {who} | {decibels(worst)} | {decibels(inner)} | {took:.2f} |", flush=True)
            method = who.removeprefix("nyquist ")
            if method in ("kaiser", "regularised") and not inner <= promised[method] + phase:
                failed.append(f"{name}, {who}: {inner} where {promised[method]} is printed")
            if name == "a period" and method in ("periodic", "least-squares, wrap") and not worst <= phase:
                failed.append(f"{name}, {who}: {worst} where {phase} is allowed")
        if name != "a period":
            best = errors["nyquist kaiser" if name == "no period" else "nyquist least-squares"]
            for who, (worst, inner) in errors.items():
                if not who.startswith("nyquist") and not (best[0] < worst and best[1] < inner):
                    failed.append(f"{name}: {who} is closer than nyquist's default")

    # spectra
    t = np.sort(rng.uniform(0, 100, 400))
    strong, weak = 1.2345, 1.5
    v = 2 * np.cos(2 * np.pi * strong * t + 0.4) + 0.02 * np.cos(2 * np.pi * weak * t - 1) + 0.01 * rng.normal(size=400)
    np.savetxt(source, np.stack([t, v], axis=1), delimiter=",", fmt="%.17g")
    check = subprocess.run([binary, "check", source, "--json"], capture_output=True, check=True)
    lines = json.loads(check.stdout)["columns"][0]["lines"]
    found = {"nyquist check (lines)": [(line["frequency"], line["amplitude"]) for line in lines]}
    for (f, a), truth, amplitude in zip(found["nyquist check (lines)"] + 2 * [(0, 0)], (strong, weak), (2, 0.02)):
        off_a = (a - amplitude) / (0.01 * np.sqrt(1.5 * 2 / 400))
        off_f = (f - truth) / (np.sqrt(2.34 * 6) * 0.01 / (np.pi * amplitude * 100 * np.sqrt(400)))
        if not max(abs(off_a), abs(off_f)) <= 5:
            failed.append(f"the line at {truth}: off by {off_a} deviations in amplitude, {off_f} in frequency")

    def two(p):
        return p[0] + sum(a * np.cos(2 * np.pi * f * t + b) for a, f, b in (p[1:4], p[4:7])) - v

    fit = optimize.least_squares(two, [0, 2, strong, 0.4, 0.02, weak, -1], x_scale=[1, 1, 1e-3, 1, 1, 1e-3, 1], xtol=1e-14)
    found["scipy least_squares, started at the truth"] = [(fit.x[2], fit.x[1]), (fit.x[5], fit.x[4])]
    grid = np.linspace(0.01, 4, 400 * 40)

    def near(amplitude):
        def top(truth):
            window = np.abs(grid - truth) < 0.02
            i = np.flatnonzero(window)[np.argmax(amplitude[window])]
            return grid[i], amplitude[i]

        return [top(strong), top(weak)]

    power = signal.lombscargle(t, v - v.mean(), 2 * np.pi * grid, floating_mean=True)
    found["scipy.signal.lombscargle"] = near(np.sqrt(4 * power / len(t)))
    psd = LombScargle(t, v).power(grid, normalization="psd")
    found["astropy LombScargle"] = near(np.sqrt(4 * psd / len(t)))
    table = os.path.join(folder, "spectrum.csv")
    args = [binary, "spectrum", source, "--window", "rectangular", "--up-to", "4", "-o", table]
    subprocess.run(args, check=True, capture_output=True)
    ours_grid, ours_amplitude = np.loadtxt(table, delimiter=",", skiprows=1).T
    scargle = LombScargle(t, v)
    theirs = np.array([np.hypot(*scargle.model_parameters(f)[1:]) for f in ours_grid])
    print("\n| who | 2 at 1.2345 | 0.02 at 1.5 |")
    print("| --- | --- | --- |")
    for who, tops in found.items():
        cells = [f"{a:.5f} at {f:.6f}" for f, a in tops[:2]]
        print(f"| {who} | {' | '.join(cells + [''] * (2 - len(cells)))} |")
    print("\nAmplitudes of `nyquist spectrum` (rectangular window) beside those of Astropy's model at the same frequencies:")
    off, allowed = np.abs(ours_amplitude - theirs).max(), eps * 400 * theirs.max()
    print(f"the largest difference is {off:.1e}; {allowed:.1e} is allowed.")
    if not off <= allowed:
        failed.append(f"amplitudes beside Astropy's: {off}")
    return failed


beside.run(__doc__, ["numpy", "scipy", "astropy"], main)
