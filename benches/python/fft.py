"""Job a: transforms of the line. Ours put units, phase and order in; the peers give the plain sum."""

import ducc0
import numpy as np
import pyfftw
import scipy
import scipy.fft

from ours import Plan
from race import Contender, least, race, save

# longer ones take FFTW minutes to plan for
LENGTHS = [1 << 10, 1 << 16, 44_100, 65_537, 1 << 20]


def main(rounds):
    generator = np.random.default_rng(9)
    outcomes = []
    for n in LENGTHS:
        for real in (False, True):
            for number in (np.float64, np.float32):
                values = generator.standard_normal(n).astype(number)
                if not real:
                    values = values + 1j * generator.standard_normal(n).astype(number)
                for threads in (1, 2):
                    outcomes.append(one(n, real, number, values, threads, rounds))
        # FFTW may search for a plan for minutes: what is there is kept
        save("fft", outcomes)


def one(n, real, number, values, threads, rounds):
    bits, width = (64, 8) if number is np.float64 else (32, 4)
    complex_number = np.complex128 if bits == 64 else np.complex64
    name = f"{'real_' if real else ''}fft_f{bits}"
    count = n // 2 + 1 if real else n
    turned = 0.1 * np.exp(2j * np.pi * 0.3 * frequencies(n, real) / 0.1)
    order = slice(None) if real else np.argsort(np.fft.fftfreq(n), kind="stable")
    # the reference: extended precision of the processor, by SciPy
    wide = np.longdouble if real else np.clongdouble
    exact = (scipy.fft.rfft if real else scipy.fft.fft)(values.astype(wide))
    plain = np.asarray(exact, np.complex128)

    def error(found, wanted=plain):
        return np.sqrt(np.mean(np.abs(found - wanted) ** 2) / np.mean(np.abs(wanted) ** 2))

    def ours():
        plan, out = Plan(name, n), np.empty(count, complex_number)
        return lambda repeats: plan.run(name, n, values, out, threads, repeats)()

    def ducc():
        out, transform = np.empty(count, complex_number), ducc0.fft.r2c if real else ducc0.fft.c2c
        return lambda: transform(values, nthreads=threads, out=out)

    # its input is a copy that is aligned
    aligned = pyfftw.byte_align(values.copy())

    def fftw():
        build = pyfftw.builders.rfft if real else pyfftw.builders.fft
        return build(aligned, threads=threads, planner_effort="FFTW_MEASURE", overwrite_input=False)

    by_scipy = scipy.fft.rfft if real else scipy.fft.fft
    contenders = [
        Contender("nyquist", ours, lambda out: error(out, (plain * turned)[order]), ours=True, counts=True),
        Contender(f"ducc0 {ducc0.__version__}", ducc, error),
        Contender(f"FFTW (pyfftw {pyfftw.__version__}) measured", fftw, error),
        Contender(f"SciPy {scipy.__version__}", lambda: lambda: by_scipy(values, workers=threads), error),
    ]
    size = f"2^{n.bit_length() - 1}" if n & (n - 1) == 0 else str(n)
    # three transforms of up to 4n numbers follow on one another where the length is a prime
    allowed = 8 * np.finfo(number).eps * 3 * np.log2(4 * n)
    half = 2.5 if real else 5
    limit = least((2 if real else 4) * n * width, half * n * np.log2(n) * width / 8, threads)
    counted = "input and result moved once; 5n·log₂n operations, half for real input"
    case = f"{'real' if real else 'complex'}, {size}, f{bits}"
    return race("a", case, threads, allowed, contenders, (limit, counted), rounds)


def frequencies(n, real):
    return np.fft.rfftfreq(n) if real else np.fft.fftfreq(n)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
