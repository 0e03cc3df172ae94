"""Contenders take turns, so that what slows the machine slows them all: the protocol of `src/race.rs`, for libraries of Python."""

import ctypes
import gc
import json
import statistics
import time
from pathlib import Path

RESULTS = Path(__file__).resolve().parent.parent / "results"
# shorter runs are repeated within one measurement
LEAST = 0.02


class Contender:
    """One way to do a job. `make` builds what is kept from run to run: the plan, its rooms, the place of the result if it has
    one; it gives the function that does the job. `error` says how far the first result is from the reference, in the norm
    that the job names. With `counts` the function takes how often to do the job, where a call costs more than a run."""

    def __init__(self, name, make, error, ours=False, counts=False):
        self.name, self.ours, self.counts = name, ours, counts

        def first():
            self.run = make()
            return self.run(1) if counts else self.run()

        # before anything else of this contender is run, so that nothing that it keeps is there already
        self.memory, result = peak_of(first)
        self.error = float(error(result))


def least(bytes_moved, operations, threads):
    """Seconds that this machine needs at least, by what `peers --machine` measured; 32-bit operations count half."""
    machine = json.loads((RESULTS / "machine.json").read_text())
    i = min(max(threads, 1), 2) - 1
    return max(bytes_moved / machine["triad"][i], operations / machine["flops"][i])


def race(job, case, threads, allowed, contenders, limit=None, rounds=15):
    """Runs it; `limit` is a pair of seconds and what they count. Gives the outcome as `src/race.rs` writes it."""
    repeats = []
    for contender in contenders:
        # a hundred at once, or the call would be counted for the run
        once = timed(contender, 100 if contender.counts else 1)
        repeats.append(min(max(int(LEAST / once), 1), 1_000_000))
    times = [[] for _ in contenders]
    for _ in range(rounds):
        for contender, count, found in zip(contenders, repeats, times):
            found.append(timed(contender, count))
    lines = []
    for contender, found in zip(contenders, times):
        quartiles = statistics.quantiles(found, n=4, method="inclusive") if len(found) > 1 else [found[0]] * 3
        lines.append(
            {
                "name": contender.name,
                "ours": contender.ours,
                "error": contender.error,
                "least": min(found),
                "median": quartiles[1],
                "spread": 0.5 * (quartiles[2] - quartiles[0]),
                "memory": contender.memory,
            }
        )
    outcome = {"job": job, "case": case, "threads": threads, "limit": limit, "allowed": float(allowed), "lines": lines}
    show(outcome)
    return outcome


def save(name, outcomes):
    """Where `peers --report` finds them."""
    RESULTS.mkdir(exist_ok=True)
    (RESULTS / f"python-{name}.json").write_text(json.dumps(outcomes, indent=2, ensure_ascii=False) + "\n")


def show(outcome):
    print(f"\n{outcome['job']}. {outcome['case']}, threads: {outcome['threads']}, allowed error {outcome['allowed']:.1e}")
    for line in outcome["lines"]:
        able = "" if line["error"] <= outcome["allowed"] else "  errs too much"
        print(
            f"  {line['name']:40} {1e3 * line['median']:10.3f} ± {1e3 * line['spread']:.3f} ms"
            f"  error {line['error']:.1e}{able}",
            flush=True,
        )
    best = {
        ours: min(
            (l["median"] for l in outcome["lines"] if l["ours"] == ours and l["error"] <= outcome["allowed"]), default=None
        )
        for ours in (True, False)
    }
    if None not in best.values():
        print(f"  ratio {best[True] / best[False]:.2f}", flush=True)


def timed(contender, count):
    start = time.perf_counter()
    if contender.counts:
        contender.run(count)
    else:
        for _ in range(count):
            contender.run()
    return (time.perf_counter() - start) / count


def peak_of(work):
    """Megabytes by which the process grew at most during some work (Linux with glibc), code that was loaded meanwhile not
    counted, and what the work gave. What had been freed before is given back first, or it would be used again and not be
    seen."""
    gc.collect()
    keeping(False)
    Path("/proc/self/clear_refs").write_text("5")
    before, code = status("VmRSS:"), status("RssFile:")
    result = work()
    peak, loaded = status("VmHWM:"), status("RssFile:") - code
    keeping(True)
    return max(peak - before - loaded, 0.0), result


def keeping(kept):
    """Whether what is freed is kept for the next run, as it is after large blocks were freed, or given back at once, as it is
    in the beginning (mallopt(3))."""
    library = ctypes.CDLL(None)
    library.mallopt(-3, 32 << 20 if kept else 128 << 10)  # M_MMAP_THRESHOLD
    library.mallopt(-1, 64 << 20 if kept else 128 << 10)  # M_TRIM_THRESHOLD
    if not kept:
        library.malloc_trim(0)


def status(field):
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(field):
            return int(line.split()[1]) / 1024
    raise LookupError(field)
