"""How a batch scales: 64 kitchens on one thread, on two threads, and as two processes of 32 each, in turns.

    python batch.py [--runs 10] [--kitchens 64] [--ticks 200]

Two processes share nothing, so that they are what the machine itself allows. Each run does all three, one after the other, so that
whatever else the machine does meets all of them. Prints each run, medians, and the load of the machine.
"""

import argparse
import os
import statistics
import subprocess
import sys
import time

import saute


def batch(count, threads):
    """Returns kitchens with a frying steak each."""
    kitchen = saute.Kitchen("medium", coarseness=2)
    kitchen.hob(w=600)
    kitchen.put("steak")
    kitchen.step(20)
    return saute.KitchenBatch([kitchen.copy() for _ in range(count)], threads=threads)


def seconds(many, ticks):
    """Returns how long a step of so many ticks takes [s]."""
    started = time.perf_counter()
    many.step(ticks)
    return time.perf_counter() - started


class Process:
    """A separate process with half of the kitchens, which steps on each command."""

    def __init__(self, count):
        command = [sys.executable, __file__, "--serve", str(count)]
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.process.stdout.readline()

    def begin(self, ticks):
        self.process.stdin.write(f"{ticks}\n")
        self.process.stdin.flush()

    def wait(self):
        self.process.stdout.readline()


def serve(count):
    """Steps its kitchens by as many ticks as each line of the input states, and answers with a line."""
    many = batch(count, 1)
    many.step(10)
    print("ready", flush=True)
    for line in sys.stdin:
        many.step(int(line))
        print("done", flush=True)


def measure(kitchens, runs, ticks):
    """Returns the seconds of each run: on one thread, on two, and in two processes."""
    one, two = batch(kitchens, 1), batch(kitchens, 2)
    halves = [Process(kitchens // 2) for _ in range(2)]
    for many in (one, two):
        many.step(10)
    rows = []
    for _ in range(runs):
        row = [seconds(one, ticks), seconds(two, ticks)]
        started = time.perf_counter()
        for half in halves:
            half.begin(ticks)
        for half in halves:
            half.wait()
        rows.append([*row, time.perf_counter() - started])
        print("  ".join(f"{s:7.3f}" for s in rows[-1]), flush=True)
    assert one.state_hashes() == two.state_hashes(), "the same bits on any number of threads"
    for half in halves:
        half.process.stdin.close()
        half.process.wait()
    return rows


def main():
    parser = argparse.ArgumentParser(description="How a batch of kitchens scales from one thread to two.")
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--kitchens", type=int, default=64)
    parser.add_argument("--ticks", type=int, default=200)
    parser.add_argument("--serve", type=int, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.serve:
        return serve(arguments.serve)
    print(f"load {os.getloadavg()[0]:.1f}\n1 thread  2 threads  2 processes [s]")
    rows = measure(arguments.kitchens, arguments.runs, arguments.ticks)
    one, two, processes = (statistics.median(column) for column in zip(*rows))
    gains = [statistics.median(row[0] / row[k] for row in rows) for k in (1, 2)]
    print(f"medians {one:.3f}  {two:.3f}  {processes:.3f} s")
    print(f"two threads {gains[0]:.2f} times as fast as one, two processes {gains[1]:.2f} times (medians of the runs' ratios)")
    print(f"load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
