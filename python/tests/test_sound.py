"""The sound of a kitchen: samples that belong to its state."""

import numpy as np
import pytest

import saute


def level_db(samples):
    """Root mean square [dB below full scale]."""
    return 20 * np.log10(max(float(np.sqrt(np.mean(np.square(samples, dtype=np.float64)))), 1e-9))


def test_a_steak_is_heard_when_it_lies_in_the_hot_pan(kitchen):
    silence = kitchen.render_sound(1)
    assert silence.shape == (48000, 2) and silence.dtype == np.float32 and not silence.any()
    assert kitchen.time_s == pytest.approx(1.0), "it advances the kitchen"
    kitchen.hob(w=1000)
    kitchen.put("steak")
    heard = kitchen.render_sound(4)
    assert heard[:48000].any(), "what is commanded between two calls is heard"
    assert level_db(heard[-48000:]) > -60
    assert np.abs(heard).max() <= 1


def test_parts_fit_together_and_the_same_cook_sounds_the_same(frying):
    other = frying.copy()
    parts = np.concatenate([frying.render_sound(0.5), frying.render_sound(1.5)])
    assert np.array_equal(parts, other.render_sound(2))
    assert frying.state_hash == other.state_hash
    before = saute.Kitchen.from_snapshot(frying.snapshot())
    frying.render_sound(0)
    assert before.state_hash == frying.state_hash, "sound is no part of the state"


def test_any_rate_has_its_number_of_samples(frying):
    for rate in (8000, 11025, 44100, 96000):
        assert len(frying.copy().render_sound(1, rate)) == rate
    frying.step(7)
    assert len(frying.render_sound(0.1)) == 4800


@pytest.mark.parametrize("wrong", [{"seconds": -1}, {"seconds": float("nan")}, {"seconds": 1e4}, {"seconds": 1, "rate": 7}])
def test_what_cannot_be_made_is_refused_with_its_range(kitchen, wrong):
    with pytest.raises(ValueError, match="out of range: it may be"):
        kitchen.render_sound(**wrong)
    assert kitchen.tick == 0
