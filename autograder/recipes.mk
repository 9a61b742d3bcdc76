# The commands of instructors and of those who work on the companion itself.
# It grades a class on all cores, and would do so once a process of the others.
HOSTILE := tests/autograder/untrusted/test_hostile.py
PYTEST = PYTHONPATH=tests/helpers $(RUN) -m pytest --dist worksteal
# One more than there are cores, since some tests wait for a browser or a time limit.
WORKERS = $$($(RUN) -c "import os; print((os.cpu_count() or 1) + 1)")

include autograder/instructor.mk
TAKES_site := OUT SOLUTIONS
TAKES_test := CH
TAKES_test-all :=
TAKES_lint :=
TAKES_update :=
TAKES_figures :=
TAKES_choose := SCENE TOLERANCE
TAKES_measure := WHAT CH SEEDS QUICK

.PHONY: grade release similarity mark handout classroom gradescope site update test test-all say-what-test-is lint
.PHONY: figures choose measure

# The chapters of a handout. If there is an assignment, the course file names them.
NAMED = $(or $(call typed,CHAPTERS),$(if $(value ASSIGNMENT),,$(error name the chapters: make $@ CHAPTERS=2 OUT=dir, or an assignment: make $@ ASSIGNMENT=lab1)))
BUILT = build/$(if $(value ASSIGNMENT),$(call escaped,ASSIGNMENT)/)
out = --out $(or $(call typed,OUT),'$(1)')

# == For instructors ==
grade: .venv/teaching ## grade a class (SUBMISSIONS=dir CHAPTERS=3 or ASSIGNMENT=lab1)
	@$(RUN) -m autograder grade $(OPTIONS_grade) $(call out,$(BUILT)grades)

release: .venv/teaching ## release the solutions after the deadline (CHAPTERS=2 OUT=dir)
	@$(RUN) -m autograder release $(NAMED) $(OPTIONS_release) $(call out,$(BUILT)release) $(if $(value GRADES)$(value SUBMISSIONS)$(wildcard $(BUILT)grades/results),--grades $(or $(call typed,GRADES),'$(BUILT)grades'))

similarity: .venv/teaching ## find similar submissions (SUBMISSIONS=dir CHAPTERS=2-3)
	@$(RUN) -m autograder similarity $(or $(call typed,SUBMISSIONS),$(if $(value ASSIGNMENT)$(value ROSTER),$(error name the class: make similarity SUBMISSIONS=../handed-in),sample_class)) $(OPTIONS_similarity) $(call out,$(BUILT)similarity)

mark: .venv/teaching ## mark written answers on a page (SUBMISSIONS=dir CHAPTERS=2)
	@$(RUN) -m autograder mark $(or $(call typed,SUBMISSIONS),$(error name the class: make mark SUBMISSIONS=dir)) $(OPTIONS_mark)

handout: .venv/teaching ## make a handout (CHAPTERS=4-5 GIVEN=2-3 OUT=dir)
	@$(RUN) -m autograder handout $(NAMED) $(OPTIONS_handout) $(call out,$(BUILT)handout)

classroom: .venv/teaching ## make a handout for GitHub Classroom (CHAPTERS=2 OUT=dir)
	@$(RUN) -m autograder classroom $(NAMED) $(OPTIONS_classroom) $(call out,$(BUILT)classroom)

gradescope: .venv/teaching ## make the zip for Gradescope (CHAPTERS=2-3 OUT=file.zip)
	@$(RUN) -m autograder gradescope $(NAMED) $(OPTIONS_gradescope) $(call out,$(BUILT)gradescope.zip)

site: .venv/pictures ## build the website; needs Node.js (OUT=dir SOLUTIONS=1)
	@$(RUN) -m web $(call out,build/site) $(if $(SOLUTIONS),--with-solutions)

# == For those who work on the companion itself ==
# One scene of the lab replays a study.
lab: $(if $(filter charts,$(value SCENE)),.venv/everything)
test: say-what-test-is .venv/everything $(if $(value CH),lint) ## run the quick tests, or those of one chapter (CH=6)
ifneq ($(value CH),)
	@$(PYTEST) -n auto -p tiers --tier quick -p by_chapter $(call option,--chapter,CH) --ignore=tests/autograder
else
	@$(PYTEST) -n $(WORKERS) -p tiers --tier quick
endif

say-what-test-is:
	@echo "This tests the companion itself, and takes $(if $(value CH),one or two minutes,about 5 minutes)."
	@echo "To check what you wrote, run make check or make watch."

test-all: test ## run all tests, as before a release
	@echo "The slow tests take about 13 minutes."
	@$(PYTEST) -n $(WORKERS) -p tiers --tier slow --ignore=$(HOSTILE)
	@$(PYTEST) $(HOSTILE)

TUNED := ch03_laws_of_motion.particle ch05_forces.forces ch05_forces.particle ch06_springs.springs \
	ch06_springs.integrators ch07_constraints.contacts \
	$(addprefix ch07_constraints.going_further.,direct_chain sequential_impulses small_steps) \
	ch08_mass_aggregate.sleeping
lint: .venv/everything ## check style, types and spelling
	@$(RUN) -m ruff check .
	@$(RUN) -m ruff format --check .
	@$(RUN) -m mypy
	@MYPYPATH=studies/tuned $(RUN) -m mypy $(foreach name,$(TUNED),-m $(name))
	@$(RUN) -m codespell_lib

update: .venv/everything ## generate all stubs and tables again
	@$(RUN) -m autograder stubs
	@$(RUN) tests/strength table

figures: .venv/everything ## draw the pictures of the lessons again
	@$(RUN) -m plots figures

# == Measurements ==
choose: .venv/everything ## find the cheapest model (SCENE=my_scene.py TOLERANCE=1e-3)
	@$(RUN) -m studies choose $(or $(call typed,SCENE),$(error name a scene: make choose SCENE=pendulum, or a file that describes yours)) $(call option,--tolerance,TOLERANCE) $(DIAGNOSIS)

measure: .venv/everything ## measure something again, such as the charts (WHAT=charts)
	@$(NOT_TAKEN)$(RUN) $(or $(MEASURE_$(value WHAT)),$(error name what to measure with WHAT=: $(MEASURED)))

# speed against accuracy, and the solvers of contacts; QUICK=1 takes minutes
MEASURE_charts = -m studies charts $(if $(QUICK),--quick)
MEASURE_contacts = -m studies contacts $(if $(QUICK),--quick)
# ratios of speed, with their targets
MEASURE_bench := -m studies bench
# the stiffness and the drag up to which methods are stable
MEASURE_limits := -m studies limits
# the cost of parts that a scene does not need, and of code that is written to be read
MEASURE_economy := -m studies economy
MEASURE_clarity := -m studies clarity
# the bridge and the platform, for ten minutes each
MEASURE_soak := -m studies soak
# what the book claims, written to docs/claims.md
MEASURE_claims := tests/reference/claims
# the mutants that the checks catch, and right answers checked with 1,000 seeds (CH=6 SEEDS=100)
MEASURE_mutants = tests/strength mutants $(call option,--chapter,CH)
MEASURE_seeds = tests/strength seeds $(call option,--chapter,CH) $(call option,--seeds,SEEDS)

MEASURED := $(sort $(patsubst MEASURE_%,%,$(filter MEASURE_%,$(.VARIABLES))))
ALSO_charts := QUICK
ALSO_contacts := QUICK
ALSO_mutants := CH
ALSO_seeds := CH SEEDS
NOT_TAKEN = $(foreach name,$(filter-out WHAT $(ALSO_$(WHAT)),$(TAKES_measure)),$(if $(value $(name)),$(error make measure WHAT=$(WHAT) does not take $(name))))
