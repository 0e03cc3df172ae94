#!/usr/bin/env bash
# The same three figures in SVG, PNG and PDF by matplotlib and by nyquist, in turn, on one core each.
# Ours is timed as a whole process; matplotlib inside its process, without its start and imports.
# Usage: benches/figures.sh [ROUNDS]
set -euo pipefail
cd "$(dirname "$0")/.."
rounds=${1:-9}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 -m venv "$work/venv"
"$work/venv/bin/pip" -q install -r benches/python/requirements.txt
cargo build --locked --release -q
nyquist="${CARGO_TARGET_DIR:-target}/release/nyquist"
for _ in $(seq "$rounds"); do
  "$work/venv/bin/python" benches/python/figures.py "$work/theirs" 2 | tail -n 1 >> "$work/theirs.s"
  start=$(date +%s.%N)
  "$nyquist" f20-closer f27-overlap f28-leak --lang en --jobs 1 --out "$work/ours" 2> /dev/null
  end=$(date +%s.%N)
  echo "$end - $start" | python3 -c 'a, b = input().split(" - "); print(f"{float(a) - float(b):.4f}")' >> "$work/ours.s"
done
python3 - "$work/ours.s" "$work/theirs.s" <<'PYTHON'
import statistics, sys
ours, theirs = ([float(line) for line in open(name)] for name in sys.argv[1:])
for name, times in [("nyquist", ours), ("matplotlib", theirs)]:
    print(f"{name:<10} min {min(times):.3f}  median {statistics.median(times):.3f}  max {max(times):.3f} s")
print(f"ratio of medians {statistics.median(ours) / statistics.median(theirs):.3f}")
PYTHON
