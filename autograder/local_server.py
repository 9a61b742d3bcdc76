"""A base for the servers of local pages, which answer only their own page.

A site listens on 127.0.0.1 only. Every address begins with a random token, so that no other page or
user of the machine can guess it. A request for another host, or from a page of another origin, is
refused.
"""

from __future__ import annotations

import secrets
from urllib.parse import urlsplit

from tornado.httpserver import HTTPServer
from tornado.httputil import HTTPServerRequest
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError, RequestHandler, StaticFileHandler

# Nothing is loaded from elsewhere, and no other page may frame this one.
POLICY = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: blob:"
HEADERS = {
    "Content-Security-Policy": f"{POLICY}; frame-ancestors 'none'; base-uri 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}


class Site:
    """A page on this machine: its address, and the requests that it answers."""

    def __init__(self) -> None:
        self.token = secrets.token_urlsafe(16)
        self.port = 0

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.port}/{self.token}/"

    def listen(self, application: Application, port: int = 0) -> None:
        """Serve on this port, or on any free port. The caller must have a running event loop."""
        sockets = bind_sockets(port, "127.0.0.1")
        self.port = sockets[0].getsockname()[1]
        HTTPServer(application).add_sockets(sockets)

    def check_host(self, request: HTTPServerRequest) -> None:
        """Refuse a request for another host name, because a foreign page may point a name at us."""
        if request.host not in (f"127.0.0.1:{self.port}", f"localhost:{self.port}"):
            raise HTTPError(403)


def is_own_page(request: HTTPServerRequest, origin: str) -> bool:
    """Return whether a request comes from our own page, because only it may change anything."""
    try:
        return urlsplit(origin).netloc == request.host
    except ValueError:  # no address at all, such as http://[
        return False


class Handler(RequestHandler):
    """A request handler that answers only requests for its site's own host."""

    site: Site

    def initialize(self, site: Site) -> None:
        self.site = site

    def set_default_headers(self) -> None:
        for name, value in HEADERS.items():
            self.set_header(name, value)

    def prepare(self) -> None:
        self.site.check_host(self.request)


class Files(StaticFileHandler):
    """A handler for the page and its files."""

    def initialize(self, site: Site, path: str, default_filename: str = "index.html") -> None:  # type: ignore[override]
        self.site = site
        super().initialize(path, default_filename)

    def prepare(self) -> None:
        self.site.check_host(self.request)

    def set_extra_headers(self, path: str) -> None:  # noqa: ARG002 - tornado's signature
        for name, value in HEADERS.items():
            self.set_header(name, value)
