"""How far to believe a prediction: bias and scatter from pairs of predicted and measured values.

As fire models report them: K. McGrattan, B. Toman, "Quantifying the predictive uncertainty of complex numerical
models", Metrologia 48 (2011); NIST SP 1018-3, FDS Validation Guide, chapter "Quantifying Model Uncertainty".
With P predicted, M measured, sigma_E the relative scatter of a test and sigma_M that of the model about delta times
the truth,

  ln(P/M) ~ N( ln delta - sigma_M^2/2 + sigma_E^2/2,  sigma_M^2 + sigma_E^2 )
  sigma_M^2 = s^2 - sigma_E^2,                        s^2 the variance of ln(P/M), n - 1 below
  delta     = exp( mean ln(P/M) + sigma_M^2/2 - sigma_E^2/2 )

and the truth behind a prediction P is about N(P/delta, (sigma_M P/delta)^2). A model cannot be shown to be better than
the tests: where s^2 < 2 sigma_E^2, both take s/sqrt(2) ("at the tests' scatter").

Intervals (95 %). The tables hold four to a dozen walls. For so few a bootstrap is too narrow (it never draws what it has not
seen), so they are those of the normal distribution: Student's t for the mean, chi square for s.

Censored pairs. A push that ended before its force fell to 80 % gives a lower bound of P, a test likewise of M. The mean and
s are then the most likely ones of the normal distribution given values and bounds, s^2 enlarged by n/(n-1). The mean's interval is
that of the likelihood ratio, cut where it is Student's t if nothing is censored: n ln(1 + t^2/(n-1)). n in both and in chi
square counts the uncensored values only. Bounds on both sides of a ratio say nothing and are left out.
"""
import math
from statistics import NormalDist

NORMAL = NormalDist()
LEVEL = 0.95


# --- quantiles: bisection on the distribution functions ---------------------------------------------

def _beta_fraction(a, b, x):
    """Continued fraction of the incomplete beta function (Lentz)."""
    tiny, c = 1e-300, 1.0
    d = 1 / (1 - (a + b) * x / (a + 1) or tiny)
    f = d
    for m in range(1, 500):
        for step in (m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
                     -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))):
            d = 1 / (1 + step * d or tiny)
            c = 1 + step / c or tiny
            f *= c * d
        if abs(c * d - 1) < 1e-15:
            break
    return f


def beta_share(a, b, x):
    """Regularised incomplete beta function I_x(a, b)."""
    if x <= 0 or x >= 1:
        return float(x >= 1)
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x))
    if x < (a + 1) / (a + b + 2):
        return front * _beta_fraction(a, b, x) / a
    return 1 - front * _beta_fraction(b, a, 1 - x) / b


def gamma_share(a, x):
    """Regularised lower incomplete gamma function P(a, x), by its series (x of a few hundred at most)."""
    if x <= 0:
        return 0.0
    term = total = 1 / a
    n = a
    while term > total * 1e-17:
        n += 1
        term *= x / n
        total += term
    return min(1.0, total * math.exp(-x + a * math.log(x) - math.lgamma(a)))


def _root(function, low, high):
    """Where a rising function passes 0, low < high."""
    for _ in range(200):
        middle = 0.5 * (low + high)
        if function(middle) < 0:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def t_quantile(p, dof):
    """Student's t for p > 0.5."""
    return _root(lambda t: 1 - 0.5 * beta_share(dof / 2, 0.5, dof / (dof + t * t)) - p, 0, 1e6)


def chi2_quantile(p, dof):
    return _root(lambda x: gamma_share(dof / 2, x / 2) - p, 0, 20 * dof + 200)


# --- a sample of ln(P/M), some of it bounds -------------------------------------------------------------

def bounds_of(predicted, measured, predicted_is_bound=False, measured_is_bound=False):
    """ln(P/M) as an interval (low, high); None where both are bounds and nothing is known."""
    if predicted_is_bound and measured_is_bound:
        return None
    ratio = math.log(predicted / measured)
    return (ratio, math.inf if predicted_is_bound else ratio) if not measured_is_bound else (-math.inf, ratio)


def log_likelihood(sample, mean, spread):
    total = 0.0
    for low, high in sample:
        if low == high:
            total += -math.log(spread) - 0.5 * ((low - mean) / spread) ** 2
        else:
            z = (mean - low) / spread if high == math.inf else (high - mean) / spread
            total += math.log(max(NORMAL.cdf(z), 1e-300))
    return total


def _hidden_moments(low, high, mean, spread):
    """Mean and variance of a normal variable known to lie beyond a bound."""
    sign, bound = (1, low) if high == math.inf else (-1, -high)
    z = (bound - sign * mean) / spread
    tail = max(NORMAL.cdf(-z), 1e-300)
    hazard = NORMAL.pdf(z) / tail
    return sign * (sign * mean + spread * hazard), spread ** 2 * max(0.0, 1 + z * hazard - hazard ** 2)


def most_likely(sample, mean=None):
    """(mean, spread) of the greatest likelihood, spread with n below; with `mean` given only the spread."""
    exact = [a for a, b in sample if a == b]
    m = mean if mean is not None else sum(exact) / len(exact)
    s = max(math.sqrt(sum((x - m) ** 2 for x in exact) / len(exact)), 1e-9)
    for _ in range(5000):  # expectation maximisation: what lies beyond a bound is replaced by its moments
        moments = [(a, 0.0) if a == b else _hidden_moments(a, b, m, s) for a, b in sample]
        next_m = mean if mean is not None else sum(x for x, _ in moments) / len(moments)
        next_s = max(math.sqrt(sum((x - next_m) ** 2 + v for x, v in moments) / len(moments)), 1e-9)
        done = abs(next_m - m) < 1e-12 and abs(next_s - s) < 1e-12
        m, s = next_m, next_s
        if done:
            break
    return m, s


def _mean_interval(sample, n, mean, spread):
    cut = n * math.log1p(t_quantile(0.5 + LEVEL / 2, n - 1) ** 2 / (n - 1))
    best = log_likelihood(sample, mean, spread)

    def beyond(m):
        return 2 * (best - log_likelihood(sample, m, most_likely(sample, m)[1])) - cut
    reach = 1e-6
    while beyond(mean + reach) < 0 and reach < 50:
        reach *= 2
    high = _root(lambda x: beyond(mean + x), 0, reach)
    reach = 1e-6
    while beyond(mean - reach) < 0 and reach < 50:
        reach *= 2
    return mean - _root(lambda x: beyond(mean - x), 0, reach), mean + high


def bias_and_scatter(sample, sigma_e):
    """The statistic of a sample of bounds_of(), with the tests' scatter; None where no value is uncensored.

    A dict: n (uncensored), censored, median ratio, delta, delta_interval, sigma_M, sigma_M_interval, at_floor. Intervals are None with
    fewer than two values, as sigma_M is.
    """
    sample = [pair for pair in sample if pair is not None]
    n = sum(a == b for a, b in sample)
    found = {"n": n, "censored": len(sample) - n, "sigma_E": sigma_e, "delta": None, "delta_interval": None,
             "sigma_M": None, "sigma_M_interval": None, "at_floor": False}
    if n == 0:
        return None
    mean, spread = most_likely(sample)
    found["median"] = math.exp(mean)
    if n == 1:
        found["delta"] = math.exp(mean)
        return found
    variance = spread ** 2 * n / (n - 1)
    found["at_floor"] = variance < 2 * sigma_e ** 2
    square_e = min(sigma_e ** 2, variance / 2)
    found["sigma_M"] = math.sqrt(variance - square_e)
    shift = 0.5 * (variance - 2 * square_e)
    found["delta"] = math.exp(mean + shift)
    found["delta_interval"] = [math.exp(x + shift) for x in _mean_interval(sample, n, mean, spread)]
    tails = [chi2_quantile(p, n - 1) for p in (0.5 + LEVEL / 2, 0.5 - LEVEL / 2)]
    found["sigma_M_interval"] = [math.sqrt(max(0.0, variance * (n - 1) / x - square_e)) for x in tails]
    return found


def scatter_of_pairs(pairs):
    """Relative scatter of one test from pairs of tests that should agree; (sigma_E, degrees of freedom)."""
    logs = [math.log(a / b) for a, b in pairs]
    return (math.sqrt(sum(x * x for x in logs) / (2 * len(logs))), len(logs)) if logs else (0.0, 0)
