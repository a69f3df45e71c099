// Threads within one step: any number of workers share a fixed list of chunks. The threads that solve samples side by
// side are those of campaign/runner/sample_pool.cpp.
//
// The result of a chunk does not depend on which worker computes it. The caller keeps sums per chunk and adds them in
// order, so the bits are the same for every number of threads.
#pragma once

#include <memory>

namespace wythe {

class Workers {
 public:
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // Calls work(chunk) for chunk = 0 .. chunks-1; returns when all are done.
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
  std::unique_ptr<Team> team_;  // null with one thread
};

}  // namespace wythe
