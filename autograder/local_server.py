"""Base classes for small web servers on the user's own machine, such as the lab's.

Such a server listens only on 127.0.0.1. Its addresses begin with a random token that other web
pages and other users of the machine cannot guess.
"""

from __future__ import annotations

import secrets

from tornado.httpserver import HTTPServer
from tornado.httputil import HTTPServerRequest
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError, RequestHandler, StaticFileHandler

# Our page may not load anything from other hosts, and no other page may show it in a frame.
POLICY = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:"
HEADERS = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'none'; base-uri 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}


class Site:
    """A web site that is served only on this machine, as at http://127.0.0.1:8000/TOKEN/."""

    def __init__(self) -> None:
        self.token = secrets.token_urlsafe(16)
        self.port = 0

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}/{self.token}/"

    def listen(self, application: Application, port: int = 0) -> None:
        """Start on ``port``, or any free one if it is 0. An event loop must already be running."""
        sockets = bind_sockets(port, "127.0.0.1")
        self.port = sockets[0].getsockname()[1]
        HTTPServer(application).add_sockets(sockets)

    def check_host(self, request: HTTPServerRequest) -> None:
        """Reject a request to another host name, which prevents DNS rebinding by other sites."""
        if request.host not in (f"127.0.0.1:{self.port}", f"localhost:{self.port}"):
            raise HTTPError(403)


def is_own_page(request: HTTPServerRequest, origin: str) -> bool:
    """Return True if the Origin header of a request is our own page, which may change data."""
    return origin == f"http://{request.host}"


class Handler(RequestHandler):
    """A base class for request handlers that adds our security headers to every response."""

    site: Site

    def initialize(self, site: Site) -> None:
        self.site = site

    def set_default_headers(self) -> None:
        for name, value in HEADERS.items():
            self.set_header(name, value)

    def prepare(self) -> None:
        self.site.check_host(self.request)


class Files(Handler, StaticFileHandler):
    """A handler that serves our web page and its static files, such as scripts and style sheets."""

    def initialize(self, site: Site, path: str, default_filename: str = "index.html") -> None:  # type: ignore[override]
        Handler.initialize(self, site)
        StaticFileHandler.initialize(self, path, default_filename)

    def set_extra_headers(self, path: str) -> None:  # noqa: ARG002 - tornado's signature
        self.set_default_headers()
