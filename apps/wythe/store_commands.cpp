// What lies in a folder: how far its campaigns, shards, options and studies are, and whether their stores are whole.
// Everything is read from the stores alone: there is no accounting everywhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "campaign_commands.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/folders.h"
#include "wythe/io.h"
#include "wythe/shards.h"
#include "wythe/stored_states.h"
#include "wythe/text.h"

namespace wythe::app {
namespace fs = std::filesystem;

std::string shards_of(const std::string& folder) { return folder + "/" + kShardsFolder; }

namespace {

// Also where a store is there that does not read: it is not left out, whoever opens it says what is wrong.
bool may_hold_campaign(const std::string& folder) {
  try {
    return holds_campaign(folder);
  } catch (const IoError&) {
    return true;
  }
}

}  // namespace

std::vector<std::string> shard_folders(const std::string& folder) {
  std::vector<std::pair<int, std::string>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(shards_of(folder), error)) {
    const std::string name = entry.path().filename().string(),
                      path = shards_of(folder) + "/" + name;
    const int number = std::atoi(name.c_str());
    if (number < 1 || name != std::to_string(number)) continue;  // "1.bak", a copy by hand
    if (!may_hold_campaign(path) && !holds_options(path)) continue;
    found.emplace_back(number, path);
  }
  std::sort(found.begin(), found.end());
  std::vector<std::string> folders;
  for (auto& [number, path] : found) folders.push_back(std::move(path));
  return folders;
}

namespace {

constexpr int kUnfinished = 3;  // exit code

int samples_of_shard(int samples, int shard, int shards) {
  return samples / shards + (shard <= samples % shards ? 1 : 0);
}

struct Line {
  std::string name, folder;  // "": a shard that has not begun
  StoreProgress of;
  int workers = 0;         // that run samples there now
  std::string fault = "";  // why its store can't be read
};

// Campaigns below a folder: itself, its options, its shards, and those of the studies in it.
class Overview {
 public:
  // Without counting, stores that do not read have their line too.
  explicit Overview(const std::string& folder, bool counts = true) : counts_(counts) {
    collect(folder, "", 0);
  }
  [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

 private:
  void collect(const std::string& folder, const std::string& name, int depth) {
    const std::vector<std::string> shards = shard_folders(folder);
    if (!shards.empty()) {  // what is joined already is in them: it counts once, and is checked too
      if (!counts_) add_joined(folder, name.empty() ? "joined" : name + ", joined");
      add_shards(shards, name.empty() ? "" : name + ", ", depth);
    } else if (may_hold_campaign(folder)) {
      lines_.push_back(counts_ ? counted(name, folder) : Line{name, folder, {}});
    } else if (depth <= kDeepest) {
      std::error_code error;
      std::vector<std::string> inner;
      for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.is_directory(error)) inner.push_back(entry.path().filename().string());
      std::sort(inner.begin(), inner.end());
      for (const std::string& one : inner)
        collect(folder + "/" + one, name.empty() ? one : name + ", " + one, depth + 1);
    }
  }
  static Line counted(const std::string& name, const std::string& folder) {
    Line line{name, folder, {}};
    try {
      line.of = campaign_progress(folder), line.workers = campaign_workers(folder);
    } catch (const IoError& error) {
      line.fault = error.what();
    }
    return line;
  }
  void add_joined(const std::string& folder, const std::string& name) {
    if (holds_campaign(folder)) lines_.push_back({name, folder, {}});
    if (holds_options(folder))
      for (const std::string& option : option_folders(folder)) lines_.push_back({name, option, {}});
  }
  // Those that are not there too, of shards by hand: each store knows how many there are.
  void add_shards(const std::vector<std::string>& shards, const std::string& name, int depth) {
    const auto called = [&](int shard) { return fmt::format("{}shard {}", name, shard); };
    const std::size_t before = lines_.size();
    std::map<int, std::size_t> there;  // by its number, where its lines end
    for (const std::string& shard : shards) {
      const int number = std::atoi(fs::path(shard).filename().c_str());
      collect(shard, called(number), depth + 1);
      there[number] = lines_.size();
    }
    const auto like =
        std::find_if(lines_.begin() + static_cast<std::ptrdiff_t>(before), lines_.end(),
                     [](const Line& line) { return line.fault.empty(); });
    if (like == lines_.end() || !counts_) return;
    StoreProgress none;
    none.samples = like->of.samples, none.shards = like->of.shards;
    std::size_t k = before;
    for (const auto& [number, end] : there)
      for (; k < end; ++k) {
        if (lines_[k].fault.empty()) {
          check_number(lines_[k], *like);
          continue;
        }
        lines_[k].of = none;
        lines_[k].of.total = samples_of_shard(none.samples, number, none.shards);
      }
    for (int shard = 1; shard <= none.shards; ++shard) {
      if (there.contains(shard)) continue;
      none.total = samples_of_shard(none.samples, shard, none.shards);
      lines_.push_back({called(shard), "", none});
    }
  }
  static void check_number(const Line& line, const Line& like) {
    if (line.of.shards != like.of.shards)
      refuse("folder", line.folder,
             fmt::format("is one of {} shards, {} of {}: together they are no campaign",
                         line.of.shards, like.folder, like.of.shards),
             "keep the shards of one array in a folder");
  }

  static constexpr int kDeepest = 2;
  bool counts_;
  std::vector<Line> lines_;
};

// Seconds of one core that samples take which have not run; NaN: none has run that could tell.
double core_seconds_left(const StoreProgress& p, double each) { return each * (p.total - p.done); }

double seconds_each(const StoreProgress& p) {
  return p.done > 0 ? p.seconds / p.done : std::nan("");
}

// What stands behind the numbers of samples: who runs them, and until when.
std::string state_text(const Line& line, double each_of_all) {
  const StoreProgress& p = line.of;
  if (p.done >= p.total) return p.writer.empty() ? "" : ", " + readable(p.writer) + " writes";
  const double left = core_seconds_left(p, p.done > 0 ? seconds_each(p) : each_of_all);
  std::string time = "; time left not known yet";
  if (!std::isnan(left))
    time = line.workers > 0 ? "; about " + duration_text(left / line.workers) + " left"
                            : "; about " + duration_text(left) + " of one core left";
  if (p.writer.empty()) return (p.done == 0 ? ", not begun" : ", not running") + time;
  std::string who = ", " + readable(p.writer) + " writes";
  if (line.workers > 0)
    who += fmt::format(" with {} worker{}", line.workers, line.workers == 1 ? "" : "s");
  return who + time;
}

void print_line(const Line& line, double each_of_all) {
  const StoreProgress& p = line.of;
  if (!line.fault.empty()) {
    fmt::print("{}cannot be read{}\n", line.name.empty() ? "" : readable(line.name) + ": ",
               p.total > 0 ? fmt::format(", {} samples", p.total) : "");
    return;
  }
  fmt::print("{}{}{} of {} samples{}{}\n", readable(line.name), line.name.empty() ? "" : ": ",
             p.done, p.total, p.failed > 0 ? fmt::format(", {} without an answer", p.failed) : "",
             state_text(line, each_of_all));
}

struct Sum {
  StoreProgress of;
  int workers = 0, running = 0, idle = 0;  // lines that somebody writes, or nobody
  int unread = 0;                          // lines whose store can't be read
  double longest = 0;                      // time left of those that run [s]
};

Sum sum_of(const std::vector<Line>& lines) {
  Sum sum;
  for (const Line& line : lines) {
    const StoreProgress& p = line.of;
    sum.of.done += p.done, sum.of.total += p.total, sum.of.failed += p.failed;
    sum.of.seconds += p.seconds;
    if (!line.fault.empty()) ++sum.unread;
  }
  const double each = seconds_each(sum.of);
  for (const Line& line : lines) {
    const StoreProgress& p = line.of;
    if (!p.writer.empty()) ++sum.running;
    if (p.done >= p.total || !line.fault.empty()) continue;
    if (p.writer.empty()) ++sum.idle;
    sum.workers += line.workers;
    if (line.workers > 0)
      sum.longest = std::max(
          sum.longest, core_seconds_left(p, p.done > 0 ? seconds_each(p) : each) / line.workers);
  }
  return sum;
}

// The workers that run now take what waits too; the last of them ends no earlier than it does alone.
void print_sum(const Sum& sum) {
  const double left = core_seconds_left(sum.of, seconds_each(sum.of));
  std::string time;
  if (sum.of.done < sum.of.total)
    time = std::isnan(left) ? "; time left not known yet"
           : sum.workers > 0
               ? "; about " + duration_text(std::max(sum.longest, left / sum.workers)) +
                     " left with the workers that run"
               : "; about " + duration_text(left) + " of one core left";
  fmt::print("all: {} of {} samples{}{}{}{}{}\n", sum.of.done, sum.of.total,
             sum.of.failed > 0 ? fmt::format(", {} without an answer", sum.of.failed) : "",
             sum.running > 0 ? fmt::format(", {} running", sum.running) : "",
             sum.idle > 0 ? fmt::format(", {} not running", sum.idle) : "",
             sum.unread > 0 ? fmt::format(", {} cannot be read", sum.unread) : "", time);
}

}  // namespace

int status(const StatusArguments& a) {
  const std::vector<Line> lines = Overview(a.folder).lines();
  if (lines.empty())
    refuse("folder", a.folder, "holds no campaign",
           "name the folder of a campaign, or of its array");
  const Sum sum = sum_of(lines);
  for (const Line& line : lines) print_line(line, seconds_each(sum.of));
  if (lines.size() > 1) print_sum(sum);
  std::string faults;
  for (const Line& line : lines)
    if (!line.fault.empty()) faults += line.fault + "\n";
  if (sum.unread > 0)
    throw IoError(faults +
                  fmt::format("{} of {} stores cannot be read; wythe store check {} reads them "
                              "through, wythe store rescue DIR --out NEW saves what still reads",
                              sum.unread, lines.size(), shell_quoted(a.folder)));
  return sum.of.done == sum.of.total ? 0 : kUnfinished;
}

int check_store(const StoreArguments& a) {
  const std::vector<Line> lines = Overview(a.folder, false).lines();
  if (lines.empty())
    refuse("folder", a.folder, "holds no campaign",
           "name the folder of a campaign, or of its array");
  int damaged = 0;
  for (const Line& line : lines) {
    try {
      check_campaign(line.folder);
      fmt::print("{}: whole\n", readable(line.folder));
    } catch (const IoError& error) {
      ++damaged;
      fmt::print(stderr, "{}\n", readable(error.what()));
    }
  }
  if (damaged > 0)
    throw IoError(fmt::format(
        "{} of {} stores damaged; wythe store rescue DIR --out NEW saves what still reads", damaged,
        lines.size()));
  return 0;
}

}  // namespace wythe::app
