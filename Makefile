# Every command sets up .venv by itself the first time. `make` alone lists them.
ifeq ($(OS),Windows_NT)
PYTHON ?= python
RUN := .venv/Scripts/python
else
PYTHON ?= python3
RUN := .venv/bin/python
endif
READY := .venv/ready

CH ?=
EX ?=
ENGINE ?= chapters
SUBMISSIONS ?= sample_class
SEED ?=
CHAPTERS ?=
GIVEN ?=
OUT ?= build/handout

.DEFAULT_GOAL := help
.PHONY: help setup check hint plot grade test lint handout bench stubs

help: ## list the commands
	@sed -n 's/^\([a-z]*\): .*## /  make \1|/p' Makefile | awk -F'|' '{printf "%-14s %s\n", $$1, $$2}'

$(READY): requirements.lock autograder/make_venv.py
	@command -v $(PYTHON) >/dev/null || { echo "Cannot set up: there is no $(PYTHON); install Python 3.11 or newer, or name one: make setup PYTHON=python3.12"; exit 1; }
	@$(PYTHON) autograder/make_venv.py

setup: $(READY) ## make .venv (the other commands do it by themselves)
	@echo "Set up: .venv is ready."

check: $(READY) ## check your work (CH=2 one chapter, EX=2.5 one exercise, ENGINE=solutions)
	@$(RUN) -m autograder check --engine $(ENGINE) $(if $(CH),--chapter $(CH)) $(if $(EX),--exercise $(EX)) $(if $(SEED),--seed $(SEED))

hint: $(READY) ## a hint for an exercise (EX=2.5; N=2 for the first two)
	@$(RUN) -m autograder hint $(EX) $(if $(N),--count $(N))

plot: $(READY) ## draw a chapter with your engine (CH=2; ENGINE=solutions for the reference)
	@$(RUN) -m studies plot --engine $(ENGINE) $(if $(CH),--chapter $(CH))

grade: $(READY) ## grade a class (SUBMISSIONS=sample_class) into build/grades/
	@$(RUN) -m autograder grade $(SUBMISSIONS) --out build/grades $(if $(SEED),--seed $(SEED)) $(if $(CHAPTERS),--chapters $(CHAPTERS))

test: lint ## run every test of the companion itself
	@$(RUN) -m pytest --engine=solutions,chapters

lint: $(READY) ## style and types
	@$(RUN) -m ruff check .
	@$(RUN) -m ruff format --check .
	@$(RUN) -m mypy

handout: $(READY) ## what students get (CHAPTERS=4-5 GIVEN=2-3 OUT=dir)
	@$(RUN) -m autograder handout $(CHAPTERS) --out $(OUT) $(if $(GIVEN),--given $(GIVEN))

bench: $(READY) ## speed, as ratios measured in turn
	@$(RUN) -m studies bench

stubs: $(READY) ## make chapters/ from solutions/ again
	@$(RUN) -m autograder stubs
