"""Executes the notebooks in the Rust kernel and compares what their cells show with what the files say they show.

The kernel only prints a panic or an error that a cell returns, sometimes too late to be heard, and goes on. So every cell
is made to say a last word, which it does not reach after either; a cell without it has failed, and so has one that says
anything on standard error or shows anything but what is stored.
"""

import re
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError, DeadKernelError

HERE = Path(__file__).resolve().parent
# The first cell of the first notebook compiles the library.
SECONDS = 1800
LAST_WORD = "the end of the cell was reached"
COLOUR = re.compile("\x1b\\[[0-9;]*m")

# What must be noticed, and would not be if only the kernel were asked whether the cell succeeded.
BROKEN = {
    "a panic": 'assert!(1 > 2, "one is more than two");',
    "an error that a cell returns": 'std::fs::read_to_string("nowhere")?;',
    "a mistake that the compiler finds": "let one: u32 = -1;",
    "another output": 'println!("two");',
}


def shown(outputs):
    """What a cell shows, as pairs of a kind and its text; neighbouring pieces of one stream are one."""
    pieces = []
    for output in outputs:
        if output.output_type == "stream":
            kind, text = output.name, output.text
        elif output.output_type == "error":
            kind, text = "error", COLOUR.sub("", "\n".join(output.traceback) or output.evalue)
        else:
            kind, text = "picture", output.data.get("image/svg+xml", str(output.data))
        if pieces and kind == pieces[-1][0] != "picture":
            pieces[-1] = (kind, pieces[-1][1] + text)
        else:
            pieces.append((kind, text))
    return [(kind, text.strip("\n")) for kind, text in pieces]


def execute(notebook, folder):
    """What is wrong with it when it is run there: a list of sentences, empty if nothing is."""
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    expected = [shown(cell.outputs) for cell in cells]
    for cell in cells:
        cell.source += f'\nprintln!("{LAST_WORD}");'
    client = NotebookClient(
        notebook, timeout=SECONDS, startup_timeout=120, kernel_name="rust", allow_errors=True,
        resources={"metadata": {"path": str(folder)}},
    )
    try:
        client.execute()
    except (CellExecutionError, CellTimeoutError, DeadKernelError) as error:
        return [f"the kernel gave up: {error}"]
    wrong = []
    for number, (cell, before) in enumerate(zip(cells, expected), 1):
        ended = any(output.get("name") == "stdout" and LAST_WORD in output.text for output in cell.outputs)
        now = [(kind, text.replace(LAST_WORD, "").strip("\n")) for kind, text in shown(cell.outputs)]
        now = [piece for piece in now if piece[1]]
        failed = [text for kind, text in now if kind in ("stderr", "error")]
        if failed or not ended:
            wrong.append(f"cell {number} failed: {' '.join(failed) or 'it did not reach its end, and the kernel is silent'}")
        elif now != before:
            new, old = next((pair for pair in zip(now, before) if pair[0] != pair[1]), (now, before))
            wrong.append(f"cell {number} shows something else: {str(new)[:300]} instead of {str(old)[:300]}")
    return wrong


def main(wanted):
    paths = sorted(HERE.glob("*/*.ipynb"))
    paths = [path for path in paths if not wanted or any(part in str(path.relative_to(HERE)) for part in wanted)]
    if not paths:
        sys.exit(f"no notebook of {HERE} is called so")
    for what, code in BROKEN.items():
        notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(code)])
        if not execute(notebook, HERE):
            sys.exit(f"{what} was not noticed: this check is worth nothing")
    failures, start = 0, time.monotonic()
    for path in paths:
        began = time.monotonic()
        wrong = execute(nbformat.read(path, as_version=4), path.parent)
        failures += bool(wrong)
        verdict = "FAILED" if wrong else "ok"
        print(f"{path.relative_to(HERE)}: {verdict}, {time.monotonic() - began:.1f} s", flush=True)
        for sentence in wrong:
            print(f"  {sentence}", flush=True)
    print(f"{len(paths)} notebooks, {failures} failed, {time.monotonic() - start:.0f} s")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
