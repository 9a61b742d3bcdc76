"""Check students' work and run scenes in a web worker of the page, with Pyodide."""
