"""What Python adds to a cook: the same recipe by the command and by the package, in turns, each in a separate process.

    SAUTE_PROGRAM=target/release/saute python cook.py [--runs 7] [--recipe medium]

Processor time of each whole process [s], start and data files included, so that other programs disturb it less than wall time.
"""

import argparse
import os
import resource
import statistics
import subprocess
import sys

PACKAGE = "import json, sys, saute; print(json.dumps(saute.cook(sys.argv[1]).to_dict()))"


def seconds(command):
    """Returns the processor time of a command [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(description="What Python adds to a cook.")
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--recipe", default="medium")
    arguments = parser.parse_args()
    program = [os.environ["SAUTE_PROGRAM"], "cook", arguments.recipe, "--json"]
    package = [sys.executable, "-c", PACKAGE, arguments.recipe]
    print(f"load {os.getloadavg()[0]:.1f}\ncommand  package  empty Python [s]")
    rows = []
    for _ in range(arguments.runs):
        rows.append([seconds(command) for command in (program, package, [sys.executable, "-c", "import saute"])])
        print("  ".join(f"{s:7.3f}" for s in rows[-1]), flush=True)
    command, package, empty = (statistics.median(column) for column in zip(*rows))
    print(f"medians {command:.3f}  {package:.3f}  {empty:.3f} s")
    print(f"the package adds {100 * (package / command - 1):.1f} %, without the start of Python {100 * ((package - empty) / command - 1):.1f} %")
    print(f"load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
