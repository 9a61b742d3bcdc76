"""Asks the kernel about the network of this machine; the point needs an answer.

earns: counter total
"""

import socket


def add(a, b):
    socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, 0).bind((0, 0))
    return a + b
