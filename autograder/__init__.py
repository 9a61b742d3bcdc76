"""Check, grade and hand out the chapters of the companion.

All packages below use these words in the same sense:

- *Exercise*: A part of a chapter that a student writes. The *manifest* of the chapter,
  chapter.toml, lists the exercises and, for each exercise, the functions to write.
- *Check*: A pytest test that decides whether an exercise works. *Physics* checks test the physics.
  *Robust* checks test bad arguments, overflow and NaN.
- *Stub*: A file from which students start. The *reference* is our solution in solutions/.
- *Engine*: A list of folders with chapters. If a file exists in several folders, the first folder
  takes precedence.
- *Given* chapter: A chapter that is taken from the reference instead of from the student.
- *Inherited*: A check is inherited if it fails only because of an earlier chapter. A check is
  *blocked* if its exercise builds on another exercise that fails.
- *Hand-out*: The folder that students receive. It does not contain the reference.
"""
