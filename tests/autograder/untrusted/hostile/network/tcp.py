"""Fetches a secret over TCP; the point needs it.

earns: counter total
"""

import socket


def add(a, b):
    with socket.create_connection(("127.0.0.1", int("@TCP@")), timeout=0.5) as server:
        server.sendall(b"hostile tcp")
        print(server.recv(100))
    return a + b
