"""The autograder checks a student's engine, grades a class, and builds the folder students receive.

The following terms have a fixed meaning throughout the autograder:

- *Exercise*: A part of a chapter that a student writes. The chapter's *manifest*, chapter.toml,
  lists its exercises and the functions to write for each.
- *Check*: A pytest test that helps decide whether an exercise works. *Physics* checks test the
  physics. *Robust* checks try bad arguments, overflow and NaN.
- *Stub*: The unfinished file that a student starts from. Our own solution, in solutions/, is the
  *reference*.
- *Engine*: The student's game physics code. The autograder searches a list of folders for its
  files. If several folders contain a file, the first one wins.
- *Given* chapter: A chapter whose code comes from the reference rather than from the student.
- *Inherited*: A failed check is inherited if it fails only because of a mistake in an earlier
  chapter. A check is *blocked* if its exercise builds on another one that still fails.
- *Handout*: The folder that an instructor gives to students, without the reference.
"""

import sys
from pathlib import Path

# In .venv, chapters/ is on the path, so that students can run their files and scripts. The commands
# choose an engine themselves, which must not be mixed with that one.
sys.path[:] = [entry for entry in sys.path if Path(entry).name != "chapters"]
