#!/usr/bin/env python3
"""Draws the spectrogram of a WAV file, with marks: needs numpy and matplotlib.

    scripts/spectrogram.py FILE.wav OUT.png --title "A steak" --from 20 --to 60 --mark 27.4=put --mark 51=turned
"""

import argparse
import pathlib
import wave

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

# Samples of a window: 43 ms at 48 kHz (chosen: tells a pop from a hiss and 100 Hz from 125 Hz).
WINDOW = 2048
# Levels that are drawn [dB below full scale] and lowest frequency [Hz].
LEVELS = (-110, -40)
LOWEST = 60


def samples(path):
    with wave.open(str(path)) as file:
        rate, channels = file.getframerate(), file.getnchannels()
        data = np.frombuffer(file.readframes(file.getnframes()), dtype="<i2").reshape(-1, channels)
    return rate, data.mean(axis=1) / 32768


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("wav", type=pathlib.Path)
    parser.add_argument("png", type=pathlib.Path)
    parser.add_argument("--title", default="")
    parser.add_argument("--from", dest="begin", type=float, default=0.0)
    parser.add_argument("--to", dest="end", type=float, default=None)
    parser.add_argument("--mark", action="append", default=[], metavar="SECONDS=WORDS")
    args = parser.parse_args()
    rate, x = samples(args.wav)
    figure, axes = plt.subplots(figsize=(9, 3.2), dpi=100, layout="constrained")
    spectrum, frequencies, times, image = axes.specgram(
        x, NFFT=WINDOW, Fs=rate, noverlap=WINDOW // 2, window=np.hanning(WINDOW), scale="dB", mode="magnitude",
        vmin=LEVELS[0], vmax=LEVELS[1], cmap="magma")
    axes.set(yscale="log", ylim=(LOWEST, rate / 2), xlim=(args.begin, args.end or len(x) / rate),
             xlabel="time [s]", ylabel="frequency [Hz]", title=args.title)
    for mark in args.mark:
        at, words = mark.split("=", 1)
        axes.axvline(float(at), color="white", linewidth=0.8, linestyle=":")
        axes.text(float(at), 0.97 * rate / 2, f" {words}", color="white", fontsize=9, va="top")
    figure.colorbar(image, label="dBFS")
    figure.savefig(args.png)


main()
