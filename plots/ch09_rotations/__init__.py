"""The plots for chapter 9."""

from plots.ch09_rotations.rates import drift_of_first_order, gimbal_lock
from plots.ch09_rotations.stones import balance_lines
from plots.ch09_rotations.turns import order_of_turns, turning_motion

PLOTS = (turning_motion, order_of_turns, drift_of_first_order, gimbal_lock, balance_lines)
