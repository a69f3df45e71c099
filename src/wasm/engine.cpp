// The C interface for a page or Node: no tasks about many walls, and progress that calls JavaScript.
#include <emscripten.h>

#include <new>
#include <vector>

#include "api/job.h"
#include "wythe/c.h"
#include "wythe/parts/model.h"

// clang 14 calls the default constructors of these two vectors of State without emitting them, so they are defined here.
extern "C" {
using Contacts = std::vector<wythe::FreeContact>;
using HandOvers = std::vector<wythe::HandOver>;
Contacts* make_contacts(void* at) __asm__(
    "_ZNSt3__26vectorIN5wythe11FreeContactENS_9allocatorIS2_EEEC1Ev");
HandOvers* make_hand_overs(void* at) __asm__(
    "_ZNSt3__26vectorIN5wythe8HandOverENS_9allocatorIS2_EEEC1Ev");
Contacts* make_contacts(void* at) { return new (at) Contacts(0); }
HandOvers* make_hand_overs(void* at) { return new (at) HandOvers(0); }
}

namespace wythe::api {

const Tasks& study_tasks() {
  static const Tasks kNone;
  return kNone;
}

}  // namespace wythe::api

// Module.progress(what, share, displacement_mm, reaction_kN); true stops the job.
EM_JS(int, tell_page, (const char* what, double share, double mm, double kn), {
  return Module["progress"] && Module["progress"](UTF8ToString(what), share, mm, kn) ? 1 : 0;
});

extern "C" WYTHE_API int wythe_do_here(wythe_job* job) {
  return wythe_do(
      job,
      [](void*, const char* what, double share, double mm, double kn) {
        return tell_page(what, share, mm, kn);
      },
      nullptr);
}
