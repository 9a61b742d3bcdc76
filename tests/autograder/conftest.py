"""What holds before any of these tests is read."""

import signal

from hypothesis import settings

settings.register_profile("long", max_examples=3000)

# Under nohup an interrupt is ignored, and would be by all that the tests start and interrupt.
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
