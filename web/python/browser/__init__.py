"""Check students' work and run scenes in one of the page's web workers, with Pyodide."""
