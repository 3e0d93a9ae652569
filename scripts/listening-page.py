#!/usr/bin/env python3
"""Makes the listening page: twelve clips of `saute cook --wav` and a form that keeps what a listener answers.

    scripts/listening-page.py [FOLDER]        (target/listening by default)

Open FOLDER/index.html in a browser. It needs no server; the answers stay in the browser until they are saved as a CSV file.
FOLDER-key.csv, beside the folder, says what each clip is: it is not for the listeners.
"""

import csv
import pathlib
import random
import subprocess
import sys
import tempfile
import wave

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent
SAUTE = ROOT / "target" / "release" / "saute"
CLIP_S = 8
# The order of the clips: the same page every time (chosen).
ORDER = 7

STEAK = 'title = "Clip"\n[pan]\nkind = "carbon-steel-26"\ninitial_c = {pan_c}\n[[food]]\nid = "steak"\nkind = "beef-lean"\n'
EMPTY = 'title = "Clip"\n[pan]\nkind = "carbon-steel-26"\ninitial_c = {pan_c}\noil_g = 0\n'
END = "[[step]]\nafter_s = {end_s}\nend = true\n"


def step(*lines):
    return "[[step]]\n" + "\n".join(lines) + "\n"


def steak(*steps, pan_c=200):
    return STEAK.format(pan_c=pan_c) + step("hob_w = 1400") + step("after_s = 4", 'put = "steak"') + "".join(steps)


def empty(*steps, pan_c=20):
    return EMPTY.format(pan_c=pan_c) + "".join(steps)


# What is heard, the recipe without its end, and the second at which the clip begins.
CLIPS = [
    ("a steak is laid into a hot pan", steak(), 2),
    ("a steak half a minute after it was laid down", steak(), 34),
    ("a steak is turned", steak(step("after_s = 90", 'flip = "steak"')), 91),
    ("a steak whose face has dried", steak(pan_c=220), 300),
    ("butter foams", empty(step("hob_w = 1400"), step("butter_g = 20"), pan_c=130), 8),
    ("water boils", empty(step("hob_w = 2000"), step("water_g = 400"), pan_c=100), 100),
    ("a lid is laid on boiling water", empty(step("hob_w = 2000"), step("water_g = 400"), step("after_s = 104", "lid = true"), pan_c=100), 100),
    ("water is poured into a hot pan", empty(step("hob_w = 1000"), step("after_s = 3", "water_g = 60"), pan_c=220), 1),
    ("the pan is set on a wet cloth", empty(step("after_s = 3", 'cool = "wet-cloth"'), pan_c=240), 1),
    ("a shaken pan of carrots", 'title = "Clip"\n[pan]\nkind = "carbon-steel-26"\ninitial_c = 180\n[[food]]\nid = "carrots"\nkind = "carrot-coin"\n'
     "count = 8\n" + step("hob_w = 1400") + step('put = "carrots"') + step("after_s = 20", "shake = 5"), 18),
    ("a gas flame under an empty pan", empty(step("hob_w = 2000")).replace("[pan]", '[hob]\nkind = "gas"\n[pan]'), 5),
    ("shrimps fry in butter", 'title = "Clip"\n[pan]\nkind = "carbon-steel-26"\ninitial_c = 150\n[[food]]\nid = "shrimps"\nkind = "shrimp"\ncount = 8\n'
     + step("hob_w = 1400") + step("butter_g = 15") + step("after_s = 3", 'put = "shrimps"'), 2),
]


def cook(recipe, from_s, to):
    """Cooks a recipe and keeps CLIP_S seconds of its sound."""
    with tempfile.TemporaryDirectory() as folder:
        file, sound = pathlib.Path(folder, "clip.toml"), pathlib.Path(folder, "clip.wav")
        # The steps before the end may have waited: it is reached in any case after so many seconds.
        file.write_text(recipe + END.format(end_s=from_s + CLIP_S))
        subprocess.run([SAUTE, "cook", file, "--wav", sound], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        with wave.open(str(sound)) as whole:
            rate = whole.getframerate()
            whole.setpos(from_s * rate)
            frames = whole.readframes(CLIP_S * rate)
            with wave.open(str(to), "wb") as clip:
                clip.setparams(whole.getparams())
                clip.writeframes(frames)


def main():
    if not SAUTE.exists():
        sys.exit("target/release/saute is missing: ./run.sh builds it")
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "target" / "listening")
    folder.mkdir(parents=True, exist_ok=True)
    clips = random.Random(ORDER).sample(CLIPS, len(CLIPS))
    for number, (what, recipe, from_s) in enumerate(clips, 1):
        print(f"clip {number} of {len(clips)}", file=sys.stderr)
        cook(recipe, from_s, folder / f"clip-{number:02}.wav")
    (folder / "index.html").write_text((HERE / "listening" / "page.html").read_text())
    with open(f"{folder}-key.csv", "w", newline="") as key:
        csv.writer(key).writerows([("clip", "what"), *((number, clip[0]) for number, clip in enumerate(clips, 1))])
    print(folder / "index.html")


main()
