"""Sends a message over UDP; the point needs it.

earns: counter total
"""

import socket


def add(a, b):
    socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(
        b"hostile udp", ("127.0.0.1", int("@UDP@"))
    )
    return a + b
