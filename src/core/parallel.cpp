#include "core/parallel.h"

#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

namespace wythe {

struct Workers::Arena {
  explicit Arena(int threads) : arena(threads) {}
  tbb::task_arena arena;
};

Workers::Workers(int threads) {
  if (threads > 1) arena_ = std::make_unique<Arena>(threads);
}

Workers::~Workers() = default;

void Workers::run(int chunks, Call call, const void* context) {
  arena_->arena.execute([&] {
    tbb::parallel_for(
        0, chunks, [&](int chunk) { call(context, chunk); }, tbb::static_partitioner());
  });
}

}  // namespace wythe
