"""Tries calls that no exercise needs: mounts, keys, filters, modules, clocks.

earns: counter total
"""

import ctypes
import platform

CALLS = {
    "mount": 165,
    "keyctl": 250,
    "bpf": 321,
    "userfaultfd": 323,
    "init_module": 175,
    "perf_event_open": 298,
    "pidfd_open": 434,
    "process_vm_readv": 310,
    "swapon": 167,
}


def add(a, b):
    libc = ctypes.CDLL(None, use_errno=True)
    for number in CALLS.values() if platform.machine() == "x86_64" else ():
        if libc.syscall(number, 1, 0, 0, 0, 0, 0) >= 0:
            return a + b
