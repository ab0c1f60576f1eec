"""Gates on Monte Carlo results, for pytest or alone. Needs numpy and scipy.

The rule is that of `ffstudy check` (docs/gates.md). Pass: the interval of level 1 - 2 pass_alpha lies in the band.
Fail: that of level 1 - alpha lies wholly outside. Otherwise inconclusive, which is no pass either.

    from ffstudy_gates import assert_mean_within, gate

    def test_mean():
        assert_mean_within([simulate(seed) for seed in range(100)], 0.2, band=1e-3)

    @gate(reference=0.2, band=1e-3)
    def test_as_many_trials_as_it_takes(seed):
        return simulate(seed)
"""

import functools
import inspect
import math
import os
from dataclasses import dataclass

import numpy
from scipy import stats

FEWEST_TRIALS = 10
PILOT_TRIALS = 64

_options = {"seed": 1}
_results = []  # (test, Result) of this run, for pytest's summary


@dataclass
class Result:
    verdict: str  # "pass", "fail" or "inconclusive"
    effect: float
    low: float  # of the interval that has to lie in the band
    high: float
    band: tuple
    alpha: float
    power: float
    trials: int
    trials_to_decide: float = 0  # to pass with the power where there is no effect; 0 where not known
    note: str = ""

    def __bool__(self):
        return self.verdict == "pass"

    def __str__(self):
        text = {"pass": "pass", "fail": "FAIL", "inconclusive": "INCONCLUSIVE (no pass)"}[self.verdict]
        if not math.isnan(self.effect):
            text += (f": effect {self.effect:.4g}, interval {self.low:.4g} to {self.high:.4g}, "
                     f"band {self.band[0]:.4g} to {self.band[1]:.4g}")
        text += f"; alpha {self.alpha:g}, power {self.power:g}; {self.trials} trials"
        if self.verdict == "inconclusive" and self.trials_to_decide > self.trials:
            text += f", about {math.ceil(self.trials_to_decide)} pass with that power if there is no effect"
        return text + (f". {self.note}" if self.note else "")


def _expect_options(band, alpha, power, pass_alpha, reference_error):
    if not band > 0:
        raise ValueError(f"band = {band} (no number of trials shows an effect of exactly nothing). Give a positive one.")
    if not 0 < alpha < 0.5 or not 0 < pass_alpha < 0.5:
        raise ValueError(f"alpha = {alpha}, pass_alpha = {pass_alpha} (risks lie above 0 and below 0.5).")
    if not 0.5 <= power < 1:
        raise ValueError(f"power = {power} (at least 0.5, and no number of trials makes it 1). Try 0.9.")
    if not reference_error >= 0:
        raise ValueError(f"reference_error = {reference_error} (a standard error is not negative).")


def _skewness_of_mean(x):
    """Skewness of the mean of x, its standard error by the influence function, and the largest that says nothing."""
    n = len(x)
    z = (x - x.mean()) / x.std()
    third = (z**3).mean()
    influence = z**3 - third - 3 * z - 1.5 * third * (z**2 - 1)
    normal = math.sqrt(6 * n * (n - 1) / ((n - 2) * (n + 1) * (n + 3)))
    root = math.sqrt(n)
    return (third * math.sqrt(n * (n - 1)) / (n - 2) / root, max(normal, math.sqrt((influence**2).mean() / n)) / root,
            2 * normal / root if n >= 30 else -math.inf)


def _reach(skewness, side, t, z):
    """How far a limit lies from the mean, in standard errors [hall1992, johnson1978]; infinite where x is too skewed.

    Side 1 is the upper limit, -1 the lower one; t and z are critical values of the tail beyond it. The factors are
    explained in stats/gates/skewed_reach.hpp.
    """
    value, error, insignificant = skewness
    value *= side
    cautious = value + 0.7 * z * error
    if cautious <= 0:
        return t
    if value > insignificant and cautious * t > 2:
        return math.inf
    first_order = t + cautious * (2 * t * t + 1) / 6
    if cautious < 1e-4:
        return first_order
    argument = cautious * (t + cautious / 6)
    if argument < 1.125:
        hall = (1 - float(numpy.cbrt(1 - argument))) * 3 / cautious
    else:
        hall = 2 * (t + math.sqrt(t * t + 0.75))
    return max(t, hall, first_order)


def trials_needed(sigma, band, *, power=0.9, pass_alpha=0.05, reference_error=0.0):
    """Trials with which a mean without effect passes with the power; infinite where no number is enough."""
    _expect_options(band, 1e-4, power, pass_alpha, reference_error)
    inner = stats.norm.isf(pass_alpha)
    both = inner + stats.norm.isf((1 - power) / 2)
    room = band**2 - (both * reference_error) ** 2
    return (both * sigma) ** 2 / room + inner**2 / 2 if room > 0 else math.inf


def judge_mean(samples, reference, *, band, alpha=1e-4, power=0.9, pass_alpha=0.05, reference_error=0.0):
    """The mean of trials, each a whole run with random numbers of its own, against a reference."""
    _expect_options(band, alpha, power, pass_alpha, reference_error)
    x = numpy.asarray(samples, dtype=float)
    if x.ndim != 1:
        raise ValueError(f"samples of shape {x.shape} (expected one number a trial). Gate one quantity at a time.")
    if not numpy.isfinite(x).all():
        raise ValueError("samples hold a value that is not finite (a mean of it would mean nothing).")
    n = len(x)

    def undecided(note):
        return Result("inconclusive", math.nan, math.nan, math.nan, (-band, band), alpha, power, n, 0, note)

    if n < FEWEST_TRIALS:
        return undecided(f"Fewer than {FEWEST_TRIALS} trials; 50 to 200 are usual.")
    if (x == x[0]).all():
        return undecided("Every trial gave the same value: was each seeded alike?")
    sigma = x.std(ddof=1)
    own = sigma / math.sqrt(n)
    error = math.hypot(own, reference_error)
    freedom = (n - 1) * (error / own) ** 4  # Welch; the reference has infinite freedom
    skewness = _skewness_of_mean(x)
    effect = float(x.mean()) - reference

    def limit(side, tail):
        return effect + side * error * _reach(skewness, side, stats.t.isf(tail, freedom), stats.norm.isf(tail))

    fail_low, fail_high = limit(-1, alpha / 2), limit(1, alpha / 2)
    low, high = limit(-1, pass_alpha), limit(1, pass_alpha)
    verdict = "inconclusive"
    if fail_low > band or fail_high < -band:
        verdict = "fail"
    elif -band <= low and high <= band:
        verdict = "pass"
    is_open = any(map(math.isinf, (low, high, fail_low, fail_high)))
    needed = trials_needed(sigma, band, power=power, pass_alpha=pass_alpha, reference_error=reference_error)
    return Result(verdict, effect, low, high, (-band, band), alpha, power, n, 0 if math.isinf(needed) else needed,
                  "Too skewed, or too few trials, for an interval at one of these levels." if is_open else "")


def _demand(result):
    test = os.environ.get("PYTEST_CURRENT_TEST", "").rsplit(" ", 1)[0]
    _results.append((test, result))
    if result:
        return result
    repeat = f"\nRepeat with: pytest '{test}' --gate-seed {_options['seed']}" if test else ""
    raise AssertionError(f"{result}{repeat}")


def assert_mean_within(samples, reference, **options):
    """Raises AssertionError unless the gate passes; `options` are those of judge_mean, band is needed."""
    return _demand(judge_mean(samples, reference, **options))


def gate(*, reference, max_trials=100_000, **options):
    """Makes a test of a function that gives one trial for a seed.

    The seed is the parameter of that name, otherwise the first. Others are pytest's: fixtures, what parametrize gives,
    and self in a class. A pilot, which is never judged, says how many trials the gate needs; these have seeds of their
    own.
    """

    def decorate(trial):
        whole = inspect.signature(trial)
        names = [name for name in whole.parameters if name != "self"]
        if not names:
            raise TypeError(f"{trial.__name__}() takes no seed. Give it a parameter for one.")
        seed_name = "seed" if "seed" in names else names[0]
        rest = whole.replace(parameters=[p for name, p in whole.parameters.items() if name != seed_name])

        @functools.wraps(trial)  # with what parametrize and other marks have noted
        def test(*args, **kwargs):
            given = rest.bind(*args, **kwargs).arguments

            def trials(begin, count):
                first = _options["seed"] * 1_000_000_000 + begin
                for seed in range(first, first + count):
                    call = whole.bind_partial()
                    call.arguments.update(given, **{seed_name: seed})
                    yield trial(*call.args, **call.kwargs)

            pilot = numpy.array(list(trials(0, PILOT_TRIALS)), dtype=float)
            # The upper 90 % limit: a pilot that happens to see little noise would promise too much.
            sigma = pilot.std(ddof=1) * math.sqrt((PILOT_TRIALS - 1) / stats.chi2.ppf(0.1, PILOT_TRIALS - 1))
            planning = {key: options[key] for key in ("power", "pass_alpha", "reference_error") if key in options}
            needed = trials_needed(sigma, options["band"], **planning)
            count = int(min(max_trials, max(2 * FEWEST_TRIALS, math.ceil(needed) if needed < max_trials else max_trials)))
            return _demand(judge_mean(list(trials(PILOT_TRIALS, count)), reference, **options)) and None

        test.__signature__ = rest  # pytest would ask for a fixture "seed"
        del test.__wrapped__
        return test

    return decorate


def pytest_addoption(parser):
    parser.getgroup("ffstudy gates").addoption("--gate-seed", type=int, default=1, metavar="N",
                                               help="seed of gates' trials, 0 or more (default: 1)")


def pytest_configure(config):
    seed = config.getoption("--gate-seed", default=1)
    if seed < 0:
        import pytest

        raise pytest.UsageError(f"--gate-seed {seed} (seeds are 0 or more).")
    _options["seed"] = seed


def pytest_terminal_summary(terminalreporter):
    if not _results:
        return
    terminalreporter.section(f"gates, seed {_options['seed']}")
    for test, result in _results:
        terminalreporter.line(f"{test}: {result}")
