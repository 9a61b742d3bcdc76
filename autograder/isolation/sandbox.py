"""Restrict what a student's code can do while it is graded.

The code runs in a worker process, which several Linux mechanisms restrict together:

- Landlock lets the worker read a few folders and write nothing.
- A seccomp filter allows only the system calls that a computation needs. The worker cannot create
  processes, open sockets, or send signals to other processes.
- Where bubblewrap is available, it isolates the whole process from the system.
- Resource limits cap memory, processor time, and the number and size of files.

All of this is in place before any student code is loaded.
"""

from __future__ import annotations

import ctypes
import errno
import os
import resource
import struct
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

UNPRIVILEGED = 65534  # the user "nobody" on Linux
MEMORY = 512 << 20  # bytes of address space
FILE_SIZE = 1 << 16  # bytes of printed output

_libc = ctypes.CDLL(None, use_errno=True)


class SandboxError(Exception):
    """Raised when a layer of the sandbox for student code cannot be set up on this machine."""


def _checked(result: int, what: str) -> int:
    """Return the result of a system call, or raise SandboxError if the call has failed."""
    if result < 0:
        raise SandboxError(f"{what}: {os.strerror(ctypes.get_errno())}")
    return int(result)


@dataclass(frozen=True)
class Level:
    """The layers of a sandbox for a student's code. Not every machine supports all of them."""

    landlock: bool = False
    seccomp: bool = False
    bubblewrap: bool = False

    @property
    def is_sandbox(self) -> bool:
        """True if these layers are enough to contain even a hostile submission."""
        return (self.landlock and self.seccomp) or self.bubblewrap

    def __str__(self) -> str:
        names = [name for name, up in vars(self).items() if up]
        if not self.is_sandbox:
            return (
                "none: the submission ran in a separate process with limited memory and time, but "
                "it could read and write files and use the network; grade only classes that you "
                "trust"
            )
        *others, last = names
        layers = f"{', '.join(others)} and {last}" if others else last
        return f"{layers}: the submission ran in a process that could only compute"


# --- Landlock (linux/landlock.h) ---

_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446  # the same on every architecture
_READ_FILE, _READ_DIR = 1 << 2, 1 << 3
# The number of file access rights in each version of Landlock.
_RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15}
_RIGHTS_NOW = 16


def landlock_version() -> int:
    """Return the version of Landlock in this Linux kernel, or 0 if there is none."""
    if sys.platform != "linux":
        return 0
    return max(0, int(_libc.syscall(_CREATE_RULESET, None, ctypes.c_size_t(0), 1)))


def landlock_rules(readable: Sequence[str]) -> int:
    """Create Landlock rules, as a descriptor, that let a worker read these paths and write none."""
    version = landlock_version()
    rights = (1 << _RIGHTS.get(version, _RIGHTS_NOW)) - 1
    # All file access rights. Version 4 adds TCP, and version 6 abstract sockets and signals.
    attributes = struct.pack("QQQ", rights, 0b11, 0b11)
    size = 24 if version >= 6 else 16 if version >= 4 else 8
    created = _libc.syscall(_CREATE_RULESET, attributes, ctypes.c_size_t(size), 0)
    rules = _checked(created, "Landlock")
    for path in readable:
        try:
            descriptor = os.open(path, os.O_PATH | os.O_CLOEXEC)
        except OSError:
            continue  # this path does not exist on this system
        allowed = _READ_FILE | _READ_DIR if Path(path).is_dir() else _READ_FILE
        rule = struct.pack("=Qi", allowed, descriptor)
        _checked(_libc.syscall(_ADD_RULE, rules, 1, rule, 0), f"Landlock, {path}")
        os.close(descriptor)
    return rules


# --- seccomp (linux/seccomp.h, linux/bpf_common.h) ---

_ARCH_X86_64 = 0xC000003E
_LOAD, _EQUAL, _AT_LEAST, _RETURN = 0x20, 0x15, 0x35, 0x06
_ALLOW, _KILL, _REFUSE = 0x7FFF0000, 0x80000000, 0x00050000 | errno.EPERM
_FIRST_X32 = 0x40000000
# Python needs these system calls of x86-64 to compute, to import and to read its files. The kernel
# searches the list at each call, so the most frequent ones come first.
_ALLOWED = {
    "read write mmap munmap brk mprotect madvise mremap": (0, 1, 9, 11, 12, 10, 28, 25),
    "newfstatat openat close fstat lseek stat lstat": (262, 257, 3, 5, 8, 4, 6),
    "select poll pselect6 ppoll futex": (23, 7, 270, 271, 202),
    "pread64 readv writev getdents64": (17, 19, 20, 217),
    "access faccessat faccessat2 open statx getcwd": (21, 269, 439, 2, 332, 79),
    "rt_sigaction rt_sigprocmask rt_sigreturn sigaltstack restart_syscall": (13, 14, 15, 131, 219),
    "getpid gettid getuid geteuid getgid getegid": (39, 186, 102, 107, 104, 108),
    "clock_gettime clock_getres gettimeofday time times getrusage": (228, 229, 96, 201, 100, 98),
    "clock_nanosleep nanosleep sched_yield sched_getaffinity": (230, 35, 24, 204),
    "getrandom getrlimit": (318, 97),
    "set_robust_list rseq exit exit_group": (273, 334, 60, 231),
}


def seccomp_filter() -> bytes:
    """Create the filter of system calls. Those that are not allowed fail with EPERM."""
    numbers = [number for group in _ALLOWED.values() for number in group]
    program = [
        (_LOAD, 0, 0, 4),  # the architecture
        (_EQUAL, 1, 0, _ARCH_X86_64),
        (_RETURN, 0, 0, _KILL),
        (_LOAD, 0, 0, 0),  # the number of the call
        (_AT_LEAST, len(numbers), 0, _FIRST_X32),
        *((_EQUAL, len(numbers) - place, 0, number) for place, number in enumerate(numbers)),
        (_RETURN, 0, 0, _REFUSE),
        (_RETURN, 0, 0, _ALLOW),
    ]
    return b"".join(struct.pack("HBBI", *line) for line in program)


def seccomp_works_here() -> bool:
    """Return True if this machine numbers its system calls as 64-bit Linux on x86-64 does."""
    return sys.platform == "linux" and os.uname().machine == "x86_64" and sys.maxsize > 1 << 32


# --- entering ---

_SET_DEATH_SIGNAL, _SET_DUMPABLE, _SET_KEEP_CAPABILITIES = 1, 4, 8
_SET_SECCOMP, _SET_NO_NEW_PRIVILEGES = 22, 38
_CAN_READ_ALL = 2  # CAP_DAC_READ_SEARCH
_LIMITS = {
    "RLIMIT_FSIZE": FILE_SIZE,
    "RLIMIT_CORE": 0,
    "RLIMIT_NOFILE": 32,
    "RLIMIT_MEMLOCK": 0,
    "RLIMIT_MSGQUEUE": 0,
}


def confine(level: Level, rules: int | None) -> None:
    """Permanently restrict the launcher, before it forks workers that inherit the restrictions."""
    for name, value in _LIMITS.items():
        if hasattr(resource, name):
            _lower(getattr(resource, name), value, value)
    if sys.platform == "linux":  # elsewhere this limit stops Python itself
        _lower(resource.RLIMIT_AS, MEMORY, MEMORY)
    if level.landlock:
        drop_privileges()
    if sys.platform == "linux":
        _control(_SET_DUMPABLE, 0)
        _control(_SET_NO_NEW_PRIVILEGES, 1)
    if rules is not None:
        _apply(rules)


def enter(level: Level, rules: int | None, seconds: int) -> None:
    """Permanently prevent a worker from starting processes and from sending signals.

    ``confine`` still allows both, because the launcher needs them. ``seconds`` is the limit on the
    worker's processor time.
    """
    _lower(resource.RLIMIT_CPU, seconds, seconds + 1)
    if sys.platform == "linux":
        _lower(resource.RLIMIT_NPROC, 0, 0)
        _control(_SET_DEATH_SIGNAL, 9)
    if rules is not None:
        _apply(rules)  # gives the worker a Landlock domain of its own
        os.close(rules)
    if level.seccomp:
        code = seccomp_filter()
        buffer = ctypes.create_string_buffer(code, len(code))
        address = ctypes.addressof(buffer)
        _control(_SET_SECCOMP, 2, struct.pack("HxxxxxxP", len(code) // 8, address))
    elif sys.platform == "linux":
        # The privilege to read any file lets open_by_handle_at pass by Landlock. Only the filter
        # refuses this call.
        _keep_capabilities(0)


def _apply(rules: int) -> None:
    _checked(_libc.syscall(_RESTRICT_SELF, rules, 0), "Landlock")


def _lower(kind: int, soft: int, hard: int) -> None:
    """Lower one of this process's resource limits, such as memory, unless it is already lower."""
    _, there = resource.getrlimit(kind)
    if there != resource.RLIM_INFINITY:
        soft, hard = min(soft, there), min(hard, there)
    resource.setrlimit(kind, (soft, hard))


def drop_privileges() -> None:
    """If this process runs as root, switch to an unprivileged user before it loads student code.

    The process may still read any file, because Python may be in a folder that only root can read,
    such as /root. Landlock then restricts reading to the listed folders.
    """
    if os.geteuid() != 0:
        return
    _control(_SET_KEEP_CAPABILITIES, 1)
    try:
        os.setgroups([])
        os.setregid(UNPRIVILEGED, UNPRIVILEGED)
        os.setreuid(UNPRIVILEGED, UNPRIVILEGED)
    except OSError as error:
        raise SandboxError(f"root cannot become an unprivileged user: {error}") from error
    _keep_capabilities(1 << _CAN_READ_ALL)


def _keep_capabilities(kept: int) -> None:
    """Give up all of root's privileges except those in the bit mask ``kept``."""
    header = struct.pack("Ii", 0x20080522, 0)
    _checked(_libc.capset(header, struct.pack("6I", kept, kept, 0, 0, 0, 0)), "capset")


def _control(option: int, *arguments: Any) -> None:
    values = [ctypes.c_ulong(a) if isinstance(a, int) else a for a in arguments]
    result = _libc.prctl(option, *values, *[ctypes.c_ulong(0)] * (4 - len(values)))
    _checked(result, f"prctl {option}")
