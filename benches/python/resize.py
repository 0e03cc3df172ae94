"""Job e: images at another size. zimg works on planes, on one thread; Pillow on bytes and on one channel of floats.

What lies beyond the border every library says otherwise, so errors are those of pixels that do not see it.
"""

import numpy as np
import PIL
from PIL import Image

import zimg
from ours import Plan
from race import Contender, least, race, save

RADII = {"lanczos-3": 3, "mitchell": 2, "catmull-rom": 2}
# Pillow's bicubic is a = −½, which is Catmull–Rom
PILLOW = {"lanczos-3": Image.Resampling.LANCZOS, "catmull-rom": Image.Resampling.BICUBIC}


def main(rounds):
    outcomes = []
    for from_, to in ((4096, 1024), (1024, 4096)):
        for kernel in RADII:
            for channels in (1, 3):
                # the light of grey codes is nothing that these libraries know
                for kind in ("f32", "u8", "light")[: 2 + channels // 3]:
                    outcomes.append(one(kernel, channels, from_, to, kind, rounds))
    save("resize", outcomes)


def one(kernel, channels, from_, to, kind, rounds):
    number = np.float32 if kind == "f32" else np.uint8
    image = picture(from_, channels, number)
    exact = resized(image, kernel, to, kind)

    def ours():
        plan, out = Plan("resize", list(RADII).index(kernel), from_, to), np.empty((to, to, channels), number)
        return plan.run(f"resize_{kind}", channels, image, out, 1)

    contenders = [Contender("nyquist", ours, lambda out: error(out, exact, kernel, from_), ours=True)]
    if zimg.LIBRARY:
        contenders.append(by_zimg(image, kernel, to, kind, exact))
    if kind != "light" and kernel in PILLOW and (channels == 1 or kind == "u8"):
        given = Image.fromarray(image.squeeze())
        make = lambda: lambda: given.resize((to, to), PILLOW[kernel])
        found = lambda result: np.asarray(result).reshape(exact.shape)
        contenders.append(
            Contender(f"Pillow {PIL.__version__}", make, lambda result: error(found(result), exact, kernel, from_))
        )
    taps = 2 * RADII[kernel] * max(from_ / to, 1.0)
    size = np.dtype(number).itemsize * channels
    limit = least(size * (from_**2 + to**2), channels * taps * (to * to + from_ * to), 1)
    counted = "the image read and the result written once; products and sums in 32 bits of both passes"
    allowed = (2 * taps + 4) * np.finfo(np.float32).eps * 2.25 if kind == "f32" else 1.25
    case = f"{from_}² → {to}², {kernel}, {'f32' if kind == 'f32' else 'u8'} × {channels}"
    case += " by light" if kind == "light" else ""
    return race("e", case, 1, allowed, contenders, (limit, counted), rounds)


def by_zimg(image, kernel, to, kind, exact):
    channels = image.shape[2]
    source = zimg.aligned((channels, *image.shape[:2]), image.dtype)
    source[:] = np.moveaxis(image, 2, 0)

    def make():
        target = zimg.aligned((channels, to, to), image.dtype)
        if kind == "light":
            light = zimg.aligned(source.shape, np.float32)
            small = zimg.aligned(target.shape, np.float32)
            into = (zimg.SRGB, zimg.LINEAR)
            same = (zimg.LINEAR, zimg.LINEAR)
            graphs = [
                zimg.Graph(source, light, kernel, into),
                zimg.Graph(light, small, kernel, same),
                zimg.Graph(small, target, kernel, into[::-1]),
            ]
        else:
            graphs = [zimg.Graph(source, target, kernel)]

        def run():
            for graph in graphs:
                graph()
            return target

        return run

    return Contender(
        zimg.version(), make, lambda target: error(np.moveaxis(target, 0, 2), exact, kernel, image.shape[0])
    )


def error(found, exact, kernel, old):
    """The largest, of pixels that see nothing beyond the border."""
    border = int(np.ceil(RADII[kernel] * max(exact.shape[0] / old, 1.0))) + 1
    inside = np.s_[border:-border, border:-border]
    return np.abs(found[inside] - exact[inside]).max()


def picture(n, channels, number):
    """Waves under noise."""
    x, y = np.meshgrid(np.arange(n), np.arange(n))
    waves = 0.225 * (2 + np.sin(0.021 * x) + np.cos(0.017 * y))
    image = waves[:, :, None] + 0.1 * np.random.default_rng(1).random((n, n, channels))
    return image.astype(np.float32) if number is np.float32 else np.round(255 * image).astype(np.uint8)


def resized(image, kernel, to, kind):
    """The sums in 64 bits; bytes are not rounded."""
    weights = matrix(image.shape[0], to, kernel)
    value = decoded(image / 255.0) if kind == "light" else image.astype(np.float64)
    sums = np.stack([weights @ value[:, :, c] @ weights.T for c in range(image.shape[2])], axis=2)
    if kind == "light":
        return 255.0 * encoded(np.clip(sums, 0, 1))
    return sums if kind == "f32" else np.clip(sums, 0, 255)


def matrix(old, new, kernel):
    ratio = old / new
    stretch = max(ratio, 1.0)
    weights = np.zeros((new, old))
    for j in range(new):
        at = (j + 0.5) * ratio - 0.5
        reach = RADII[kernel] * stretch
        read = np.arange(np.ceil(at - reach), np.floor(at + reach) + 1)
        w = kernel_at(kernel, (at - read) / stretch)
        np.add.at(weights[j], np.clip(read, 0, old - 1).astype(int), w / w.sum())
    return weights


def kernel_at(kernel, t):
    t = np.abs(t)
    if kernel == "lanczos-3":
        return np.where(t < 3, np.sinc(t) * np.sinc(t / 3), 0.0)
    b, c = (1 / 3, 1 / 3) if kernel == "mitchell" else (0.0, 0.5)
    near = ((12 - 9 * b - 6 * c) * t**3 + (-18 + 12 * b + 6 * c) * t**2 + 6 - 2 * b) / 6
    far = ((-b - 6 * c) * t**3 + (6 * b + 30 * c) * t**2 + (-12 * b - 48 * c) * t + 8 * b + 24 * c) / 6
    return np.where(t < 1, near, np.where(t < 2, far, 0.0))


def decoded(v):
    return np.where(v <= 0.04045, v / 12.92, ((v + 0.055) / 1.055) ** 2.4)


def encoded(v):
    return np.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
