// The functions of wythe/c.h; none of them lets an exception out.
#include <fmt/format.h>

#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "api/job.h"
#include "wythe/c.h"
#include "wythe/parts/error.h"
#include "wythe/parts/folders.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/text.h"

struct wythe_job {
  wythe::api::Job job;
  std::string faults, error, made;  // texts that are not results
};

namespace wythe::api {
namespace {

const Tasks& tasks() {
  static const Tasks kTasks = [] {
    Tasks all = run_tasks();
    all.insert(study_tasks().begin(), study_tasks().end());
    return all;
  }();
  return kTasks;
}

bool do_task(Job& job) {
  const auto task = tasks().find(job.task);
  if (task != tasks().end()) return task->second(job);
  std::string known;
  for (const auto& [name, function] : tasks()) known += (known.empty() ? "" : ", ") + name;
  throw InputError({{.path = "task",
                     .value = job.task,
                     .problem = "is no task",
                     .cure = "write one of: " + known}});
}

std::string faults_json(const std::vector<Fault>& faults) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Fault& f : faults)
    list.push_back({{"file", f.file},
                    {"line", f.line},
                    {"path", f.path},
                    {"value", f.value},
                    {"problem", f.problem},
                    {"cure", f.cure}});
  // texts of a user may not be UTF-8
  return list.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// Runs `action` and converts an exception to a code; "error" and "faults" describe it.
template <class Action>
int guarded(wythe_job& job, const Action& action) noexcept {
  try {
    job.error.clear();
    job.faults.clear();
    try {
      return action();
    } catch (const InputError& error) {
      job.error = error.what();
      job.faults = faults_json(error.faults());
      return WYTHE_BAD_INPUT;
    } catch (const LimitStopped& stopped) {
      job.error = stopped.what();
      return WYTHE_STOPPED;
    } catch (const IoError& error) {
      job.error = error.what();
      return WYTHE_NO_ACCESS;
    } catch (const std::bad_alloc&) {
      job.error = "there is not enough memory";
      return WYTHE_NO_MEMORY;
    } catch (const std::exception& error) {
      job.error = fmt::format("a defect of wythe: {}", error.what());
      return WYTHE_DEFECT;
    } catch (...) {
      job.error = "a defect of wythe";
      return WYTHE_DEFECT;
    }
  } catch (...) {  // no memory for the text
    return WYTHE_NO_MEMORY;
  }
}

// Calls the caller's progress function, one call at a time.
std::function<void(const std::string&, double, double, double)> listener(wythe_job& job,
                                                                         wythe_progress progress,
                                                                         void* context) {
  if (progress == nullptr) return [](const std::string&, double, double, double) {};
  auto mutex = std::make_shared<std::mutex>();
  return [&job, progress, context, mutex](const std::string& what, double share, double mm,
                                          double kn) {
    const std::lock_guard lock(*mutex);
    const double bounded = share > 0 ? std::min(share, 1.0) : 0;
    if (progress(context, what.c_str(), bounded, mm, kn) != 0) job.job.stop = true;
  };
}

// A stop request counts once. When a task ends, the request was fulfilled or came too late. A
// run in pieces drops it where it stops, and obeys a new one that comes between two pieces.
struct Obeyed {
  Job& job;
  ~Obeyed() {
    if (!job.rest) job.stop = false;
  }
};

}  // namespace
}  // namespace wythe::api

using wythe::api::guarded;

int wythe_interface(void) { return WYTHE_INTERFACE; }

const char* wythe_version(void) {
  static const std::string kVersion = wythe::provenance_text();
  return kVersion.c_str();
}

wythe_job* wythe_new(const char* task) {
  try {
    auto job = std::make_unique<wythe_job>();
    job->job.task = task == nullptr ? "" : task;
    return job.release();
  } catch (...) {
    return nullptr;
  }
}

void wythe_free(wythe_job* job) { delete job; }

int wythe_set_text(wythe_job* job, const char* name, const char* text, size_t size) {
  if (job == nullptr || name == nullptr || (text == nullptr && size > 0)) return WYTHE_BAD_INPUT;
  return guarded(*job, [&] {
    job->job.rest = nullptr;
    std::vector<std::string>& texts = job->job.in.text[name];
    const std::string_view list = name;
    if (list != "set" && list != "path" && list != "unit" && list != "only" && list != "record")
      texts.clear();
    texts.emplace_back(text == nullptr ? "" : text, size);
    return WYTHE_DONE;
  });
}

int wythe_set_number(wythe_job* job, const char* name, double value) {
  if (job == nullptr || name == nullptr) return WYTHE_BAD_INPUT;
  return guarded(*job, [&] {
    job->job.rest = nullptr;
    job->job.in.number[name] = value;
    return WYTHE_DONE;
  });
}

int wythe_set_column(wythe_job* job, const char* name, const double* values, size_t rows) {
  if (job == nullptr || name == nullptr || (values == nullptr && rows > 0)) return WYTHE_BAD_INPUT;
  return guarded(*job, [&] {
    job->job.rest = nullptr;
    job->job.in.column[name].assign(values, values + rows);
    return WYTHE_DONE;
  });
}

int wythe_do(wythe_job* job, wythe_progress progress, void* context) {
  if (job == nullptr) return WYTHE_BAD_INPUT;
  return guarded(*job, [&] {
    job->job.out.clear();
    job->job.progress = wythe::api::listener(*job, progress, context);
    const auto rest = std::exchange(job->job.rest, nullptr);
    const wythe::api::Obeyed obeyed{job->job};
    const bool stopped = rest ? rest(job->job) : wythe::api::do_task(job->job);
    return stopped ? WYTHE_STOPPED : WYTHE_DONE;
  });
}

void wythe_stop(wythe_job* job) {
  if (job != nullptr) job->job.stop = true;
}

const char* wythe_text(wythe_job* job, const char* name, size_t* size) {
  if (job == nullptr || name == nullptr) return nullptr;
  const std::string* text = nullptr;
  const std::string_view asked = name;
  if (asked == "error") {
    text = &job->error;
  } else if (asked == "faults") {
    text = &job->faults;
  } else {
    constexpr std::string_view kColumnsOf = "columns of ";
    (void)guarded(*job, [&] {
      const bool columns = asked.starts_with(kColumnsOf);
      if (asked == "tables") job->made = job->job.out.tables_json();
      if (asked == "texts") job->made = job->job.out.texts_json();
      if (columns) job->made = job->job.out.columns_json(name + kColumnsOf.size());
      const bool made = asked == "tables" || asked == "texts" || (columns && !job->made.empty());
      text = made ? &job->made : columns ? nullptr : job->job.out.text(name);
      return WYTHE_DONE;
    });
  }
  if (text == nullptr) return nullptr;
  if (size != nullptr) *size = text->size();
  return text->c_str();
}

const double* wythe_column(wythe_job* job, const char* table, const char* column, size_t* rows) {
  if (job == nullptr || table == nullptr || column == nullptr) return nullptr;
  const std::vector<double>* values = nullptr;
  (void)guarded(*job, [&] {
    values = job->job.out.column(table, column);
    return WYTHE_DONE;
  });
  static const double kNone = 0;  // for a column without rows, which must not be NULL
  if (values == nullptr) return nullptr;
  if (rows != nullptr) *rows = values->size();
  return values->empty() ? &kNone : values->data();
}
