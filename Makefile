# Every command sets up .venv by itself the first time. `make` alone lists them.
# instructor.mk has the commands that students do not need.
ifeq ($(OS),Windows_NT)
PYTHON ?= python
RUN := .venv/Scripts/python
else
PYTHON ?= python3
RUN := .venv/bin/python
endif
READY := .venv/ready
ENGINE ?= chapters

.DEFAULT_GOAL := help
.PHONY: help setup check watch hint reset plot demo

help: ## list the commands
	@sed -n 's/^\([a-z]*\): .*## /  make \1|/p' $(MAKEFILE_LIST) | awk -F'|' '{printf "%-18s %s\n", $$1, $$2}'

$(READY): requirements.lock autograder/make_venv.py
	@command -v $(PYTHON) >/dev/null || { echo "Cannot set up: there is no $(PYTHON); install Python 3.11 or newer, or name one: make setup PYTHON=python3.12"; exit 1; }
	@$(PYTHON) autograder/make_venv.py

setup: $(READY) ## make .venv (the other commands do it by themselves)
	@echo "Set up: .venv is ready."

check: $(READY) ## check your work (CH=3 one chapter, EX=3.4b one exercise, GIVEN=2 on the reference's chapter 2)
	@$(RUN) -m autograder check --engine "$(ENGINE)" $(if $(CH),--chapter "$(CH)") $(if $(EX),--exercise "$(EX)") $(if $(GIVEN),--given "$(GIVEN)") $(if $(SEED),--seed "$(SEED)")

watch: $(READY) ## check what you work on whenever you save (CH=3, GIVEN=2)
	@$(RUN) -m autograder watch --engine "$(ENGINE)" $(if $(CH),--chapter "$(CH)") $(if $(GIVEN),--given "$(GIVEN)") $(if $(SEED),--seed "$(SEED)")

hint: $(READY) ## a hint for an exercise (EX=2.5; N=2 for the first two)
	@$(RUN) -m autograder hint $(or $(EX),$(error name an exercise: make hint EX=2.5)) $(if $(N),--count $(N))

reset: $(READY) ## put the stub of an exercise back (EX=2.5; WHOLE=1 its whole file), and keep a copy
	@$(RUN) -m autograder reset $(or $(EX),$(error name an exercise: make reset EX=2.5)) --engine "$(ENGINE)" $(if $(WHOLE),--whole)

plot: $(READY) ## draw a chapter with your engine (CH=2)
	@$(RUN) -m studies plot --engine "$(ENGINE)" $(if $(CH),--chapter "$(CH)")

demo: $(READY) ## play a demo with your engine (DEMO=throw, fireworks, ballistics, sniper, springbridge, cloth, ropes, bridge, platform, blob, wheel, cube, trebuchet, ball or spin)
	@$(RUN) -m studies demo --engine "$(ENGINE)" "$(or $(DEMO),$(error name a demo: make demo DEMO=fireworks))"

-include instructor.mk
