# Every command sets up .venv by itself the first time. `make` alone lists them.
# autograder/recipes.mk has the commands that students do not need.
ifeq ($(OS),Windows_NT)
PYTHON ?= python
RUN := .venv/Scripts/python
else
PYTHON ?= python3
RUN := .venv/bin/python
endif
READY := .venv/ready
ENGINE ?= chapters
RECIPES := autograder/recipes.mk

# Commands get the value of a variable exactly as it was typed, even if it has quotes or dollars, as
# in NOTE="it's \"late\" and costs \$5". In single quotes, the shell changes nothing. A recipe cannot
# have a value of several lines.
define newline


endef
escaped = $(if $(findstring $(newline),$(value $(1))),$(error $(1) must be on one line))$(subst ','\'',$(value $(1)))
typed = $(if $(value $(1)),'$(call escaped,$(1))')
option = $(if $(value $(2)),$(1) $(call typed,$(2)))

# A diagnosis, such as checks that fail, is what these commands are for: their status 1 is no error
# of make's. Trouble, such as a chapter that is not there, has status 2.
DIAGNOSIS := ; status=$$?; test $$status -eq 1 || exit $$status

# What each command takes and passes on: another variable on the command line is an error.
include autograder/commands.mk
TAKES_setup :=
TAKES_help :=
TAKES_help-all :=

.DEFAULT_GOAL := help
.PHONY: help help-all watch check debug python hint reset lab plot setup

LIST := -e 's/^\([a-z-]*\): .*\#\# /  make \1|/p'
ALIGN := awk -F'|' 'NF == 1 {print "\n" $$0} NF > 1 {printf "%-17s  %s\n", $$1, $$2}'

help:
	@echo "These are your commands. CH=3 means chapter 3, and EX=2.5 means exercise 2.5."
	@echo "If this folder has the reference, GIVEN=2-5 takes chapters 2 to 5 from it."
	@sed -n $(LIST) $(firstword $(MAKEFILE_LIST)) | $(ALIGN)
ifneq ($(wildcard $(RECIPES)),)
	@echo "To see the commands for instructors and developers too, run: make help-all"
endif

help-all: help
ifneq ($(wildcard $(RECIPES)),)
	@sed -n -e 's/^# == \(.*\) ==$$/\1:/p' $(LIST) $(RECIPES) | $(ALIGN)
endif

watch: $(READY) ## check your current exercise whenever you save a file (CH=3)
	@$(RUN) -m autograder watch $(OPTIONS_watch)

check: $(READY) ## check everything, a chapter (CH=3) or an exercise (EX=2.5)
	@$(RUN) -m autograder check $(OPTIONS_check) $(DIAGNOSIS)

debug: $(READY) ## stop in your function where a check fails (EX=2.5)
	@$(RUN) -m autograder debug $(OPTIONS_debug) $(DIAGNOSIS)

python: $(READY) ## try your engine in an interpreter (CH=2)
	@$(RUN) -m autograder python $(OPTIONS_python)

hint: $(READY) ## show a hint for an exercise (EX=2.5), or the first two (N=2)
	@$(RUN) -m autograder hint $(OPTIONS_hint)

reset: $(READY) ## restore a stub (EX=2.5) or its file (WHOLE=1); keep a copy
	@$(RUN) -m autograder reset $(OPTIONS_reset)

lab: $(READY) ## run scenes with your engine in the browser (SCENE=one-spring)
	@$(RUN) -m lab serve $(OPTIONS_lab)

plot: .venv/pictures ## draw the pictures of a chapter with your engine (CH=2)
	@$(RUN) -m plots draw $(OPTIONS_plot) $(DIAGNOSIS)

setup: $(READY) ## create .venv (the other commands do this when needed)
	@echo "Set up: .venv is ready."

$(READY): autograder/locks/requirements.lock autograder/make_venv.py
	@command -v $(PYTHON) >/dev/null || { echo "Cannot set up: there is no $(PYTHON); install Python 3.11 or newer, or name one: make setup PYTHON=python3.14"; exit 1; }
	@$(PYTHON) autograder/make_venv.py

# A command that needs more packages installs them when it is first used.
.venv/%: autograder/locks/%.lock $(READY)
	@$(RUN) autograder/make_venv.py $*

-include $(RECIPES)

# The rest looks at the command line.
COMMANDS := $(patsubst TAKES_%,%,$(filter TAKES_%,$(.VARIABLES)))
GOALS := $(or $(MAKECMDGOALS),help)
$(if $(filter demo,$(GOALS)),$(error make demo is gone: run make lab SCENE=$(or $(value DEMO),fireworks), which opens the scene in your browser))
$(foreach goal,$(filter $(MEASURED),$(GOALS)),$(error make $(goal) is now make measure WHAT=$(goal)))
$(if $(filter stubs table,$(GOALS)),$(error make $(filter stubs table,$(GOALS)) is now part of make update))
$(foreach goal,$(filter-out $(COMMANDS) .venv/%,$(GOALS)),$(error there is no command "make $(goal)"; the commands are $(sort $(COMMANDS))))
TAKEN := PYTHON $(foreach goal,$(GOALS),$(TAKES_$(goal)))
GIVEN_BY_USER := $(foreach name,$(.VARIABLES),$(if $(filter command,$(origin $(name))),$(name)))
$(foreach name,$(filter-out $(TAKEN) MAKE% -%,$(GIVEN_BY_USER)),$(error make $(GOALS) does not take $(name); it takes $(or $(sort $(filter-out PYTHON,$(TAKEN))),no variables)))
# Otherwise, make would expand the values for the environment of the commands.
unexport $(GIVEN_BY_USER)
