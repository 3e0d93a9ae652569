"""Learns to fry a steak: proximal policy optimisation (PPO) of saute/Steak-v1 in one file on NumPy.

    python train_steak.py --seed 1 --minutes 15 --out policy-1.npz
    python train_steak.py --judge policy-1.npz          # on the full mesh, with thicknesses that training never saw

Needs: pip install 'saute[gym]'. Every five seconds the policy sets the hob and leaves the steak, turns it over or takes it
out; the reward is the score of the plate, at the end. Steaks of training have whole millimetres, those of the examination
halves. docs/python.md has the curves and what five seeds gave.
"""

import argparse
import copy
import json
import time

import numpy as np

from saute.envs import SteakVectorEnv
from saute.envs.steak import COOK, HOB_SETTINGS, SCIENTIST

#: Names of what is observed, in order.
NAMES = [name for name, _ in COOK + SCIENTIST]
#: Steaks at once; decisions of each in a batch; seconds between decisions.
STEAKS, DECISIONS, CONTROL_S = 32, 64, 5.0
#: Passes over a batch, decisions of a step, bound of the ratio, rate of learning, weight of the entropy at the start.
PASSES, MINIBATCH, CLIP, RATE, ENTROPY = 4, 512, 0.2, 1e-3, 0.005
#: Mean change of the logarithm of the probabilities after which no further pass is made over a batch.
FARTHEST = 0.03
#: Discount per decision for advantages (none for rewards: an episode is judged at its end).
LAMBDA = 0.97
#: Units of the hidden layers.
HIDDEN = 48
#: Updates between two trials, and the steaks of a trial [mm]: the best policy of all trials is kept.
TRIAL_EVERY, TRIED_MM = 10, (15, 18, 21, 24, 27, 30, 33, 35)
#: Tasks of the examination: thicknesses [mm] and temperatures of the pan [°C]. None of these thicknesses is drawn in training.
EXAMINED_MM = (17.5, 20.5, 23.5, 26.5, 29.5, 32.5)
EXAMINED_PAN_C = 210.0
#: What the first policy leans to (chosen): about 500 W, as more burns the oil; one turn in two minutes; to take out a steak whose
#: core nears 55 °C. From there it learns.
HOB_LEANING = -0.35 * (np.arange(HOB_SETTINGS) - 2.0) ** 2
TURN_LEANING, RAW_LEANING, RIPE_LEANING = -3.2, -7.0, 7.0
RIPE_C, RIPE_WIDTH_C = 50.0, 2.5


def features(seen):
    """Returns what the networks read: the observation, what matters near the end of a cook on its own scale, and ripeness."""
    at = {name: seen[:, i].astype(float) for i, name in enumerate(NAMES)}
    core = 100.0 * at["core_c"]
    near = [np.clip((core - middle) / 6.0, -2.0, 2.0) for middle in (30.0, 45.0, 52.0, 58.0)]
    pan = 250.0 * at["pan_c"]
    hot = [np.clip((pan - middle) / 20.0, -2.0, 2.0) for middle in (190.0, 220.0, 250.0)]
    since = 300.0 * at["since_flip_s"]
    late = [np.clip(since / scale, 0.0, 2.0) - 1.0 for scale in (20.0, 60.0, 180.0)]
    ripe = 1.0 / (1.0 + np.exp((RIPE_C - core) / RIPE_WIDTH_C))
    return np.column_stack([seen, *near, *hot, *late, ripe])


class Network:
    """Two hidden layers of tanh units, with Adam."""

    def __init__(self, random, inputs, outputs, last):
        sizes = [inputs, HIDDEN, HIDDEN, outputs]
        scales = [1.0, 1.0, last]
        self.weights = [
            value
            for rows, columns, scale in zip(sizes, sizes[1:], scales)
            for value in (scale * random.standard_normal((rows, columns)) / np.sqrt(rows), np.zeros(columns))
        ]
        self.moments = [(np.zeros_like(w), np.zeros_like(w)) for w in self.weights]
        self.steps = 0

    def forward(self, x):
        """Returns the output, and what `learn` needs of the layers."""
        w1, b1, w2, b2, w3, b3 = self.weights
        one = np.tanh(x @ w1 + b1)
        two = np.tanh(one @ w2 + b2)
        return two @ w3 + b3, (x, one, two)

    def learn(self, kept, slope, rate):
        """One step of Adam against the slope of the loss by the output."""
        x, one, two = kept
        _, _, w2, _, w3, _ = self.weights
        by_two = (slope @ w3.T) * (1.0 - two * two)
        by_one = (by_two @ w2.T) * (1.0 - one * one)
        slopes = [x.T @ by_one, by_one.sum(0), one.T @ by_two, by_two.sum(0), two.T @ slope, slope.sum(0)]
        length = np.sqrt(sum(float((s * s).sum()) for s in slopes))
        shorten = min(1.0, 0.5 / (length + 1e-12))
        self.steps += 1
        for weight, (mean, square), step in zip(self.weights, self.moments, slopes):
            step = step * shorten
            mean += 0.1 * (step - mean)
            square += 0.001 * (step * step - square)
            unbiased = np.sqrt(square / (1.0 - 0.999**self.steps)) + 1e-8
            weight -= rate * mean / (1.0 - 0.9**self.steps) / unbiased


def chances(logits):
    """Returns the probabilities of logits."""
    logits = logits - logits.max(axis=1, keepdims=True)
    odds = np.exp(logits)
    return odds / odds.sum(axis=1, keepdims=True)


class Policy:
    """Two choices at once: the hob's setting, and what is done with the steak."""

    def __init__(self, random, inputs):
        self.network = Network(random, inputs, HOB_SETTINGS + 3, 0.01)

    def chances(self, x):
        logits, kept = self.network.forward(x)
        hob, deed = logits[:, :HOB_SETTINGS], logits[:, HOB_SETTINGS:]
        out = RAW_LEANING + RIPE_LEANING * x[:, -1]
        leaning = np.column_stack([np.zeros(len(x)), np.full(len(x), TURN_LEANING), out])
        return chances(hob + HOB_LEANING), chances(deed + leaning), kept

    def act(self, x, random):
        """Draws actions; returns them and the logarithm of their probability."""
        hob, deed, _ = self.chances(x)
        drawn = [(p.cumsum(1) > random.random((len(p), 1))).argmax(1) for p in (hob, deed)]
        rows = np.arange(len(x))
        return np.column_stack(drawn), np.log(hob[rows, drawn[0]] * deed[rows, drawn[1]] + 1e-12)

    def learn(self, x, actions, before, advantage, rate, entropy, farthest=FARTHEST):
        """One step of PPO: the ratio is bounded, and the entropy counts a little. No step, and False, where the policy went far."""
        *both, kept = self.chances(x)
        rows, count = np.arange(len(x)), len(x)
        now = np.log(both[0][rows, actions[:, 0]] * both[1][rows, actions[:, 1]] + 1e-12)
        ratio = np.exp(now - before)
        bounded = ((advantage > 0) & (ratio > 1 + CLIP)) | ((advantage < 0) & (ratio < 1 - CLIP))
        weight = np.where(bounded, 0.0, -advantage * ratio) / count
        away = float((before - now).mean())
        if away > farthest:
            return False
        slopes = []
        for p, chosen in zip(both, actions.T):
            taken = np.zeros_like(p)
            taken[rows, chosen] = 1.0
            logs = np.log(p + 1e-12)
            spread = p * (logs - (p * logs).sum(1, keepdims=True))
            slopes.append(weight[:, None] * (taken - p) + entropy / count * spread)
        self.network.learn(kept, np.concatenate(slopes, axis=1), rate)
        return True


class Scale:
    """Running mean and spread of the features; the last one, ripeness, is left as it is."""

    def __init__(self, width):
        self.count, self.mean, self.square = 1e-4, np.zeros(width), np.ones(width)

    def note(self, x):
        share = len(x) / (self.count + len(x))
        off = x.mean(0) - self.mean
        self.square += share * (x.var(0) - self.square) + share * (1 - share) * off * off
        self.mean += share * off
        self.count += len(x)

    def __call__(self, x):
        scaled = np.clip((x - self.mean) / np.sqrt(self.square + 1e-4), -5, 5)
        scaled[:, -1] = x[:, -1]
        return scaled


def advantages(rewards, values, ended, last):
    """Returns the advantage of each decision and what its value should have been."""
    found, ahead = np.zeros_like(rewards), np.zeros(rewards.shape[1])
    following = last
    for t in reversed(range(len(rewards))):
        goes_on = 1.0 - ended[t]
        ahead = rewards[t] + goes_on * following - values[t] + LAMBDA * goes_on * ahead
        found[t], following = ahead, values[t]
    return found, found + values


def train(seed, minutes, updates, threads, quiet=False, decisions=DECISIONS):
    """Trains for so many minutes or updates; returns the policy, its scale and the curve."""
    random = np.random.default_rng(seed)
    # The core has its peak within three minutes on the board.
    env = SteakVectorEnv(STEAKS, threads=threads, control_s=CONTROL_S, rest_s=180.0)
    seen, _ = env.reset(seed=1000 * seed)
    width = features(seen).shape[1]
    policy, value, scale = Policy(random, width), Network(random, width, 1, 0.1), Scale(width)
    scale.note(features(seen))
    started, curve, scores, update = time.monotonic(), [], [], 0
    again = np.zeros(STEAKS, dtype=bool)
    best, tried = None, float("nan")
    while time.monotonic() - started < 60 * minutes and update < updates:
        done = update / updates
        kept = {name: [] for name in ("x", "action", "log", "reward", "value", "end", "counts")}
        raw = []
        for _ in range(decisions):
            read = features(seen)
            raw.append(read)
            x = scale(read)
            action, log = policy.act(x, random)
            kept["value"].append(value.forward(x)[0][:, 0])
            seen, reward, taken, late, _ = env.step(action)
            end = taken | late
            for name, one in zip(kept, (x, action, log, reward, None, end | again, ~again)):
                if one is not None:
                    kept[name].append(one)
            scores += [100 * r for r in reward[end]]
            again = end
        last = value.forward(scale(features(seen)))[0][:, 0]
        arrays = {name: np.array(values) for name, values in kept.items()}
        advantage, wanted = advantages(arrays["reward"], arrays["value"], arrays["end"], last)
        counts = arrays["counts"].ravel()
        x, actions, logs = (arrays[name].reshape(counts.size, -1)[counts] for name in ("x", "action", "log"))
        advantage, wanted = advantage.ravel()[counts], wanted.ravel()[counts]
        advantage = (advantage - advantage.mean()) / (advantage.std() + 1e-6)
        rate, entropy = RATE * (1.0 - 0.9 * done), ENTROPY * (1.0 - done)
        near = True
        for _ in range(PASSES):
            for part in np.array_split(random.permutation(len(x)), max(1, len(x) // MINIBATCH)):
                near = near and policy.learn(x[part], actions[part], logs[part, 0], advantage[part], rate, entropy)
                guess, layers = value.forward(x[part])
                value.learn(layers, (guess - wanted[part, None]) / len(part), rate)
        update += 1
        if update % TRIAL_EVERY == 0:
            tried = float(np.mean(judge(policy, scale, "reduced", threads, TRIED_MM)[0]))
            if best is None or tried > best[0]:
                best = (tried, [w.copy() for w in policy.network.weights], copy.deepcopy(scale))
        scale.note(np.concatenate(raw))
        recent = scores[-64:]
        passed = round(time.monotonic() - started, 1)
        curve.append([update, passed, len(scores), float(np.mean(recent or [np.nan])), tried])
        if not quiet:
            print("update {}, {:.0f} s, {} steaks, score {:.1f}, last trial {:.1f}".format(*curve[-1]), flush=True)
    if best is not None:
        policy.network.weights, scale = best[1:]
    return policy, scale, curve


def judge(policy, scale, mesh="full", threads=None, thicknesses=EXAMINED_MM, max_s=1200.0):
    """Returns the score of each thickness, in points, and the flips. What the policy leaves to chance is drawn, always the same."""
    random = np.random.default_rng(0)
    env = SteakVectorEnv(len(thicknesses), threads=threads, control_s=CONTROL_S, mesh=mesh, max_s=max_s)
    seen, _ = env.reset(seed=1, options={"thickness_mm": list(thicknesses), "pan_c": EXAMINED_PAN_C})
    scores, flips = np.zeros(len(thicknesses)), np.zeros(len(thicknesses), dtype=int)
    left = np.ones(len(thicknesses), dtype=bool)
    while left.any():
        seen, reward, taken, late, said = env.step(policy.act(scale(features(seen)), random)[0])
        ended = left & (taken | late)
        scores[ended], flips[ended] = 100 * reward[ended], said["flips"][ended]
        left &= ~ended
    return scores.tolist(), flips.tolist()


def store(path, policy, scale, curve):
    weights = {f"w{i}": w for i, w in enumerate(policy.network.weights)}
    np.savez(path, mean=scale.mean, square=scale.square, curve=np.array(curve), **weights)


def load(path):
    with np.load(path) as file:
        policy = Policy(np.random.default_rng(0), len(file["mean"]))
        policy.network.weights = [file[f"w{i}"] for i in range(6)]
        scale = Scale(len(file["mean"]))
        scale.mean, scale.square = file["mean"], file["square"]
    return policy, scale


def main():
    parser = argparse.ArgumentParser(description="Learns to fry a steak.")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=15.0, help="longest time of training")
    parser.add_argument("--updates", type=int, default=110, help="updates of the policy; rates fall until the last one")
    parser.add_argument("--threads", type=int, default=None, help="threads; all cores by default")
    parser.add_argument("--out", help="file for the policy (.npz)")
    parser.add_argument("--judge", metavar="FILE", help="examine a stored policy instead of training one")
    parser.add_argument("--wanted", type=float, help="exit with 1 if the mean score stays below this [points]")
    arguments = parser.parse_args()
    if arguments.judge:
        policy, scale = load(arguments.judge)
    else:
        policy, scale, curve = train(arguments.seed, arguments.minutes, arguments.updates, arguments.threads)
        if arguments.out:
            store(arguments.out, policy, scale, curve)
    scores, flips = judge(policy, scale, threads=arguments.threads)
    found = {str(mm): [round(s, 1), n] for mm, s, n in zip(EXAMINED_MM, scores, flips)}
    mean = float(np.mean(scores))
    print(json.dumps({"seed": arguments.seed, "mean": round(mean, 2), "score_and_flips": found}))
    raise SystemExit(arguments.wanted is not None and mean < arguments.wanted)


if __name__ == "__main__":
    main()
