#!/usr/bin/env python3
"""Conversion of sampling rates beside soxr and SciPy, on tones whose converted samples are known in closed form.

    cargo build --release
    python3 tests/peers/sound.py target/release/nyquist [VENV]

Installs numpy, scipy and soxr by name into VENV (a temporary one if it is not given) and prints a table in Markdown:

- residual: the largest sample that is left when the tone itself is fitted and taken away (images, distortion, noise), over
  tones up to 0.9 of the lower Nyquist frequency, in dB of the tone;
- truth: the largest difference from the true samples of these tones (gain, phase and delay count), over the same tones;
- pass-band: up to which fraction of the lower Nyquist frequency the gain is within 0.1 dB;
- alias, near and far: the largest sample that tones beyond the lower Nyquist frequency leave, within 10 % of it and above.

Tones last 20000 samples of the lower rate and up to the next half second; 2000 at either end are not looked at. All samples are 64-bit floats.
"""

import os
import subprocess
import sys
import tempfile
import venv

PAIRS = [(44100, 48000), (48000, 44100), (96000, 44100), (8000, 48000), (44100, 46181.3)]


def inside(folder):
    """Runs this script again with the peers installed."""
    python = os.path.join(folder, "bin", "python")
    if not os.path.exists(python):
        venv.create(folder, with_pip=True)
    subprocess.check_call([python, "-m", "pip", "install", "-q", "numpy", "scipy", "soxr"])
    subprocess.check_call([python, __file__, sys.argv[1]], env={**os.environ, "NYQUIST_PEERS": "1"})


def main():
    import numpy as np
    import scipy
    import soxr
    from scipy import signal
    from scipy.io import wavfile

    binary = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp()

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
    print("| rates | who | residual, dB | truth, dB | pass-band | alias near, dB | alias far, dB |")
    print("| --- | --- | ---: | ---: | ---: | ---: | ---: |")
    for a, b in PAIRS:
        slow = min(a, b)
        low, high = slow / 2, a / 2
        flat = low * np.linspace(0.013, 0.9, 40)
        edge = low * np.arange(0.8, 1.0, 0.0025)
        near = low + np.linspace(0.0005, min(0.1, high / low - 1.001), 25) * low if a > b else []
        far = np.linspace(1.1 * low, 0.999 * high, 25) if 1.1 * low < high else []
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
                if len(frequencies) == 0:
                    leaks.append("")
                    continue
                left = middle(convert(tones(frequencies, a, slow), a, b), b, slow)[1]
                leaks.append(f"{decibels(np.abs(left).max()):.1f}")
            mark = "≤ " if band == 0.8 else ""
            print(
                f"| {a} → {b} | {name} | {decibels(rest.max()):.1f} | {decibels(truth):.1f} | {mark}{band:.4f} "
                f"| {leaks[0]} | {leaks[1]} |",
                flush=True,
            )


if len(sys.argv) < 2:
    sys.exit(__doc__)
if os.environ.get("NYQUIST_PEERS"):
    main()
else:
    inside(sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp())
