#!/usr/bin/env bash
# Opens the notebooks in Jupyter with the Rust kernel evcxr, or executes them all in it and reports what failed.
#
#   notebooks-rs/jupyter.sh                  open JupyterLab in this folder
#   notebooks-rs/jupyter.sh --check          execute every notebook; exit code 1 if a cell fails or prints anything new
#   notebooks-rs/jupyter.sh --check en/07    only those whose path contains en/07
#
# Jupyter and the kernel are installed once, into a cache of their own and nowhere else; the kernel takes a quarter of an
# hour to compile. Needed before: Rust, and Python 3.10 or newer with the module venv.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
cache="${XDG_CACHE_HOME:-$HOME/.cache}/nyquist-jupyter"
evcxr=0.22.0

fail() { echo "$1" >&2; exit 2; }
command -v cargo >/dev/null || fail "cargo is missing: install Rust 1.95 or newer (rustup)"
command -v python3 >/dev/null || fail "python3 is missing: install Python 3.10 or newer"

venv="$cache/venv"
if ! cmp -s "$here/requirements.txt" "$venv/requirements.txt"; then
  echo "installing Jupyter into $venv" >&2
  python3 -m venv --clear "$venv" || fail "python3 has no module venv: install it (Debian: python3-venv)"
  "$venv/bin/pip" install --quiet --disable-pip-version-check --requirement "$here/requirements.txt"
  cp "$here/requirements.txt" "$venv/requirements.txt"
fi

if [ ! -x "$cache/evcxr-$evcxr/bin/evcxr_jupyter" ]; then
  echo "compiling the kernel evcxr $evcxr into $cache, about a quarter of an hour" >&2
  cargo install evcxr_jupyter --version "$evcxr" --locked --root "$cache/evcxr-$evcxr" --target-dir "$cache/target"
  rm -rf "$cache/target"
fi

# The kernel's own specification starts it without a folder to keep what it compiles in: the library would be compiled
# again with every start. Each running kernel needs a folder to itself; the first free one is taken.
JUPYTER_PATH="$venv/share/jupyter" "$cache/evcxr-$evcxr/bin/evcxr_jupyter" --install >/dev/null
cat > "$cache/kernel.sh" <<END
#!/usr/bin/env bash
# cells are libraries that find Rust's own by a path relative to where they are linked, one folder beside where they end
export LD_LIBRARY_PATH="\$(rustc --print target-libdir)\${LD_LIBRARY_PATH:+:\$LD_LIBRARY_PATH}"
kernel="$cache/evcxr-$evcxr/bin/evcxr_jupyter"
command -v flock >/dev/null || exec "\$kernel" --control_file "\$1" # slow, but it works
for i in 1 2 3 4 5 6 7 8; do
  export EVCXR_TMPDIR="$cache/work/\$i"
  mkdir -p "\$EVCXR_TMPDIR"
  exec 9>"$cache/work/\$i.lock"
  if flock --nonblock 9; then
    exec "\$kernel" --control_file "\$1"
  fi
done
echo "eight kernels are running: shut one down" >&2
exit 1
END
cat > "$venv/share/jupyter/kernels/rust/kernel.json" <<END
{
  "argv": ["bash", "$cache/kernel.sh", "{connection_file}"],
  "display_name": "Rust",
  "language": "rust",
  "interrupt_mode": "message"
}
END

if [ "${1:-}" = --check ]; then
  shift
  exec "$venv/bin/python" "$here/execute.py" "$@"
fi
exec "$venv/bin/jupyter" lab --notebook-dir "$here" "$@"
