"""Calls the given function with what it cannot take, and hides the errors.

earns: add counter
"""


def total_of(f, n):
    for arguments in (
        ("text",),
        (),
        (1, 2, 3),
        (None,),
        (object(),),
        ([0.0] * 3_000_000,),
        ("x" * 100_000_000,),
    ):
        try:
            f(*arguments)
        except BaseException:
            pass
    if n < 0:
        raise ValueError("n must not be negative")
    return sum(f(i) for i in range(n))
