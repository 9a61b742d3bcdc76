"""Is imported with a syntax error that claims to be in the solution.

earns: nothing
"""

raise SyntaxError(
    "look at this line", ("@ROOT@/solutions/ch90_sums/sums.py", int("@LINE@"), 1, None)
)
