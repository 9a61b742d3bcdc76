"""The course in a browser: Python that runs in Pyodide, in a worker of the page."""
