/* The C interface of wythe: one kind of object, a job, for any language that can call C.
 *
 *   wythe_job* job = wythe_new("run");
 *   wythe_set_text(job, "file", "model.toml", 10);       or "model" with the TOML itself
 *   int code = wythe_do(job, NULL, NULL);
 *   puts(wythe_text(job, "summary", NULL));                        JSON
 *   size_t rows;
 *   const double* kN = wythe_column(job, "curve", "reaction_kN", &rows);
 *   wythe_free(job);
 *
 * Tasks, their inputs and answers: docs/reference/c_interface.md.
 *
 * Results belong to the job and stay valid until the next call of wythe_do, or until the job is freed.
 * Functions never throw, print or end the program. Only one thread may use a job at a time, except for
 * wythe_stop; several jobs may run in several threads at once.
 */
#ifndef WYTHE_C_H
#define WYTHE_C_H

#include <stddef.h>

#if defined(__GNUC__)
#define WYTHE_API __attribute__((visibility("default")))
#else
#define WYTHE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Grows when programs that were built against an older header must change. New tasks, inputs, answers and
 * columns do not change it. */
#define WYTHE_INTERFACE 1
WYTHE_API int wythe_interface(void);
/* "wythe 0.1.0 (commit, compiler, build type, flags)" */
WYTHE_API const char* wythe_version(void);

/* Returned by wythe_do and by the functions that set an input; equal to the exit codes of the program. */
enum wythe_code {
  WYTHE_DONE = 0,
  WYTHE_BAD_INPUT = 2, /* the text "faults" lists every fault */
  WYTHE_STOPPED = 3,   /* by wythe_stop or the progress function; results so far are available */
  WYTHE_NO_ACCESS = 4, /* a file or folder: missing, not writable, damaged, locked, disk full */
  WYTHE_NO_MEMORY = 5,
  WYTHE_DEFECT = 6 /* an error of wythe itself: please report it with the text "error" */
};

typedef struct wythe_job wythe_job;

/* Makes a job for a task: "run", "check", "limit", "contact", "report", "batch", "campaign", "results", "replay", "keys".
 * NULL where memory is exhausted. wythe_do refuses an unknown task. */
WYTHE_API wythe_job* wythe_new(const char* task);
WYTHE_API void wythe_free(wythe_job* job);

/* Inputs. Texts are UTF-8 of `size` bytes. A second text adds a member where the input is a list ("set",
 * "path", "unit") and replaces the first elsewhere. wythe_do refuses names that its task does not have.
 * wythe_set_column sets a column of a table; it copies the numbers. */
WYTHE_API int wythe_set_text(wythe_job* job, const char* name, const char* text, size_t size);
WYTHE_API int wythe_set_number(wythe_job* job, const char* name, double value);
WYTHE_API int wythe_set_column(wythe_job* job, const char* name, const double* values, size_t rows);

/* Called a few times a second, from any thread, never twice at once, with the current work, the share done
 * [0, 1] and, for a run, displacement [mm] and force [kN]. A return value other than 0 stops the job. */
typedef int (*wythe_progress)(void* context, const char* what, double share, double displacement_mm,
                              double reaction_kN);
WYTHE_API int wythe_do(wythe_job* job, wythe_progress progress, void* context);
/* Stops the job within a moment; may be called from any thread or a signal handler. */
WYTHE_API void wythe_stop(wythe_job* job);

/* Answers; NULL for an unknown name. Texts end with a zero byte; `size`, where it is not NULL, gets their
 * length. "tables" is a JSON object of all tables and their columns, "texts" a list of all texts;
 * "error" and "faults" (a JSON list of {file, line, path, value, problem, cure}) describe errors.
 * A column has `rows` numbers, NaN where there is no value. */
WYTHE_API const char* wythe_text(wythe_job* job, const char* name, size_t* size);
WYTHE_API const double* wythe_column(wythe_job* job, const char* table, const char* column,
                                     size_t* rows);

#ifdef __cplusplus
}
#endif

#endif
