"""Minimise a function of a few numbers that costs seconds a value and jumps a little: a model of all that is known.

Values of past runs are fitted by radial basis functions, as smoothly as foretells values best that are left out of the
fit: last bits of a run can make another curve, so that a good value may be luck. Of many candidates, half around the
best point and half in a box around the given one, the next point is the one with the least score

    w (model, scaled to 0 .. 1)  +  (1 - w) (1 - distance to the nearest known point, scaled to 0 .. 1),

with w cycling from exploring to exploiting, and candidates that draw in while nothing better is found (stochastic RBF,
Regis and Shoemaker 2007; coordinates perturbed by chance, DYCORS, 2013). It begins with the points that it is given and
a Latin hypercube in that box. The same arguments give the same points.
"""

from collections.abc import Sequence

import numpy as np
from scipy import interpolate, spatial
from scipy.stats import qmc

REACH = 2.3  # logarithms, a factor of ten: the box, to either side of the last point that was given
CANDIDATES = 200  # for each number that is sought
METHODS = (0.3, 0.6, 0.9, 1.0)  # the weights w, in turn
FAR = 1.5  # logarithms, to the nearest known point: farther counts no more
FIRST_SPREAD, SMALLEST_SPREAD, LARGEST_SPREAD = 0.5, 0.03, 1.2  # of the candidates around the best point, in logarithms
SUCCESSES, FAILURES = 2, 4  # in a row, after which they spread, or draw in, twice as far
SMOOTHINGS = (0.0, 1.0, 10.0, 100.0)  # of the model; 0 goes through all values
ENOUGH, FOLDS = 10, 5  # points to choose one by leaving values out, a part of them at a time; before, it is 1


class Search:
    """The points asked for so far, and what was told of them.

    Args:
        given: (k, d) points to begin with; the last is the one that is usual.
        low, high: (d,) bounds.
        seed: of the random numbers.
    """

    def __init__(self, given: Sequence[np.ndarray], low: np.ndarray, high: np.ndarray, seed: int = 0):
        self.random = np.random.default_rng(seed)
        self.low, self.high = low, high
        self.points, self.values = np.empty((0, len(low))), np.empty(0)
        known = np.array(given)
        self.floor, self.ceiling = np.maximum(low, known[-1] - REACH), np.minimum(high, known[-1] + REACH)
        cube = qmc.LatinHypercube(len(low), rng=self.random).random(2 * (len(low) + 1))
        self.waiting = [*known, *(self.floor + cube * (self.ceiling - self.floor))]
        self.spread, self.successes, self.failures, self.turn = FIRST_SPREAD, 0, 0, 0

    @property
    def best(self) -> np.ndarray:
        """(d,) the point of the least value."""
        return self.points[np.argmin(self.values)]

    def ask(self, num: int = 1) -> np.ndarray:
        """(num, d) the points to try next."""
        chosen: list[np.ndarray] = []
        while len(chosen) < num:
            chosen.append(self.waiting.pop(0) if self.waiting else self._by_model(chosen))
        return np.array(chosen)

    def tell(self, points: np.ndarray, values: np.ndarray) -> None:
        """What was found at ``points`` (n, d): values (n,), infinite where there is none."""
        is_better = len(self.values) > 0 and np.min(values) < np.min(self.values)
        is_modelled = not self.waiting
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
        model = self._model()
        return np.full(len(points), np.nan) if model is None else model(points)

    def _model(self) -> interpolate.RBFInterpolator | None:
        distinct, first = np.unique(self.points, axis=0, return_index=True)
        values = self.values[first]
        if len(distinct) < len(self.low) + 2 or not np.isfinite(values).any():
            return None
        # A few bad values would bend the model everywhere; that they are no better than most is all that counts.
        values = np.minimum(values, np.median(values[np.isfinite(values)]))
        return _fitted(distinct, values, _smoothing(distinct, values))

    def _by_model(self, chosen: list[np.ndarray]) -> np.ndarray:
        num, size = CANDIDATES * len(self.low), len(self.low)
        steps = self.spread * self.random.normal(size=(num, size))
        stays = self.random.random((num, size)) > max(0.5, 1 / size)
        stays[np.arange(num), self.random.integers(size, size=num)] = False
        # In turn around the best value, and around the point that the model holds for the best.
        model, around = self._model(), self.best
        if model is not None and self.turn % 2:
            around = self.points[np.argmin(np.where(np.isfinite(self.values), model(self.points), np.inf))]
        candidates = np.clip(around + np.where(stays, 0.0, steps), self.low, self.high)
        candidates[: num // 2] = self.random.uniform(self.floor, self.ceiling, (num // 2, size))
        weight = METHODS[self.turn % len(METHODS)]
        self.turn += 1
        known = np.concatenate([self.points, np.reshape(chosen, (-1, size))])
        away = np.asarray(spatial.KDTree(known).query(candidates)[0])
        hoped = np.zeros(num) if model is None else model(candidates)
        score = weight * _scaled(hoped) + (1 - weight) * (1 - _scaled(np.minimum(away, FAR)))
        score[away < SMALLEST_SPREAD / 10] = np.inf  # known already
        return candidates[np.argmin(score)]


def _fitted(points: np.ndarray, values: np.ndarray, smoothing: float) -> interpolate.RBFInterpolator:
    return interpolate.RBFInterpolator(points, values, kernel="cubic", degree=1, smoothing=smoothing)


def _smoothing(points: np.ndarray, values: np.ndarray) -> float:
    """The one of `SMOOTHINGS` whose models come nearest to values that were left out."""
    num = len(points)
    if num < ENOUGH:
        return 1.0
    fold = np.random.default_rng(0).permutation(np.arange(num) % FOLDS)
    errors = [
        sum(
            (
                (_fitted(points[fold != k], values[fold != k], smoothing)(points[fold == k]) - values[fold == k]) ** 2
            ).sum()
            for k in range(FOLDS)
        )
        for smoothing in SMOOTHINGS
    ]
    return SMOOTHINGS[int(np.argmin(errors))]


def _scaled(values: np.ndarray) -> np.ndarray:
    return (values - values.min()) / max(np.ptp(values), 1e-300)
