"""The Python part of the course's website. It runs in the browser, with Pyodide."""
