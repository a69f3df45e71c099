/* Runs one model N times through the C interface and prints the seconds of each call, one a line:
 * c_calls MODEL.toml N PATH=VALUE... Compiled and compared with Python by benchmarks/python_calls.py. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "wythe/c.h"

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int count, char** words) {
  if (count < 3) return 2;
  for (int i = 0; i < atoi(words[2]); ++i) {
    const double begin = now();
    wythe_job* job = wythe_new("run");
    wythe_set_text(job, "file", words[1], strlen(words[1]));
    for (int k = 3; k < count; ++k) wythe_set_text(job, "set", words[k], strlen(words[k]));
    size_t rows = 0;
    if (wythe_do(job, NULL, NULL) != WYTHE_DONE || wythe_text(job, "summary", NULL) == NULL ||
        wythe_column(job, "curve", "reaction_kN", &rows) == NULL) {
      fprintf(stderr, "%s\n", wythe_text(job, "error", NULL));
      return 1;
    }
    wythe_free(job);
    printf("%.9f\n", now() - begin);
  }
  return 0;
}
