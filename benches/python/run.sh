#!/usr/bin/env bash
# nyquist beside the libraries of Python, in one process, taking turns; then RESULTS.md.
# Usage: benches/python/run.sh [--rounds N] [JOB…]; a job is a script of this folder: fft, plane, interpolant, …
set -euo pipefail
cd "$(dirname "$0")"
rounds=15
if [ "${1:-}" = --rounds ]; then rounds=$2; shift 2; fi
jobs=("$@")
if [ ${#jobs[@]} = 0 ]; then jobs=(fft plane interpolant sound resize spectrum points film figures); fi

# what Python cannot bring along: FFTW itself stands in its wheel; resize uses libzimg2 of Debian where it is installed
test -x venv/bin/pip || python3 -m venv venv
venv/bin/pip install --quiet --requirement requirements.txt

cargo build --locked --release --package peers --package nyquist
target=${CARGO_TARGET_DIR:-../../target}
NYQUIST_SHIM=$(realpath "$target/release/libshim.so")
NYQUIST=$(realpath "$target/release/nyquist")
# Mitsuba compiles with LLVM: that of Rust is at hand
DRJIT_LIBLLVM_PATH=${DRJIT_LIBLLVM_PATH:-$(find "$(rustc --print sysroot)/lib" -maxdepth 1 -name 'libLLVM.so*' | head -n 1)}
# one heap for all threads: of others not all that is free can be given back before memory is measured
MALLOC_ARENA_MAX=1
export NYQUIST_SHIM NYQUIST DRJIT_LIBLLVM_PATH MALLOC_ARENA_MAX
"$target/release/peers" --machine
for job in "${jobs[@]}"; do venv/bin/python "$job.py" "$rounds"; done
"$target/release/peers" --report
