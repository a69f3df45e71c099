// Records, pulses and spectra; the files of records and their faults; inputs and results of a shake.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <utility>

#include "model/shaking.h"
#include "scenes/places.h"
#include "scenes/scenes.h"
#include "unit/io_helpers.h"
#include "wythe/parts/solve.h"

namespace wythe::shaking_test {
namespace {

namespace fs = std::filesystem;

// --- motions ----------------------------------------------------------------------------------------------

TEST(GroundMotion, integrates_what_is_linear_between_samples_exactly) {
  // a = t up to 1 s, then down to 0 at 3 s
  const GroundMotion m = ground_motion({0, 1, 3}, {0, 1, 0});
  EXPECT_DOUBLE_EQ(m.velocity_at(1), 0.5);
  EXPECT_DOUBLE_EQ(m.displacement_at(1), 1.0 / 6);
  EXPECT_DOUBLE_EQ(m.velocity_at(3), 1.5);
  // 1/6 + 1/2 2 + integral over 2 s of (s - s^2/4) = 1/6 + 1 + 2 - 2/3
  EXPECT_DOUBLE_EQ(m.displacement_at(3), 1.0 / 6 + 1 + 2 - 2.0 / 3);
  EXPECT_DOUBLE_EQ(m.acceleration_at(2), 0.5);
  EXPECT_DOUBLE_EQ(m.velocity_at(5), 1.5);
  EXPECT_DOUBLE_EQ(m.displacement_at(5), m.displacement_at(3) + 3);
  EXPECT_EQ(m.acceleration_at(5), 0);
  EXPECT_EQ(m.velocity_at(-1), 0);
}

TEST(GroundMotion, finds_the_peak_velocity_between_samples) {
  const GroundMotion m = ground_motion({0, 1}, {1, -1});  // v = t - t^2
  EXPECT_DOUBLE_EQ(peak_velocity(m), 0.25);
  EXPECT_EQ(m.velocity.back(), 0);
}

TEST(GroundMotion, has_the_arias_intensity_of_its_squares) {
  const GroundMotion m = ground_motion({0, 2}, {3, 3});
  EXPECT_NEAR(arias_intensity(m), M_PI / (2 * 9.80665) * 18, 1e-12);
}

// A step of the acceleration: u = a (1 - cos wt)/w^2, damped a (1 + exp(-pi xi/root)).
TEST(GroundMotion, spectra_are_those_of_closed_forms) {
  const GroundMotion step = ground_motion({0, 5}, {2, 2});
  const double w = 2 * M_PI / 0.7;
  EXPECT_NEAR(spectral_displacement(step, 0.7, 0), 2 * 2 / (w * w), 2e-5 * 4 / (w * w));
  const double xi = 0.05, over = std::exp(-M_PI * xi / std::sqrt(1 - xi * xi));
  EXPECT_NEAR(spectral_displacement(step, 0.7, xi), 2 * (1 + over) / (w * w), 1e-3 / (w * w));
  // a stiff one follows the ground, a soft one stands still
  const GroundMotion hat = ground_motion({0, 0.25, 0.5, 0.75, 1}, {0, 3, 0, -3, 0});
  EXPECT_NEAR(pseudo_acceleration(hat, 0.01, 0.05), 3, 0.03);
  EXPECT_NEAR(spectral_displacement(hat, 1e3, 0.05), std::fabs(hat.displacement.back()),
              0.02 * hat.displacement.back());
}

TEST(GroundMotion, the_sum_of_two_has_the_samples_of_both) {
  const GroundMotion a = ground_motion({0, 2}, {0, 2}), b = ground_motion({0, 1, 2}, {0, 1, 0});
  const GroundMotion sum = combined(a, b, -1);
  EXPECT_EQ(sum.time, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(sum.acceleration, (std::vector<double>{0, 0, 2}));
  EXPECT_NEAR(sum.displacement_at(2), a.displacement_at(2) - b.displacement_at(2), 1e-15);
}

// The base goes on shaking when the record of the floor is over, which ends with an acceleration.
TEST(GroundMotion, the_sum_of_two_of_different_length_is_that_of_their_ways) {
  const GroundMotion a = ground_motion({0, 0.5, 1}, {0, 2, 3}),
                     b = ground_motion({0, 0.4, 2}, {1, -1, 0.5});
  for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
    const GroundMotion sum = combined(one, other, -1);
    for (const double t : {0.3, 0.99, 1.01, 1.5, 2.0, 2.5}) {
      EXPECT_NEAR(sum.displacement_at(t), one.displacement_at(t) - other.displacement_at(t), 1e-12);
      EXPECT_NEAR(sum.velocity_at(t), one.velocity_at(t) - other.velocity_at(t), 1e-12);
    }
  }
}

TEST(GroundMotion, restitution_and_fraction_belong_together) {
  EXPECT_NEAR(fraction_of_restitution(1), 0, 1e-12);
  EXPECT_NEAR(fraction_of_restitution(std::exp(-2.0)), 1, 1e-6);
  // psi = 30 degrees: exp(-tan 30 (pi - pi/3))
  EXPECT_NEAR(fraction_of_restitution(std::exp(-std::tan(M_PI / 6) * 2 * M_PI / 3)), 0.5, 1e-9);
  // xi = 2 gives exp(-2/1.7321 ln(3.7321/0.2679)) = 0.04777, so 0.23 % of the energy
  for (const double less : {0.0, 0.0477}) EXPECT_EQ(fraction_of_restitution(less), 2);
  EXPECT_LT(fraction_of_restitution(0.0479), 2);
}

TEST(Shake, storeys_whose_top_no_block_holds_are_named) {
  ModelSpec spec = read_model(source_dir() + "/tests/data/shaken_storeys.toml");
  Model model = compile(spec);
  const auto told = [&] {
    model.anatomy.notes.clear();
    note_storeys_without_top(model);
    return model.anatomy.notes.empty() ? "" : text_of(model.anatomy.notes.front());
  };
  EXPECT_EQ(told(), "");
  model.anatomy.storey_top.back() += 0.3;
  EXPECT_NE(told().find("storey first"), std::string::npos) << told();
}

// --- files ------------------------------------------------------------------------------------------------

class RecordFile : public ::testing::Test {
 protected:
  RecordFile() {
    fs::create_directories(folder_);
    model_ = io_tests::kModel.substr(0, io_tests::kModel.find("[[stage]]\nname = \"push\""));
    const std::string density = "density = \"1250 kg/m^3\"\n";
    model_.insert(model_.find(density) + density.size(), "split = \"none\"\n");
    const std::string timber = "density = \"600 kg/m^3\"\n";
    model_.insert(model_.find(timber) + timber.size(),
                  "youngs_modulus = \"10 GPa\"\nshear_modulus = \"0.6 GPa\"\n");
  }
  ~RecordFile() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  // The model with a shake of these lines.
  [[nodiscard]] ModelSpec parse(const std::string& lines) const {
    return parse_model(model_ + "[[stage]]\nname = \"quake\"\n" + lines,
                       (folder_ / "model.toml").string());
  }
  [[nodiscard]] std::string refusal(const std::string& lines) const {
    try {
      const ModelSpec spec = parse(lines);
      static_cast<void>(compile(spec));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  static void says(const std::string& text, std::initializer_list<const char*> words) {
    for (const char* word : words)
      EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" is not in:\n" << text;
  }

  fs::path folder_ = fs::temp_directory_path() / ("wythe_records_" + std::to_string(getpid()));
  std::string model_;
};

const char* const kCsv = "# made up\ntime_s,ns,ew\n0,0,0.1\n0.01,0.2,0.1\n0.02,-0.1,0.1\n";

TEST_F(RecordFile, csv_is_read_by_its_head) {
  write("a.csv", kCsv);
  const ModelSpec spec =
      parse("record = { file = \"a.csv\", unit = \"g\", column = \"ns\", direction = \"-x\" }\n");
  ASSERT_EQ(spec.stage.back().get<ShakeStage>().record.size(), 1U);
  const RecordSpec& r = spec.stage.back().get<ShakeStage>().record.front();
  EXPECT_EQ(spec.stage.back().kind(), StageKind::kShake);
  EXPECT_EQ(r.read_times, (std::vector<double>{0, 0.01, 0.02}));
  EXPECT_DOUBLE_EQ(r.read_accelerations[1], 0.2 * 9.81);
  const Model model = compile(spec);
  EXPECT_EQ(model.stages.back().base.front().along.x, -1);
  EXPECT_EQ(model.stages.back().spec.damping, 0);  // no local damping unless asked for
}

TEST_F(RecordFile, at2_is_read_by_its_head) {
  write("a.AT2",
        "PEER NGA\nsomewhere\nACCELERATION TIME SERIES IN UNITS OF G\n"
        "NPTS=      5, DT=   .0050 SEC,\n  .1E-01  -.2\n .3 .4\n .5\n");
  const ModelSpec spec = parse("record = [{ file = \"a.AT2\", unit = \"g\" }]\n");
  const RecordSpec& r = spec.stage.back().get<ShakeStage>().record.front();
  ASSERT_EQ(r.read_times.size(), 5U);
  EXPECT_DOUBLE_EQ(r.read_times[4], 0.02);
  EXPECT_DOUBLE_EQ(r.read_accelerations[1], -0.2 * 9.81);
}

// A step that is stated beside a column of times does not make the times the motion.
TEST_F(RecordFile, the_second_of_two_columns_is_the_motion) {
  const std::vector<double> expected = {0.1 * 9.81, 0.2 * 9.81, -0.1 * 9.81};
  for (const char* head : {"Time(s),Acc(g)\n", "seconds,acc\n", "when,a\n", ""})
    for (const char* step : {"", ", step = \"0.01 s\""}) {
      write("a.csv", std::string(head) + "0,0.1\n0.01,0.2\n0.02,-0.1\n");
      const std::string lines =
          std::string("record = { file = \"a.csv\", unit = \"g\"") + step + " }\n";
      EXPECT_EQ(parse(lines).stage.back().get<ShakeStage>().record.front().read_accelerations,
                expected)
          << head << step;
    }
}

TEST_F(RecordFile, units_of_at2_are_told_apart) {
  const auto file = [&](const char* unit) {
    write("a.AT2", std::string("PEER NGA\nsomewhere\nACCELERATION TIME SERIES IN UNITS OF ") +
                       unit + "\nNPTS=      3, DT=   .0050 SEC,\n  .1E-01  -.2\n .3\n");
  };
  const char* const kAsked = "record = [{ file = \"a.AT2\", unit = \"g\" }]\n";
  for (const char* unit : {"G", "g", "G  "}) {
    file(unit);
    EXPECT_NO_THROW(static_cast<void>(parse(kAsked))) << unit;
  }
  for (const char* unit : {"GAL", "CM/S/S", "cm/sec2"}) {
    file(unit);
    says(refusal(kAsked), {"the model file states another", "cm/s2"});
  }
  file("M/S2");
  says(refusal(kAsked), {"the model file states another", "\"m/s2\""});
  for (const char* scaled : {"G X 10", "G x10", "G * 100", "CM/S2 x 10", "0.01 G", "PERCENT G"}) {
    file(scaled);
    says(refusal(kAsked), {"a.AT2:3", "is no unit of accelerations"});
  }
  for (const char* head : {"(CM/S2)", ", cm/sec2", "IN GAL"}) {
    write("a.AT2", std::string("PEER\nx\nACCELERATION TIME SERIES ") + head +
                       "\nNPTS= 3, DT= .0050 SEC,\n .1 -.2 .3\n");
    says(refusal(kAsked), {"a.AT2:3", "the model file states another", "cm/s2"});
  }
  file("FURLONGS");
  says(refusal(kAsked), {"is no unit of accelerations"});
}

// A head may say what the numbers are; one that says something else than the model is refused.
TEST_F(RecordFile, units_in_the_head_of_a_csv_are_compared) {
  const auto told = [&](const char* head, const char* unit) {
    write("a.csv", std::string(head) + "\n0,0.1\n0.01,0.2\n0.02,-0.1\n");
    return refusal(std::string("record = { file = \"a.csv\", unit = \"") + unit + "\" }\n");
  };
  for (const char* head : {"time_s,acceleration_g", "t,a (g)", "time,north", "time,acc"})
    EXPECT_EQ(told(head, "g"), "accepted") << head;
  for (const char* head : {"time_s,acc_m_s2", "t [s],a [m/s^2]"}) {
    EXPECT_EQ(told(head, "m/s2"), "accepted") << head;
    says(told(head, "g"), {"a.csv:1", "the model file states another", "\"m/s2\""});
  }
  says(told("time,a [cm/s2]", "m/s2"), {"the model file states another", "\"cm/s2\""});
  says(told("time,acceleration_g", "m/s2"), {"the model file states another", "\"g\""});
  says(told("time_ms,acc", "g"), {"time_ms", "not in seconds"});
  says(told("t [ms],acc", "g"), {"not in seconds"});
  says(told("time,velocity_cm_s", "cm/s2"), {"is no column of accelerations"});
  write("v.AT2",
        "PEER NGA\nx\nVELOCITY TIME HISTORY IN UNITS OF CM/S\nNPTS= 3, DT= .0050 SEC,\n 1 2 3\n");
  says(refusal("record = [{ file = \"v.AT2\", unit = \"cm/s2\" }]\n"), {"is a unit of velocities"});
}

// A motion of 0.2 g whose numbers can't be taken for others.
const double kMotion[] = {0, 98.1, -196.2, 49.05};  // [cm/s2]

// As the file that `row` writes, one line for each time and acceleration, under `head`.
std::string motion(const std::string& head, const std::function<std::string(int, double)>& row) {
  std::string text = head;
  for (int k = 0; k < 4; ++k) text += row(k, kMotion[k]) + "\n";
  return text;
}

TEST_F(RecordFile, tables_are_read_whatever_stands_between_their_cells) {
  const auto with = [](const char* format) {
    return [format](int k, double a) {
      std::string text = fmt::format(fmt::runtime(format), 0.5 * k, a);
      if (std::string(format).find(';') != std::string::npos)
        std::replace(text.begin(), text.end(), '.', ',');
      return text;
    };
  };
  const std::pair<std::string, std::function<std::string(int, double)>> files[] = {
      {"time;acc\n", with("{:.2f};{:.3f}")},
      {"\"Zeit (s)\";\"acc (cm/s2)\"\n", with("{:.2f};{:.3f}")},
      {"t [s]\tacc [cm/s^2]\n", with("{:.2f}\t{:.3f}")},
      {"t [s]   acc [cm/s^2]\n", with("  {:.2f}   {:.3f}")},
      {"", with("{:.2f} {:.3f}")},
      {"\xEF\xBB\xBFtime, acc\r\n", with("\"{:.2f}\", \"{:.3f}\"\r")},
      {"# time acc_cm_s2\n", with("{:.2f} {:.3f}")},
      {"time,acc\n", with("{:.2f},{:.3f},")}};
  for (const auto& [head, row] : files) {
    write("a.csv", motion(head, row));
    const RecordSpec read = parse("record = { file = \"a.csv\", unit = \"cm/s2\" }\n")
                                .stage.back()
                                .get<ShakeStage>()
                                .record.front();
    ASSERT_EQ(read.read_accelerations.size(), 4U) << head;
    for (int k = 0; k < 4; ++k) {
      EXPECT_DOUBLE_EQ(read.read_accelerations[k], kMotion[k] / 100) << head;
      EXPECT_DOUBLE_EQ(read.read_times[k], 0.5 * k) << head;
    }
  }
}

TEST_F(RecordFile, decimal_commas_are_read_or_refused_and_never_cut) {
  const char* const kRecord =
      "record = { file = \"a.csv\", unit = \"cm/s2\", step = \"0.05 s\" }\n";
  for (const char* text : {"time,acc\n0,00,0,1\n0,05,0,2\n0,10,0,1\n",  // four cells
                           "0,0000\n0,0936\n0,2616\n", "acc\n0,0000\n0,0936\n0,2616\n",
                           "time;acc\n0,00;0.1\n0,05;0.2\n0,10;0.1\n",
                           "time;acc\n0,00;1.000,5\n0,05;0,2\n0,10;0,1\n"}) {
    write("a.csv", text);
    EXPECT_NE(refusal(kRecord), "accepted") << text;
  }
}

TEST_F(RecordFile, the_column_is_the_one_that_is_named_as_an_acceleration) {
  const auto row = [](int k, double a) {
    return fmt::format("{},{:.2f},{},{}", k, 0.5 * k, a / 10, a);
  };
  const auto peak = [&](const std::string& head, const std::string& more = "") {
    write("a.csv", motion(head + "\n", row));
    const RecordSpec read = parse("record = { file = \"a.csv\", unit = \"cm/s2\"" + more + " }\n")
                                .stage.back()
                                .get<ShakeStage>()
                                .record.front();
    return *std::min_element(read.read_accelerations.begin(), read.read_accelerations.end());
  };
  for (const char* head : {",time_s,vel,acc", "n,t,v_cm_s,a_cm_s2", "Unnamed: 0,time,d,a",
                           "index,Time (s),u [cm],acceleration", "row,t [s],disp,ax",
                           ",t,x (cm/s),y (cm/s^2)", "i,time,north,ns_acc"})
    EXPECT_DOUBLE_EQ(peak(head), -1.962) << head;
  EXPECT_DOUBLE_EQ(peak(",time,ax,ay", ", column = \"ay\""), -1.962);
  EXPECT_DOUBLE_EQ(peak(",time,ax,ay", ", column = \"4\""), -1.962);
  for (const char* head :
       {",time,ax,ay", ",time,north,east", ",time,v,d", ",time,vel,disp", ",time,up,east"}) {
    write("a.csv", motion(std::string(head) + "\n", row));
    says(refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n"), {"column", "time"});
  }
  says(refusal("record = { file = \"a.csv\", unit = \"cm/s2\", column = \"acc\" }\n"),
       {"is no column of accelerations", "time, up, east"});
  write("a.csv", motion("", row));
  says(refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n"), {"column", "1 to 4"});
}

TEST_F(RecordFile, row_numbers_and_times_are_no_accelerations) {
  const auto told = [&](const std::string& head, const std::string& keys) {
    std::string text = head;
    for (int k = 0; k < 9; ++k) text += fmt::format("{},{:.2f}\n", k, 0.05 * k);
    write("a.csv", text);
    return refusal("record = { file = \"a.csv\", unit = \"cm/s2\"" + keys + " }\n");
  };
  says(told("", ""), {"rises evenly"});
  says(told("x,north\n", ""), {"rises evenly"});
  says(told("time,north\n", ""), {"rises evenly"});
  write("a.csv", "0\n1\n2\n3\n4\n5\n");
  says(refusal("record = { file = \"a.csv\", unit = \"cm/s2\", step = \"1 s\" }\n"),
       {"rises evenly"});
}

// Row numbers, milliseconds, frames: what rises by more than half a second a row is no time unless the head says so.
TEST_F(RecordFile, row_numbers_are_no_times) {
  const auto file = [&](const std::string& head, double first, double step) {
    std::string text = head;
    for (int k = 0; k < 9; ++k) text += fmt::format("{:g},{}\n", first + step * k, k % 3 - 0.7);
    write("a.csv", text);
  };
  const auto told = [&](const std::string& keys) {
    return refusal("record = { file = \"a.csv\", unit = \"cm/s2\"" + keys + " }\n");
  };
  const char* const kStep = ", step = \"0.05 s\"";
  for (const char* head : {"X,acc\n",
                           "frame,acc\n",
                           "count,acc\n",
                           "counter,acc\n",
                           "rownames,acc\n",
                           "Nr.,acc\n",
                           "N°,acc\n",
                           "Lfd. Nr.,acc\n",
                           "TIME_STEP,acc\n",
                           "timestep,acc\n",
                           "t_index,acc\n",
                           "time index,acc\n",
                           "t,acc\n",
                           "time,acc\n",
                           "when,north\n",
                           "\"\",acc\n",
                           "tick,acc\n",
                           "frame_s,acc\n",
                           "step_s,acc\n",
                           "time x 0.05 s,acc\n",
                           "time (s) index,acc\n",
                           "seconds_x10,acc\n",
                           "time milli seconds,acc\n",
                           ""})
    for (const double first : {0.0, 1.0, 500.0})
      for (const double step : {1.0, 50.0}) {
        file(head, first, step);
        says(told(""), {"step: is missing"});
        const RecordSpec read =
            parse(std::string("record = { file = \"a.csv\", unit = \"cm/s2\"") + kStep + " }\n")
                .stage.back()
                .get<ShakeStage>()
                .record.front();
        ASSERT_EQ(read.read_times.size(), 9U) << head;
        EXPECT_DOUBLE_EQ(read.read_times[1], 0.05) << head;
      }
  for (const char* head : {"time_s,acc\n", "t [s],acc\n", "seconds,acc\n", "Zeit (sec),acc\n"}) {
    file(head, 0, 1);
    EXPECT_EQ(told(""), "accepted") << head;
    says(told(kStep), {"is not the step of", "1 s"});
  }
  for (const char* head : {"timeMs", "timems", "tms", "msec", "milliseconds", "Time_millis",
                           "time_ms", "t (us)", "elapsed_ms", "elapsed millis", "ms"}) {
    file(std::string(head) + ",acc\n", 0, 50);
    says(told(""), {head, "not in seconds"});
    says(told(kStep), {head, "not in seconds"});
  }
  write("a.csv", "t,acc\n0,1\n50,2\n99,1\n151,2\n");  // a clock, in whatever
  says(told(kStep), {"no unit that is stated", "time_s"});
  write("a.csv", "0,0.00,1\n1,0.05,2\n2,0.10,1\n3,0.15,-2\n");
  says(told(", column = \"3\""), {"step: is missing", "column 1"});
}

TEST_F(RecordFile, a_unit_in_the_head_is_the_unit_or_the_file_is_refused) {
  const auto told = [&](const std::string& head, const char* unit) {
    write("a.csv", "time," + head + "\n0,0.1\n0.01,0.2\n0.02,-0.1\n");
    return refusal(std::string("record = { file = \"a.csv\", unit = \"") + unit + "\" }\n");
  };
  for (const char* head : {"acc [cm/s^2]", "acc (cm/s/s)", "a [cm/sec**2]", "acc_cm_s2",
                           "acc [Gal]", "acc (gal)", "ACC [CM/S2]", "acc cm/s²", "acc_cm_per_s2"})
    EXPECT_EQ(told(head, "cm/s2"), "accepted") << head;
  for (const char* head : {"acc (g)", "acc [G]", "a_g", "acc g"})
    EXPECT_EQ(told(head, "g"), "accepted") << head;
  for (const char* head : {"acc [%g]", "acc (in/s2)", "acc_in_s2", "acc (ft/s^2)", "acc [mm/s2]",
                           "acc (mg)", "acc_mg", "acc [-]", "acc (raw)", "acc [counts]"})
    for (const char* unit : {"g", "m/s2", "cm/s2"})
      says(told(head, unit), {"unit that is not known here", "g, m/s2 or cm/s2"});
  for (const char* head : {"acc_cm_s2_ns", "acc in gal", "acc (NS) [cm/s^2]", "acc_gal_filtered"})
    EXPECT_EQ(told(head, "cm/s2"), "accepted") << head;
  for (const char* head : {"acc in g", "acc_g_x", "a_x_g", "g", "G"}) {
    EXPECT_EQ(told(head, "g"), "accepted") << head;
    says(told(head, "cm/s2"), {"states another"});
  }
  says(told("acc (in/s2) NS", "g"), {"unit that is not known here"});
  for (const char* head : {"acc [m]", "x [cm/s]", "acc (kN)", "cm/s", "Sa (g)", "PSA [g]"})
    EXPECT_NE(told(head, "g"), "accepted") << head;
  for (const char* head : {"acc [cm/s^2]", "acc (gal)", "acc_m_s2"})
    says(told(head, "g"), {"states another"});
}

// Nothing that may change a unit is passed over, and a column is an acceleration by its name alone.
TEST_F(RecordFile, heads_are_understood_as_a_whole) {
  const auto told = [&](const std::string& head, const char* unit, const char* column = "") {
    write("a.csv", "time,\"" + head + "\"\n0,0.1\n0.01,0.2\n0.02,-0.1\n");
    return refusal(std::string("record = { file = \"a.csv\"") + unit + column + " }\n");
  };
  for (const char* unit : {"", ", unit = \"g\"", ", unit = \"m/s2\"", ", unit = \"cm/s2\""})
    for (const char* head : {"acc_pct_g",      "acc, % of g",
                             "acc 10^-3 g",    "acc_milli_g",
                             "acc x0.01 g",    "acc_g_x100",
                             "acc_cm_s2_x10",  "acc_x10_cm_s2",
                             "acc 0.1 cm/s2",  "acc_0.01g",
                             "acc_percentg",   "%acc g",
                             "acc pct (g)",    "acc x100 [g]",
                             "acc (g) x 10",   "acc*10 [cm/s2]",
                             "1e-3 acc [g]",   "acc 2 g",
                             "acc cm/s2 * 10", "acc milli [g]",
                             "acc_mps2",       "acc_ms2",
                             "acc_mms2",       "acc_inps2",
                             "acc gees",       "acc meters per second squared",
                             "accmms2",        "acc_promille_g",
                             "acc µg",         "acc²",
                             "acc/981",        "acc_volts",
                             "acc_norm",       "acc_g100",
                             "acc/10 (g)",     "EW pct g",
                             "acc 1/100 g",    "acc millig"})
      EXPECT_NE(told(head, unit), "accepted") << head << unit;
  for (const char* head : {"accg", "acc-g", "acc:g", "acc {g}", "acc <g>", "acc g's", "acc (g",
                           "acc g)", "acc=g", "acc|g", "acc.g", "a(t) g"}) {
    says(told(head, ", unit = \"cm/s2\""), {"states another", "\"g\""});
    EXPECT_EQ(told(head, ""), "accepted") << head;
  }
  says(told("acc (m/s2", ", unit = \"cm/s2\""), {"states another", "\"m/s2\""});
  for (const char* head : {"acc",         "ag(t)",        "a(t)",
                           "a",           "ax",           "a_x",
                           "acc1",        "acc 2",        "acc_ns",
                           "Acc. NS",     "accelX",       "acceleration EW corrected",
                           "aceleracion", "accélération", "Beschleunigung x",
                           "NS",          "ground acc",   "acc_ch3",
                           "acc_360",     "acc_x_raw",    "acc []"})
    EXPECT_EQ(told(head, ", unit = \"g\""), "accepted") << head;
  for (const char* head : {"acc station 123 [g]", "acc (run 3) [g]", "acc x1 [g]"})
    EXPECT_EQ(told(head, ""), "accepted") << head;
  for (const char* head :
       {"Geschwindigkeit", "Weg", "position", "x", "strain", "y", "what", "Motion"}) {
    says(told(head, ", unit = \"g\""), {"column: is missing", head});
    EXPECT_EQ(told(head, ", unit = \"g\"", (std::string(", column = \"") + head + "\"").c_str()),
              "accepted")
        << head;
  }
  write("a.csv", "Weg\n0.1\n0.2\n-0.1\n");
  says(refusal("record = { file = \"a.csv\", unit = \"g\", step = \"0.01 s\" }\n"),
       {"column: is missing", "Weg"});
  write("a.csv", "freq,acc\n0,0.1\n0.01,0.2\n0.02,-0.1\n");
  says(refusal("record = { file = \"a.csv\", unit = \"g\" }\n"), {"no column of times"});
  for (const char* comment :
       {"# vel, cm/s\n", "# displacement of the base\n", "# Station 3\n# velocity\n# x\n"}) {
    write("a.txt", std::string(comment) + "0 0.1\n0.01 0.2\n0.02 -0.1\n");
    says(refusal("record = { file = \"a.txt\", unit = \"g\" }\n"), {"column: is missing", "a.txt"});
    EXPECT_EQ(refusal("record = { file = \"a.txt\", unit = \"g\", column = \"2\" }\n"), "accepted");
  }
  write("a.txt", "# velocity and acceleration of a table\n0 0.1\n0.01 0.2\n0.02 -0.1\n");
  EXPECT_EQ(refusal("record = { file = \"a.txt\", unit = \"g\" }\n"), "accepted");
}

TEST_F(RecordFile, a_step_beside_that_of_the_file_is_refused) {
  const auto told = [&](const char* file, const char* step) {
    return refusal(std::string("record = { file = \"") + file + "\", unit = \"g\", step = \"" +
                   step + "\" }\n");
  };
  write("a.csv", "time,acc\n0,0.1\n0.01,0.2\n0.02,-0.1\n");
  write("b.csv", "0 0.1\n0.01 0.2\n0.02 -0.1\n");
  write("c.AT2", "ACCELERATION IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n.1 .2 -.1\n");
  for (const char* file : {"a.csv", "b.csv", "c.AT2"}) {
    EXPECT_EQ(told(file, "0.01 s"), "accepted") << file;
    says(told(file, "0.005 s"), {"is not the step of", "0.01 s"});
  }
}

TEST_F(RecordFile, heads_of_at2_that_are_in_use) {
  for (const char* head :
       {"Own\n3 points at equal spacing of 0.05 sec\nfive across\nx\nThe units are (g)\n*** Begin "
        "***\n"
        "NPTS=  3, DT= .05000 SEC\n",
        "PEER\nOwn, 1 Jan 2000\nACCELERATION TIME SERIES IN UNITS OF G\nDT= .0500 SEC, NPTS=  3\n",
        "PEER\nhouse, units of 3 storeys\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=  3, DT= "
        ".05\n",
        "PEER\nx\nACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz, LP=30 Hz\n  3 "
        "  .0500  NPTS, DT\n",
        "ACCELERATION, UNITS: g\nNPTS: 3 DT: 5e-2\n", "DT=0.05 NPTS=3\n"}) {
    write("a.AT2", std::string(head) + " .1E+00 -.2 .3\n");
    const RecordSpec read = parse("record = { file = \"a.AT2\", unit = \"g\" }\n")
                                .stage.back()
                                .get<ShakeStage>()
                                .record.front();
    ASSERT_EQ(read.read_times.size(), 3U) << head;
    EXPECT_DOUBLE_EQ(read.read_times[1], 0.05) << head;
    EXPECT_DOUBLE_EQ(read.read_accelerations[1], -0.2 * 9.81) << head;
  }
  write("a.AT2", "some\nwords\n1 2 3\n");
  says(refusal("record = { file = \"a.AT2\", unit = \"g\" }\n"), {"names NPTS and DT"});
}

// Fortran leaves no blank between numbers of full width.
TEST_F(RecordFile, numbers_of_at2_that_touch_are_parted) {
  const auto told = [&](const char* rows) {
    write("a.AT2", std::string("ACCELERATION IN UNITS OF G\nNPTS= 6, DT= .005 SEC\n") + rows);
    return refusal("record = [{ file = \"a.AT2\" }]\n");
  };
  for (const char* rows :
       {" .1E-01  -.2 .3\n-.123-0.456 .2\n", "-.1E-01-.2E-01-.3E-01 .1E-01-.2E+00+.3E-01\n",
        "0.1-0.2-0.1-0.2-0.3-0.1\n"}) {
    EXPECT_EQ(told(rows), "accepted") << rows;
  }
  const auto once = [&](const char* rows, const char* words) {
    const std::string said = told(rows);
    says(said, {words});
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  };
  once(".1 .2 .3\n-.123x4.56 .2\n", "is no number");
  once(".1 .2 .3\n.4 .5 *******\n", "is no number");
  once(".1 .2 .3\n.4 .5\n", "are not the 6");
}

TEST_F(RecordFile, at2_with_a_factor_or_two_units_or_of_a_spectrum_is_refused) {
  const auto told = [&](const std::string& head, const char* unit = "g") {
    write("f.AT2", "PEER NGA\nOwn\n" + head + ".1 .2 .3\n");
    return refusal(std::string("record = { file = \"f.AT2\", unit = \"") + unit + "\" }\n");
  };
  const std::string counts = "\nNPTS= 3, DT= .0050 SEC,\n ";
  for (const char* head :
       {"ACCELERATION TIME SERIES IN UNITS OF G MULTIPLIED BY 100",
        "ACCELERATION TIME SERIES IN UNITS OF G, SCALED BY 10", "ACCELERATION (g x 100)",
        "ACCELERATION IN UNITS OF G, SCALE FACTOR 981"})
    says(told(head + counts), {"f.AT2:3", "may be in a unit that is not known here"});
  says(told("ACCELERATION (CM/SEC^2) * 10" + counts, "cm/s2"), {"f.AT2:3", "it has a factor"});
  for (const char* head :
       {"ACCELERATION RESPONSE SPECTRUM IN UNITS OF G", "SPECTRAL ACCELERATION IN G",
        "PSEUDO-ACCELERATION IN UNITS OF G", "FOURIER AMPLITUDE OF ACCELERATION, UNITS OF G"})
    says(told(head + counts), {"f.AT2:3", "head of a spectrum"});
  for (const char* head :
       {"ACCELERATION TIME SERIES, SPECTRUM MATCHED, IN UNITS OF G",
        "Spectrum-compatible accelerogram, acceleration in units of g",
        "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=30.0 Hz"})
    EXPECT_EQ(told(head + counts), "accepted") << head;
  EXPECT_EQ(told("ACCELERATION IN UNITS OF CM/SEC**2" + counts, "cm/s2"), "accepted");
  says(told("ACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT=.05, UNITS=CM/S2\n "),
       {"f.AT2:4", "another unit than G in line 3"});
}

TEST_F(RecordFile, a_unit_in_a_comment_agrees_or_is_refused) {
  const auto told = [&](const std::string& comment, const std::string& head, const char* unit) {
    write("c.csv", comment + "\n" + head + "\n0,0.1\n0.01,0.2\n0.02,-0.1\n");
    return refusal(std::string("record = { file = \"c.csv\"") +
                   (*unit == '\0' ? "" : std::string(", unit = \"") + unit + "\"") + " }\n");
  };
  EXPECT_EQ(told("# accelerations in g", "time,acc", "g"), "accepted");
  EXPECT_EQ(told("# station A, Vs30 = 300 m/s, 5 % damping", "time,acc", "g"), "accepted");
  EXPECT_EQ(told("# accelerations in g", "time,acc [g]", ""), "accepted");
  says(told("# accelerations in g", "time,acc", "m/s2"), {"c.csv:1", "the model says m/s2"});
  says(told("# unit: cm/s2", "time,acc [g]", ""), {"c.csv:1", "the head says g"});
  says(told("# unit: mm/s2", "time,acc", "cm/s2"), {"c.csv:1", "not known here"});
  says(told("# % of g", "time,acc", "g"), {"c.csv:1", "not known here"});
}

TEST_F(RecordFile, a_mark_of_missing_data_is_no_peak) {
  const auto told = [&](const char* values, const char* unit) {
    write("m.csv", std::string("acc\n") + values);
    return refusal(std::string("record = { file = \"m.csv\", step = \"0.01 s\", unit = \"") + unit +
                   "\" }\n");
  };
  says(told("12\n-80\n-999\n40\n", "cm/s2"), {"acceleration 3 of 4", "mark of missing data"});
  says(told("0.1\n0.2\n9999.99\n0.1\n", "m/s2"), {"acceleration 3 of 4"});
  EXPECT_EQ(told("700\n-800\n-999\n400\n", "cm/s2"), "accepted");
  EXPECT_EQ(told("0.1\n0.9\n-0.99\n0.4\n", "g"), "accepted");
}

TEST_F(RecordFile, thousands_or_decimals) {
  const auto told = [&](const char* values) {
    write("k.csv", std::string("time_s;acc_cm_s2\n") + values);
    return refusal("record = { file = \"k.csv\" }\n");
  };
  says(told("0;0\n0.01;120\n0.02;-350\n0.03;1.150\n"),
       {"k.csv:5", "1.150", "three decimals or marks of thousands"});
  EXPECT_EQ(told("0;0.000\n0.01;12.345\n0.02;-35.250\n"), "accepted");
  EXPECT_EQ(told("0;0\n0.01;120.5\n0.02;-35.250\n"), "accepted");
}

// Tables of three columns and more, of which the model names one.
TEST_F(RecordFile, a_step_is_compared_with_columns_that_were_not_chosen) {
  const auto told = [&](const std::string& head, double step, const char* asked) {
    std::string text = head;
    for (int k = 0; k < 9; ++k) text += fmt::format("{} {:g} {}.5 7\n", k, step * k, k % 3);
    write("a.txt", text);
    return refusal(std::string("record = { file = \"a.txt\", unit = \"cm/s2\", column = \"3\", ") +
                   "step = \"" + asked + "\" }\n");
  };
  for (const char* head : {"", "n a b c\n", "# four columns\n"}) {
    EXPECT_EQ(told(head, 0.01, "0.01 s"), "accepted") << head;
    EXPECT_EQ(told(head, 10, "0.01 s"), "accepted") << head;
    says(told(head, 0.01, "0.005 s"),
         {"step = 0.005 s", "is not the step of column", "0.01 a row"});
    says(told(head, 10, "0.005 s"), {"is not the step of column", "10 a row"});
  }
}

TEST_F(RecordFile, times_in_words_are_seconds_or_refused) {
  const auto told = [&](const char* head, const char* step = "") {
    write("a.csv", std::string("\"") + head +
                       "\",acc\n0,0.1\n0.0025,0.2\n0.005,-0.1\n0.0075,0.1\n0.01,0.2\n");
    return refusal(std::string("record = { file = \"a.csv\", unit = \"g\"") + step + " }\n");
  };
  for (const char* head :
       {"tempo_minuti", "Zeit_ms", "time/1000 [s]", "time in minutes", "Zeit (h)", "time x10 [s]",
        "seconds*100", "tempo (1/100 s)", "heures", "Minuten", "t_min", "log time", "millisecondi",
        "time_s/10", "frames", "10^3 s"})
    EXPECT_NE(told(head), "accepted") << head;
  says(told("tempo_minuti"), {"tempo_minuti", "minuti", "time_s"});
  for (const char* head : {"t", "time", "tempo", "Zeit", "tempo [s]", "tempo_secondi", "Sekunden",
                           "Time from trigger (s)", "elapsed time", "Time_s", "TIME", "when",
                           "t (sec)", "tiempo (s)", "T", "x", "timestamp [s]", "time history (s)"})
    EXPECT_EQ(told(head), "accepted") << head;
  EXPECT_EQ(told("tick", ", step = \"0.0025 s\""), "accepted");
}

TEST_F(RecordFile, times_that_do_not_rise_are_told_for_what_they_are) {
  const auto told = [&](const char* text) {
    write("a.csv", text);
    const std::string said = refusal("record = { file = \"a.csv\", unit = \"g\" }\n");
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  };
  says(told("time,acc\n0.1,0\n-0.2,0.01\n0.3,0.02\n0.1,0.03\n"), {"are exchanged", "heads"});
  says(told("0.1 0\n-0.2 0.01\n0.3 0.02\n0.1 0.03\n"), {"are exchanged", "times first"});
  says(told("time,acc\n0,0.1\n0,0.2\n0.01,0.3\n0.01,-0.1\n0.02,0.3\n0.02,0.2\n"),
       {"a.csv:3", "are rounded", "3 rows", "more decimals"});
  says(told("time,acc\n0.03,0.1\n0.02,0.2\n0.01,-0.3\n0,0.1\n"), {"fall from row to row"});
  says(told("time,acc\n0.1,0.1\n-0.2,0.2\n0.3,-0.3\n-0.1,0.1\n"), {"are no times", "2 times in 4"});
  says(told("time,acc\n0,0.1\n0.02,0.2\n0.01,-0.3\n0.03,0.1\n0.04,0.2\n"),
       {"a.csv:4", "times do not rise", "sort the rows"});
}

TEST_F(RecordFile, comments_of_other_programs_are_heads_and_comments) {
  for (const char* mark : {"#", "%", "!", "//", "%%", "% "}) {
    write("a.txt",
          std::string(mark) + " station 3\n" + mark + " time acc_cm_s2\n0 0.5\n0.01 1\n0.02 -2\n");
    EXPECT_EQ(refusal("record = { file = \"a.txt\" }\n"), "accepted") << mark;
    says(refusal("record = { file = \"a.txt\", unit = \"g\" }\n"), {"states another", "cm/s2"});
    write("a.txt", std::string(mark) + " velocity in cm/s\n0 0.5\n0.01 1\n0.02 -2\n");
    says(refusal("record = { file = \"a.txt\", unit = \"g\" }\n"), {"column: is missing"});
    write("a.txt", std::string(mark) + " units: cm/s2\n0 0.5\n0.01 1\n0.02 -2\n");
    says(refusal("record = { file = \"a.txt\", unit = \"g\" }\n"), {"is what a comment says"});
  }
}

TEST_F(RecordFile, comments_about_the_numbers_agree_with_them_or_are_refused) {
  const auto told = [&](const std::string& comment, const char* keys = ", step = \"0.01 s\"") {
    write("a.csv", "# " + comment + "\nacc\n0.5\n1\n-2\n0.7\n");
    return refusal(std::string("record = { file = \"a.csv\", unit = \"cm/s2\"") + keys + " }\n");
  };
  for (const char* comment :
       {"dt = 0.005 s", "DT: 5 ms", "dt (ms): 5", "sampling rate 200 Hz",
        "Sampling frequency: 200Hz", "sampling interval 0.005", "time step = 5e-3"})
    says(told(comment), {"step", "is not the step that a comment of", "0.005 s"});
  for (const char* comment :
       {"dt = 0.01 s", "DT: 10 ms", "sampling rate: 100 Hz", "cutoff frequency 25 Hz", "NPTS = 4",
        "scale factor: 1.0", "factor = 1"})
    EXPECT_EQ(told(comment), "accepted") << comment;
  for (const char* comment : {"multiply by 9.81", "scale factor: 0.01", "Scaled by 2.5",
                              "factor = 980.665", "calibration factor 3.2"})
    says(told(comment), {"a.csv:1", "may be a factor of the numbers below"});
  says(told("NPTS = 100"), {"4 numbers", "are not the 100 that a comment states"});
  write("a.csv", "# dt = 0.005 s\ntime,acc\n0,0.5\n0.01,1\n0.02,-2\n");
  says(refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n"),
       {"is not the step that a comment"});
  write("a.csv", "time,acc\n0,0.5\n0.01,1\n0.02,-2\ntime,acc\n0,0.5\n");
  const std::string twice = refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n");
  says(twice, {"a.csv:5", "the head a second time"});
  EXPECT_EQ(twice.find('\n'), std::string::npos) << twice;
  for (const char* head : {"t/T1,acc", "time,|acc|"}) {
    write("a.csv", std::string(head) + "\n0,0.5\n0.01,1\n0.02,-2\n");
    EXPECT_NE(refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n"), "accepted") << head;
  }
  write("a.csv", "t/s,acc\n0,0.5\n0.01,1\n0.02,-2\n");
  EXPECT_EQ(refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n"), "accepted");
}

TEST_F(RecordFile, one_slip_of_a_record_is_one_fault) {
  const auto faults = [&](const std::string& lines) {
    const std::string said = refusal("record = { " + lines + " }\n");
    return std::count(said.begin(), said.end(), '\n') + (said == "accepted" ? 0 : 1);
  };
  write("big.csv", "acc\n10\n92.5\n-20\n5\n");
  EXPECT_EQ(faults("file = \"big.csv\", step = \"0.01 s\", unit = \"g\""), 1);
  EXPECT_EQ(faults("file = \"big.csv\", step = \"0.02\", unit = \"cm/s2\""), 1);
  EXPECT_EQ(faults("file = \"big.csv\", step = \"200 Hz\", unit = \"cm/s2\""), 1);
  write("tail.csv", "time;acc\n0;10\n0.01;20\n0.02;-10\n;\n;\n;\n");
  EXPECT_EQ(faults("file = \"tail.csv\", unit = \"cm/s2\""), 0);
  write("hole.csv", "time;acc\n0;10\n;\n0.02;-10\n");
  EXPECT_EQ(faults("file = \"hole.csv\", unit = \"cm/s2\""), 1);
}

TEST_F(RecordFile, at2_of_velocities_and_displacements_is_refused) {
  for (const char* unit : {"", ", unit = \"g\"", ", unit = \"cm/s2\""})
    for (const char* head :
         {"DISPLACEMENT TIME SERIES IN UNITS OF CM", "DISPLACEMENT TIME SERIES",
          "VELOCITY TIME SERIES", "VELOCITY TIME HISTORY IN UNITS OF CM/S",
          "Displacement in units of g", "velocity", "DISP. (CM)", "TIME SERIES IN UNITS OF CM",
          "units of in", "Vel, 5 a line", "VELOCITIES (CM/SEC)", "TIME SERIES OF VELOC."}) {
      write("v.AT2",
            std::string("PEER NGA\nOwn\n") + head + "\nNPTS= 3, DT= .0050 SEC,\n .1 .2 .3\n");
      says(refusal(std::string("record = { file = \"v.AT2\"") + unit + " }\n"),
           {"v.AT2:3", "give the accelerations"});
    }
  for (const char* name : {"a.VT2", "a.dt2"}) {
    write(name, "PEER\nOwn\nNPTS= 3, DT= .0050 SEC,\n .1 .2 .3\n");
    says(refusal(std::string("record = { file = \"") + name + "\", unit = \"g\" }\n"),
         {"give the accelerations"});
  }
  for (const char* title :
       {"High velocity pulse", "Displacement House", "velocity-corrected acceleration"}) {
    write("a.AT2",
          std::string("PEER\n") + title +
              "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .0050 SEC,\n .1 .2 .3\n");
    EXPECT_EQ(refusal("record = { file = \"a.AT2\" }\n"), "accepted") << title;
  }
}

TEST_F(RecordFile, the_step_of_at2_is_in_its_unit) {
  const auto told = [&](const char* line) {
    write("a.AT2", std::string("PEER\nx\nACCELERATION TIME SERIES IN UNITS OF G\n") + line +
                       "\n .1 .2 -.3\n");
    try {
      return fmt::format("{:g}", parse("record = { file = \"a.AT2\" }\n")
                                     .stage.back()
                                     .get<ShakeStage>()
                                     .record.front()
                                     .read_times[1]);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
  };
  for (const char* line :
       {"NPTS= 3, DT= .0500 SEC", "NPTS= 3, DT= 5.0D-02 SEC", "NPTS= 3, DT= 5.0d-2",
        "NPTS= 3, DT= 50 ms", "NPTS= 3, DT= 50ms", "NPTS= 3, DT= 50 msec", "NPTS= 3, DT= 50. MSEC.",
        "NPTS= 3, DT= 50000 us", "DT= 50 milliseconds, NPTS= 3", "NPTS= 3, DT(ms)= 50",
        "NPTS= 3, DT [msec] = 50", "NPTS= 3, DT_ms = 50", "NPTS= 3, DT= .05 s.",
        "NPTS= 3, DT= .05 seconds, 5 a line", "  3   .0500   NPTS, DT",
        "  3   0.5D-1  NPTS, DT (SEC)", "  3   50  NPTS, DT (ms)"})
    EXPECT_EQ(told(line), "0.05") << line;
  for (const char* line : {"NPTS= 3, DT= 20 HZ", "NPTS= 3, DT= 50", "  3  50  NPTS, DT",
                           "NPTS= 3, DT= 1", "NPTS= 3, DT= 20 sps", "NPTS= 3, DT= 0.05 Hz"})
    says(told(line), {"a.AT2:4", "s"});
}

TEST_F(RecordFile, formats_of_the_field_are_read_or_named) {
  std::string esm =
      "EVENT_NAME: OWN\nUNITS: cm/s^2\nSAMPLING_INTERVAL_S: 0.05\nNDATA: 4\nDATA_TYPE: "
      "ACCELERATION\n";
  for (int k = 1; k < 60; ++k) esm += fmt::format("USER{}:\n", k);
  write("a.ASC", motion(esm, [](int, double a) { return fmt::format("{:.4f}", a); }));
  // counts of 1/1000 gal
  const std::string knet =
      "Origin Time       2000/01/01 00:00:00\nSampling Freq(Hz) 20Hz\nDuration Time(s)  0.2\n"
      "Scale Factor      2000(gal)/2000000\nMemo.\n";
  write("a.NS", motion(knet, [](int, double a) { return fmt::format("{:9.0f}", 1000 * a); }));
  for (const char* file : {"a.ASC", "a.NS"}) {
    const RecordSpec read =
        parse(std::string("record = { file = \"") + file + "\", unit = \"cm/s2\" }\n")
            .stage.back()
            .get<ShakeStage>()
            .record.front();
    ASSERT_EQ(read.read_accelerations.size(), 4U) << file;
    EXPECT_DOUBLE_EQ(read.read_times[1], 0.05) << file;
    EXPECT_NEAR(read.read_accelerations[2], -1.962, 1e-12) << file;
    says(refusal(std::string("record = { file = \"") + file + "\", unit = \"g\" }\n"),
         {"states another", "cm/s2"});
  }
  esm.replace(esm.find("TYPE: ACCELERATION"), 18, "TYPE: VELOCITY");
  write("v.ASC", motion(esm, [](int, double a) { return fmt::format("{:.4f}", a); }));
  says(refusal("record = { file = \"v.ASC\", unit = \"cm/s2\" }\n"), {"velocity"});
  write("c.v2",
        "Corrected accelerogram 57007\nx\n  4 points of accel data equally spaced at  .020 sec, in "
        "cm/sec2. (8f10.3)\n"
        "  1.000  2.000  3.000\n");
  says(refusal("record = { file = \"c.v2\", unit = \"cm/s2\" }\n"), {"CSMIP", "not read here"});
  write("w.txt", "some words\nother words\n1\n2\n3\n");
  const std::string told =
      refusal("record = { file = \"w.txt\", unit = \"cm/s2\", step = \"1 s\" }\n");
  says(told, {"2 lines before its first number", "begin the others with #"});
  EXPECT_EQ(told.find('\n'), std::string::npos) << told;  // one fault
}

// A channel as CESMD writes it: 100 real values of which the 34th is the step [s] and the 62nd that of the series [ms].
std::string cosmos(double step_s, double step_ms, int count, const std::string& unit,
                   const std::string& format, const std::vector<std::string>& rows, double seconds,
                   const std::string& what = "acceleration") {
  std::string text =
      "Corrected acceleration    (Format v01.20 with 13 text lines)\nStation X\n"
      "   100 Real-header values follow on  17 lines , Format = (6F13.6)\n";
  for (int k = 1; k <= 100; ++k)
    text += fmt::format("{:13.6f}{}",
                        k == 34   ? step_s
                        : k == 62 ? step_ms
                                  : -999.0,
                        k % 6 == 0 || k == 100 ? "\n" : "");
  text += "   1 Comment line(s) follow, each starting with a \"|\":\n|units=cm a = b\n";
  text += fmt::format("   {} {} pts, approx {:3.0f} secs, units={},Format=({})\n", count, what,
                      seconds, unit, format);
  for (const std::string& row : rows) text += row + "\n";
  return text + "End-of-data for Chan HNE " + what + "\n";
}

TEST_F(RecordFile, a_channel_of_cosmos_is_read_by_its_widths_and_its_step) {
  const auto reads = [&](const std::string& text, double step, std::vector<double> values) {
    write("a.V2c", text);
    const RecordSpec record =
        parse("record = { file = \"a.V2c\" }\n").stage.back().get<ShakeStage>().record.front();
    ASSERT_EQ(record.read_accelerations.size(), values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
      EXPECT_DOUBLE_EQ(record.read_accelerations[k], 0.01 * values[k]);
      EXPECT_NEAR(record.read_times[k], step * static_cast<double>(k), 1e-12);
    }
  };
  // numbers that touch; both ways of writing the unit
  const std::vector<double> values = {-0.5, -1.25, 2, -3, 0.1};
  reads(cosmos(0.005, 5, 5, "cm/s^2 (4)", "2F8.5",
               {"-0.50000-1.25000", " 2.00000-3.00000", " 0.10000"}, 0),
        0.005, values);
  reads(cosmos(0.005, 5, 3, "cm/sec2(04)", "1E15.6",
               {"  -2.500000E-01", "   1.000000E+00", "   0.000000E+00"}, 0),
        0.005, {-0.25, 1, 0});
  // resampled: the series has its own step
  reads(cosmos(0.005, 10, 2, "cm/s^2", "8F10.5", {"   1.00000   2.00000"}, 0), 0.01, {1, 2});
  reads(cosmos(0.02, -999, 2, "cm/s^2", "8F10.5", {"   1.00000   2.00000"}, 0), 0.02, {1, 2});
  // velocities and displacements of the same channel stand behind it
  const std::vector<std::string> two = {"   1.00000   2.00000"};
  reads(cosmos(0.02, 20, 2, "cm/s^2", "8F10.5", two, 0) +
            cosmos(0.02, 20, 2, "cm/s", "8F10.5", two, 0, "velocity"),
        0.02, {1, 2});
}

TEST_F(RecordFile, a_channel_of_cosmos_that_is_not_whole_or_not_alone_is_refused) {
  const auto told = [&](const std::string& text) {
    write("a.V2c", text);
    const std::string said = refusal("record = { file = \"a.V2c\" }\n");
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    return said;
  };
  const std::vector<std::string> two = {"   1.00000   2.00000"};
  const std::string one = cosmos(0.02, 20, 2, "cm/s^2", "8F10.5", two, 0);
  std::string no_number = one;  // of seconds
  no_number.replace(no_number.find("approx   0 secs"), 15, "approx 1.2.3 secs");
  EXPECT_NE(told(no_number).find("which last 0.04 s"), std::string::npos) << told(no_number);
  says(told(one + one), {"second of 2 accelerations", "keep one channel"});
  says(told(cosmos(0.02, 20, 2, "counts (50)", "8F10.5", two, 0)), {"counts", "no unit of acc"});
  says(told(cosmos(-999, -999, 2, "cm/s^2", "8F10.5", two, 0)), {"has no step"});
  says(told(cosmos(0.02, 20, 9, "cm/s^2", "8F10.5", two, 0)), {"no line of numbers", "2 of 9"});
  says(told(cosmos(0.02, 20, 2, "cm/s^2", "8F10.5", two, 60)), {"which last 0.04 s"});
  says(told(cosmos(0.02, 20, 2, "cm/s^2", "8F10.5", {"   1.00000   2.0z000"}, 0)), {"2.0z000"});
  write("b.V2c", one);
  says(refusal("record = { file = \"b.V2c\", unit = \"g\" }\n"), {"states another"});
  says(refusal("record = { file = \"b.V2c\", step = \"0.01 s\" }\n"), {"is not the step"});
}

TEST_F(RecordFile, formats_that_are_not_read_are_named) {
  const auto told = [&](const std::string& text) {
    write("a.dat", text);
    return refusal("record = { file = \"a.dat\", unit = \"cm/s2\", step = \"0.02 s\" }\n");
  };
  for (const auto& [text, name] : std::initializer_list<std::pair<std::string, const char*>>{
           {"Raw acceleration counts (Format v01.20 with 13 text lines)\nx\n3 raw accel pts\n1 2 "
            "3\n",
            "COSMOS"},
           {"3 raw accel. pts, approx 1 secs\n1 2 3\n", "COSMOS"},
           {"GeoNet Strong-Motion Accelerogram; Volume 2\nfilter\n1 2 3\n", "GeoNet"},
           {"PLACE : X\nSAMPLING INTERVAL (s) : 0.05\nNUMBER OF DATA : 3\nN-S  E-W  U-D (gal)\n1 2 "
            "3\n",
            "AFAD"},
           {"1. NOMBRE\nINTERVALO DE MUESTREO, C1-C6 (s): .05\n1 2 3\n", "Mexic"},
           {"EVENT: x\nSAMPLING INTERVAL [s]: 0.05\nUNITS: cm/s^2\n1\n2\n", "ITACA"},
           {std::string("000001D IV AQU  HNE") + std::string("\x00\x01\xff\xfe", 4), "MiniSEED"},
           {std::string("MS\x03\x04\x00\x00\xff", 7), "MiniSEED"}}) {
    const std::string said = told(text);
    says(said, {name, "not read here"});
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;  // one fault
    EXPECT_EQ(said.find("UTF-8"), std::string::npos) << said;
  }
  std::string sac(640, '\0');
  sac[304] = 6;
  sac[1] = '\xff';
  says(told(sac), {"SAC", "not read here"});
  std::swap(sac[304], sac[307]);
  says(told(sac), {"SAC"});
  write("a.SAC", std::string("\x00\x01\xff\xfe", 4));
  says(refusal("record = { file = \"a.SAC\", unit = \"g\" }\n"), {"SAC", "not read here"});
  says(told("time,acc\n0,\xff\n"), {"UTF-8"});
  says(told(std::string("PK\x03\x04\x00\x00\xff", 7)), {"binary"});
}

TEST_F(RecordFile, one_slip_of_a_table_has_one_reason) {
  const auto told = [&](const std::string& text) {
    write("a.csv", text);
    return refusal("record = { file = \"a.csv\", unit = \"cm/s2\", step = \"0.05 s\" }\n");
  };
  std::string commas, named = "time,acc\n", macs = "time_s,acc\r";
  for (int k = 0; k < 12; ++k) {
    commas += fmt::format("0,{:04d}\n", (k * 37) % 100);
    named += fmt::format("{},{:.2f},{}.5\n", k + 1, 0.05 * k, k % 3);
    macs += fmt::format("{:.2f},{}.5\r", 0.05 * k, k % 3);
  }
  const std::string decimals = told(commas), heads = told(named), mac = told(macs);
  says(decimals, {"a.csv:1", "decimals"});
  says(heads, {"a.csv:2", "give each column a name, that of row numbers too"});
  says(mac, {"line ends"});
  for (const std::string& said : {decimals, heads, mac})
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  says(told("time,acc\n0,00,0,1\n0,05,0,2\n"), {"decimals by a point"});
  says(told("NPTS= 3, DT= .05\r1\r2\r3\r"), {"line ends"});
  for (const char* text : {"time_s|acc\n0|1.5\n0.05|2\n0.1|-1\n",
                           "time_s | acc\n0,00 | 1,5\n0,05 | 2,0\n0,10 | -1,0\n"})
    EXPECT_EQ(told(text), "accepted") << text;
}

TEST_F(RecordFile, what_was_taken_is_told) {
  write("a.csv", ",time_s,acc_cm_s2\n0,0,10\n1,0.05,-20\n2,0.1,10\n3,0.15,20\n");
  const auto told = [&] {
    std::string text;
    for (const std::string& note : texts_of(
             compile(parse("record = { file = \"a.csv\", unit = \"cm/s2\" }\n")).anatomy.notes))
      text += note + "\n";
    return text;
  };
  says(told(), {"a.csv, column acc_cm_s2 in cm/s2, 4 accelerations, one each 50 ms",
                "mean of 25 % of the peak", "0.0204 g"});
  write("a.csv", ",time_s,acc_cm_s2\n0,0,10\n1,0.05,-20\n2,0.1,10\n3,0.2,20\n");
  says(told(), {"one each 50 to 100 ms"});
}

TEST_F(RecordFile, faults_are_named_with_their_lines) {
  write("a.csv", kCsv);
  says(refusal("record = { file = \"a.csv\", column = \"ns\" }\n"),
       {"unit", "is missing, and a.csv does not state it"});
  says(refusal("record = { accelerations = [0, 1], step = \"0.1 s\" }\n"), {"without its unit"});
  says(refusal("record = { file = \"b.csv\", unit = \"g\" }\n"), {"b.csv", "folder of the model"});
  says(refusal("record = { file = \"a.csv\", unit = \"g\", column = \"up\" }\n"), {"up", "ns, ew"});
  write("c.csv", "time_s,a\n0,0\n0.01,x\n0.02,\n0.02,1\n0.01,1\n");
  says(refusal("record = { file = \"c.csv\", unit = \"g\" }\n"),
       {"c.csv:3", "must be a finite number", "c.csv:4", "times do not rise"});
  std::string gap = "time_s,a\n";
  for (int k = 0; k < 40; ++k)
    if (k != 20 && k != 21) gap += fmt::format("{},0.1\n", 0.01 * k);
  write("d.csv", gap);
  says(refusal("record = { file = \"d.csv\", unit = \"g\" }\n"), {"0.19 s to 0.22 s", "missing"});
  write("e.AT2", "a\nb\nACCELERATION IN UNITS OF G\nNPTS= 6, DT= .005 SEC\n1 2 3\n");
  says(refusal("record = { file = \"e.AT2\", unit = \"g\" }\n"), {"3 numbers", "missing"});
}

TEST_F(RecordFile, a_wrong_unit_shows_by_its_size) {
  write("a.csv", "time_s,a\n0,0\n0.01,180\n0.02,-240\n0.03,0\n");
  says(refusal("record = { file = \"a.csv\", unit = \"m/s2\" }\n"), {"24.5 g", "cm/s2"});
  EXPECT_EQ(refusal("record = { file = \"a.csv\", unit = \"cm/s2\" }\n"), "accepted");
  write("b.csv", "time_s,a\n0,0\n0.01,0.0002\n0.02,0\n");
  says(refusal("record = { file = \"b.csv\", unit = \"m/s2\" }\n"), {"unit", "often g"});
}

TEST_F(RecordFile, a_shake_that_shakes_nothing_is_told) {
  const auto notes = [&](const std::string& lines) {
    std::string all;
    for (const std::string& note : texts_of(compile(parse(lines)).anatomy.notes))
      all += note + "\n";
    return all;
  };
  const std::string still =
      "record = { pulse = \"cycle\", amplitude = \"0 m/s^2\", period = \"1 s\" }\n";
  const std::string pulse =
      "record = { pulse = \"cycle\", amplitude = \"2 m/s^2\", period = \"1 s\" }\n";
  says(notes(still), {"nothing shakes"});
  says(notes(pulse + "scale = { factor = 0 }\n"), {"nothing shakes"});
  EXPECT_EQ(notes(pulse).find("nothing shakes"), std::string::npos);
  for (const char* scale :
       {"pga = \"1 m/s^2\"", "pgv = \"1 m/s\"", "sa = \"1 m/s^2\", period = \"1 s\""})
    says(refusal(still + "scale = { " + scale + " }\n"), {"cannot be reached", "amplitude"});
  says(refusal("record = { accelerations = [0, 0, 0], step = \"0.01 s\", unit = \"g\" }\n"),
       {"zero throughout"});
  says(notes("record = { pulse = \"cycle\", amplitude = \"2 m/s^2\", period = \"1e-5 s\" }\n"),
       {"change of velocity alone"});
  says(refusal(pulse + "scale = { sa = \"1 m/s^2\", period = \"1e-9 s\" }\n"), {"scale.period"});
  std::string times = "0", values = "0";
  for (int k = 1; k < 20; ++k)
    times += fmt::format(", {}", k < 10 ? 0.01 * k : 0.01 * (k + 3)), values += ", 0.1";
  says(refusal("record = { accelerations = [" + values + "], times = [" + times +
               "], unit = \"g\" }\n"),
       {"times are missing", "0.09 s to 0.13 s"});
}

TEST_F(RecordFile, a_changed_file_is_refused_where_its_hash_is_stated) {
  write("a.csv", kCsv);
  const std::string was = parse("record = { file = \"a.csv\", unit = \"g\", column = \"ns\" }\n")
                              .stage.back()
                              .get<ShakeStage>()
                              .record.front()
                              .hash;
  ASSERT_EQ(was.size(), 16U);
  const std::string lines =
      "record = { file = \"a.csv\", unit = \"g\", column = \"ns\", hash = \"" + was + "\" }\n";
  EXPECT_EQ(refusal(lines), "accepted");
  write("a.csv", "time_s,ns\n0,0\n0.01,0.3\n0.02,-0.1\n");
  says(refusal(lines), {was.c_str(), "another"});
}

TEST_F(RecordFile, a_shake_says_what_it_lacks) {
  says(refusal("free_vibration = \"1 s\"\n"), {"record", "missing"});
  says(refusal("record = { unit = \"g\" }\n"), {"nothing of the motion"});
  says(refusal("record = { pulse = \"cycle\" }\n"), {"amplitude", "period"});
  says(refusal("record = { pulse = \"cycle\", amplitude = \"1 m/s^2\", period = \"1 s\", "
               "direction = \"+z\" }\n"),
       {"out of the wall's plane"});
  says(refusal("record = [{ pulse = \"cycle\", amplitude = \"1 m/s^2\", period = \"1 s\" },"
               "{ pulse = \"cycle\", amplitude = \"1 m/s^2\", period = \"1 s\", direction = \"-x\" "
               "}]\n"),
       {"has a record already"});
  const std::string pulse =
      "record = { pulse = \"cycle\", amplitude = \"1 m/s^2\", period = \"1 s\" }\n";
  says(refusal(pulse + "scale = { pga = \"1 m/s^2\", factor = 2 }\n"), {"one of factor, pga"});
  says(refusal(pulse + "scale = { sa = \"1 m/s^2\" }\n"), {"with its period"});
  says(refusal(pulse + "mass_damping = { fraction = 0.02 }\n"), {"frequency"});
  says(refusal(pulse + "velocity = \"1 mm/s\"\n"), {"several kinds"});
  says(refusal(pulse + "rotation = \"blocked\"\n"), {"rotation", "has no effect", "`at`"});
}

TEST_F(RecordFile, all_components_are_scaled_by_the_first) {
  const std::string records =
      "record = [{ pulse = \"cycle\", amplitude = \"1 m/s^2\", period = \"0.5 s\" },"
      "{ pulse = \"ricker\", amplitude = \"0.5 m/s^2\", period = \"0.5 s\", direction = \"+y\" "
      "}]\n";
  const Model by_pgv = compile(parse(records + "scale = { pgv = \"0.2 m/s\" }\n"));
  EXPECT_NEAR(peak_velocity(by_pgv.stages.back().base[0]), 0.2, 1e-12);
  const Model by_pga = compile(parse(records + "scale = { pga = \"3 m/s^2\" }\n"));
  EXPECT_NEAR(peak_acceleration(by_pga.stages.back().base[0]), 3, 1e-12);
  EXPECT_NEAR(peak_acceleration(by_pga.stages.back().base[1]), 1.5, 1e-12);
  const Model by_sa =
      compile(parse(records + "scale = { sa = \"4 m/s^2\", period = \"0.3 s\" }\n"));
  EXPECT_NEAR(pseudo_acceleration(by_sa.stages.back().base[0], 0.3, 0.05), 4, 1e-9);
}

// --- runs -------------------------------------------------------------------------------------------------

StageSpec shaken_by(PulseShape shape, double amplitude, double period) {
  StageSpec shake{.name = "quake", .action = ShakeStage{}};
  RecordSpec record;
  record.pulse = shape;
  record.amplitude = amplitude;
  record.period = period;
  shake.get<ShakeStage>().record = {record};
  return shake;
}

Result shaken(const ModelSpec& spec) {
  const Model model = compile(spec);
  State state = initial_state(model);
  return solve(model, state);
}

ModelSpec lone_block(double width, double height, double friction) {
  ModelSpec spec = scenes::block_on_ground(
      width, height, scenes::dry_joint(1e10, 4e9, std::atan(friction)), 0.3, 2000);
  spec.stage = {scenes::gravity_stage()};
  return spec;
}

// A block that nothing holds stays where it is while the base moves under it: -D against the base.
TEST(Shake, without_friction_the_base_slides_away_under_the_block) {
  ModelSpec spec = lone_block(1, 0.2, 1e-9);
  StageSpec shake = shaken_by(PulseShape::kCycle, 2, 0.5);
  shake.get<ShakeStage>().free_vibration = 0.1;
  spec.stage.push_back(shake);
  const Result r = shaken(spec);
  ASSERT_EQ(r.status, SolveStatus::kCompleted) << r.reason;
  const double way = 2 * 0.5 * 0.5 / (2 * M_PI);  // of a whole sine: A T^2 / 2 pi
  const ShakeRow& last = r.history.row.back();
  EXPECT_NEAR(last.base_displacement[0], way, 2e-4 * way);
  EXPECT_NEAR(r.history.motion.back()[0], -last.base_displacement[0], 1e-7);
  EXPECT_LT(r.energy.gap_ratio, 1e-3);
}

// Newmark's block: it slides from mu g on; way of a rigid block under a rectangular pulse.
TEST(Shake, a_block_slides_as_newmark_says) {
  constexpr double kMu = 0.2, kG = 9.81, kA = 4, kT = 0.2;
  ModelSpec spec = lone_block(2, 0.1, kMu);
  StageSpec shake = shaken_by(PulseShape::kNone, 0, 0);
  RecordSpec& record = shake.get<ShakeStage>().record.front();
  record.unit = RecordUnit::kMetres;
  record.times = {0, 1e-6, kT, kT + 1e-6};
  record.accelerations = {0, kA, kA, 0};
  shake.get<ShakeStage>().free_vibration = 0.5;
  spec.stage.push_back(shake);
  const Result r = shaken(spec);
  ASSERT_EQ(r.status, SolveStatus::kCompleted) << r.reason;
  const double wanted = -0.5 * kA * kT * kT * (kA / (kMu * kG) - 1);
  EXPECT_NEAR(r.history.motion.back()[0], wanted, 5e-3 * std::fabs(wanted));
  EXPECT_NEAR(r.shaking.largest_slip, -wanted, 5e-3 * std::fabs(wanted));
  EXPECT_NEAR(r.shaking.motion.front().residual, -wanted, 5e-3 * std::fabs(wanted));
  // the ground feels no more than friction
  EXPECT_NEAR(r.shaking.peak_base_shear, kMu * 2000 * 0.2 * 0.3 * kG,
              0.05 * kMu * 2000 * 0.06 * kG);
}

TEST(Shake, a_toppled_block_is_a_collapse_and_a_rocking_one_is_not) {
  ModelSpec spec = lone_block(0.3, 1.2, 2);
  spec.solve.point_rule = PointRule::kCorners;
  spec.solve.points_per_face = 2;
  StageSpec shake = shaken_by(PulseShape::kHalfCycle, 4, 0.8);
  shake.get<ShakeStage>().restitution = 0.2;
  shake.get<ShakeStage>().free_vibration = 3;
  spec.stage.push_back(shake);
  const Result rocks = shaken(spec);
  EXPECT_EQ(rocks.status, SolveStatus::kCompleted) << rocks.reason;
  EXPECT_FALSE(rocks.shaking.collapsed);
  EXPECT_GT(rocks.shaking.motion.front().peak, 1e-3);
  spec.stage.back().get<ShakeStage>().record.front().amplitude = 12;
  const Result falls = shaken(spec);
  EXPECT_EQ(falls.status, SolveStatus::kCollapsed);
  EXPECT_EQ(falls.reason.code, "block.toppled");
  EXPECT_TRUE(falls.shaking.collapsed);
}

// Peaks are read from rows: a block that rocks to and fro between two of them would seem to stand still.
TEST(Shake, rows_far_apart_do_not_hide_the_motion) {
  ModelSpec spec = lone_block(0.3, 1.2, 2);
  StageSpec shake = shaken_by(PulseShape::kHalfCycle, 4, 0.8);
  shake.get<ShakeStage>().restitution = 0.2;
  spec.stage.push_back(shake);
  const Result usual = shaken(spec);
  spec.stage.back().get<ShakeStage>().interval = 100;
  const Result far = shaken(spec);
  EXPECT_GT(usual.shaking.motion.front().peak, 1e-3);
  EXPECT_NEAR(far.shaking.motion.front().peak, usual.shaking.motion.front().peak,
              0.02 * usual.shaking.motion.front().peak);
  const std::vector<Message> notes = compile(spec).anatomy.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(),
                          [](const Message& n) { return n.code == "shake.rows"; }));
}

TEST(Shake, a_mirrored_record_mirrors_the_answer) {
  ModelSpec spec = lone_block(0.3, 1.2, 2);
  StageSpec shake = shaken_by(PulseShape::kCycle, 5, 0.6);
  shake.get<ShakeStage>().restitution = 0.3;
  shake.get<ShakeStage>().free_vibration = 0.5;
  spec.stage.push_back(shake);
  const Result one = shaken(spec);
  spec.stage.back().get<ShakeStage>().scale.factor = -1;
  const Result other = shaken(spec);
  ASSERT_EQ(one.history.row.size(), other.history.row.size());
  double most = 0;
  for (std::size_t k = 0; k < one.history.motion.size(); ++k) {
    EXPECT_NEAR(one.history.motion[k][0], -other.history.motion[k][0], 1e-9);
    most = std::fmax(most, std::fabs(one.history.motion[k][0]));
  }
  EXPECT_GT(most, 1e-3);
}

// The base moved under the wall, or the wall computed in the base's frame: the same motion against the base.
TEST(Shake, moving_supports_are_the_frame_of_the_base) {
  const auto model = [](bool supports) {
    ModelSpec spec = scenes::in_space({scenes::box("floor", {-1, -0.2, -1}, {2, 0.2, 2}, true),
                                       scenes::box("a", {-0.2, 0, -0.15}, {0.4, 0.3, 0.3}),
                                       scenes::box("b", {-0.2, 0.3, -0.15}, {0.4, 0.3, 0.3})},
                                      scenes::dry_joint(1e9, 4e8, std::atan(0.3)));
    StageSpec shake = shaken_by(PulseShape::kCycle, 4, 0.3);
    if (supports) shake.get<ShakeStage>().record.front().at.block = "floor";
    shake.get<ShakeStage>().record.front().direction = Direction::kPlusZ;
    shake.get<ShakeStage>().free_vibration = 0.1;
    spec.stage = {scenes::gravity_stage(), shake};
    return spec;
  };
  const Result frame = shaken(model(false)), moved = shaken(model(true));
  ASSERT_EQ(frame.history.row.size(), moved.history.row.size());
  const GroundMotion base = compile(model(false)).stages.back().base.front();
  double most = 0;
  for (std::size_t k = 0; k < frame.history.row.size(); ++k) {
    const double wanted =
        frame.history.motion[k][2] + base.displacement_at(frame.history.row[k].time);
    EXPECT_NEAR(moved.history.motion[k][2], wanted, 2e-5);
    most = std::fmax(most, std::fabs(frame.history.motion[k][2]));
  }
  EXPECT_GT(most, 1e-3);
  EXPECT_LT(frame.energy.gap_ratio, 1e-2);
}

TEST(Shake, in_space_as_in_the_plane) {
  std::vector<BlockSpec> blocks{scenes::rectangle("floor", -0.5, -0.2, 1.3, 0.2)};
  blocks.front().fixed = true;
  for (int k = 0; k < 3; ++k)
    blocks.push_back(scenes::rectangle("b" + std::to_string(k), 0, 0.2 * k, 0.3, 0.2));
  ModelSpec plane =
      scenes::assembly(blocks, scenes::dry_joint(1e9, 4e8, std::atan(0.6)), 0.3, 2000);
  plane.solve.point_rule = PointRule::kCorners;
  plane.solve.points_per_face = 2;
  StageSpec shake = shaken_by(PulseShape::kCycle, 6, 0.4);
  shake.get<ShakeStage>().restitution = 0.5;
  shake.get<ShakeStage>().mass_damping = {0.02, 10};
  plane.stage = {scenes::gravity_stage(), shake};
  plane.solve.damping_form = DampingForm::kComponents;
  const Result flat = shaken(plane), space = shaken(scenes::prisms(plane));
  ASSERT_EQ(flat.status, SolveStatus::kCompleted) << flat.reason;
  const std::size_t rows = std::min(flat.history.row.size(), space.history.row.size());
  double most = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    most = std::fmax(most, std::fabs(flat.history.motion[k][0]));
    EXPECT_NEAR(flat.history.motion[k][0], space.history.motion[k][0], 1e-4) << k;
  }
  EXPECT_GT(most, 2e-3);
  EXPECT_LT(flat.energy.gap_ratio, 1e-2);
  EXPECT_LT(space.energy.gap_ratio, 1e-2);
}

}  // namespace
}  // namespace wythe::shaking_test
