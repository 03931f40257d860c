"""Tests of the reduced forms of studies: each statement is an interval of 99 % (t distribution) that must lie within bounds."""
import math
import statistics

T_99 = {7: 3.499, 14: 2.977, 15: 2.947, 23: 2.807, 30: 2.750, 46: 2.687, 47: 2.685}  # two-sided, by degrees of freedom


def interval(values):
    """The interval of the mean."""
    half = T_99[len(values) - 1] * statistics.stdev(values) / math.sqrt(len(values))
    return statistics.mean(values) - half, statistics.mean(values) + half


def difference(first, second):
    """The interval of the difference of two means."""
    variance = statistics.variance(first) / len(first) + statistics.variance(second) / len(second)
    half = T_99[len(first) + len(second) - 2] * math.sqrt(variance)
    mean = statistics.mean(first) - statistics.mean(second)
    return mean - half, mean + half


class Statements:
    """Prints statements, and counts those that do not hold."""

    def __init__(self):
        self.wrong = 0

    def require(self, text, found, low, high):
        """States that the interval found lies within [low, high]."""
        holds = low <= found[0] and found[1] <= high
        self.wrong += not holds
        print(f"{'ok' if holds else 'WRONG'}: {text}: [{found[0]:.3f}, {found[1]:.3f}] within [{low}, {high}]")
