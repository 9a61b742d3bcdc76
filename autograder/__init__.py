"""The autograder checks a student's engine, grades a class, and makes the folders we hand out.

The code in all of these packages uses the same few words, so it helps to know them first:

- *Exercise*: A part of a chapter that a student writes. The chapter's *manifest*, chapter.toml,
  lists the exercises, and says for each one which functions the student has to write.
- *Check*: A pytest test that helps to decide whether an exercise works. *Physics* checks test the
  physics, and *robust* checks try bad arguments, overflow and NaN.
- *Stub*: The unfinished file that a student starts from. The *reference* is our own solution, in
  solutions/.
- *Engine*: The list of folders in which we look for a chapter's files. If a file exists in several
  of them, the first folder wins.
- *Given* chapter: A chapter whose code comes from the reference instead of from the student.
- *Inherited*: A check is inherited if it fails only because of a mistake in an earlier chapter.
  It is *blocked* if its exercise builds on another exercise that still fails.
- *Hand-out*: The folder that students receive. It does not contain the reference.
"""
