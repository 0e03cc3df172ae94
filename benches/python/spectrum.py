"""Job f: power spectra of points at 512² frequencies, to 10⁻⁶.

Ours write the whole plane, as do the peers; and where half of it is asked of ducc0, points being real, only that half.
"""

import ducc0
import finufft
import numpy as np

from ours import Plan
from race import Contender, least, race, save

SIDE, TOLERANCE = 512, 1e-6


def main(rounds):
    generator = np.random.default_rng(2)
    outcomes = []
    for n in (4096, 16384, 65536):
        points = generator.random((n, 2))
        for threads in (1, 2):
            outcomes.append(one(points, threads, rounds))
    save("spectrum", outcomes)


def one(points, threads, rounds):
    n = len(points)
    angles, ones = points * 2 * np.pi, np.ones(n, complex)
    x, y = angles[:, 0].copy(), angles[:, 1].copy()
    # frequencies 0 … 256 along y are those around the middle of points turned by 128
    turns = np.exp(-1j * (SIDE // 4) * y)

    def ours():
        plan, power = Plan("point_power", SIDE // 2, TOLERANCE), np.empty((SIDE, SIDE))
        return plan.run("point_power", n, points, power, threads)

    def square(sums):
        return (sums.real**2 + sums.imag**2) / n

    def ducc(weights, columns):
        out = np.empty((SIDE, columns), complex)

        def run():
            ducc0.nufft.nu2u(points=weights, coord=angles, forward=True, epsilon=TOLERANCE, nthreads=threads, out=out)
            return square(out)

        return run

    def by_finufft():
        plan = finufft.Plan(1, (SIDE, SIDE), eps=TOLERANCE, isign=-1, nthreads=threads)

        def run():
            plan.setpts(x, y)
            return square(plan.execute(ones))

        return run

    peers = {
        f"ducc0 {ducc0.__version__}": lambda: ducc(ones, SIDE),
        f"ducc0 {ducc0.__version__}, half of the plane": lambda: ducc(turns, SIDE // 2 + 1),
        f"FINUFFT {finufft.__version__}": by_finufft,
    }
    # the direct sum in some columns, of frequencies from zero on along y
    columns = [-256, -131, -1, 1, 2, 77, 255]
    along = np.arange(SIDE // 2)
    waves = np.exp(-1j * np.outer(columns, x))
    exact = np.abs(sum(waves[:, i : i + 4096] @ np.exp(-1j * np.outer(y[i : i + 4096], along)) for i in range(0, n, 4096))) ** 2 / n

    def error(found):
        known = found[np.array(columns) + SIDE // 2][:, -along.size :] if found.shape[1] == SIDE else found[np.array(columns) + SIDE // 2][:, : along.size]
        return np.linalg.norm(known - exact) / np.linalg.norm(exact)

    contenders = [Contender("nyquist", ours, error, ours=True)]
    contenders += [Contender(name, make, error) for name, make in peers.items()]
    # a real transform of a grid that is a quarter finer, and 5 × 5 cells for every point
    finer = (1.25 * SIDE) ** 2
    operations = 2.5 * finer * np.log2(finer) + n * 2 * 25
    limit = least(8 * (2 * n + 2 * finer + SIDE * SIDE), operations, threads)
    counted = "points, grid out and in, and result moved once; a real transform, and sums over 5 × 5 cells"
    return race("f", f"{n} points", threads, 10 * TOLERANCE, contenders, (limit, counted), rounds)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
