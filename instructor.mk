# The commands of instructors and of those who work on the companion itself.
SUBMISSIONS ?= sample_class
# It grades a class on all cores, and would do so once a process of the others.
HOSTILE := tests/autograder/test_hostile.py
OURS := $(wildcard chapters/*/plots*.py chapters/*/demos*.py)

.PHONY: grade handout classroom gradescope stubs test lint bench charts limits economy soak figures mutants seeds table

grade: $(READY) ## grade a class (SUBMISSIONS=sample_class CHAPTERS=3 GIVEN=2 CHECKS=hidden) into build/grades/
	@$(RUN) -m autograder grade "$(SUBMISSIONS)" --out "$(or $(OUT),build/grades)" $(if $(SEED),--seed "$(SEED)") $(if $(CHAPTERS),--chapters "$(CHAPTERS)") $(if $(GIVEN),--given "$(GIVEN)") $(if $(CHECKS),--checks "$(CHECKS)")

handout: $(READY) ## what students get (CHAPTERS=4-5 GIVEN=2-3 OUT=dir)
	@$(RUN) -m autograder handout $(or $(CHAPTERS),$(error name the chapters: make handout CHAPTERS=2 OUT=dir)) --out "$(or $(OUT),build/handout)" $(if $(GIVEN),--given "$(GIVEN)")

classroom: $(READY) ## a hand-out that GitHub Classroom marks (CHAPTERS=2 GIVEN=... OUT=dir)
	@$(RUN) -m autograder classroom $(or $(CHAPTERS),$(error name the chapters: make classroom CHAPTERS=2 OUT=dir)) --out "$(or $(OUT),build/classroom)" $(if $(GIVEN),--given "$(GIVEN)")

gradescope: $(READY) ## the autograder zip for Gradescope (CHAPTERS=2-3 GIVEN=... OUT=file.zip)
	@$(RUN) -m autograder gradescope $(or $(CHAPTERS),$(error name the chapters: make gradescope CHAPTERS=2-3)) --out "$(or $(OUT),build/gradescope.zip)" $(if $(GIVEN),--given "$(GIVEN)")

figures: $(READY) ## draw the pictures of the chapters' READMEs anew, in a minute or two
	@$(RUN) -m studies figures

stubs: $(READY) ## make chapters/ from solutions/ again
	@$(RUN) -m autograder stubs

test: lint .venv/cluster .venv/mutants ## run every test of the companion itself
	@$(RUN) -m pytest -n auto --engine=solutions --engine=chapters --ignore=$(HOSTILE)
	@$(RUN) -m pytest --engine=solutions --engine=chapters $(HOSTILE)

.venv/cluster .venv/mutants: .venv/%: %.lock $(READY)
	@echo "Installing the packages of $< into .venv."
	@$(RUN) -m pip install --quiet --disable-pip-version-check --require-hashes -r $<
	@touch $@

mutants: .venv/mutants ## how many changed references the checks of a chapter tell (CH=6)
	@$(RUN) tests/strength mutants $(if $(CH),--chapter "$(CH)")

seeds: $(READY) ## the checks on both right solutions with the numbers of 1,000 seeds (CH=6 SEEDS=100)
	@$(RUN) tests/strength seeds $(if $(CH),--chapter "$(CH)") $(if $(SEEDS),--seeds "$(SEEDS)")

table: $(READY) ## what make mutants and make seeds have measured, into tests/README.md
	@$(RUN) tests/strength table

lint: $(READY) ## style and types
	@$(RUN) -m ruff check . $(OURS)
	@$(RUN) -m ruff format --check . $(OURS)
	@$(RUN) -m mypy

soak: $(READY) ## ten minutes of bridge and platform at three frame rates, in about ten minutes
	@$(RUN) -m studies soak

bench: $(READY) ## speed, as ratios measured in turn
	@$(RUN) -m studies bench

economy: $(READY) ## what parts of a model cost that a scene does not need
	@$(RUN) -m studies economy

limits: $(READY) ## what springs and drag each method bears, maps of it, and what lies outside
	@$(RUN) -m studies limits

charts: $(READY) ## speed against accuracy, every scene by every model (QUICK=1 for a minute's version)
	@$(RUN) -m studies charts $(if $(QUICK),--quick)
