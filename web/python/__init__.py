"""The Python part of the course's website, which runs in the browser with Pyodide."""
