"""Job b: power spectra of images. Ours give the whole plane in rising order and units, the peers half of it as it comes."""

import ducc0
import mkl
import mkl_fft
import numpy as np
import pyfftw
import scipy
import scipy.fft

from ours import Plan
from race import Contender, least, race, save


def main(rounds):
    outcomes = []
    for n in (1024, 2048, 4096):
        for number in (np.float64, np.float32):
            image = np.random.default_rng(1).standard_normal((n, n)).astype(number)
            for threads in (1, 2):
                outcomes.append(one(n, number, image, threads, rounds))
    save("plane", outcomes)


def one(n, number, image, threads, rounds):
    bits, width = (64, 8) if number is np.float64 else (32, 4)
    mkl.set_num_threads(threads)
    shape = (n, n // 2 + 1)

    def ours():
        plan, out = Plan(f"plane_f{bits}", n, n), np.empty((n, n), number)
        return plan.run(f"power_f{bits}", n * n, image, out, threads)

    def squared(transform):
        """Their half planes, squared in rooms that are kept."""
        power, squares = np.empty(shape, number), np.empty(shape, number)

        def run():
            bins = transform()
            np.multiply(bins.real, bins.real, out=power)
            np.multiply(bins.imag, bins.imag, out=squares)
            return np.add(power, squares, out=power)

        return run

    def ducc():
        half = np.empty(shape, np.complex128 if bits == 64 else np.complex64)
        return squared(lambda: ducc0.fft.r2c(image, axes=(0, 1), nthreads=threads, out=half))

    # its input is a copy that is aligned
    aligned = pyfftw.byte_align(image.copy())

    def fftw():
        return squared(
            pyfftw.builders.rfft2(aligned, threads=threads, planner_effort="FFTW_MEASURE", overwrite_input=False)
        )

    peers = {
        f"ducc0 {ducc0.__version__}": ducc,
        f"mkl_fft {mkl_fft.__version__}": lambda: squared(lambda: mkl_fft.interfaces.numpy_fft.rfft2(image)),
        f"FFTW (pyfftw {pyfftw.__version__}) measured": fftw,
        f"SciPy {scipy.__version__}": lambda: squared(lambda: scipy.fft.rfft2(image, workers=threads)),
    }
    # the reference: 64 bits by NumPy
    exact = np.abs(np.fft.rfft2(image.astype(np.float64))) ** 2
    # ours in the quarter of the plane that both have as it stands: frequencies from zero on, along both axes
    quarter = np.s_[: n // 2, : n // 2]
    error = lambda found, known: np.abs(found - known).max() / exact.max()
    own = lambda out: error(out[n // 2 :, n // 2 :] * float(n * n), exact[quarter])
    contenders = [Contender("nyquist", ours, own, ours=True)]
    contenders += [Contender(name, make, lambda found: error(found, exact)) for name, make in peers.items()]
    # two transforms of n numbers, squared
    allowed = 2 * 2 * 8 * np.finfo(number).eps * np.log2(n * n)
    limit = least(n * n * width * 4, 2.5 * n * n * np.log2(n * n) * width / 8, threads)
    counted = "image, half plane out and in, and result moved once; 2.5n²·log₂n² operations"
    return race("b", f"{n}², f{bits}", threads, allowed, contenders, (limit, counted), rounds)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
