"""Sets an alarm that ends the process a little later, and does no work.

earns: nothing
"""

import signal

signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)
while True:
    pass
