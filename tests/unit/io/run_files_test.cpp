// write_run, prepare_folder and the texts that they write, on an artificial run.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/files.h"
#include "io/results/curve_csv.h"
#include "io/results/vtu.h"
#include "scenes/sample_run.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"

namespace wythe::run_files_test {
namespace {

namespace fs = std::filesystem;

// A fresh folder for one test, removed at its end.
class RunFiles : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "wythe_files_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    std::ostringstream all;
    all << file.rdbuf();
    return all.str();
  }
  void write_sample() const {
    write_run(folder_.string(), scenes::sample_spec(), scenes::sample_model(),
              scenes::sample_result());
  }

  fs::path folder_;
};

// The message of an IoError; "" if nothing was thrown.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CurveCsv, columns_carry_their_units_and_values) {
  const std::string csv = io::curve_csv(scenes::sample_result().curve);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "time_s,displacement_mm,drift_percent,reaction_kN,base_shear_kN,unbalance_ratio,"
            "kinetic_ratio,work_drive_J,work_damping_J,load_factor");
  EXPECT_TRUE(has(csv, "\n0.2,2,1.333333333,10,9.9,0.0001,0.001,0,0,0\n")) << csv;
}

TEST(SummaryJson, numbers_are_in_the_units_of_their_names) {
  const auto json =
      nlohmann::json::parse(summary_json(scenes::sample_model(), scenes::sample_result()));
  EXPECT_EQ(json["status"], "completed");
  EXPECT_DOUBLE_EQ(json["peak_reaction_kN"], 10);
  EXPECT_DOUBLE_EQ(json["displacement_at_peak_mm"], 2);
  EXPECT_DOUBLE_EQ(json["displacement_at_80_percent_mm"], 6);
  EXPECT_DOUBLE_EQ(json["displacement_max_mm"], 10);
  EXPECT_DOUBLE_EQ(json["initial_stiffness_kN_per_mm"], 5);
  EXPECT_EQ(json["censored"], false);
  EXPECT_EQ(json["censored_max"], true);
  EXPECT_EQ(json["blocks"], 2);
  EXPECT_EQ(json["points"], 4);
  EXPECT_EQ(json["provenance"]["spec_hash"], "0000000000abcdef");
  for (const char* key : {"version", "commit", "compiler", "flags"})
    EXPECT_FALSE(json["provenance"][key].get<std::string>().empty()) << key;
}

TEST(SummaryJson, lists_stay_lists_of_objects) {
  const auto json =
      nlohmann::json::parse(summary_json(scenes::sample_model(), scenes::sample_result()));
  EXPECT_EQ(json["failure_mode"]["name"], "FM-1");
  EXPECT_DOUBLE_EQ(json["failure_mode"]["scores"]["FM-1"], 0.8);
  EXPECT_EQ(json["failure_mode"]["evidence"][0]["unit"], "mm");
  EXPECT_EQ(json["events"][0]["name"], "first crack");
  EXPECT_EQ(json["stages"][0]["steps"], 4000);
  EXPECT_DOUBLE_EQ(json["energy_J"]["friction"], 60);
}

TEST(SummaryJson, what_is_no_number_is_null) {
  const auto json =
      nlohmann::json::parse(summary_json(scenes::sample_model(), scenes::sample_result()));
  EXPECT_TRUE(json["energy_J"]["gap_ratio"].is_null());
}

TEST_F(RunFiles, all_files_of_the_contract_are_there_and_no_others) {
  write_sample();
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"elements.csv", "force_displacement.csv",
                                             "model.used.toml", "run.pvd", "state_blocks_00.vtu",
                                             "state_blocks_01.vtu", "state_joints_00.vtu",
                                             "state_joints_01.vtu", "summary.json"}));
}

TEST_F(RunFiles, series_lists_blocks_and_joints_with_displacement_as_time) {
  write_sample();
  const std::string pvd = text("run.pvd");
  EXPECT_TRUE(has(pvd, "timestep=\"10\" part=\"1\" name=\"joints\" file=\"state_joints_01.vtu\""))
      << pvd;
}

TEST_F(RunFiles, all_of_an_earlier_run_is_replaced) {
  write_sample();
  for (const char* name : {"state_blocks_07.vtu", "report.html", "report.data", "blocks.json"})
    std::ofstream(path(name)) << "old";
  const std::string before = text("summary.json");
  {
    const auto dropped = replace_run(folder_.string());
    std::ofstream(dropped->path() + "/summary.json") << "half";
  }
  EXPECT_EQ(text("summary.json"), before);
  EXPECT_TRUE(fs::exists(path("state_blocks_07.vtu")));
  const auto results = replace_run(folder_.string());
  EXPECT_TRUE(
      has(refusal([&] { (void)replace_run(folder_.string()); }), "another wythe is writing"));
  std::ofstream(results->path() + "/summary.json") << "new";
  results->commit();
  EXPECT_EQ(text("summary.json"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

// Killed at every point of a commit: old results only, or new ones only; the next command has the rest.
TEST_F(RunFiles, a_commit_that_is_killed_never_mixes_two_runs) {
  struct Killed {};
  const auto files = [&] {
    std::string all;
    for (const char* name : {"force_displacement.csv", "report.html", "summary.json"})
      if (fs::exists(path(name))) all += text(name) + " ";
    return all;
  };
  for (const char* point :
       {"results written", "results ready", "results removed", "results moving"}) {
    for (const char* name : {"force_displacement.csv", "report.html", "summary.json"})
      std::ofstream(path(name)) << "old";
    {
      const auto results = replace_run(folder_.string());
      for (const char* name : {"force_displacement.csv", "report.html", "summary.json"})
        std::ofstream(results->path() + "/" + name) << "new";
      EXPECT_THROW(results->commit([&](const char* at) {
        if (std::string(at) == point) throw Killed();
      }),
                   Killed);
    }
    const std::string left = files();
    EXPECT_FALSE(has(left, "old") && has(left, "new")) << point << ": " << left;
    finish_replacement(folder_.string());
    EXPECT_EQ(files(), std::string(point) == "results written" ? "old old old " : "new new new ");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 3) << point;
  }
}

TEST_F(RunFiles, a_folder_of_other_things_is_refused_untouched) {
  const auto said = [&] {
    try {
      (void)replace_run(folder_.string());
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said(), "");  // empty
  for (const char* name : {"model.toml", "blocks.json", "report.html", "notes.txt"}) {
    std::ofstream(path(name)) << "mine";
    EXPECT_TRUE(has(said(), std::string("holds ") + name + ", which no run wrote")) << said();
    EXPECT_EQ(text(name), "mine");
    fs::remove(path(name));
  }
  write_sample();
  EXPECT_EQ(said(), "");
  std::ofstream(path("limit.html")) << "another command's";
  std::ofstream(path("model.toml")) << "mine";
  EXPECT_TRUE(has(said(), "holds limit.html and 1 more")) << said();
  EXPECT_TRUE(fs::exists(path("summary.json")));
}

TEST_F(RunFiles, a_missing_folder_is_made_with_its_parents) {
  prepare_folder(path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(path("a/b/c")));
  EXPECT_TRUE(fs::is_empty(path("a/b/c")));  // the probe is gone
}

TEST_F(RunFiles, a_folder_that_is_a_file_is_refused_by_name) {
  std::ofstream(path("out")) << "x";
  const std::string said = refusal([&] { prepare_folder(path("out")); });
  EXPECT_TRUE(has(said, path("out")) && has(said, "is a file")) << said;
}

TEST_F(RunFiles, a_path_through_a_file_is_refused) {
  std::ofstream(path("out")) << "x";
  const std::string said = refusal([&] { prepare_folder(path("out/deeper")); });
  EXPECT_TRUE(has(said, "Not a directory")) << said;
}

TEST_F(RunFiles, an_unwritable_folder_is_refused_with_the_cause) {
  if (::geteuid() == 0) {
    // root writes anywhere but into the kernel's own folders
    EXPECT_TRUE(has(refusal([] { prepare_folder("/proc/self"); }), "/proc/self"));
    return;
  }
  fs::permissions(folder_, fs::perms::owner_read | fs::perms::owner_exec);
  const std::string said = refusal([&] { prepare_folder(folder_.string()); });
  fs::permissions(folder_, fs::perms::owner_all);
  EXPECT_TRUE(has(said, "Permission denied")) << said;
}

TEST_F(RunFiles, a_write_that_breaks_off_leaves_the_old_file_and_no_scraps) {
  write_file(path("a.txt"), "old");
  // a file size limit fails in the middle of the write, as a full disk does
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small = {.rlim_cur = 4096, .rlim_max = before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string said = refusal([&] { write_file(path("a.txt"), std::string(100000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(has(said, "a.txt") && has(said, "File too large")) << said;
  EXPECT_EQ(text("a.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST(Vtu, values_that_are_no_numbers_survive) {
  Model model = scenes::sample_model();
  State state = scenes::sample_state();
  state.theta[1] = kUnset;
  const std::string vtu = io::blocks_vtu(model, state);
  EXPECT_FALSE(has(vtu, "nan"));
  EXPECT_TRUE(has(vtu, "NumberOfCells=\"2\""));
}

}  // namespace
}  // namespace wythe::run_files_test
