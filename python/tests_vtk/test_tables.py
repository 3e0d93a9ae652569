"""Promise: a reader of CSV that finds the separator by itself, as spreadsheets of any locale do on import, reads the table of a cook."""

import csv
import math

import pytest


def test_the_separator_is_found_and_every_field_is_a_number(series):
    text = (series.folder / "series.csv").read_text(encoding="utf-8")
    # Those that the world's locales separate lists with, and a decimal comma.
    found = csv.Sniffer().sniff(text, delimiters=",;\t|")
    header, *rows = csv.reader(text.splitlines(), found)
    assert found.delimiter == "," and header[0] == "time_s" and "steak.mass_g" in header
    for row in rows:
        assert len(row) == len(header)
        assert all(math.isfinite(float(field)) for field in row)
    numbers = next(f for f in series.summary["foods"] if f["id"] == "steak")
    last = dict(zip(header, map(float, rows[-1])))
    assert last["steak.mass_g"] == pytest.approx(numbers["mass_g"]["end"], abs=1e-3)
