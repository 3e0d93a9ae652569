"""Coupling with another simulator at 240 Hz, and the examples."""

import pathlib
import sys

import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).parent.parent / "examples"
WEIGHT = 9.81


@pytest.fixture(scope="module")
def examples():
    sys.path.insert(0, str(EXAMPLES))
    yield
    sys.path.remove(str(EXAMPLES))


def test_a_partner_is_asked_four_times_a_frame_and_sees_load_and_poses(frying):
    seen = []
    frying.couple(lambda wrench, poses: seen.append((wrench, poses)), n=6)
    assert len(seen) == 24
    wrench, poses = seen[-1]
    assert wrench.shape == (6,) and poses.shape == (1, 7)
    on_pan = frying["steak"].mass_g + frying.oil_g + frying.water_g
    assert wrench[2] == pytest.approx(-1e-3 * on_pan * WEIGHT, rel=0.01)
    assert poses[0] == pytest.approx(frying["steak"].pose_m)


def test_a_partner_that_only_looks_changes_nothing(frying):
    other = frying.copy()
    frying.flip("steak")
    other.flip("steak")
    frying.couple(lambda wrench, poses: None, n=60)
    other.step_frames(60)
    assert frying.state_hash == other.state_hash


def test_a_partner_moves_the_pan_at_each_step(frying):
    home, heights = frying.pan_pose_m.copy(), []

    def partner(wrench, poses):
        heights.append(poses[0, 2])
        pose = home.copy()
        pose[2] += 0.0005 * len(heights)
        return pose

    frying.couple(partner, n=20)
    behind = 0.04 - (frying.pan_pose_m[2] - home[2])
    assert 0 <= behind / (0.0005 * 240) < 0.035, "the pan follows some 30 ms behind"
    rises = np.diff(heights[40:])
    assert (rises > 0).mean() > 0.9, "the steak rises with each of the steps, not with each frame"


def test_what_goes_wrong_in_a_partner_comes_out(frying):
    def fails(wrench, poses):
        raise RuntimeError("the robot stopped")

    frames = frying.time_s * 60
    with pytest.raises(RuntimeError, match="the robot stopped"):
        frying.couple(fails, n=10)
    assert frying.time_s * 60 == pytest.approx(frames + 1), "the frame is completed"
    with pytest.raises(ValueError, match="7 finite numbers"):
        frying.couple(lambda wrench, poses: [0.0])
    frying.couple(lambda wrench, poses: [5, 0, 0, 0, 0, 0, 1], n=120)
    assert abs(frying.pan_pose_m[0]) <= 0.5, "no pose is beyond the reach of a hand"


def test_the_example_couples_a_wrist_that_yields_under_the_food(examples):
    import couple

    kitchen, wrist = couple.couple(2.0)
    assert wrist.steps == 480
    load = np.array(wrist.log)[-120:, 2].mean()
    on_pan = kitchen["steak"].mass_g + kitchen.oil_g + kitchen.water_g
    assert load == pytest.approx(-1e-3 * on_pan * WEIGHT, rel=0.02)
    sag = wrist.wanted_m()[2] - wrist.at_m[2]
    assert sag == pytest.approx(-load / wrist.STIFFNESS_N_M, rel=0.1)


def test_the_training_example_learns_stores_and_is_judged(examples, tmp_path):
    pytest.importorskip("gymnasium")
    import train_steak

    policy, scale, curve = train_steak.train(seed=1, minutes=5, updates=2, threads=1, quiet=True, decisions=4)
    assert len(curve) == 2
    train_steak.store(tmp_path / "policy.npz", policy, scale, curve)
    again, scale_again = train_steak.load(tmp_path / "policy.npz")
    scores = [train_steak.judge(p, s, "reduced", 1, (16.5,), max_s=30.0) for p, s in ((policy, scale), (again, scale_again))]
    assert scores[0] == scores[1]


def test_advantages_are_the_return_less_the_value_where_nothing_is_discounted(examples, monkeypatch):
    pytest.importorskip("gymnasium")
    import train_steak

    monkeypatch.setattr(train_steak, "LAMBDA", 1.0)
    rewards, values = np.array([[0.0], [0.0], [1.0], [0.0]]), np.array([[0.2], [0.4], [0.6], [0.1]])
    ended = np.array([[False], [False], [True], [False]])
    found, wanted = train_steak.advantages(rewards, values, ended, np.array([0.5]))
    assert found[:, 0] == pytest.approx([0.8, 0.6, 0.4, 0.4])
    assert wanted[:, 0] == pytest.approx([1.0, 1.0, 1.0, 0.5])


def test_the_gradient_of_the_policy_is_that_of_its_loss(examples):
    pytest.importorskip("gymnasium")
    import train_steak

    random = np.random.default_rng(1)
    policy = train_steak.Policy(random, 5)
    policy.network.weights[4] *= 100
    x, actions = random.random((4, 5)), np.array([[0, 1], [3, 0], [9, 2], [5, 0]])
    advantage, before = np.array([1.0, -2.0, 0.5, 0.3]), np.full(4, -3.0)

    def loss():
        hob, deed, _ = policy.chances(x)
        rows = np.arange(4)
        ratio = np.exp(np.log(hob[rows, actions[:, 0]] * deed[rows, actions[:, 1]]) - before)
        bounded = np.minimum(ratio * advantage, np.clip(ratio, 0.8, 1.2) * advantage)
        entropy = -sum((p * np.log(p)).sum(1) for p in (hob, deed))
        return -bounded.mean() - 0.01 * entropy.mean()

    slopes = []
    policy.network.learn = lambda kept, slope, rate: slopes.append(slope)
    policy.learn(x, actions, before, advantage, 1e-3, 0.01, farthest=np.inf)
    bias = policy.network.weights[5]
    for k in range(len(bias)):
        here = loss()
        bias[k] += 1e-6
        assert slopes[0].sum(0)[k] == pytest.approx((loss() - here) / 1e-6, abs=1e-4)
        bias[k] -= 1e-6
