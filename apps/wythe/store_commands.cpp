// Shows the content of a folder: the progress of campaigns, shards, options and studies, and whether
// their stores are undamaged. All data come from the stores, because not every cluster has accounting.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "campaign_commands.h"
#include "progress.h"
#include "wythe/error.h"
#include "wythe/io.h"
#include "wythe/study.h"

namespace wythe::app {
namespace fs = std::filesystem;

std::string shards_of(const std::string& folder) { return folder + "/" + kShardsFolder; }

bool is_option_name(const std::string& name) {
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

std::vector<std::string> shard_folders(const std::string& folder) {
  std::vector<std::pair<int, std::string>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(shards_of(folder), error)) {
    const std::string name = entry.path().filename().string(),
                      path = shards_of(folder) + "/" + name;
    const int number = std::atoi(name.c_str());
    if (number < 1 || name != std::to_string(number)) continue;  // "1.bak" is a manual copy
    if (!holds_campaign(path) && !holds_options(path)) continue;
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
  std::string name, folder;  // folder "": a shard that has not begun
  StoreProgress of;
  int workers = 0;       // that run samples there now
  std::string fault{};   // why it is not counted: its store can't be read, or is none of this array
  int shard = 0;         // by the name of its folder; 0: none
  std::string option{};  // its folder within the shard's, "." where there is only one
};

std::vector<std::string> folders_in(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> inner;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(".") && entry.is_directory(error)) inner.push_back(name);
  }
  std::sort(inner.begin(), inner.end());
  return inner;
}

// Campaigns in a folder: itself, its options, its shards, and those of the studies in it.
class Overview {
 public:
  // Without `counts`, every store gets a line, and no store is read.
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
    } else if (holds_campaign(folder)) {
      lines_.push_back(counts_ ? counted(name, folder) : Line{name, folder, {}});
    } else if (depth <= kDeepest) {
      for (const std::string& one : folders_in(folder))
        collect(folder + "/" + one, name.empty() ? one : name + ", " + one, depth + 1);
    }
  }
  static Line counted(const std::string& name, const std::string& folder) {
    Line line{name, folder, {}};
    try {
      line.of = campaign_progress(folder), line.workers = campaign_workers(folder);
    } catch (const IoError& error) {
      line.fault = error.what();
    } catch (const InputError& error) {
      line.fault = error.what();
    }
    return line;
  }
  void add_joined(const std::string& folder, const std::string& name) {
    if (holds_campaign(folder)) return lines_.push_back({name, folder, {}});
    for (const std::string& inner : folders_in(folder))
      if (holds_campaign(folder + "/" + inner)) lines_.push_back({name, folder + "/" + inner, {}});
  }
  // All shards and options of an array, present or not; the stores give their number.
  void add_shards(const std::vector<std::string>& shards, const std::string& name, int depth) {
    const std::size_t before = lines_.size();
    for (const std::string& shard : shards) {
      const int number = std::atoi(fs::path(shard).filename().c_str());
      const std::size_t first = lines_.size();
      collect(shard, fmt::format("{}shard {}", name, number), depth + 1);
      for (std::size_t k = first; k < lines_.size(); ++k) {
        lines_[k].shard = number;
        lines_[k].option = fs::path(lines_[k].folder).lexically_relative(shard).string();
      }
      std::erase_if(lines_, [](const Line& line) {
        return line.shard > 0 && line.option != "." && !is_option_name(line.option);
      });
    }
    if (!counts_) return;
    std::vector<Line> array(lines_.begin() + static_cast<std::ptrdiff_t>(before), lines_.end());
    lines_.resize(before);
    complete(array, name);
    lines_.insert(lines_.end(), array.begin(), array.end());
  }
  // Marks a store in the folder of another shard, or of another array or study than most stores of its option.
  static void refuse_aliens(std::vector<Line>& array, const std::set<std::string>& options) {
    for (Line& line : array)
      if (line.fault.empty() && line.of.shard != line.shard)
        line.fault = fmt::format(
            "{}: is shard {} of {}, in the folder of shard {}; "
            "put it into the folder of its number",
            line.folder, line.of.shard, line.of.shards, line.shard);
    std::map<int, int> shards;  // how many stores give this number of shards
    for (const Line& line : array)
      if (line.fault.empty()) ++shards[line.of.shards];
    for (Line& line : array)
      if (const int most = most_said(shards); line.fault.empty() && line.of.shards != most)
        line.fault = fmt::format(
            "{}: is one of {} shards, most others of {}: together they are no campaign; keep the "
            "shards of one array in a folder",
            line.folder, line.of.shards, most);
    for (const std::string& option : options) {
      std::map<std::string, int> studies;
      for (const Line& line : array)
        if (line.fault.empty() && line.option == option) ++studies[line.of.study];
      for (Line& line : array)
        if (line.fault.empty() && line.option == option && line.of.study != most_said(studies))
          line.fault = fmt::format(
              "{}: is of another study than most others of its array; put the right one back, or "
              "remove it",
              line.folder);
    }
  }
  // The most frequent value; of several, the first.
  template <class What>
  static What most_said(const std::map<What, int>& said) {
    const auto most = std::max_element(
        said.begin(), said.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == said.end() ? What() : most->first;
  }
  // The largest design applies to all: a shard that has not grown to it has samples left.
  static void complete(std::vector<Line>& array, const std::string& name) {
    const Line* like = nullptr;
    std::set<std::string> options;
    for (const Line& line : array) options.insert(line.option);
    refuse_aliens(array, options);
    for (Line& line : array) {
      if (line.fault.empty() && (like == nullptr || line.of.samples > like->of.samples))
        like = &line;
    }
    if (like == nullptr) return;
    const int samples = like->of.samples, shards = like->of.shards;
    std::set<std::pair<int, std::string>> there;
    for (Line& line : array) {
      there.emplace(line.shard, line.option);
      if (!line.fault.empty()) line.of = {}, line.workers = 0;
      line.of.samples = samples, line.of.shards = shards;
      line.of.total = samples_of_shard(samples, line.shard, shards);
    }
    for (int shard = 1; shard <= std::min(shards, samples); ++shard)
      for (const std::string& option : options) {
        if (there.contains({shard, option})) continue;
        Line none{
            fmt::format("{}shard {}{}", name, shard, option == "." ? "" : ", " + option), "", {}};
        none.of.samples = samples, none.of.shards = shards;
        none.of.total = samples_of_shard(samples, shard, shards);
        none.shard = shard, none.option = option;
        array.push_back(std::move(none));
      }
    std::stable_sort(array.begin(), array.end(), [](const Line& a, const Line& b) {
      return std::tie(a.shard, a.option) < std::tie(b.shard, b.option);
    });
  }

  static constexpr int kDeepest = 2;
  bool counts_;
  std::vector<Line> lines_;
};

// Core seconds for the samples that have not run; NaN if no sample has run.
double core_seconds_left(const StoreProgress& p, double each) { return each * (p.total - p.done); }

double seconds_each(const StoreProgress& p) {
  return p.done > 0 ? p.seconds / p.done : std::nan("");
}

// The text after the numbers of samples: who runs them, and until when.
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
    fmt::print("{}not counted{}\n", line.name.empty() ? "" : readable(line.name) + ": ",
               p.total > 0 ? fmt::format(", {} samples", p.total) : "");
    return;
  }
  fmt::print("{}{}{} of {} samples{}{}\n", readable(line.name), line.name.empty() ? "" : ": ",
             p.done, p.total, p.failed > 0 ? fmt::format(", {} without an answer", p.failed) : "",
             state_text(line, each_of_all));
}

struct Sum {
  StoreProgress of;
  int workers = 0, running = 0, idle = 0;  // lines with and without a running process
  int unread = 0;                          // lines whose store can't be read
  double longest = 0;                      // longest time left of those that run [s]
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

// The running workers also take the waiting samples; the last one ends no earlier than it would alone.
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
             sum.unread > 0 ? fmt::format(", {} not counted", sum.unread) : "", time);
}

}  // namespace

int status(const StatusArguments& a) {
  const std::vector<Line> lines = Overview(a.folder).lines();
  if (lines.empty())
    refuse("folder", a.folder, "holds no campaign",
           "name the folder of a campaign, or of its array");
  const Sum sum = sum_of(lines);
  if (lines.size() == 1 && sum.unread > 0) throw IoError(lines.front().fault);
  for (const Line& line : lines) print_line(line, seconds_each(sum.of));
  if (lines.size() > 1) print_sum(sum);
  std::string faults;
  for (const Line& line : lines)
    if (!line.fault.empty()) faults += line.fault + "\n";
  if (sum.unread > 0)
    throw IoError(faults +
                  fmt::format("{} of {} stores not counted; why, and what to do, stands above",
                              sum.unread, lines.size()));
  return sum.of.done == sum.of.total ? 0 : kUnfinished;
}

int check_store(const StoreArguments& a) {
  const std::vector<Line> lines = Overview(a.folder, false).lines();
  if (lines.empty())
    refuse("folder", a.folder, "holds no campaign",
           "name the folder of a campaign, or of its array");
  if (lines.size() == 1) {
    check_campaign(lines.front().folder);
    fmt::print("{}: whole\n", readable(lines.front().folder));
    return 0;
  }
  int damaged = 0;
  for (const Line& line : lines) {
    try {
      check_campaign(line.folder);
      fmt::print("{}: whole\n", readable(line.folder));
    } catch (const IoError& error) {
      ++damaged;
      fmt::print(stderr, "{}\n", readable_lines(error.what()));
    } catch (const InputError& error) {
      ++damaged;
      fmt::print(stderr, "{}\n", error.what());
    }
  }
  if (damaged > 0)
    throw IoError(fmt::format("{} of {} stores {} not whole; why, and what to do, stands above",
                              damaged, lines.size(), damaged == 1 ? "is" : "are"));
  return 0;
}

}  // namespace wythe::app
