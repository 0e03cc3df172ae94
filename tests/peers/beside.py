"""Runs a script with other libraries installed beside it."""

import os
import subprocess
import sys
import tempfile
import venv


def run(doc, packages, main):
    """`main()` in an environment with these packages, which returns what is beyond its tolerance.

    The script's arguments are the command `nyquist` and, if it is to be kept, a folder for the environment.
    """
    if len(sys.argv) < 2:
        sys.exit(doc)
    if os.environ.get("NYQUIST_PEERS"):
        failed = main()
        sys.exit("beyond the tolerance: " + "; ".join(failed) if failed else 0)
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()
    python = os.path.join(folder, "bin", "python")
    if not os.path.exists(python):
        venv.create(folder, with_pip=True)
    subprocess.check_call([python, "-m", "pip", "install", "-q", *packages])
    done = subprocess.run([python, *sys.argv[:2]], env={**os.environ, "NYQUIST_PEERS": "1"})
    sys.exit(done.returncode)
