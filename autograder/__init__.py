"""The autograder checks a student's engine, grades a class, and makes the folders we hand out.

A few terms have a fixed meaning throughout these packages:

- *Exercise*: A part of a chapter that a student writes. The chapter's *manifest*, chapter.toml,
  lists its exercises and the functions to write for each.
- *Check*: A pytest test that helps decide whether an exercise works. *Physics* checks test the
  physics; *robust* checks try bad arguments, overflow and NaN.
- *Stub*: The unfinished file that a student starts from. Our own solution, in solutions/, is the
  *reference*.
- *Engine*: A list of folders to search for a chapter's files, in order: the first folder that has a
  file wins.
- *Given* chapter: A chapter whose code comes from the reference rather than from the student.
- *Inherited*: Said of a check that fails only because of a mistake in an earlier chapter. A check
  is *blocked* if its exercise builds on another one that still fails.
- *Hand-out*: The folder that students receive, without the reference.
"""
