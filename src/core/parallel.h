// Threads within one step: a fixed list of chunks done by any number of workers. Threads that solve samples side by
// side: campaign/runner/sample_pool.cpp.
//
// What a chunk computes never depends on who does it, and sums are kept per chunk and added in
// order by the caller, so the bits are the same for every number of threads.
#pragma once

#include <memory>

namespace wythe {

class Workers {
 public:
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // work(chunk) for chunk = 0 .. chunks-1; returns when all are done.
  template <class Work>
  void for_each_chunk(int chunks, const Work& work) {
    if (!team_) {
      for (int chunk = 0; chunk < chunks; ++chunk) work(chunk);
      return;
    }
    run(
        chunks, [](const void* context, int chunk) { (*static_cast<const Work*>(context))(chunk); },
        &work);
  }

 private:
  using Call = void (*)(const void* context, int chunk);
  void run(int chunks, Call call, const void* context);

  struct Team;
  std::unique_ptr<Team> team_;  // empty for one thread
};

}  // namespace wythe
