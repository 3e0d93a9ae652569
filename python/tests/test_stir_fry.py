"""`saute/StirFry-v1`: it keeps Gymnasium's contract, is seeded, and rewards vegetables that stay in the pan and become tender."""

import numpy as np
import pytest

import saute

gymnasium = pytest.importorskip("gymnasium")
envs = pytest.importorskip("saute.envs")
from saute.envs import stir_fry  # noqa: E402

QUICK = {"carrots": 2, "leeks": 1, "coarseness": 6.0, "max_s": 1.0}
#: The pan stands on the hob, at 1200 W; the turner is away.
STILL = np.array([0, 0, -1, 0, 0, 0.2, 0, 0, 0, 0, 0.0])


def test_the_environment_keeps_the_contract_of_gymnasium():
    from gymnasium.utils.env_checker import check_env

    for observation in stir_fry.PRESETS:
        env = gymnasium.make("saute/StirFry-v1", observation=observation, **QUICK)
        check_env(env.unwrapped, skip_render_check=True)


def play(env, seed, count):
    seen = [env.reset(seed=seed)[0]]
    rewards = []
    for i in range(count):
        action = STILL.copy()
        action[0], action[10] = np.sin(i), 1.0 if i > 4 else -1.0
        observation, reward, empty, served, said = env.step(action)
        seen.append(observation)
        rewards.append(reward)
    return np.array(seen), rewards, empty, served, said


def test_an_episode_is_served_after_its_time_with_the_score_of_the_planner():
    env = envs.StirFryEnv(**QUICK)
    _, rewards, empty, served, said = play(env, 1, 20)
    assert served and not empty and said["time_s"] == pytest.approx(1)
    assert rewards[:-1] == [0.0] * 19
    assert rewards[-1] == pytest.approx(env.kitchen.score(**stir_fry.GOAL)["score"] / 100)


def test_a_seed_gives_the_same_episode_and_another_seed_another_one():
    env = envs.StirFryEnv(**QUICK)
    one, again, other = play(env, 3, 6), play(env, 3, 6), play(env, 4, 6)
    assert np.array_equal(one[0], again[0]) and one[1] == again[1]
    assert not np.array_equal(one[0][0], other[0][0])


def test_the_pan_goes_where_it_is_held():
    env = envs.StirFryEnv(**QUICK)
    env.reset(seed=1)
    for _ in range(15):
        env.step(STILL + np.array([0.5, -0.5, 1.0, 0, 0, 0, 0, 0, 0, 0, 0]))
    place = env.kitchen.pan_pose_m[:3] - np.array([0, 0, 0.0025])
    assert place == pytest.approx([0.03, -0.03, 0.06], abs=2e-3)


def test_vegetables_that_are_thrown_out_cost_their_share():
    env = envs.StirFryEnv(**{**QUICK, "max_s": 20.0})
    env.reset(seed=1)
    total, empty, random = 0.0, False, np.random.default_rng(0)
    while not empty:
        _, reward, empty, served, said = env.step(random.uniform(-1, 1, 11))
        assert not served
        total += reward
    assert empty and said["spilled"] == 3
    score = env.kitchen.score(**stir_fry.GOAL)["score"] / 100
    assert total == pytest.approx(-1 + score)


def test_the_turner_pushes_vegetables():
    env = envs.StirFryEnv(**QUICK)
    env.reset(seed=1)
    before = np.array([env.kitchen[name].at_mm for name in env.kitchen.names])
    for i in range(60):
        sweep = STILL.copy()
        sweep[6], sweep[7], sweep[8], sweep[10] = np.cos(i / 5), np.sin(i / 5), -1.0, 1.0
        sweep[6:8] *= 0.5 if i < 30 else 0.2
        env.step(sweep)
    after = np.array([env.kitchen[name].at_mm for name in env.kitchen.names])
    assert np.linalg.norm(after - before, axis=1).max() > 10


def test_oil_is_poured_once_a_second():
    env = envs.StirFryEnv(observation="scientist", **{**QUICK, "max_s": 3.0})
    env.reset(seed=1)
    pour = STILL.copy()
    pour[10] = -1.0
    poured = [env.step(pour)[0][9] * 20 for _ in range(41)]
    assert poured[0] == pytest.approx(2) and poured[19] == pytest.approx(2) and poured[-1] == pytest.approx(6)


def test_many_environments_give_what_one_gives():
    many = gymnasium.make_vec("saute/StirFry-v1", num_envs=2, vectorization_mode="vector_entry_point", threads=2, **QUICK)
    ones = [envs.StirFryEnv(**QUICK) for _ in range(2)]
    seen, _ = many.reset(seed=5)
    for i, env in enumerate(ones):
        assert np.array_equal(seen[i], env.reset(seed=5 + i)[0])
    for step in range(20):
        actions = np.array([STILL, 0.3 * np.cos(np.arange(11) + step)])
        seen, rewards, empty, served, _ = many.step(actions)
        for i, env in enumerate(ones):
            expected = env.step(actions[i])
            assert np.array_equal(seen[i], expected[0])
            assert (rewards[i], empty[i], served[i]) == expected[1:4]
    assert served.all()
    seen, rewards, *_ = many.step(actions)
    assert np.array_equal(seen[0], ones[0].reset()[0]) and rewards[0] == 0


def test_bad_choices_are_refused():
    with pytest.raises(ValueError, match="cook, scientist"):
        envs.StirFryEnv(observation="nose")
    with pytest.raises(ValueError, match="0 to 7"):
        envs.StirFryEnv(carrots=9)
    with pytest.raises(ValueError, match="may have pan_c"):
        envs.StirFryEnv(**QUICK).reset(options={"wine": 1})
    with pytest.raises(ValueError, match="rgb_array"):
        envs.StirFryEnv(render_mode="print", **QUICK)


def test_a_picture_needs_a_driver_and_nothing_else_does():
    env = envs.StirFryEnv(render_mode="rgb_array", size=(64, 48), **QUICK)
    env.reset(seed=1)
    try:
        picture = env.render()
    except saute.GraphicsError as error:
        assert "Vulkan" in str(error)
        return
    assert picture.shape == (48, 64, 3) and picture.std() > 5
