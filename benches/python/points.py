"""Job g: Sobol' points beside SciPy's, whose scrambling is a matrix and a shift, and the discrepancy."""

import ctypes

import numpy as np
import scipy
from scipy.stats import qmc

from ours import LIBRARY, pointer
from race import Contender, least, race, save


def main(rounds):
    outcomes = [sobol(m, rounds) for m in (14, 16, 18)]
    outcomes += [discrepancy(n, rounds) for n in (256, 1024)]
    save("points", outcomes)


def empty_boxes(points):
    """Elementary boxes of a net in base 2 that have not one point each, of all shapes."""
    m = len(points).bit_length() - 1
    wrong = 0
    for a in range(m + 1):
        cells = (points[:, 0] * 2**a).astype(np.int64) * 2 ** (m - a) + (points[:, 1] * 2 ** (m - a)).astype(np.int64)
        wrong += np.count_nonzero(np.bincount(cells, minlength=2**m) != 1)
    return wrong


def sobol(m, rounds):
    n = 2**m

    def ours():
        out = np.empty((n, 2))
        size, seed, place = ctypes.c_size_t(n), ctypes.c_size_t(1), pointer(out)

        def run():
            LIBRARY.sobol_owen(size, seed, place)
            return out

        return run

    def kept():
        engine = qmc.Sobol(2, scramble=True, rng=1)

        def run():
            engine.reset()
            return engine.random_base2(m)

        return run

    fresh = lambda: qmc.Sobol(2, scramble=True, rng=1).random_base2(m)
    contenders = [
        Contender("nyquist, Owen's nested scrambling", ours, empty_boxes, ours=True),
        Contender(f"SciPy {scipy.__version__}, matrix and shift", lambda: fresh, empty_boxes),
        Contender(f"SciPy {scipy.__version__}, matrix and shift, kept", kept, empty_boxes),
    ]
    limit = least(16 * n, 0, 1)
    return race("g", f"scrambled Sobol', {n} × 2", 1, 0, contenders, (limit, "the points written once"), rounds)


def discrepancy(n, rounds):
    """SciPy has the star discrepancy in the 2-norm only, which is easier: its sum over all pairs of points."""
    points = qmc.Sobol(2, scramble=True, rng=1).random(n)
    size, place = ctypes.c_size_t(n), pointer(points)
    LIBRARY.discrepancy.restype = ctypes.c_double
    ours = lambda: LIBRARY.discrepancy(size, place)
    # the textbook: all boxes whose sides go through points, open and closed
    x, y = (np.append(np.sort(points[:, d]), 1.0) for d in (0, 1))
    area = x[:, None] * y[None, :]
    ranks = np.zeros((n + 1, n + 1))
    np.add.at(ranks, (np.searchsorted(x, points[:, 0]), np.searchsorted(y, points[:, 1])), 1)
    closed = ranks.cumsum(0).cumsum(1) / n
    within = np.zeros((n + 1, n + 1))
    within[1:, 1:] = closed[:-1, :-1]
    known = max((closed - area).max(), (area - within).max())
    contenders = [
        Contender("nyquist, the largest", lambda: ours, lambda found: abs(found - known), ours=True),
        Contender(
            f"SciPy {scipy.__version__}, in the 2-norm: another measure",
            lambda: lambda: qmc.discrepancy(points, method="L2-star"),
            lambda _: 0.0,
        ),
    ]
    return race("g", f"star discrepancy of {n}", 1, 4 * np.finfo(float).eps, contenders, None, rounds)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
