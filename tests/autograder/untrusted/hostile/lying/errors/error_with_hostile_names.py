"""Raises an exception whose class, function and file have hostile names.

earns: counter total
"""

NAME = "<script>alert(1)</script>" + chr(27) + "[31m=cmd()"
HOSTILE = type(NAME, (Exception,), {"__module__": NAME})
CODE = compile("raise HOSTILE", __file__, "exec").replace(co_name=NAME * 1000, co_qualname=NAME)


def add(a, b):
    exec(CODE, {"HOSTILE": HOSTILE})
