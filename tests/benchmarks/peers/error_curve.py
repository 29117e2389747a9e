# SPDX-License-Identifier: GPL-3.0-or-later
"""Time that an error costs, from a few measured pairs (error, time)."""
import dataclasses
import math


@dataclasses.dataclass
class Cost:
    seconds: float
    is_bound: bool  # no setting is this coarse: the cheapest one, which is more accurate


def front(pairs):
    """The settings that no other one beats in both, from the largest error to the smallest."""
    best = []
    for error, time in sorted(pairs):
        if not best or time < best[-1][1]:
            best.append((error, time))
    return best[::-1]


def cost_of(error, pairs):
    """Log-log between the neighbours on the front; None where no setting reaches the error."""
    best = front(pairs)
    if not best or error < best[-1][0]:
        return None
    if error >= best[0][0]:
        return Cost(best[0][1], error > best[0][0])
    for (e0, t0), (e1, t1) in zip(best, best[1:]):
        if e1 <= error:
            part = math.log(error / e0) / math.log(e1 / e0)
            return Cost(math.exp(math.log(t0) + part * math.log(t1 / t0)), False)
    return None
