// Preloaded: the clock of the day jumps with each look at it, by a year forwards or two backwards in turn, and beyond both
// ends of what it knows. The clock that only counts on (CLOCK_MONOTONIC) stays as it is, as the system promises. Each jump is
// counted in the file that JUMPING_CLOCK_COUNT names.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static time_t jumped(time_t now) {
  static const time_t kYear = 31557600;
  static int looks;
  const char* file = getenv("JUMPING_CLOCK_COUNT");
  const int count = file ? open(file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600) : -1;
  if (count >= 0) {
    if (write(count, ".", 1) != 1) abort();
    close(count);
  }
  switch (looks++ % 4) {
    case 0: return now + kYear;
    case 1: return now - 2 * kYear;
    case 2: return 0;
    default: return 4102444800;  // 2100
  }
}

int clock_gettime(clockid_t clock, struct timespec* at) {
  static int (*real)(clockid_t, struct timespec*);
  if (!real) real = (int (*)(clockid_t, struct timespec*))dlsym(RTLD_NEXT, "clock_gettime");
  const int result = real(clock, at);
  if (result == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)) at->tv_sec = jumped(at->tv_sec);
  return result;
}

int gettimeofday(struct timeval* at, void* zone) {
  (void)zone;
  struct timespec now;
  if (clock_gettime(CLOCK_REALTIME, &now) != 0) return -1;
  at->tv_sec = now.tv_sec, at->tv_usec = now.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* at) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (at) *at = now.tv_sec;
  return now.tv_sec;
}
