# `make update` writes this file from autograder/instructor.toml.
TAKES_grade := SUBMISSIONS OUT SEED CHAPTERS GIVEN CHECKS STUDENT NOTE ROSTER TITLE POINTS ASSIGNMENT COURSE
OPTIONS_grade = $(call typed,SUBMISSIONS) $(call option,--seed,SEED) $(call option,--chapters,CHAPTERS) $(call option,--given,GIVEN) $(call option,--checks,CHECKS) $(call option,--student,STUDENT) $(call option,--note,NOTE) $(call option,--roster,ROSTER) $(call option,--title,TITLE) $(call option,--points,POINTS) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
TAKES_handout := CHAPTERS GIVEN OUT ASSIGNMENT COURSE
OPTIONS_handout = $(call option,--given,GIVEN) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
TAKES_classroom := CHAPTERS GIVEN OUT ASSIGNMENT COURSE
OPTIONS_classroom = $(call option,--given,GIVEN) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
TAKES_gradescope := CHAPTERS GIVEN OUT ASSIGNMENT COURSE
OPTIONS_gradescope = $(call option,--given,GIVEN) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
TAKES_similarity := SUBMISSIONS OUT CHAPTERS ROSTER ASSIGNMENT COURSE
OPTIONS_similarity = $(call option,--chapters,CHAPTERS) $(call option,--roster,ROSTER) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
TAKES_mark := SUBMISSIONS CHAPTERS ROSTER OPEN ASSIGNMENT COURSE
OPTIONS_mark = $(call option,--chapters,CHAPTERS) $(call option,--roster,ROSTER) $(if $(filter 0,$(OPEN)),--no-browser) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
TAKES_release := CHAPTERS EX SUBMISSIONS GRADES ROSTER OUT ASSIGNMENT COURSE
OPTIONS_release = $(call option,--exercises,EX) $(call option,--submissions,SUBMISSIONS) $(call option,--roster,ROSTER) $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
