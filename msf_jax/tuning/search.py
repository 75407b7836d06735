"""Minimises an expensive, slightly discontinuous function of a few variables with a surrogate model.

Radial basis functions are fitted to all known values. Their smoothness is chosen by cross-validation, because the last
bits of a run can change a curve, so that a good value may be chance. Candidates are random points, half of them around
the best point, and half in a box around the last given point. The next point is the candidate with the least score

    w (model, scaled to 0 .. 1)  +  (1 - w) (1 - distance to the nearest known point, scaled to 0 .. 1).

w cycles from exploring to exploiting, and candidates come closer to the best point while nothing better is found
(stochastic RBF, Regis and Shoemaker 2007; random subsets of coordinates, DYCORS, 2013). The search begins with the
given points and a Latin hypercube in the box. The same arguments give the same points.
"""

from collections.abc import Sequence

import numpy as np
from scipy import interpolate, spatial
from scipy.stats import qmc

HALF_WIDTH = 2.3  # natural logarithms (a factor of ten): half the width of the box
CANDIDATES = 200  # candidates for each variable
METHODS = (0.3, 0.6, 0.9, 1.0)  # the weights w, in turn
LARGEST_DISTANCE = 1.5  # natural logarithms: larger distances to the nearest known point count as this
FIRST_SPREAD = 0.5  # natural logarithms: first standard deviation of candidates around the best point
SMALLEST_SPREAD = 0.03  # natural logarithms: its least value
LARGEST_SPREAD = 1.2  # natural logarithms: its largest value
SUCCESSES = 2  # successive successes after which the standard deviation doubles
FAILURES = 4  # successive failures after which it is halved
SMOOTHINGS = (0.0, 1.0, 10.0, 100.0)  # smoothings of the model to choose from; 0 interpolates
ENOUGH = 10  # points that cross-validation needs; with fewer, the smoothing is 1
FOLDS = 5  # folds of the cross-validation


class Search:
    """The known points and values of a search.

    Args:
        given: (k, d) first points. The box of candidates is around the last.
        low, high: (d,) bounds.
        seed: of the random numbers.
    """

    def __init__(self, given: Sequence[np.ndarray], low: np.ndarray, high: np.ndarray, seed: int = 0):
        self.random = np.random.default_rng(seed)
        self.low, self.high = low, high
        self.points, self.values = np.empty((0, len(low))), np.empty(0)
        known = np.array(given)
        self.floor, self.ceiling = np.maximum(low, known[-1] - HALF_WIDTH), np.minimum(high, known[-1] + HALF_WIDTH)
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
        """Add the ``values`` (n,) at ``points`` (n, d); infinite for a point without a value."""
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
        """(n,) the model's values at ``points`` (n, d); NaN while there are too few known points."""
        model = self._model()
        return np.full(len(points), np.nan) if model is None else model(points)

    def _model(self) -> interpolate.RBFInterpolator | None:
        distinct, first = np.unique(self.points, axis=0, return_index=True)
        values = self.values[first]
        if len(distinct) < len(self.low) + 2 or not np.isfinite(values).any():
            return None
        # A few bad values would distort the model everywhere, so values above the median count as the median.
        values = np.minimum(values, np.median(values[np.isfinite(values)]))
        return _fitted(distinct, values, _smoothing(distinct, values))

    def _by_model(self, chosen: list[np.ndarray]) -> np.ndarray:
        num, size = CANDIDATES * len(self.low), len(self.low)
        steps = self.spread * self.random.normal(size=(num, size))
        stays = self.random.random((num, size)) > max(0.5, 1 / size)
        stays[np.arange(num), self.random.integers(size, size=num)] = False
        # The centre is in turn the best known point, and the known point with the least value of the model.
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
        score = weight * _scaled(hoped) + (1 - weight) * (1 - _scaled(np.minimum(away, LARGEST_DISTANCE)))
        score[away < SMALLEST_SPREAD / 10] = np.inf  # too close to a known point
        return candidates[np.argmin(score)]


def _fitted(points: np.ndarray, values: np.ndarray, smoothing: float) -> interpolate.RBFInterpolator:
    return interpolate.RBFInterpolator(points, values, kernel="cubic", degree=1, smoothing=smoothing)


def _smoothing(points: np.ndarray, values: np.ndarray) -> float:
    """The one of `SMOOTHINGS` with the least error of cross-validation."""
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
