#!/usr/bin/env python3
"""Resizing beside Pillow, OpenCV and SciPy, on pictures whose resized pixels are known in closed form.

    cargo build --release
    python3 tests/peers/pictures.py target/release/nyquist [VENV]

Installs numpy, scipy, pillow and opencv-python-headless by name into VENV (a temporary one if it is not given), prints two
tables in Markdown, and fails where something is beyond its tolerance.

The first holds filters beside those of the same definition: a random picture of 16 bits, codes averaged (--encoded), and
the largest difference away from the border, where definitions differ, in codes. One code is allowed: half of one for
rounding to 16 bits, and what the others lose in 32-bit floats.

The second says who is closer to the truth when a picture is made smaller; all in 16 bits or floats, codes taken for light:

- zone plate: 1024 pixels to 256, local frequency r/1024. "Inside", the root mean square difference from the true rings up
  to 0.8 of the new Nyquist frequency; "outside", what is left of the rings from 1.2 of it on, where there should be none;
  in dB of the amplitude of the rings;
- tones: 640 pixels to 256 (a factor of 2.5). Seven waves up to 0.6 of the new Nyquist frequency, and seven beyond 1.2 of it,
  in all directions; the root mean square error of either, in dB of the waves;
- grey: the code (of 255) that a checkerboard of single black and white pixels becomes, at half its size. Its light is one
  half, which is written 188: no other is accepted of nyquist.

Filters of the same definition must err by the same: their root mean squares differ by no more than the pixels, one code.
"""

import os
import subprocess
import sys
import tempfile

import beside


def main():
    import cv2
    import numpy as np
    import PIL
    import scipy
    from PIL import Image
    from scipy import ndimage, signal

    binary = os.path.abspath(sys.argv[1])
    folder = tempfile.mkdtemp()

    def command(picture, size, *options):
        """The command on codes: floats from 0 to 1 become 16 bits and come back."""
        source, target = os.path.join(folder, "in.png"), os.path.join(folder, "out.png")
        deep = picture.dtype != np.uint8
        cv2.imwrite(source, np.round(picture * 65535).astype(np.uint16) if deep else picture)
        width, height = str(size[0]), str(size[1])
        args = [binary, "resize", source, target, "--width", width, "--height", height, "--force", *options]
        subprocess.run(args, check=True, capture_output=True)
        result = cv2.imread(target, cv2.IMREAD_UNCHANGED)
        return result / 65535 if deep else result

    def ours(name):
        return lambda p, size: command(p, size, "--filter", name, "--encoded")

    def pillow(filter):
        return lambda p, size: np.asarray(Image.fromarray(p.astype(np.float32)).resize(size, filter))

    def opencv(filter):
        return lambda p, size: cv2.resize(p.astype(np.float32), size, interpolation=filter)

    def zoomed(order):
        def resize(p, size):
            factors = (size[1] / p.shape[0], size[0] / p.shape[1])
            return ndimage.zoom(p, factors, order=order, mode="grid-mirror" if order != 1 else "nearest", grid_mode=True)

        return resize

    def fourier(p, size):
        # samples at the first pixel's corner: shifted to the middles by its own transform
        def along(x, n, axis):
            k = np.fft.rfftfreq(x.shape[axis], 1 / x.shape[axis])
            shift = 0.5 * (x.shape[axis] / n - 1) / x.shape[axis]
            turn = np.exp(2j * np.pi * k * shift)
            shape = [1, 1]
            shape[axis] = -1
            moved = np.fft.irfft(np.fft.rfft(x, axis=axis) * turn.reshape(shape), x.shape[axis], axis=axis)
            return signal.resample(moved, n, axis=axis)

        return along(along(p, size[0], 1), size[1], 0)

    versions = f"Pillow {PIL.__version__}, OpenCV {cv2.__version__}, SciPy {scipy.__version__}, NumPy {np.__version__}"
    print(versions + "\n")
    R = Image.Resampling
    rng = np.random.default_rng(1)
    failed = []
    codes = np.round(rng.random((120, 160)) * 65535) / 65535

    print("| filter | beside | size | largest difference, codes of 16 bits |")
    print("| --- | --- | --- | ---: |")
    same = [
        ("box", "Pillow BOX", pillow(R.BOX), [(40, 30), (320, 240)]),
        ("tent", "Pillow BILINEAR", pillow(R.BILINEAR), [(40, 30), (64, 48), (320, 240), (377, 291)]),
        ("hamming", "Pillow HAMMING", pillow(R.HAMMING), [(40, 30), (64, 48), (320, 240)]),
        ("catmull-rom", "Pillow BICUBIC", pillow(R.BICUBIC), [(40, 30), (64, 48), (320, 240), (377, 291)]),
        ("lanczos-3", "Pillow LANCZOS", pillow(R.LANCZOS), [(40, 30), (64, 48), (320, 240), (377, 291)]),
        ("box", "OpenCV AREA", opencv(cv2.INTER_AREA), [(40, 30), (80, 60)]),
        ("tent", "OpenCV LINEAR", opencv(cv2.INTER_LINEAR), [(320, 240), (640, 480)]),
        ("cubic:0,0.75", "OpenCV CUBIC", opencv(cv2.INTER_CUBIC), [(320, 240), (640, 480)]),
        ("lanczos-4", "OpenCV LANCZOS4", opencv(cv2.INTER_LANCZOS4), [(320, 240), (640, 480)]),
        ("tent", "SciPy zoom, order 1", zoomed(1), [(320, 240), (640, 480)]),
    ]
    for name, who, peer, sizes in same:
        for size in sizes:
            a, b = np.clip(ours(name)(codes, size), 0, 1), np.clip(peer(codes, size), 0, 1)
            # the widest kernel reaches four old pixels, or four new ones when it widens
            rim = int(np.ceil(4 * max(1, size[0] / 160))) + 1
            off = np.abs(a - b)[rim:-rim, rim:-rim].max() * 65535
            print(f"| {name} | {who} | 160 × 120 → {size[0]} × {size[1]} | {off:.2f} |", flush=True)
            if not off <= 1:
                failed.append(f"{name} beside {who} at {size}: {off} codes")

    peers = [
        ("nyquist box", ours("box")),
        ("nyquist tent", ours("tent")),
        ("nyquist mitchell", ours("mitchell")),
        ("nyquist catmull-rom", ours("catmull-rom")),
        ("nyquist lanczos-3", ours("lanczos-3")),
        ("nyquist lanczos-4", ours("lanczos-4")),
        ("nyquist kaiser:8,8", ours("kaiser:8,8")),
        ("Pillow BOX", pillow(R.BOX)),
        ("Pillow BILINEAR", pillow(R.BILINEAR)),
        ("Pillow BICUBIC (its default)", pillow(R.BICUBIC)),
        ("Pillow LANCZOS", pillow(R.LANCZOS)),
        ("OpenCV LINEAR (its default)", opencv(cv2.INTER_LINEAR)),
        ("OpenCV AREA", opencv(cv2.INTER_AREA)),
        ("OpenCV CUBIC", opencv(cv2.INTER_CUBIC)),
        ("OpenCV LANCZOS4", opencv(cv2.INTER_LANCZOS4)),
        ("SciPy zoom, order 3 (its default)", zoomed(3)),
        ("SciPy signal.resample (FFT)", fourier),
    ]

    n, small, m = 1024, 256, 1024.0

    def rings(count):
        at = (np.arange(count) + 0.5) * (n / count) - n / 2
        square = at[None, :] ** 2 + at[:, None] ** 2
        return np.cos(np.pi * np.mod(square / m, 2.0)), np.sqrt(square)

    plate, _ = rings(n)
    truth, radius = rings(small)
    limit = m / 8
    far = radius < 0.95 * n / 2  # not the corners, beyond the Nyquist frequency of the plate itself
    edge = np.zeros_like(far)
    edge[8:-8, 8:-8] = True

    def waves(low, high, count, pixels, whole):
        at = (np.arange(pixels) + 0.5) * (whole / pixels)
        total = np.zeros((pixels, pixels))
        for k in range(count):
            nu = low + (high - low) * k / (count - 1)
            angle, phase = 2.4 * k, 1.1 * k
            u, v = nu * np.cos(angle), nu * np.sin(angle)
            total += np.cos(2 * np.pi * np.mod(u * at[None, :] + v * at[:, None], 1.0) + phase)
        return total / count

    def share(error, scale):
        return np.sqrt(np.mean(error**2)) / scale

    def grey(who, peer):
        board = ((np.indices((64, 64)).sum(axis=0) % 2) * 255).astype(np.uint8)
        if who.startswith("nyquist"):
            name = who.split()[1]
            result = command(board, (32, 32), "--filter", name)
        else:
            result = np.round(peer(board / 255, (32, 32)) * 255)
        return f"{result[16, 16]:.0f}"

    print("\n| who | plate inside, dB | plate outside, dB | tones inside, dB | tones outside, dB | grey |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    shares = {}
    for who, peer in peers:
        result = (peer(0.5 + 0.4 * plate, (small, small)) - 0.5) / 0.4
        within = (radius < 0.8 * limit) & edge
        beyond = (radius > 1.2 * limit) & far & edge
        cells = [share((result - truth)[within], np.sqrt(0.5)), share(result[beyond], np.sqrt(0.5))]
        new, old = 256, 640
        nyquist = 0.5 * new / old
        for low, high, keep in [(0.05, 0.6, 1.0), (1.2, 2.2, 0.0)]:
            picture = waves(low * nyquist, high * nyquist, 7, old, old)
            result = (peer(0.5 + 0.4 * picture, (new, new)) - 0.5) / 0.4
            expected = keep * waves(low * nyquist, high * nyquist, 7, new, old)
            error = (result - expected)[16:-16, 16:-16]
            cells.append(share(error, np.sqrt(0.5 / 7)))
        shares[who] = np.array(cells)
        row = " | ".join(f"{20 * np.log10(c):.1f}" for c in cells)
        code = grey(who, peer)
        print(f"| {who} | {row} | {code} |", flush=True)
        if who.startswith("nyquist") and code != "188":
            failed.append(f"grey of {who}: {code}")

    code = 1 / 65535 / 0.4 / np.sqrt(0.5 / np.array([1, 1, 7, 7]))
    twins = [
        ("nyquist box", "OpenCV AREA"),
        ("nyquist tent", "Pillow BILINEAR"),
        ("nyquist catmull-rom", "Pillow BICUBIC (its default)"),
        ("nyquist lanczos-3", "Pillow LANCZOS"),
    ]
    for mine, theirs in twins:
        off = np.max(np.abs(shares[mine] - shares[theirs]) / code)
        if not off <= 1:
            failed.append(f"{mine} errs otherwise than {theirs}: by {off} codes")
    return failed


beside.run(__doc__, ["numpy", "scipy", "pillow", "opencv-python-headless"], main)
