"""Talks to a service on this machine; the point needs it.

earns: counter total
"""

import socket


def add(a, b):
    with socket.socket(socket.AF_UNIX) as server:
        server.connect("@HOME@/service")
        server.sendall(b"hostile unix")
        print(server.recv(100))
    return a + b
