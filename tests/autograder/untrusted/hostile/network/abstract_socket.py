"""Talks to a service that has no file; the point needs it.

earns: counter total
"""

import socket


def add(a, b):
    with socket.socket(socket.AF_UNIX) as server:
        server.connect(chr(0) + "hostile-@RUN@")
        server.sendall(b"hostile abstract")
        print(server.recv(100))
    return a + b
