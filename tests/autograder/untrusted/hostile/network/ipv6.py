"""Sends a message over IPv6; the point needs it.

earns: counter total
"""

import socket


def add(a, b):
    socket.socket(socket.AF_INET6, socket.SOCK_DGRAM).sendto(b"hostile udp", ("::1", int("@UDP@")))
    return a + b
