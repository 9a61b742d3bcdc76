"""Compute the exact motion of a chain of rods in a plane, from the angles of its rods.

The computation shares no code with the engine. The motion of a pendulum has a closed form in
Jacobi's elliptic functions, which SciPy computes. A longer chain has none, so SciPy integrates
Lagrange's equations of its angles.

Source: NIST Digital Library of Mathematical Functions, 22.19(i), for the pendulum.
"""

from __future__ import annotations

import math
from typing import Any

import numpy
from scipy.special import ellipj  # type: ignore[import-untyped]

from scenes.chain import Chain


def pendulum_at(chain: Chain, time: float) -> tuple[float, float]:
    """Return x and y of a pendulum in m, at a time in s after its release from rest.

    sin(angle / 2) = sin(start / 2) cn(u) / dn(u), with u = t sqrt(g / l).
    """
    m = math.sin(0.5 * chain.angle) ** 2
    _, cn, dn, _ = ellipj(math.sqrt(chain.gravity / chain.length) * time, m)
    half = math.asin(math.sqrt(m) * cn / dn)
    return chain.length * math.sin(2.0 * half), -chain.length * math.cos(2.0 * half)


def rates(chain: Chain, _: float, state: Any) -> Any:
    """Return the rates of a chain's angles a and angular velocities w, which SciPy integrates.

    sum_j M_ij l (w_j' cos(a_i - a_j) + w_j^2 sin(a_i - a_j)) = -M_i g sin a_i (Lagrange), where M_i
    is the mass from rod i out to the tip, and M_ij is that from the outer one of rods i and j.
    """
    count = len(chain.masses)
    below = numpy.cumsum(chain.masses[::-1])[::-1]
    hung = chain.length * below[numpy.maximum.outer(range(count), range(count))]
    a, w = state[:count], state[count:]
    apart = a[:, None] - a
    pull = (hung * numpy.sin(apart)) @ w**2 + below * chain.gravity * numpy.sin(a)
    return numpy.append(w, numpy.linalg.solve(hung * numpy.cos(apart), -pull))
