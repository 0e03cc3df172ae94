#!/usr/bin/env bash
# nyquist beside the libraries of Python, in one process, taking turns; then RESULTS.md.
# Usage: benches/python/run.sh [--rounds N] [JOB…]; a job is a script of this folder: fft, plane, interpolant, points, …
set -euo pipefail
cd "$(dirname "$0")"
rounds=15
if [ "${1:-}" = --rounds ]; then rounds=$2; shift 2; fi
jobs=("$@")
if [ ${#jobs[@]} = 0 ]; then jobs=(fft plane interpolant points); fi

# what Python cannot bring along: FFTW itself stands in its wheel, libraries of the system are named here
test -d venv || python3 -m venv venv
venv/bin/pip install --quiet --requirement requirements.txt

cargo build --locked --release --package peers
target=${CARGO_TARGET_DIR:-../../target}
NYQUIST_SHIM=$(realpath "$target/release/libshim.so")
export NYQUIST_SHIM
"$target/release/peers" --machine
for job in "${jobs[@]}"; do venv/bin/python "$job.py" "$rounds"; done
"$target/release/peers" --report
