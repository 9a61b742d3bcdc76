"""Returns an object that raises whatever is asked of it.

earns: nothing
"""


class Nothing:
    def __getattribute__(self, name):
        raise KeyboardInterrupt(name)


RIGHT = Nothing()
