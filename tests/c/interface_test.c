/* The C interface as a C program sees it: tasks, answers, faults, progress, stop, misuse. Compiled as C11 and
 * linked with libwythe.so alone (tests/cli/c_interface_test.py). Prints a line for each check that fails. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "wythe/c.h"

static int failed = 0;
#define CHECK(condition)                                            \
  do {                                                              \
    if (!(condition)) {                                             \
      printf("interface_test.c:%d: %s\n", __LINE__, #condition);    \
      failed = 1;                                                   \
    }                                                               \
  } while (0)

static int set(wythe_job* job, const char* name, const char* text) {
  return wythe_set_text(job, name, text, strlen(text));
}
static int has(const char* text, const char* part) { return text != NULL && strstr(text, part) != NULL; }

static int calls = 0;
static double last_share = 0;
static int count(void* context, const char* what, double share, double mm, double kN) {
  (void)mm, (void)kN;
  CHECK(context == &calls && what != NULL && share >= last_share && share <= 1);
  last_share = share;
  ++calls;
  return 0;
}
static int stop_at_once(void* context, const char* what, double share, double mm, double kN) {
  (void)context, (void)what, (void)share, (void)mm, (void)kN;
  return 1;
}

static void run(const char* model) {
  wythe_job* job = wythe_new("run");
  CHECK(set(job, "file", model) == WYTHE_DONE);
  CHECK(set(job, "set", "stage.push.targets=[\"0.2 mm\"]") == WYTHE_DONE);
  CHECK(wythe_do(job, count, &calls) == WYTHE_DONE);
  CHECK(calls > 0);
  CHECK(has(wythe_text(job, "summary", NULL), "\"state_hash\""));
  size_t rows = 0, same = 0, size = 0;
  const double* force = wythe_column(job, "curve", "reaction_kN", &rows);
  const double* way = wythe_column(job, "curve", "displacement_mm", &same);
  CHECK(force != NULL && way != NULL && rows == same && rows > 10);
  CHECK(fabs(way[rows - 1] - 0.2) < 0.01 && force[rows - 1] > 1);
  CHECK(wythe_column(job, "curve", "no such column", &rows) == NULL);
  CHECK(wythe_column(job, "no such table", "x", &rows) == NULL);
  CHECK(wythe_text(job, "no such text", NULL) == NULL);
  CHECK(has(wythe_text(job, "tables", &size), "\"state 0 joints\""));
  CHECK(size == strlen(wythe_text(job, "tables", NULL)));
  CHECK(has(wythe_text(job, "texts", NULL), "\"summary\""));
  CHECK(has(wythe_text(job, "columns of curve", NULL), "reaction_kN"));
  CHECK(wythe_text(job, "columns of nothing", NULL) == NULL);
  CHECK(wythe_column(job, "state 0 joints", "opening_mm", &rows) != NULL && rows > 10);
  /* the same job again gives the same */
  char hash[40] = "";
  strncpy(hash, strstr(wythe_text(job, "summary", NULL), "\"state_hash\""), 32);
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_DONE);
  CHECK(has(wythe_text(job, "summary", NULL), hash));
  wythe_free(job);
}

static void stop(const char* model) {
  wythe_job* job = wythe_new("run");
  set(job, "file", model);
  CHECK(wythe_do(job, stop_at_once, NULL) == WYTHE_STOPPED);
  CHECK(has(wythe_text(job, "summary", NULL), "interrupted"));
  wythe_free(job);
}

/* a run that goes on after stops has the bits of one in one go; a new input begins anew */
static void go_on(const char* model) {
  wythe_job* whole = wythe_new("run");
  wythe_job* pieces = wythe_new("run");
  wythe_job* both[] = {whole, pieces};
  for (int k = 0; k < 2; ++k) {
    set(both[k], "file", model);
    set(both[k], "set", "stage.push.targets=[\"0.2 mm\"]");
  }
  wythe_set_number(pieces, "goes_on", 1);
  CHECK(wythe_do(whole, NULL, NULL) == WYTHE_DONE);
  for (int k = 0; k < 3; ++k) {
    CHECK(wythe_do(pieces, stop_at_once, NULL) == WYTHE_STOPPED);
    CHECK(has(wythe_text(pieces, "svg", NULL), "<svg"));
    CHECK(wythe_text(pieces, "summary", NULL) == NULL);
  }
  CHECK(wythe_do(pieces, NULL, NULL) == WYTHE_DONE);
  char hash[40] = "";
  strncpy(hash, strstr(wythe_text(whole, "summary", NULL), "\"state_hash\""), 32);
  CHECK(has(wythe_text(pieces, "summary", NULL), hash));
  /* a stop between two pieces is obeyed, one at the end is forgotten */
  CHECK(wythe_do(pieces, stop_at_once, NULL) == WYTHE_STOPPED);
  wythe_stop(pieces);
  CHECK(wythe_do(pieces, NULL, NULL) == WYTHE_STOPPED);
  wythe_set_number(pieces, "frames", 3);
  CHECK(wythe_do(pieces, NULL, NULL) == WYTHE_DONE);
  CHECK(has(wythe_text(pieces, "summary", NULL), hash));
  wythe_stop(whole);
  CHECK(wythe_do(whole, NULL, NULL) == WYTHE_STOPPED);
  CHECK(wythe_do(whole, NULL, NULL) == WYTHE_DONE);
  CHECK(has(wythe_text(whole, "summary", NULL), hash));
  CHECK(wythe_do(pieces, stop_at_once, NULL) == WYTHE_STOPPED);
  set(pieces, "model", "[wall]\nlength = \"-1 m\"\n");
  CHECK(wythe_do(pieces, NULL, NULL) == WYTHE_BAD_INPUT);
  wythe_free(whole);
  wythe_free(pieces);
}

/* asked for quickly there is one load, and a note that says so */
static void quick_limit(const char* model) {
  wythe_job* job = wythe_new("limit");
  set(job, "file", model);
  set(job, "only", "lp");
  wythe_set_number(job, "quick", 1);
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_DONE);
  const char* found = wythe_text(job, "mechanisms", NULL);
  CHECK(has(found, "\"dry\"") && !has(found, "residual friction, crushing"));
  CHECK(has(found, "asked for quickly"));
  wythe_free(job);
}

/* the picture of a limit load is of the wall that stands while the load grows: with the lintel put in */
static void limit_after_a_cut(void) {
  const char* model =
      "[wall]\nlength = \"2 m\"\nheight = \"1.6 m\"\nthickness = \"0.3 m\"\n"
      "unit = { length = \"400 mm\", height = \"200 mm\", split = \"none\", density = \"1800 kg/m^3\" }\n"
      "[[wall.opening]]\nx = \"0.6 m\"\ny = \"0 m\"\nwidth = \"0.8 m\"\nheight = \"1 m\"\ncut = \"works\"\n"
      "lintel = { kind = \"timber\", depth = \"200 mm\", bearing = \"200 mm\", material = \"timber\" }\n"
      "[material.joint]\nnormal_stiffness = \"20 GPa/m\"\nshear_stiffness = \"8 GPa/m\"\n"
      "tensile_strength = \"0 MPa\"\ncohesion = \"0 MPa\"\nresidual_cohesion = \"0 MPa\"\n"
      "friction_angle = \"30 deg\"\nresidual_friction_angle = \"30 deg\"\n"
      "compressive_strength = \"unlimited\"\n"
      "[material.timber]\ndensity = \"500 kg/m^3\"\nyoungs_modulus = \"10 GPa\"\nshear_modulus = \"0.6 GPa\"\n"
      "[[stage]]\nname = \"gravity\"\n[[stage]]\nname = \"works\"\nkind = \"cut\"\n"
      "[[stage]]\nname = \"push\"\nat = { x = \"0 m\", y = \"1.5 m\" }\nuntil = \"5 mm\"\n";
  wythe_job* job = wythe_new("limit");
  set(job, "model", model);
  set(job, "only", "lp");
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_DONE);
  CHECK(has(wythe_text(job, "dry svg", NULL), "class=\"timber\""));
  wythe_free(job);
}

static void faults(void) {
  wythe_job* job = wythe_new("run");
  set(job, "model", "[wall]\nlength = \"-1 m\"\n");
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_BAD_INPUT);
  CHECK(has(wythe_text(job, "faults", NULL), "\"wall.length\""));
  CHECK(has(wythe_text(job, "faults", NULL), "\"line\":2"));
  CHECK(has(wythe_text(job, "error", NULL), "wall.length"));
  CHECK(wythe_text(job, "summary", NULL) == NULL);
  wythe_set_number(job, "thread", 2);
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_BAD_INPUT);
  CHECK(has(wythe_text(job, "faults", NULL), "thread"));
  wythe_free(job);
  job = wythe_new("fly");
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_BAD_INPUT);
  CHECK(has(wythe_text(job, "error", NULL), "campaign"));
  wythe_free(job);
}

/* what a check counts, and beside it the time of a push, which is measured when it is asked for */
static void check(const char* model) {
  wythe_job* job = wythe_new("check");
  set(job, "file", model);
  CHECK(wythe_do(job, NULL, NULL) == WYTHE_DONE);
  const char* counts = wythe_text(job, "counts", NULL);
  CHECK(has(counts, "\"blocks\"") && has(counts, "\"notes\"") && !has(counts, "seconds"));
  const char* facts = wythe_text(job, "check", NULL);
  CHECK(counts != NULL && facts != NULL && strncmp(counts, facts, strlen(counts) - 1) == 0);
  CHECK(has(facts, "\"time_step_s\"") && has(facts, "\"steps\"") && has(facts, "\"expected_seconds\""));
  CHECK(has(wythe_text(job, "svg", NULL), "<svg") && has(wythe_text(job, "model", NULL), "[wall]"));
  wythe_free(job);
}

static void misuse(void) {
  CHECK(wythe_do(NULL, NULL, NULL) == WYTHE_BAD_INPUT);
  CHECK(wythe_text(NULL, "summary", NULL) == NULL);
  CHECK(wythe_column(NULL, "curve", "reaction_kN", NULL) == NULL);
  wythe_stop(NULL);
  wythe_free(NULL);
  wythe_job* job = wythe_new(NULL);
  CHECK(job != NULL && wythe_do(job, NULL, NULL) == WYTHE_BAD_INPUT);
  CHECK(wythe_set_text(job, NULL, "", 0) == WYTHE_BAD_INPUT);
  CHECK(wythe_set_column(job, "x", NULL, 3) == WYTHE_BAD_INPUT);
  CHECK(wythe_text(job, NULL, NULL) == NULL);
  wythe_free(job);
}

int main(int count_of_arguments, char** arguments) {
  if (count_of_arguments != 2) return 2;
  CHECK(wythe_interface() == WYTHE_INTERFACE);
  CHECK(has(wythe_version(), "wythe "));
  run(arguments[1]);
  check(arguments[1]);
  stop(arguments[1]);
  go_on(arguments[1]);
  quick_limit(arguments[1]);
  limit_after_a_cut();
  faults();
  misuse();
  return failed;
}
