"""Seeds of random end-to-end tests: fixed ones, those of tests/seeds.txt that once found a fault, and new ones. All are printed.

The environment variable of a module (FAULT_SEED …) repeats one: then only what it asks for is run."""
import os
import pathlib
import random
import sys

FOUND = pathlib.Path(__file__).resolve().parents[1] / "seeds.txt"


def found(module, lines=None):
    """What seeds.txt has for this module."""
    if lines is None:
        lines = FOUND.read_text(encoding="utf-8").splitlines()
    words = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    return [int(seed) for name, seed in words if name == module]


def seeds(module, variable, first, runs, new):
    """`runs` fixed seeds from `first` on, those that found something, `new` new ones; only the fixed ones when the variable is given."""
    fixed = list(range(first, first + runs))
    if variable in os.environ:
        chosen = fixed
    else:
        fresh = [random.SystemRandom().randrange(10**6, 10**9) for _ in range(new)]
        chosen = fixed + found(module) + fresh
        print(f"{module}: seeds {first} to {first + runs - 1}, found earlier {found(module)}, new {fresh}; "
              f"{variable}=n repeats one; what finds a fault goes into tests/seeds.txt as \"{module} n\"", file=sys.stderr, flush=True)
    return chosen
