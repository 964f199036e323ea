#!/usr/bin/python3
"""Compares Bosk's measures with those of the reference scripts, digit by digit as shown (four decimals).

usage: compare_scores.py SCORE_FOLDERS_PROGRAM SCORE_VIEWS.PY SCORE_MATTES.PY

Makes random pictures (noise, blurs, discs of alpha at the border, 8 and 16 bit), scores them both ways and fails when a
digit differs. Needs Debian's python3-numpy and python3-opencv.
"""
import os
import subprocess
import sys
import tempfile

import cv2
import numpy as np


def random_rgba(rng, width, height, deep):
    picture = rng.random((height, width, 4))
    picture = cv2.GaussianBlur(picture, (0, 0), rng.choice([0.3, 1.0, 4.0]))
    y, x = np.mgrid[:height, :width]
    disc = np.hypot(x - rng.uniform(0, width), y - rng.uniform(0, height)) < rng.uniform(4, width)
    picture[..., 3] = np.clip(picture[..., 3] * disc * 1.5, 0, 1)
    picture[int(height / 2), int(width / 2), 3] = 1
    scale, kind = (65535, np.uint16) if deep else (255, np.uint8)
    return np.round(picture * scale).astype(kind)


def make_pairs(folder, rng, count, deep):
    for side in ("a", "b"):
        os.makedirs(os.path.join(folder, side))
    for i in range(count):
        width, height = rng.integers(20, 160, 2)
        truth = random_rgba(rng, width, height, deep)
        other = random_rgba(rng, width, height, deep)
        mix = rng.uniform(0, 1)
        near = np.round(mix * truth + (1 - mix) * other.astype(float)).astype(truth.dtype)
        cv2.imwrite(os.path.join(folder, "a", f"{i:03}.png"), near)
        cv2.imwrite(os.path.join(folder, "b", f"{i:03}.png"), truth)
    return os.path.join(folder, "a"), os.path.join(folder, "b")


def rows(command):
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return {words[0]: words[1:] for words in map(str.split, text.splitlines()) if words}


def compare(name, ours, theirs, columns):
    differing = total = 0
    for row, numbers in theirs.items():
        if row in ("view", "photo") or row not in ours:
            continue
        for mine, reference in zip(ours[row][:columns], numbers[:columns]):
            total += 1
            if mine != reference:
                differing += 1
                print(f"{name} {row}: {mine} against {reference}")
    print(f"{name}: {total} figures, {differing} differ")
    return differing == 0 and total > 0


def main():
    program, views_script, mattes_script = sys.argv[1:]
    rng = np.random.default_rng(1)
    with tempfile.TemporaryDirectory() as folder:
        views = make_pairs(os.path.join(folder, "views"), rng, 60, False)
        mattes = make_pairs(os.path.join(folder, "mattes"), rng, 40, True)
        good = compare("views", rows([program, "views", *views]),
                       rows([sys.executable, views_script, *views]), 6)
        good &= compare("mattes", rows([program, "mattes", *mattes]),
                        rows([sys.executable, mattes_script, *mattes]), 5)
    sys.exit(0 if good else 1)


main()
