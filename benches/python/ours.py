"""nyquist through the C interface of `src/shim/`: process start and copies do not count."""

import ctypes
import os
from functools import partial

LIBRARY = ctypes.CDLL(os.environ["NYQUIST_SHIM"])


def pointer(array):
    assert array.flags.c_contiguous
    return ctypes.c_void_p(array.ctypes.data)


class Plan:
    """What `NAME_new` built; `run` calls a function with it, sizes as numbers, arrays as pointers, threads last."""

    def __init__(self, name, *sizes, new=None):
        build = getattr(LIBRARY, new or f"{name}_new")
        build.restype = ctypes.c_void_p
        self._free = getattr(LIBRARY, f"{name}_free")
        self._plan = build(*map(number, sizes))
        if not self._plan:
            raise ValueError(f"nyquist has no plan {name}{sizes}")

    def run(self, function, *arguments):
        """A call without arguments left to give: what it needs is bound now, and lives as long as the call. It gives the
        last array, in which the result stands."""
        call = getattr(LIBRARY, function)
        call.restype = ctypes.c_int
        ready = [number(a) if isinstance(a, (int, float)) else pointer(a) for a in arguments]
        return partial(self._checked, call, arguments, ctypes.c_void_p(self._plan), *ready)

    def _checked(self, call, given, *arguments):
        if call(*arguments) != 0:
            raise RuntimeError(call.__name__)
        return next(a for a in reversed(given) if not isinstance(a, (int, float)))

    def __del__(self):
        if getattr(self, "_plan", None):
            self._free(ctypes.c_void_p(self._plan))


def number(value):
    return ctypes.c_double(value) if isinstance(value, float) else ctypes.c_size_t(value)
