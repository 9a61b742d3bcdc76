"""A trebuchet by Lagrange's equations, for comparison with one made of particles and rods.

Two angles describe its whole state: the angle of the long arm and that of the sling, which stays
taut.
"""

from __future__ import annotations

import math

G, PIVOT_HEIGHT, PROJECTILE, TIP = 9.81, 5.0, 5.0, 5.0
START, BEND = math.radians(200.0), math.radians(120.0)
STEP = 5e-3  # s; with Runge-Kutta, more accurate than the checks need
LAST_STEP = 1e-3  # s; near the release, which is found at the end of a step
TIME_LIMIT = 4.0  # s

State = tuple[float, float, float, float]  # angles of arm and sling, and their rates


def thrown(
    counterweight: float, short_arm: float, long_arm: float, sling: float, release_angle: float
) -> tuple[float, float]:
    """Return the range in m and the fraction of the energy; zeros without a release."""
    inertia = counterweight * short_arm**2 + (TIP + PROJECTILE) * long_arm**2
    joint = PROJECTILE * long_arm * sling
    bob = PROJECTILE * sling**2

    def rates(state: State) -> State:
        arm, cord, arm_rate, cord_rate = state
        c, s = math.cos(arm - cord), math.sin(arm - cord)
        weights = counterweight * short_arm * math.cos(arm - BEND)
        weights += (TIP + PROJECTILE) * long_arm * math.cos(arm)
        on_arm = -joint * s * cord_rate**2 - G * weights
        on_cord = joint * s * arm_rate**2 - G * PROJECTILE * sling * math.cos(cord)
        both = inertia * bob - (joint * c) ** 2
        return (
            arm_rate,
            cord_rate,
            (bob * on_arm - joint * c * on_cord) / both,
            (inertia * on_cord - joint * c * on_arm) / both,
        )

    def along(state: State, rate: State, time: float) -> State:
        a, b, c, d = (x + time * r for x, r in zip(state, rate, strict=True))
        return a, b, c, d

    def stepped(state: State, h: float) -> State:
        k1 = rates(state)
        k2 = rates(along(state, k1, 0.5 * h))
        k3 = rates(along(state, k2, 0.5 * h))
        k4 = rates(along(state, k3, h))
        for rate, weight in ((k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)):
            state = along(state, rate, weight * h / 6.0)
        return state

    def projectile(state: State) -> State:
        """Return x, the height above the pivot, and the two parts of the velocity."""
        arm, cord, arm_rate, cord_rate = state
        return (
            long_arm * math.cos(arm) + sling * math.cos(cord),
            long_arm * math.sin(arm) + sling * math.sin(cord),
            -long_arm * math.sin(arm) * arm_rate - sling * math.sin(cord) * cord_rate,
            long_arm * math.cos(arm) * arm_rate + sling * math.cos(cord) * cord_rate,
        )

    def flies(state: State) -> bool:
        _, rise, vx, vy = projectile(state)
        return vx > 0.0 and rise > 0.0 and math.degrees(math.atan2(vy, vx)) <= release_angle

    state: State = (START, -0.5 * math.pi, 0.0, 0.0)
    time, h = 0.0, STEP
    while time < TIME_LIMIT and PIVOT_HEIGHT + projectile(state)[1] > 0.0:
        after = stepped(state, h)
        if not flies(after):
            state, time = after, time + h
        elif h == STEP:
            h = LAST_STEP  # make this step again, in shorter ones
        else:
            x, rise, vx, vy = projectile(after)
            start = long_arm * math.sin(START) - sling
            gained = PROJECTILE * (G * (rise - start) + 0.5 * (vx * vx + vy * vy))
            sunk = short_arm * (math.sin(START - BEND) - math.sin(after[0] - BEND))
            flight = (vy + math.sqrt(vy * vy + 2.0 * G * (PIVOT_HEIGHT + rise))) / G
            return x + vx * flight, gained / (counterweight * G * sunk)
    return 0.0, 0.0
