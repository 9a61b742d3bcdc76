# The commands of instructors and of those who work on the companion itself.
# It grades a class on all cores, and would do so once a process of the others.
HOSTILE := tests/autograder/untrusted/test_hostile.py
PYTEST = PYTHONPATH=tests/helpers $(RUN) -m pytest --dist worksteal
# One more than there are cores, since some tests wait for a browser or a time limit.
WORKERS = $$($(RUN) -c "import os; print((os.cpu_count() or 1) + 1)")

TAKES_grade := SUBMISSIONS CHAPTERS GIVEN CHECKS OUT SEED ROSTER TITLE POINTS ASSIGNMENT COURSE STUDENT NOTE
TAKES_release := CHAPTERS EX SUBMISSIONS GRADES OUT ROSTER ASSIGNMENT COURSE
TAKES_similarity := SUBMISSIONS CHAPTERS OUT ROSTER ASSIGNMENT COURSE
TAKES_mark := SUBMISSIONS CHAPTERS OPEN ROSTER ASSIGNMENT COURSE
TAKES_handout := CHAPTERS GIVEN OUT ASSIGNMENT COURSE
TAKES_classroom := CHAPTERS GIVEN OUT ASSIGNMENT COURSE
TAKES_gradescope := CHAPTERS GIVEN OUT ASSIGNMENT COURSE
TAKES_site := OUT SOLUTIONS
TAKES_test := CH
TAKES_test-all :=
TAKES_lint :=
TAKES_update :=
TAKES_stubs :=
TAKES_figures :=
TAKES_mutants := CH
TAKES_seeds := CH SEEDS
TAKES_table :=
TAKES_claims :=
TAKES_bench :=
TAKES_charts := QUICK
TAKES_choose := SCENE TOLERANCE
TAKES_limits :=
TAKES_economy :=
TAKES_soak :=
TAKES_clarity :=
TAKES_contacts := QUICK

.PHONY: grade release similarity mark handout classroom gradescope site update stubs test test-all say-what-test-is lint
.PHONY: bench charts choose limits
.PHONY: economy soak clarity contacts figures mutants seeds table claims

# ASSIGNMENT names an assignment of the course file, which then says what the other variables do.
ASSIGNED = $(call option,--assignment,ASSIGNMENT) $(call option,--course,COURSE)
# The chapters of a handout, which the course file names if there is an assignment.
NAMED = $(or $(call typed,CHAPTERS),$(if $(value ASSIGNMENT),,$(error name the chapters: make $@ CHAPTERS=2 OUT=dir, or an assignment: make $@ ASSIGNMENT=lab1)))
BUILT = build/$(if $(value ASSIGNMENT),$(call escaped,ASSIGNMENT)/)
out = --out $(or $(call typed,OUT),'$(1)')

# == For instructors ==
grade: .venv/teaching ## grade a class (SUBMISSIONS=dir CHAPTERS=3 or ASSIGNMENT=lab1)
	@$(RUN) -m autograder grade $(call typed,SUBMISSIONS) $(call out,$(BUILT)grades) $(ASSIGNED) $(call option,--seed,SEED) $(call option,--chapters,CHAPTERS) $(call option,--given,GIVEN) $(call option,--checks,CHECKS) $(call option,--roster,ROSTER) $(call option,--title,TITLE) $(call option,--points,POINTS) $(call option,--student,STUDENT) $(call option,--note,NOTE)

release: .venv/teaching ## release the solutions after the deadline (CHAPTERS=2 OUT=dir)
	@$(RUN) -m autograder release $(NAMED) $(call out,$(BUILT)release) $(ASSIGNED) $(call option,--exercises,EX) $(call option,--submissions,SUBMISSIONS) $(if $(value GRADES)$(value SUBMISSIONS)$(wildcard $(BUILT)grades/results),--grades $(or $(call typed,GRADES),'$(BUILT)grades')) $(call option,--roster,ROSTER)

similarity: .venv/teaching ## find similar submissions (SUBMISSIONS=dir CHAPTERS=2-3)
	@$(RUN) -m autograder similarity $(or $(call typed,SUBMISSIONS),$(if $(value ASSIGNMENT)$(value ROSTER),$(error name the class: make similarity SUBMISSIONS=../handed-in),sample_class)) $(call out,$(BUILT)similarity) $(ASSIGNED) $(call option,--chapters,CHAPTERS) $(call option,--roster,ROSTER)

mark: .venv/teaching ## mark written answers on a page (SUBMISSIONS=dir CHAPTERS=2)
	@$(RUN) -m autograder mark $(or $(call typed,SUBMISSIONS),$(error name the class: make mark SUBMISSIONS=dir)) $(call option,--chapters,CHAPTERS) $(call option,--roster,ROSTER) $(if $(filter 0,$(OPEN)),--no-browser) $(ASSIGNED)

handout: .venv/teaching ## make a handout (CHAPTERS=4-5 GIVEN=2-3 OUT=dir)
	@$(RUN) -m autograder handout $(NAMED) $(call out,$(BUILT)handout) $(ASSIGNED) $(call option,--given,GIVEN)

classroom: .venv/teaching ## make a handout for GitHub Classroom (CHAPTERS=2 OUT=dir)
	@$(RUN) -m autograder classroom $(NAMED) $(call out,$(BUILT)classroom) $(ASSIGNED) $(call option,--given,GIVEN)

gradescope: .venv/teaching ## make the zip for Gradescope (CHAPTERS=2-3 OUT=file.zip)
	@$(RUN) -m autograder gradescope $(NAMED) $(call out,$(BUILT)gradescope.zip) $(ASSIGNED) $(call option,--given,GIVEN)

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
	@echo "This tests the companion itself, and takes $(if $(value CH),half a minute,about 4 minutes)."
	@echo "To check what you wrote, run make check or make watch."

test-all: test ## run all tests, as before a release
	@echo "The slow tests take about 10 minutes."
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

update: .venv/everything stubs ## generate all stubs and tables again
	@$(RUN) tests/strength table

stubs: .venv/teaching ## generate the stubs in chapters/ from solutions/
	@$(RUN) -m autograder stubs

figures: .venv/everything ## draw the pictures of the lessons again
	@$(RUN) -m plots figures

# == Measurements ==
mutants: .venv/everything ## count the mutants that the checks catch (CH=6)
	@$(RUN) tests/strength mutants $(call option,--chapter,CH)

seeds: .venv/everything ## check right answers with 1,000 seeds (CH=6 SEEDS=100)
	@$(RUN) tests/strength seeds $(call option,--chapter,CH) $(call option,--seeds,SEEDS)

table: .venv/everything ## copy the measured figures into the pages
	@$(RUN) tests/strength table

claims: .venv/everything ## measure what the book claims, and write claims.md
	@$(RUN) tests/reference/claims

bench: .venv/everything ## measure ratios of speed and compare them with their targets
	@$(RUN) -m studies bench

charts: .venv/everything ## measure speed against accuracy (QUICK=1 takes 3 minutes)
	@$(RUN) -m studies charts $(if $(QUICK),--quick)

choose: .venv/everything ## find the cheapest model (SCENE=my_scene.py TOLERANCE=1e-3)
	@$(RUN) -m studies choose $(or $(call typed,SCENE),$(error name a scene: make choose SCENE=pendulum, or a file that describes yours)) $(call option,--tolerance,TOLERANCE) $(DIAGNOSIS)

limits: .venv/everything ## find the stiffness and drag up to which methods are stable
	@$(RUN) -m studies limits

clarity: .venv/everything ## measure what it costs that the engine is written to be read
	@$(RUN) -m studies clarity

economy: .venv/everything ## measure the cost of parts that a scene does not need
	@$(RUN) -m studies economy

soak: .venv/everything ## simulate the bridge and the platform for ten minutes each
	@$(RUN) -m studies soak

contacts: .venv/everything ## compare the contact solvers (QUICK=1 takes one minute)
	@$(RUN) -m studies contacts $(if $(QUICK),--quick)
