/* The C interface of wythe: one kind of object, a job, that any language with C calls can use.
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
 * What a function gives belongs to the job and stays until wythe_do is called again or the job is freed.
 * Functions never throw, never print and never end the program. A job is used by one thread at a time, only
 * wythe_stop may come from another; several jobs may run in several threads at once.
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

/* Grows when a program that was built against an older header has to be changed. New tasks, inputs, answers
 * and columns may come without that. */
#define WYTHE_INTERFACE 1
WYTHE_API int wythe_interface(void);
/* "wythe 0.1.0 (commit, compiler, build type, flags)" */
WYTHE_API const char* wythe_version(void);

/* What wythe_do and the functions that set an input answer; as the exit codes of the program. */
enum wythe_code {
  WYTHE_DONE = 0,
  WYTHE_BAD_INPUT = 2, /* the text "faults" lists every fault */
  WYTHE_STOPPED = 3, /* by wythe_stop or the progress function; what was done until then is there */
  WYTHE_NO_ACCESS = 4, /* a file or folder: missing, not writable, damaged, locked, disk full */
  WYTHE_NO_MEMORY = 5,
  WYTHE_DEFECT = 6 /* of wythe itself: please report it with the text "error" */
};

typedef struct wythe_job wythe_job;

/* A job of a task: "run", "check", "limit", "contact", "batch", "campaign", "results", "replay", "keys".
 * NULL where there is no memory. An unknown task is refused by wythe_do. */
WYTHE_API wythe_job* wythe_new(const char* task);
WYTHE_API void wythe_free(wythe_job* job);

/* Inputs. Texts are UTF-8 and have `size` bytes. Setting a text again adds a member where the input is a list
 * ("set", "path", "unit") and replaces it elsewhere. Names that a task does not have are refused by wythe_do.
 * wythe_set_column gives a column of a table; the numbers are copied. */
WYTHE_API int wythe_set_text(wythe_job* job, const char* name, const char* text, size_t size);
WYTHE_API int wythe_set_number(wythe_job* job, const char* name, double value);
WYTHE_API int wythe_set_column(wythe_job* job, const char* name, const double* values, size_t rows);

/* Called a few times a second, from any thread, never twice at once: what is under way, the share done [0, 1],
 * and of a run displacement [mm] and force [kN]. An answer other than 0 stops the job. */
typedef int (*wythe_progress)(void* context, const char* what, double share, double displacement_mm,
                              double reaction_kN);
WYTHE_API int wythe_do(wythe_job* job, wythe_progress progress, void* context);
/* From any thread or a signal handler: the job stops within a moment. */
WYTHE_API void wythe_stop(wythe_job* job);

/* Answers; NULL where there is none of that name. Texts end with a zero byte; `size`, where it is not NULL,
 * takes their length. "tables" is a JSON object of all tables and their columns, "texts" a list of all texts;
 * "error" and "faults" (a JSON list of {file, line, path, value, problem, cure}) say what went wrong.
 * Columns: `rows` numbers, NaN where there is no value. */
WYTHE_API const char* wythe_text(wythe_job* job, const char* name, size_t* size);
WYTHE_API const double* wythe_column(wythe_job* job, const char* table, const char* column,
                                     size_t* rows);

#ifdef __cplusplus
}
#endif

#endif
