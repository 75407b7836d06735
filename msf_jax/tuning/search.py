"""Minimise a function of a few numbers that costs seconds a value and jumps a little: a model of all that is known.

Values of past runs are interpolated by radial basis functions; the next point is, of many candidates around the best
one, the one with the least score

    w (model, scaled to 0 .. 1)  +  (1 - w) (1 - distance to the nearest known point, scaled to 0 .. 1),

with w cycling from exploring to exploiting, and candidates that draw in while nothing better is found (stochastic RBF,
Regis and Shoemaker 2007; coordinates perturbed by chance, DYCORS, 2013). It begins with a Latin hypercube around the
better of the points that it is given. The same arguments give the same points.
"""

from collections.abc import Sequence

import numpy as np
from scipy import interpolate, spatial
from scipy.stats import qmc

CANDIDATES = 200  # for each number that is sought
WAYS = (0.3, 0.6, 0.9, 1.0)  # the weights w, in turn
FIRST_SPREAD, SMALLEST_SPREAD, LARGEST_SPREAD = 0.5, 0.03, 1.2  # of the candidates around the best point, in logarithms
SUCCESSES, FAILURES = 2, 4  # in a row, after which they spread, or draw in, twice as far
REACH = 2.3  # logarithms, a factor of ten, by which the first points reach to either side of the best that was given


class Search:
    """The points asked for so far, and what was told of them.

    Args:
        given: (k, d) points to begin with.
        low, high: (d,) bounds.
        seed: of the random numbers.
    """

    def __init__(self, given: Sequence[np.ndarray], low: np.ndarray, high: np.ndarray, seed: int = 0):
        self.random = np.random.default_rng(seed)
        self.low, self.high = low, high
        self.points, self.values = np.empty((0, len(low))), np.empty(0)
        self.waiting = [*np.array(given)]
        self.has_begun = False  # whether the hypercube has been drawn
        self.spread, self.successes, self.failures, self.turn = FIRST_SPREAD, 0, 0, 0

    @property
    def best(self) -> np.ndarray:
        """(d,) the point of the least value."""
        return self.points[np.argmin(self.values)]

    def ask(self, num: int = 1) -> np.ndarray:
        """(n, d) the points to try next, ``num`` or fewer: what comes after those given depends on their values."""
        chosen: list[np.ndarray] = []
        while len(chosen) < num:
            if not self.waiting and not self.has_begun:
                if chosen:
                    break
                self.waiting, self.has_begun = self._around_the_best(), True
            chosen.append(self.waiting.pop(0) if self.waiting else self._by_model(chosen))
        return np.array(chosen)

    def tell(self, points: np.ndarray, values: np.ndarray) -> None:
        """What was found at ``points`` (n, d): values (n,), infinite where there is none."""
        is_better = len(self.values) > 0 and np.min(values) < np.min(self.values)
        is_modelled = self.has_begun and not self.waiting
        self.points = np.concatenate([self.points, points])
        self.values = np.concatenate([self.values, values])
        if is_modelled:
            self.successes, self.failures = (self.successes + 1, 0) if is_better else (0, self.failures + len(points))
            if self.successes >= SUCCESSES:
                self.spread, self.successes = min(2 * self.spread, LARGEST_SPREAD), 0
            elif self.failures >= FAILURES:
                self.spread, self.failures = max(self.spread / 2, SMALLEST_SPREAD), 0

    def expected(self, points: np.ndarray) -> np.ndarray:
        """(n,) what the model says of ``points`` (n, d); NaN while it knows too little."""
        distinct, first = np.unique(self.points, axis=0, return_index=True)
        if len(distinct) < len(self.low) + 2:
            return np.full(len(points), np.nan)
        values = self.values[first]
        # A few bad values would bend the model everywhere; that they are no better than most is all that counts.
        values = np.minimum(values, np.median(values[np.isfinite(values)]))
        return interpolate.RBFInterpolator(distinct, values, kernel="cubic", degree=1)(points)

    def _around_the_best(self) -> list[np.ndarray]:
        floor, ceiling = np.maximum(self.low, self.best - REACH), np.minimum(self.high, self.best + REACH)
        cube = qmc.LatinHypercube(len(self.low), rng=self.random).random(len(self.low) + 2)
        return [*(floor + cube * (ceiling - floor))]

    def _by_model(self, chosen: list[np.ndarray]) -> np.ndarray:
        num, size = CANDIDATES * len(self.low), len(self.low)
        steps = self.spread * self.random.normal(size=(num, size))
        stays = self.random.random((num, size)) > max(0.5, 1 / size)
        stays[np.arange(num), self.random.integers(size, size=num)] = False
        candidates = np.clip(self.best + np.where(stays, 0.0, steps), self.low, self.high)
        weight = WAYS[self.turn % len(WAYS)]
        self.turn += 1
        known = np.concatenate([self.points, np.reshape(chosen, (-1, size))])
        away = np.asarray(spatial.KDTree(known).query(candidates)[0])
        model = self.expected(candidates)
        model = np.zeros(num) if np.isnan(model).any() else model
        score = weight * _scaled(model) + (1 - weight) * (1 - _scaled(away))
        score[away < SMALLEST_SPREAD / 10] = np.inf  # known already
        return candidates[np.argmin(score)]


def _scaled(values: np.ndarray) -> np.ndarray:
    return (values - values.min()) / max(np.ptp(values), 1e-300)
