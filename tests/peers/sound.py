#!/usr/bin/env python3
"""Conversion of sampling rates beside soxr and SciPy, on tones and sweeps whose converted samples are known in closed form.

    cargo build --release
    python3 tests/peers/sound.py target/release/nyquist [VENV]

Installs numpy, scipy and soxr by name into VENV (a temporary one if it is not given), prints two tables in Markdown, and
fails where something is beyond its tolerance.

The first says who is closer to the truth:

- residual: the largest sample that is left when the tone itself is fitted and taken away (images, distortion, noise), over
  tones up to 0.9 of the lower Nyquist frequency, in dB of the tone;
- truth: the largest difference from the true samples of these tones (gain, phase and delay count), over the same tones;
- pass-band: up to which fraction of the lower Nyquist frequency the gain is within 0.1 dB;
- alias, near and far: the largest sample that tones beyond the lower Nyquist frequency leave, within 10 % of it and above;
- sweep: the largest difference from the true samples of one sweep from 0 to 0.91 of the lower Nyquist frequency, ends of the
  record included;
- sweep beyond: the largest sample that a sweep from the lower Nyquist frequency to the higher leaves.

Tones last 20000 samples of the lower rate and up to the next half second; 2000 at either end are not looked at. Sweeps are as
long and fade in and out by error functions of the frequency, √(r/π) Hz wide where it rises by r Hz/s: their spectrum falls off
at both ends like a Gaussian of that deviation, and 7.5 deviations are kept, which is −244 dB. All samples are 64-bit floats.

What each quality promises (`nyquist resample --help`) is its tolerance: the pass-band; the rejection for residuals and
aliases; rejection and ripple together for differences from the truth. And `best` has to be at least as clean as soxr VHQ.

The second holds the definition beside `scipy.signal.resample_poly`: a rational conversion is one filter between zeros put in
and values left out. The filter is read off from nyquist's own responses to impulses, at every phase, and given to SciPy; both
convert hiss of full scale. Tolerance: the promised rejection, of full scale. nyquist filters through the spectrum, block by
block, and what its filter leaves beyond a block depends on where the block starts; that part is rejected as aliases are.
"""

import os
import subprocess
import sys
import tempfile

import beside

# pass-band (of the lower Nyquist frequency), ripple in dB, rejection in dB
PROMISES = {"best": (0.99, 1e-9, 200), "high": (0.96, 3e-7, 150), "fast": (0.91, 1e-4, 100)}
PAIRS = [(44100, 48000), (48000, 44100), (96000, 44100), (8000, 48000), (44100, 46181.3)]


def main():
    import numpy as np
    import scipy
    import soxr
    from scipy import signal, special
    from scipy.io import wavfile

    binary = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp()
    failed = []

    def ours(quality):
        def convert(x, a, b):
            source, target = os.path.join(folder, "in.wav"), os.path.join(folder, "out.wav")
            wavfile.write(source, a, x)
            args = [binary, "resample", source, target, "--rate", str(b), "--quality", quality, "--force"]
            subprocess.run(args, check=True, capture_output=True)
            return wavfile.read(target)[1]

        return convert

    def poly(window):
        def convert(x, a, b):
            if b != int(b):
                return None
            g = np.gcd(a, b)
            return signal.resample_poly(x, b // g, a // g, axis=0, window=window)

        return convert

    def fourier(x, a, b):
        if len(x) * b % a != 0:
            return None
        return signal.resample(x, round(len(x) * b / a), axis=0)

    peers = [
        ("nyquist best", ours("best")),
        ("nyquist high", ours("high")),
        ("nyquist fast", ours("fast")),
        ("soxr VHQ", lambda x, a, b: soxr.resample(x, a, b, quality="VHQ")),
        ("soxr HQ", lambda x, a, b: soxr.resample(x, a, b, quality="HQ")),
        ("resample_poly, Kaiser 5 (default)", poly(("kaiser", 5.0))),
        ("resample_poly, Kaiser 14 (default length)", poly(("kaiser", 14.0))),
        ("scipy.signal.resample (FFT of the whole)", fourier),
    ]

    def tones(frequencies, rate, low):
        t = np.arange(round(np.ceil(40_000 / low) / 2 * rate))[:, None]
        # phases reduced before they are multiplied by 2π
        return np.sin(2 * np.pi * np.mod(t * (np.asarray(frequencies) / rate), 1.0) + 0.3)

    def sweep(start, end, rate, low, frames=None):
        lasts = np.ceil(40_000 / low) / 2
        t = np.arange(round(lasts * rate) if frames is None else frames, dtype=np.longdouble) / rate
        rise = (end - start) / lasts
        width = np.sqrt(rise / np.pi)
        f = (start + rise * t).astype(float)
        fade = special.erf((f - start) / width - 7.5) - special.erf((f - end) / width + 7.5)
        phase = np.mod((start + rise / 2 * t) * t, 1).astype(float)
        return (fade / 2 * np.sin(2 * np.pi * phase))[:, None]

    def middle(y, rate, low):
        where = slice(round(2_000 * rate / low), round(18_000 * rate / low))
        return where, y[where]

    def decibels(v):
        return 20 * np.log10(max(v, 1e-20))

    def gains_and_rest(y, frequencies, rate, low):
        where, y = middle(y, rate, low)
        t = np.arange(where.start, where.stop)
        gains, rest = [], []
        for c, f in enumerate(frequencies):
            phase = 2 * np.pi * np.mod(t * (f / rate), 1.0)
            basis = np.stack([np.cos(phase), np.sin(phase)], axis=1)
            fit = np.linalg.lstsq(basis, y[:, c], rcond=None)[0]
            gains.append(np.hypot(*fit))
            rest.append(np.abs(y[:, c] - basis @ fit).max())
        return np.array(gains), np.array(rest)

    print(f"soxr {soxr.__version__}, SciPy {scipy.__version__}, NumPy {np.__version__}\n")
    heads = "residual, dB | truth, dB | pass-band | alias near, dB | alias far, dB | sweep, dB | sweep beyond, dB"
    print(f"| rates | who | {heads} |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    for a, b in PAIRS:
        slow = min(a, b)
        low, high = slow / 2, a / 2
        flat = low * np.linspace(0.013, 0.9, 40)
        edge = low * np.arange(0.8, 1.0, 0.0025)
        near = low + np.linspace(0.0005, min(0.1, high / low - 1.001), 25) * low if a > b else []
        far = np.linspace(1.1 * low, 0.999 * high, 25) if 1.1 * low < high else []
        found = {}
        for name, convert in peers:
            y = convert(tones(flat, a, slow), a, b)
            if y is None:
                continue
            _, rest = gains_and_rest(y, flat, b, slow)
            where, values = middle(y, b, slow)
            truth = np.abs(values - tones(flat, b, slow)[where]).max()
            gains, _ = gains_and_rest(convert(tones(edge, a, slow), a, b), edge, b, slow)
            bad = np.nonzero(np.abs(20 * np.log10(gains)) > 0.1)[0]
            band = edge[bad[0] - 1] / low if len(bad) and bad[0] > 0 else (0.8 if len(bad) else 1.0)
            leaks = []
            for frequencies in (near, far):
                if len(frequencies) > 0:
                    left = middle(convert(tones(frequencies, a, slow), a, b), b, slow)[1]
                    leaks.append(decibels(np.abs(left).max()))
                else:
                    leaks.append(None)
            y = np.reshape(convert(sweep(0, 0.91 * low, a, slow), a, b), (-1, 1))
            swept = np.abs(y - sweep(0, 0.91 * low, b, slow, len(y))).max()
            leaks.append(decibels(swept))
            leaks.append(decibels(np.abs(convert(sweep(low, high, a, slow), a, b)).max()) if a > b else None)
            mark = "≤ " if band == 0.8 else ""
            cells = ["" if v is None else f"{v:.1f}" for v in leaks]
            print(
                f"| {a} → {b} | {name} | {decibels(rest.max()):.1f} | {decibels(truth):.1f} | {mark}{band:.4f} "
                f"| {' | '.join(cells)} |",
                flush=True,
            )
            # all in dB; smaller is better
            found[name] = [decibels(rest.max()), decibels(truth), *leaks]
            quality = name.removeprefix("nyquist ")
            if quality in PROMISES:
                pass_band, ripple, rejection = PROMISES[quality]
                exact = decibels(10 ** (ripple / 20) - 1 + 10 ** (-rejection / 20))
                allowed = [-rejection, exact, -rejection, -rejection, exact, -rejection]
                for v, most in zip(found[name], allowed):
                    if v is not None and not v <= most:
                        failed.append(f"{a} → {b}, {name}: {v} dB where {most} are allowed")
                if not band >= pass_band:
                    failed.append(f"{a} → {b}, {name}: a pass-band of {band}")
        for v, most in zip(found["nyquist best"], found["soxr VHQ"]):
            if v is not None and not v <= most:
                failed.append(f"{a} → {b}: nyquist best {v} dB, soxr VHQ {most} dB")

    print("\n| rates | quality | difference from resample_poly with its filter, dB | allowed |")
    print("| --- | --- | ---: | ---: |")
    hiss = np.random.default_rng(1).uniform(-1, 1, 30_011)
    for a, b in PAIRS:
        if b != int(b):
            continue
        up, down = b // np.gcd(a, b), a // np.gcd(a, b)
        # the longest filter's reach; impulses that far apart, one at every phase
        reach = round(2500 * max(1, a / b))
        apart = -(-2 * reach // down) * down + 1
        places = apart * np.arange(1, down + 1)
        impulses = np.zeros(apart * (down + 1))
        impulses[places] = 1
        for quality, (_, _, rejection) in PROMISES.items():
            response = ours(quality)(impulses, a, b)
            # output m is the filter at m·down − n·up of the impulse at n
            taps = np.zeros(2 * reach * up + 1)
            for n in places:
                m = np.arange(-((reach - n) * up // down), (n + reach) * up // down + 1)
                taps[m * down - n * up + reach * up] = response[m]
            # SciPy multiplies its filters by the zeros put in
            mine, theirs = ours(quality)(hiss, a, b), signal.resample_poly(hiss, up, down, window=taps / up)
            # SciPy rounds the length up
            off = decibels(np.abs(mine - theirs[: len(mine)]).max())
            print(f"| {a} → {b} | {quality} | {off:.1f} | -{rejection} |", flush=True)
            if not off <= -rejection:
                failed.append(f"{a} → {b}, {quality}: {off} dB from resample_poly with its filter")
    return failed


beside.run(__doc__, ["numpy", "scipy", "soxr"], main)
