"""Job h: 16 scattered samples a pixel into n² pixels, with the Gaussian and Mitchell's cubic of radius two."""

import drjit as dr
import finufft
import mitsuba
import numba
import numpy as np

from ours import Plan
from race import Contender, least, race, save


def main(rounds):
    outcomes = []
    for n in (256, 512, 1024):
        samples = np.random.default_rng(1).random((16 * n * n, 3), np.float32)
        samples[:, :2] *= np.float32(n)
        for threads in (1, 2):
            for name, kernel in (("gaussian", gaussian), ("mitchell", mitchell)):
                outcomes.append(one(n, name, kernel, samples, threads, rounds))
                # a render of Mitsuba's takes seconds: what is there is kept
                save("film", outcomes)


def gaussian(t):
    return np.where(np.abs(t) < 2, np.exp(-2 * t * t) - np.exp(-8), 0)


def mitchell(t):
    t = np.abs(t)
    inner = (7 * t**3 - 12 * t**2 + 16 / 3) / 6
    outer = (-7 / 3 * t**3 + 12 * t**2 - 20 * t + 32 / 3) / 6
    return np.where(t < 1, inner, np.where(t < 2, outer, 0))


# steps from zero to the radius
STEPS = 1 << 14


@numba.njit(fastmath=True)
def scattered(samples, table, pixels):
    n = pixels.shape[0]
    pixels[:] = 0
    across = np.empty(4, pixels.dtype)
    scale = np.float32(STEPS / 2)
    for i in range(len(samples)):
        x, y, light = samples[i, 0] - np.float32(0.5), samples[i, 1] - np.float32(0.5), samples[i, 2]
        left, top = int(np.ceil(x - np.float32(2))), int(np.ceil(y - np.float32(2)))
        for k in range(4):
            across[k] = table[int(abs(np.float32(left + k) - x) * scale + np.float32(0.5))]
        for j in range(max(-top, 0), min(n - top, 4)):
            down = table[int(abs(np.float32(top + j) - y) * scale + np.float32(0.5))]
            for k in range(max(-left, 0), min(n - left, 4)):
                weight = across[k] * down
                pixels[top + j, left + k, 0] += weight
                pixels[top + j, left + k, 1] += weight * light
    return pixels


def one(n, name, kernel, samples, threads, rounds):
    count = len(samples)

    def ours():
        plan, out = Plan("film", n, n, new=f"film_{name}_new"), np.empty((n, n), np.float32)
        return plan.run("film_develop", count, n * n, samples, out, threads)

    def loop():
        pixels = np.zeros((n, n, 2), np.float32)
        return lambda: scattered(samples, table, pixels)

    places = np.linspace(0, 2, STEPS + 1)
    table = np.append(kernel(places), [0, 0]).astype(np.float32)
    # compiled before it is measured
    scattered(samples[:1], table, np.zeros((2, 2, 2), np.float32))
    # the reference: the same loop in double precision, the table so fine that its steps count for nothing
    exact = reference(samples, kernel, n)
    contenders = [
        Contender("nyquist, f32", ours, lambda out: np.abs(out - exact).max(), ours=True),
        Contender(
            f"numba {numba.__version__}, a loop (one thread)",
            loop,
            lambda sums: np.abs(sums[..., 1] / sums[..., 0] - exact).max(),
        ),
        image_block(n, name, samples, exact, threads),
        spread(n, samples, threads),
    ]
    limit = least(12 * count, 0.5 * 2 * 2 * 16 * count, threads)
    counted = "samples read once; two fused multiply-adds of 32 bits a sample and pixel"
    # two sums of 256 numbers in single precision, and as much for tables and approximate exponentials
    allowed = 4 * 256 * np.finfo(np.float32).eps
    return race("h", f"{name}, {n}²", threads, allowed, contenders, (limit, counted), rounds)


def image_block(n, name, samples, exact, threads):
    """Mitsuba's film, compiled by LLVM: light and weight as two channels."""
    mitsuba.set_variant("llvm_ad_mono")
    dr.set_thread_count(threads)
    kind = {"type": "gaussian", "stddev": 0.5} if name == "gaussian" else {"type": "mitchell"}
    x, y, light = (mitsuba.Float(np.ascontiguousarray(samples[:, d])) for d in range(3))
    one = dr.full(mitsuba.Float, 1, len(samples))
    dr.eval(x, y, light, one)

    def make():
        block = mitsuba.ImageBlock([n, n], [0, 0], 2, rfilter=mitsuba.load_dict(kind), border=True, normalize=False)

        def run():
            block.clear()
            block.put(mitsuba.Point2f(x, y), [light, one])
            pixels = block.tensor()
            dr.eval(pixels)
            dr.sync_thread()
            return pixels

        return run

    def error(tensor):
        pixels = np.array(tensor)
        edge = (pixels.shape[0] - n) // 2
        pixels = pixels[edge : edge + n, edge : edge + n]
        return np.abs(pixels[..., 0] / pixels[..., 1] - exact).max()

    # it keeps what it frees
    dr.flush_malloc_cache()
    return Contender(f"Mitsuba {mitsuba.__version__}, LLVM", make, error)


def spread(n, samples, threads):
    """FINUFFT's spreader alone, weight and weighted light as the two parts of a complex number; its own kernel, of width 4
    like ours, on a torus. What it errs is therefore taken from what any kernel owes: constant light stays constant."""
    turns = np.float32(2 * np.pi / n)
    x, y = (np.ascontiguousarray(samples[:, d] * turns - np.float32(np.pi)) for d in (1, 0))
    values = (1 + 1j * samples[:, 2]).astype(np.complex64)

    def make(values=values):
        plan = finufft.Plan(
            1, (n, n), n_trans=1, eps=1e-3, dtype="complex64", nthreads=threads, spreadinterponly=1, upsampfac=2.0
        )
        out = np.empty((n, n), np.complex64)

        def run():
            plan.setpts(x, y)
            return plan.execute(values, out=out)

        return run

    def error(_):
        even = make(np.full(len(samples), 1 + 0.25j, np.complex64))()
        return np.abs(even.imag / even.real - 0.25).max()

    return Contender(f"FINUFFT {finufft.__version__}, spreading only, its kernel", make, error)


def reference(samples, kernel, n):
    """`Σ f·L / Σ f` in double precision, tap by tap."""
    at = samples[:, :2].astype(np.float64) - 0.5
    first = np.ceil(at - 2).astype(np.int64)
    sums = np.zeros((2, n * n))
    for j in range(4):
        for k in range(4):
            column, row = first[:, 0] + k, first[:, 1] + j
            inside = (0 <= column) & (column < n) & (0 <= row) & (row < n)
            weight = (kernel(column - at[:, 0]) * kernel(row - at[:, 1]))[inside]
            index = (row * n + column)[inside]
            sums[0] += np.bincount(index, weight, n * n)
            sums[1] += np.bincount(index, weight * samples[inside, 2], n * n)
    return (sums[1] / sums[0]).reshape(n, n)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
