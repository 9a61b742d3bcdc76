"""Blocks and ignores every signal, stops the clocks that it can find, and loops.

earns: counter total
says: did not finish
"""

import faulthandler
import signal


def add(a, b):
    for attack in (
        faulthandler.cancel_dump_traceback_later,
        lambda: faulthandler.unregister(signal.SIGUSR1),
        lambda: signal.setitimer(signal.ITIMER_REAL, 0),
        lambda: signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals()),
        *(lambda s=s: signal.signal(s, signal.SIG_IGN) for s in signal.valid_signals()),
    ):
        try:
            attack()
        except BaseException:
            pass
    while True:
        pass
