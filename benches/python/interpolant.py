"""Job c: up to four million real samples of a period, and their band-limited interpolant at as many arbitrary points.

Ours from samples to values. The peers have complex transforms: the samples' spectrum by ducc0's real transform, then
either all harmonics, of which symmetry repeats one half, or that half moved to the middle, which the phases of the points
move back; whichever is faster counts. Angles are ready before the clock starts.
"""

import ducc0
import finufft
import numpy as np

from ours import Plan
from race import Contender, least, race, save


def main(rounds):
    generator = np.random.default_rng(1)
    outcomes = []
    for n in (100_000, 1_000_000, 4_000_000):
        samples, points = generator.standard_normal(n), generator.random(n) * n
        for order, positions in (("random", points), ("sorted", np.sort(points))):
            for tolerance in (1e-6, 1e-12):
                for threads in (1, 2):
                    outcomes.append(one(samples, positions, order, tolerance, threads, rounds))
    save("interpolant", outcomes)


def one(samples, positions, order, tolerance, threads, rounds):
    n = len(samples)
    angles = positions * (2 * np.pi / n)
    middle = (n // 2 + 1) // 2 * angles

    def ours():
        plan, values = Plan("interpolant", n, tolerance), np.empty(n)
        return plan.run("interpolant", n, samples, n, positions, values, threads)

    def spectrum():
        return ducc0.fft.r2c(samples, nthreads=threads)

    def whole():
        half, modes = spectrum(), np.empty(n, complex)
        np.divide(half, n, out=half)
        modes[: n // 2 + 1] = half
        np.conj(half[1 : n // 2][::-1], out=modes[n // 2 + 1 :])
        modes[n // 2] = modes[n // 2].real
        return modes

    def half():
        modes = spectrum() * (2 / n)
        modes[0], modes[-1] = 0.5 * modes[0], 0.5 * modes[-1].real
        return modes

    def turned(sums):
        return sums.real * np.cos(middle) - sums.imag * np.sin(middle)

    def ducc(modes, fft_order):
        return ducc0.nufft.u2nu(
            grid=modes, coord=angles[:, None], forward=False, epsilon=tolerance, nthreads=threads, fft_order=fft_order
        )

    def by_finufft(count, modeord):
        theirs = finufft.Plan(2, (count,), eps=tolerance, isign=1, nthreads=threads, modeord=modeord)

        def run(modes):
            theirs.setpts(angles)
            return theirs.execute(modes)

        return run

    def by_finufft_whole():
        sums = by_finufft(n, 1)
        return lambda: sums(whole()).real

    def by_finufft_half():
        sums = by_finufft(n // 2 + 1, 0)
        return lambda: turned(sums(half()))

    peers = {
        f"ducc0 {ducc0.__version__}, all harmonics": lambda: lambda: ducc(whole(), True).real,
        f"ducc0 {ducc0.__version__}, half of them": lambda: lambda: turned(ducc(half(), False)),
        f"FINUFFT {finufft.__version__}, all harmonics": by_finufft_whole,
        f"FINUFFT {finufft.__version__}, half of them": by_finufft_half,
    }
    probes = np.random.default_rng(2).integers(0, n, 40)
    exact = dirichlet(samples, positions[probes])

    def error(found):
        return np.linalg.norm(found[probes] - exact) / np.linalg.norm(exact)

    contenders = [Contender("nyquist", ours, error, ours=True)]
    contenders += [Contender(name, make, error) for name, make in peers.items()]
    # angles in doubles keep 10⁻¹⁶·n of a step: no peer reaches 10⁻¹² at this length
    allowed = max(10 * tolerance, 1e-15 * n)
    # a transform of the samples and one of a grid at least a quarter finer, and sums over ln(1/ε)/π cells at least
    finer, width = 1.25 * n, np.log(1 / tolerance) / np.pi
    operations = 2.5 * n * np.log2(n) + 2.5 * finer * np.log2(finer) + n * 4 * width
    limit = least(8 * (n + n + 2 * finer + n + n), operations, threads)
    counted = "samples, spectrum, grid out and in, positions and values moved once; two real transforms, sums of ln(1/ε)/π terms"
    return race("c", f"{n} {order} points, {tolerance:.0e}", threads, allowed, contenders, (limit, counted), rounds)


def dirichlet(samples, positions):
    """The sum of periodic sincs, in extended precision, cells and fractions apart."""
    n = len(samples)
    steps = np.arange(n)
    values = []
    for position in positions:
        cell = int(position)
        fraction = np.longdouble(position) - cell
        if fraction == 0:
            values.append(float(samples[cell]))
            continue
        distance = (cell - steps) % n
        distance = np.where(distance > n // 2, distance - n, distance)
        sign = np.where(distance % 2 == 0, 1, -1)
        angle = np.longdouble(np.pi) * (distance + fraction) / n
        weight = sign / (np.tan(angle) if n % 2 == 0 else np.sin(angle))
        values.append(float(np.sum(weight * samples) * np.sin(np.longdouble(np.pi) * fraction) / n))
    return np.array(values)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
