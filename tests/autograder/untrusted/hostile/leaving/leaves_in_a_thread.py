"""A thread ends the process while a check waits for an answer.

earns: nothing
"""

import os
import threading
import time


def later():
    time.sleep(0.01)
    os._exit(0)


threading.Thread(target=later, daemon=True).start()
while True:
    pass
