#!/usr/bin/env python3
"""Spectra beside SciPy, and the predictions of `nyquist check` beside NumPy doing what they are about.

    cargo build --release
    python3 tests/peers/spectra.py target/release/nyquist [VENV]

Installs numpy and scipy by name into VENV (a temporary one if it is not given), prints two tables in Markdown, and fails
where something is beyond its tolerance.

1. `nyquist spectrum` beside `scipy.signal.welch` and `periodogram`: the definitions agree, so only rounding is left. What is
   shown is the largest difference of two densities in units of u·√(P·P_max) + u²·P_max, u = ε·log₂(n): a transform of n
   values errs by e = u·√P_max in every bin, and |√P + e|² − P = 2·e·√P + e². Tolerance: 8, of either side four.
2. `nyquist check --rate`: the sound is decimated by NumPy (every n-th value; where the ratio is no whole number, the tones
   are computed at the new times), and each predicted component is fitted at its predicted place.
   - tones: the difference of the fitted amplitude and the predicted one, in dB of the tone. Tolerance −90 dB, for the quietest
     tone (10⁻⁴): noise of 24 bits (q/√12 = 3.4·10⁻⁸) makes a fit of N values stray by √(2/N) of it (N ≥ 24000), and the
     spectrum of 144000 under a window of four bins by √(8/144000); five deviations of both are −91 dB. The loudest tone (0.3)
     adds −118 dB: side lobes of the window are 188 dB down.
   - bands: hiss under a swell, brick-wall high-passed by one transform of the whole and then decimated: its power against
     the predicted one, in dB. Tolerance 0.3 dB: five deviations of the mean square of 48000 values, √(2/48000) each, and
     0.013 dB that squared windows do not add up to.
"""

import json
import os
import subprocess
import sys
import tempfile

import beside


def main():
    import numpy as np
    import scipy
    from scipy import signal
    from scipy.io import wavfile

    binary = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp()
    source = os.path.join(folder, "in.wav")
    failed = []

    def spectrum(*args):
        command = [binary, "spectrum", source, "-o", "-", "--quantity", "density", *args]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        return np.loadtxt(done.stdout.splitlines()[1:], delimiter=",", ndmin=2)

    def check(rate):
        done = subprocess.run([binary, "check", source, "--rate", repr(rate), "--json"], capture_output=True, text=True)
        return json.loads(done.stdout)

    rng = np.random.default_rng(1)
    rate = 44100
    n = 100_003
    t = np.arange(n)
    cases = [
        ("hiss", rng.uniform(-0.5, 0.5, n)),
        ("two tones, an offset", 0.3 + 0.5 * np.sin(2 * np.pi * 0.0123 * t) + 1e-6 * np.sin(2 * np.pi * 0.31 * t)),
        ("a click", np.eye(1, n, n // 2)[0]),
    ]
    settings = [
        ("welch", "hann", "hann", 1024, 0.5, True),
        ("welch", "hamming", "hamming", 1000, 0.75, True),
        ("welch", "blackman", "blackman", 999, 0.5, True),
        ("welch", "blackman-harris", "blackmanharris", 4096, 0.5, False),
        ("welch", "flat-top", "flattop", 512, 0.0, True),
        ("welch", "kaiser:14", ("kaiser", 14.0), 2048, 0.875, True),
        ("periodogram", "rectangular", "boxcar", n, 0.0, True),
        ("periodogram", "hann", "hann", n, 0.0, False),
    ]
    print(f"SciPy {scipy.__version__}, NumPy {np.__version__}\n")
    print("| function | window | segment | overlap | mean | " + " | ".join(name for name, _ in cases) + " |")
    print("| --- | --- | ---: | ---: | --- |" + " ---: |" * len(cases))
    for function, ours, theirs, segment, overlap, detrend in settings:
        row = []
        for _, x in cases:
            wavfile.write(source, rate, x)
            args = ["--window", ours, "--segment", str(segment), "--overlap", str(overlap)]
            mine = spectrum(*args, *([] if detrend else ["--keep-mean"]))
            detrended = "constant" if detrend else False
            if function == "welch":
                shared = segment - round(segment * (1 - overlap))
                f, p = signal.welch(x, rate, theirs, nperseg=segment, noverlap=shared, detrend=detrended)
            else:
                f, p = signal.periodogram(x, rate, theirs, detrend=detrended)
            # each side multiplies and divides once or twice
            assert len(f) == len(mine) and np.allclose(f, mine[:, 0], rtol=4 * np.finfo(float).eps, atol=0)
            u = np.finfo(float).eps * np.log2(segment)
            size = u * np.sqrt(p.max() * p) + u**2 * p.max()
            worst = (np.abs(p - mine[:, 1]) / size).max()
            row.append(f"{worst:.2f}")
            if not worst <= 8:
                failed.append(f"{function} {ours}: {worst}")
        kept = "taken away" if detrend else "kept"
        print(f"| {function} | {ours} | {segment} | {overlap} | {kept} | " + " | ".join(row) + " |")

    own = 48000
    tones = np.array([[0.3, 440.3], [0.1, 1234.5], [0.02, 9123.4], [0.01, 12345.6], [0.001, 19191.9], [0.0001, 22222.2]])

    def tone(rate, n):
        t = np.arange(n)[:, None]
        return (tones[:, 0] * np.sin(2 * np.pi * np.mod(t * (tones[:, 1] / rate), 1.0) + tones[:, 0])).sum(axis=1)

    def fit(y, rate, frequencies):
        phase = 2 * np.pi * np.mod(np.arange(len(y))[:, None] * (np.asarray(frequencies) / rate), 1.0)
        basis = np.concatenate([np.cos(phase), np.sin(phase)], axis=1)
        found = np.linalg.lstsq(basis, y, rcond=None)[0]
        return np.hypot(found[: len(frequencies)], found[len(frequencies) :])

    def brickwall(x, low):
        bins = np.fft.rfft(x)
        bins[np.fft.rfftfreq(len(x), 1 / own) < low] = 0
        return np.fft.irfft(bins, len(x))

    n = 3 * own
    swell = np.sin(np.pi * np.clip((np.arange(n) / own - 0.5) / 2, 0, 1)) ** 2
    hiss = 0.2 * rng.uniform(-1, 1, n) * swell
    print("\n| to, Hz | tones: predicted place and amplitude against the fitted | bands: predicted power against the done |")
    print("| ---: | ---: | ---: |")
    for new in (24000, 16000, 12000, 8000, 11025, 7000, 15915.5):
        # 24-bit integers in the upper bytes of 32: what a recorder writes
        x = np.round(tone(own, n) * 2**23) / 2**23
        wavfile.write(source, own, x)
        folded = check(new)["forecast"][0]["folded"]
        step = own / new
        y = x[:: int(step)] if step == int(step) else tone(new, int(3 * new))
        beyond = tones[tones[:, 1] > new / 2]
        places = [line["lands_at"] for line in folded[: len(beyond)]]
        below = [f for _, f in tones if f <= new / 2]
        amplitudes = fit(y, new, below + places)[len(below) :]
        said = np.array([10 ** (line["levels"]["plain"] / 20) for line in folded[: len(beyond)]])
        worst = 20 * np.log10(np.max(np.abs(amplitudes / said - 1)))
        if not worst <= -90 or len(places) < len(beyond):
            failed.append(f"tones at {new}: {worst}")
        bands = ""
        if step == int(step):
            wavfile.write(source, own, hiss)
            ways = check(new)["forecast"][0]["ways"]
            done = np.mean(brickwall(hiss, new / 2)[:: int(step)] ** 2)
            off = 10 * np.log10(2 * done) - ways[0]["aliases"]
            bands = f"{off:+.3f} dB"
            if not abs(off) <= 0.3:
                failed.append(f"bands at {new}: {off}")
        print(f"| {new} | {worst:.1f} dB | {bands} |")
    return failed


beside.run(__doc__, ["numpy", "scipy"], main)
