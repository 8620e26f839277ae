"""Medians with their spread, and fitted lines with their error."""
import math


def quantile(values, share):
    """The quantile of `values`, linear between its neighbours."""
    ordered = sorted(values)
    at = share * (len(ordered) - 1)
    low = math.floor(at)
    high = min(low + 1, len(ordered) - 1)
    return ordered[low] + (at - low) * (ordered[high] - ordered[low])


def median(values):
    return quantile(values, 0.5)


def spread(values):
    """{median, low, high, repetitions}: the median and the quartiles."""
    return {"median": median(values), "low": quantile(values, 0.25), "high": quantile(values, 0.75),
            "repetitions": len(values)}


def line(xs, ys):
    """Least squares y = intercept + slope x: {slope, slope_error, intercept, r_squared, points}.

    slope_error is the standard error of the slope; None for two points, which leave nothing to judge by.
    """
    n = len(xs)
    if n < 2 or len(set(xs)) < 2:
        raise ValueError("a line needs two different abscissas")
    mean_x, mean_y = sum(xs) / n, sum(ys) / n
    squares = sum((x - mean_x) ** 2 for x in xs)
    slope = sum((x - mean_x) * (y - mean_y) for x, y in zip(xs, ys)) / squares
    intercept = mean_y - slope * mean_x
    rest = sum((y - intercept - slope * x) ** 2 for x, y in zip(xs, ys))
    total = sum((y - mean_y) ** 2 for y in ys)
    error = math.sqrt(rest / (n - 2) / squares) if n > 2 else None
    return {"slope": slope, "slope_error": error, "intercept": intercept,
            "r_squared": 1 - rest / total if total > 0 else 1.0, "points": n}


def exponent(xs, ys):
    """Least squares y = factor x^exponent, in logarithms: {exponent, error, factor, r_squared, points}."""
    fit = line([math.log(x) for x in xs], [math.log(y) for y in ys])
    return {"exponent": fit["slope"], "error": fit["slope_error"], "factor": math.exp(fit["intercept"]),
            "r_squared": fit["r_squared"], "points": fit["points"]}
