// _wythe: the C interface (wythe/c.h) as a Python class. All that users see is written in Python on it.
//
// A job works in a thread of its own without the interpreter's lock. The calling thread waits, hands progress
// on, and looks for Ctrl-C, so that a signal reaches Python within a moment and the job is stopped with what it
// has done kept.
#include <pybind11/pybind11.h>
#include <signal.h>

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "wythe/c.h"

namespace py = pybind11;

namespace {

// The numbers of one column, where they lie; keeps the job that owns them.
struct Column {
  std::shared_ptr<wythe_job> job;
  const double* values = nullptr;
  py::ssize_t rows = 0;
};

struct News {
  std::string what;
  double share = 0, displacement = 0, force = 0;
};

// Lets Python's own handler hear Ctrl-C, and afterwards the one that was there. Some libraries (OpenTURNS) put one in
// its place that throws out of the signal, which ends an interpreter whose lock is free. In other threads than the main
// one Python changes no handlers, and none is called.
class PythonHearsInterrupts {
 public:
  PythonHearsInterrupts() {
    sigaction(SIGINT, nullptr, &before_);
    try {
      const py::object signals = py::module_::import("signal"), number = signals.attr("SIGINT");
      const py::object handler = signals.attr("getsignal")(number);
      if (PyCallable_Check(handler.ptr()) != 0) signals.attr("signal")(number, handler);
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_ValueError)) throw;
    }
  }
  ~PythonHearsInterrupts() { sigaction(SIGINT, &before_, nullptr); }
  PythonHearsInterrupts(const PythonHearsInterrupts&) = delete;
  PythonHearsInterrupts& operator=(const PythonHearsInterrupts&) = delete;

 private:
  struct sigaction before_ {};
};

class Job {
 public:
  explicit Job(const std::string& task) : job_(wythe_new(task.c_str()), wythe_free) {
    if (!job_) throw std::bad_alloc();
  }

  int set_text(const std::string& name, const std::string& text) {
    check_idle();
    return wythe_set_text(job_.get(), name.c_str(), text.data(), text.size());
  }
  int set_number(const std::string& name, double value) {
    check_idle();
    return wythe_set_number(job_.get(), name.c_str(), value);
  }
  int set_column(const std::string& name, const py::buffer& values) {
    check_idle();
    const py::buffer_info info = values.request();
    if (info.ndim != 1 || info.format != py::format_descriptor<double>::format() ||
        (info.size > 1 && info.strides[0] != sizeof(double)))
      throw py::type_error(name + " must be a contiguous list of float64 numbers");
    return wythe_set_column(job_.get(), name.c_str(), static_cast<const double*>(info.ptr),
                            static_cast<size_t>(info.size));
  }

  // The code of wythe_do, and the exception that stopped it (Ctrl-C, or one of `progress`), or None.
  std::pair<int, py::object> perform(const py::object& progress) {
    check_idle();
    const PythonHearsInterrupts hears;
    busy_ = true;
    ended_ = false;
    int code = WYTHE_DEFECT;
    std::thread worker([&] {
      const int answer = wythe_do(job_.get(), &Job::hear, this);
      const std::lock_guard lock(mutex_);
      code = answer;
      ended_ = true;
      changed_.notify_one();
    });
    py::object raised = py::none();
    while (true) {
      std::optional<News> news;
      bool ended = false;
      {
        const py::gil_scoped_release release;
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, kLookEvery, [&] { return ended_ || news_; });
        news.swap(news_);
        ended = ended_;
      }
      if (ended) break;
      if (!raised.is_none()) continue;  // stopped already: wait for the end
      try {
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
        if (news && !progress.is_none())
          progress(news->what, news->share, news->displacement, news->force);
      } catch (py::error_already_set& error) {
        raised = error.value();
        wythe_stop(job_.get());
      }
    }
    worker.join();
    busy_ = false;
    return {code, raised};
  }

  [[nodiscard]] py::object text(const std::string& name) {
    check_idle();
    size_t size = 0;
    const char* text = wythe_text(job_.get(), name.c_str(), &size);
    if (text == nullptr) return py::none();
    // a path in a message need not be UTF-8
    PyObject* decoded = PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(size), "replace");
    if (decoded == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(decoded);
  }

  [[nodiscard]] std::optional<Column> column(const std::string& table, const std::string& name) {
    check_idle();
    size_t rows = 0;
    const double* values = wythe_column(job_.get(), table.c_str(), name.c_str(), &rows);
    if (values == nullptr) return std::nullopt;
    return Column{job_, values, static_cast<py::ssize_t>(rows)};
  }

 private:
  void check_idle() const {
    if (busy_) throw std::runtime_error("this job is at work in another thread");
  }

  static int hear(void* context, const char* what, double share, double displacement,
                  double force) {
    Job& job = *static_cast<Job*>(context);
    const std::lock_guard lock(job.mutex_);
    job.news_ = News{what, share, displacement, force};
    job.changed_.notify_one();
    return 0;
  }

  static constexpr auto kLookEvery = std::chrono::milliseconds(50);
  std::shared_ptr<wythe_job> job_;
  bool busy_ = false;  // read and written with the interpreter's lock
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::optional<News> news_;
};

}  // namespace

PYBIND11_MODULE(_wythe, m) {
  m.doc() = "The C interface of wythe (include/wythe/c.h). Use the package wythe.";
  m.attr("interface") = wythe_interface();
  m.attr("version") = wythe_version();
  py::class_<Column>(m, "Column", py::buffer_protocol())
      .def_buffer([](const Column& c) {
        return py::buffer_info(const_cast<double*>(c.values), sizeof(double),
                               py::format_descriptor<double>::format(), 1, {c.rows},
                               {static_cast<py::ssize_t>(sizeof(double))}, true);
      })
      .def("__len__", [](const Column& c) { return c.rows; });
  py::class_<Job>(m, "Job")
      .def(py::init<const std::string&>(), py::arg("task"))
      .def("set_text", &Job::set_text, py::arg("name"), py::arg("text"))
      .def("set_number", &Job::set_number, py::arg("name"), py::arg("value"))
      .def("set_column", &Job::set_column, py::arg("name"), py::arg("values"))
      .def("perform", &Job::perform, py::arg("progress"))
      .def("text", &Job::text, py::arg("name"))
      .def(
          "column",
          [](Job& job, const std::string& table, const std::string& name) -> py::object {
            std::optional<Column> column = job.column(table, name);
            return column ? py::cast(std::move(*column)) : py::none();
          },
          py::arg("table"), py::arg("name"));
}
