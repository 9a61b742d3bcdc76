"""Check, grade and hand out the chapters of the companion.

These words have a fixed meaning in all packages below:

- An *exercise* is a part of a chapter that a student writes. The *manifest* of a chapter,
  chapter.toml, lists its exercises, and names the functions to write for each of them.
- A *check* is a pytest test that decides whether an exercise works. *Physics* checks test the
  physics, and *robust* checks test bad arguments, overflow and NaN.
- A *stub* is a file from which students start. The *reference* is our solution in solutions/.
- An *engine* is a list of folders with chapters. A file in an earlier folder takes precedence over
  the same file in a later one.
- A *given* chapter is taken from the reference instead of from the student.
- A check that fails only because of an earlier chapter is *inherited*. It is *blocked* if an
  exercise on which it builds fails.
- A *hand-out* is the folder that students receive. It contains no reference.
"""
