"""zimg of the system (Debian: libzimg2), through its C interface: planes of bytes or of 32-bit floats, on one thread."""

import ctypes
import math

import numpy as np

VERSION = 2 << 8 | 4
BYTE, FLOAT = 0, 3
GREY, RGB = 0, 1
BT709, SRGB, LINEAR, UNSPECIFIED = 1, 13, 8, 2
# wherever there are instructions of 512 bits they may be used
WIDEST = 2
FILTERS = {"mitchell": (2, 1 / 3, 1 / 3), "catmull-rom": (2, 0.0, 0.5), "lanczos-3": (5, 3.0, math.nan)}


class Region(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("left", "top", "width", "height")]


class Format(ctypes.Structure):
    _fields_ = [
        *[(name, ctypes.c_uint) for name in ("version", "width", "height")],
        ("pixel_type", ctypes.c_int),
        *[(name, ctypes.c_uint) for name in ("subsample_w", "subsample_h")],
        *[(name, ctypes.c_int) for name in ("color_family", "matrix", "transfer", "primaries")],
        ("depth", ctypes.c_uint),
        *[(name, ctypes.c_int) for name in ("pixel_range", "field_parity", "chroma_location")],
        ("active_region", Region),
        ("alpha", ctypes.c_int),
    ]


class Parameters(ctypes.Structure):
    _fields_ = [
        ("version", ctypes.c_uint),
        ("filter", ctypes.c_int),
        ("a", ctypes.c_double),
        ("b", ctypes.c_double),
        ("filter_uv", ctypes.c_int),
        ("a_uv", ctypes.c_double),
        ("b_uv", ctypes.c_double),
        ("dither", ctypes.c_int),
        ("cpu", ctypes.c_int),
        ("nominal_peak_luminance", ctypes.c_double),
        ("allow_approximate_gamma", ctypes.c_char),
    ]


class Plane(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("stride", ctypes.c_ssize_t), ("mask", ctypes.c_uint)]


class Buffer(ctypes.Structure):
    _fields_ = [("version", ctypes.c_uint), ("plane", Plane * 4)]


def load():
    """The library, or nothing where the system has none."""
    try:
        library = ctypes.CDLL("libzimg.so.2")
    except OSError:
        return None
    library.zimg_filter_graph_build.restype = ctypes.c_void_p
    return library


LIBRARY = load()


def version():
    parts = [ctypes.c_uint() for _ in range(3)]
    LIBRARY.zimg_get_version_info(*map(ctypes.byref, parts))
    return "zimg " + ".".join(str(part.value) for part in parts)


def aligned(shape, number):
    """Planes whose rows begin at multiples of 64 bytes, as zimg wants them."""
    size = np.dtype(number).itemsize
    width = -(-shape[2] * size // 64) * 64 // size
    memory = np.zeros(shape[0] * shape[1] * width * size + 64, np.uint8)
    start = -memory.ctypes.data % 64
    flat = memory[start : start + shape[0] * shape[1] * width * size].view(number)
    return flat.reshape(shape[0], shape[1], width)[:, :, : shape[2]]


class Graph:
    """From planes to planes: another size, another number, another transfer."""

    def __init__(self, source, target, kernel, transfers=None):
        formats = [self.format(planes, i, transfers) for i, planes in enumerate((source, target))]
        parameters = Parameters()
        LIBRARY.zimg_graph_builder_params_default(ctypes.byref(parameters), VERSION)
        name, a, b = FILTERS[kernel]
        parameters.filter = parameters.filter_uv = name
        parameters.a = parameters.a_uv = a
        parameters.b = parameters.b_uv = b
        parameters.dither, parameters.cpu = 0, WIDEST
        self.graph = LIBRARY.zimg_filter_graph_build(*map(ctypes.byref, [*formats, parameters]))
        if not self.graph:
            why = ctypes.create_string_buffer(512)
            LIBRARY.zimg_get_last_error(why, 512)
            raise RuntimeError(why.value.decode())
        size = ctypes.c_size_t()
        LIBRARY.zimg_filter_graph_get_tmp_size(ctypes.c_void_p(self.graph), ctypes.byref(size))
        self.room = aligned((1, 1, size.value), np.uint8)
        self.kept = source, target
        self.buffers = [self.buffer(planes) for planes in (source, target)]

    @staticmethod
    def format(planes, which, transfers):
        made = Format()
        LIBRARY.zimg_image_format_default(ctypes.byref(made), VERSION)
        count, made.height, made.width = planes.shape
        made.pixel_type = BYTE if planes.dtype == np.uint8 else FLOAT
        made.depth = 8 if planes.dtype == np.uint8 else 32
        made.pixel_range = 1
        made.color_family = RGB if count == 3 else GREY
        made.matrix = 0 if count == 3 else UNSPECIFIED
        if transfers:
            made.transfer, made.primaries = transfers[which], BT709
        return made

    @staticmethod
    def buffer(planes):
        made = Buffer(version=VERSION)
        for i, plane in enumerate(planes):
            made.plane[i] = Plane(plane.ctypes.data, plane.strides[0], 0xFFFFFFFF)
        return made

    def __call__(self):
        room = ctypes.c_void_p(self.room.ctypes.data)
        source, target = map(ctypes.byref, self.buffers)
        wrong = LIBRARY.zimg_filter_graph_process(ctypes.c_void_p(self.graph), source, target, room, None, None, None, None)
        if wrong:
            raise RuntimeError("zimg failed")

    def __del__(self):
        if getattr(self, "graph", None):
            LIBRARY.zimg_filter_graph_free(ctypes.c_void_p(self.graph))
