"""Job d: sound at another rate, beside soxr. Errors are what is left of tones when their best fit is taken away: tones up to
0.97 of the lower Nyquist frequency for ours, whose gain must be right there to 0.1 dB, and up to 0.91 for soxr."""

import numpy as np
import soxr

from ours import Plan
from race import Contender, least, race, save

QUALITIES = {"best": 2, "high": 1}
PROBE = 2.0


def main(rounds):
    outcomes = []
    for threads in (1, 2):
        for channels in (1, 2):
            for number in (np.float64, np.float32):
                outcomes.append(one(44_100.0, 48_000.0, channels, number, threads, rounds))
        # a real ratio, where soxr's own errors are what is allowed
        outcomes.append(one(44_100.0, 14_700.0 * np.pi, 1, np.float64, threads, rounds, allowed=10 ** (-120 / 20)))
    save("sound", outcomes)


def one(before, after, channels, number, threads, rounds, allowed=None):
    bits, width = (64, 8) if number is np.float64 else (32, 4)
    shape = (int(60 * before),) if channels == 1 else (int(60 * before), channels)
    record = (np.random.default_rng(4).random(shape) - 0.5).astype(number)
    made = int(np.floor(record.shape[0] * after / before + 0.5))

    def ours(quality):
        plan = lambda: Plan(f"sound_f{bits}", before, after, channels, QUALITIES[quality])

        def converted(plan, values):
            out = np.empty((int(np.floor(values.shape[0] * after / before + 0.5)), channels), number)
            return plan.run(f"sound_f{bits}", values.size, values, out.size, out, threads)

        convert = lambda values: converted(plan(), values)()
        error = lambda _: worst(convert, before, after, channels, number, (0.1, 0.5, 0.91, 0.97))
        return Contender(f"nyquist {quality}", lambda: converted(plan(), record), error, ours=True)

    def theirs(quality):
        convert = lambda values: soxr.resample(values, before, after, quality)
        error = lambda _: worst(convert, before, after, channels, number, (0.1, 0.5, 0.91))
        return Contender(f"soxr {soxr.__version__} {quality}", lambda: lambda: convert(record), error)

    contenders = [ours("best"), theirs("VHQ")]
    if bits == 32:
        contenders += [ours("high"), theirs("HQ")]
    samples = channels * (record.shape[0] + made)
    limit = least(samples * width, 2.5 * 14 * samples * width / 8, threads)
    counted = "input and output moved once; transforms of 2¹⁴ real samples, forward and back, without overlap"
    case = f"60 s, {before:.0f} to {after:.0f} Hz, {('mono', 'stereo')[channels - 1]}, f{bits}"
    return race("d", case, threads, allowed or 10 ** (-(180 if bits == 64 else 130) / 20), contenders, (limit, counted), rounds)


def worst(convert, before, after, channels, number, parts):
    found = []
    for part in parts:
        frequency = 0.5 * part * min(before, after)
        tone = lambda rate, count: 2 * np.pi * np.modf(frequency / rate * np.arange(count))[0]
        values = (0.9 * np.cos(tone(before, int(PROBE * before)) + 0.6)).astype(number)
        record = values if channels == 1 else np.ascontiguousarray(np.repeat(values[:, None], channels, axis=1))
        out = convert(record).reshape(-1, channels).astype(np.float64)
        middle = slice(int(after / 2), len(out) - int(after / 2))
        phase = tone(after, len(out))[middle]
        basis = np.stack([np.cos(phase), np.sin(phase)], axis=1)
        rest, fit = out[middle], 0
        # twice: what rounding leaves of the tone in the first fit is taken by the second
        for _ in range(2):
            more = np.linalg.lstsq(basis, rest, rcond=None)[0]
            rest, fit = rest - basis @ more, fit + more
        amplitude = np.hypot(fit[0], fit[1])
        found.append(np.max(np.sqrt(2 * np.mean(rest**2, axis=0)) / amplitude))
        if part == parts[-1] and np.max(np.abs(20 * np.log10(amplitude / 0.9))) > 0.1:
            found.append(1.0)
    return max(found)


if __name__ == "__main__":
    import sys

    main(int(sys.argv[1]))
