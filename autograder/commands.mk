# `make update` writes this file from autograder/commands.toml.
TAKES_check := EX CH ENGINE SEED GIVEN
OPTIONS_check = $(call option,--exercise,EX) $(call option,--chapter,CH) $(call option,--engine,ENGINE) $(call option,--seed,SEED) $(call option,--given,GIVEN)
TAKES_watch := CH ENGINE SEED GIVEN
OPTIONS_watch = $(call option,--chapter,CH) $(call option,--engine,ENGINE) $(call option,--seed,SEED) $(call option,--given,GIVEN)
TAKES_debug := EX ENGINE SEED GIVEN
OPTIONS_debug = $(call typed,EX) $(call option,--engine,ENGINE) $(call option,--seed,SEED) $(call option,--given,GIVEN)
TAKES_python := CH ENGINE GIVEN
OPTIONS_python = $(call option,--chapter,CH) $(call option,--engine,ENGINE) $(call option,--given,GIVEN)
TAKES_hint := EX N GIVEN
OPTIONS_hint = $(call typed,EX) $(call option,--count,N) $(call option,--given,GIVEN)
TAKES_reset := EX WHOLE ENGINE GIVEN
OPTIONS_reset = $(call typed,EX) $(if $(WHOLE),--whole) $(call option,--engine,ENGINE) $(call option,--given,GIVEN)
TAKES_plot := CH ENGINE GIVEN
OPTIONS_plot = $(call option,--chapter,CH) $(call option,--engine,ENGINE) $(call option,--given,GIVEN)
TAKES_lab := SCENE CH ENGINE GIVEN SET OPEN
OPTIONS_lab = $(call typed,SCENE) $(call option,--chapter,CH) $(call option,--engine,ENGINE) $(call option,--given,GIVEN) $(foreach SET,$(value SET),--set $(call typed,SET)) $(if $(filter 0,$(OPEN)),--no-browser)
