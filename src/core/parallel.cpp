// A team of threads that stays awake between passes. A step of a wall takes tens of microseconds, as long as waking a thread.
// So a waiting thread first spins, then sleeps: a team without work costs
// nothing. The threads are those of the standard library. TBB was slower: it woke its threads for each pass,
// and two of them took longer on 825 blocks than one.
#include "core/parallel.h"

#include <atomic>
#include <thread>
#include <vector>

namespace wythe {
namespace {

// Spins for some tenths of a millisecond, longer than any serial part of a step.
constexpr int kSpins = 20000;

void rest_a_little() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Waits until `number` differs from `was`: spins first, then sleeps.
template <class T>
void wait_for_change(const std::atomic<T>& number, T was, int spins) {
  for (int k = 0; k < spins; ++k) {
    if (number.load(std::memory_order_acquire) != was) return;
    rest_a_little();
  }
  number.wait(was, std::memory_order_acquire);
}

}  // namespace

struct Workers::Team {
  explicit Team(int members) : size(members) {
    for (int member = 1; member < members; ++member)
      threads.emplace_back([this, member] { serve(member); });
  }
  ~Team() {
    call = nullptr;
    begin();
    for (std::thread& thread : threads) thread.join();
  }

  // Member m works on the chunks k with k % size = m.
  void do_mine(int member) const {
    for (int chunk = member; chunk < chunks; chunk += size) call(context, chunk);
  }

  void serve(int member) {
    unsigned seen = 0;
    for (;;) {
      wait_for_change(round, seen, spins);
      seen = round.load(std::memory_order_acquire);
      if (call == nullptr) return;
      do_mine(member);
      if (left.fetch_sub(1, std::memory_order_acq_rel) == 1) left.notify_one();
    }
  }

  void begin() {
    left.store(size - 1, std::memory_order_relaxed);
    round.fetch_add(1, std::memory_order_release);
    round.notify_all();
  }

  void run() {
    begin();
    do_mine(0);
    for (int now = left.load(std::memory_order_acquire); now != 0;
         now = left.load(std::memory_order_acquire))
      wait_for_change(left, now, spins);
  }

  const int size;
  // with more threads than cores nobody spins: it would keep another thread from working
  const int spins = size <= static_cast<int>(std::thread::hardware_concurrency()) ? kSpins : 0;
  // what a round works on; the thread that begins it writes these before it increments `round`
  Call call = nullptr;
  const void* context = nullptr;
  int chunks = 0;
  std::atomic<unsigned> round{0};
  std::atomic<int> left{0};  // members that have not finished the round
  std::vector<std::thread> threads;
};

Workers::Workers(int threads) {
  if (threads > 1) team_ = std::make_unique<Team>(threads);
}

Workers::~Workers() = default;

void Workers::run(int chunks, Call call, const void* context) {
  team_->call = call;
  team_->context = context;
  team_->chunks = chunks;
  team_->run();
}

}  // namespace wythe
