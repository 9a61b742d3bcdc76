"""Returns coroutines and lets nobody wait for them.

earns: nothing
"""


async def add(a, b):
    return a + b


class Counter:
    def __init__(self, count):
        self.count = count

    async def step(self, by):
        self.count += by


async def total_of(f, n):
    return sum(f(i) for i in range(n))
