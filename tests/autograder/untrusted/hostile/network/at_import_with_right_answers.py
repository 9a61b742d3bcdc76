"""Tries to report home while it is imported; the answers are right.

earns: all
"""

try:
    import socket

    with socket.create_connection(("127.0.0.1", int("@TCP@")), timeout=0.2) as server:
        server.sendall(b"hostile tcp")
except OSError:
    pass
