// The commands of the wythe program; each returns its exit code (0 done, 2 input, 3 run, 4 I/O).
#pragma once

#include <string>
#include <vector>

namespace wythe::app {

inline constexpr int kFailed = 3;  // exit code of a run that failed
inline constexpr int kMostWalls = 100'000;

struct RunArguments {
  std::string model, out;
  std::string checkpoint;  // time between checkpoints, with its unit; "": none
  std::string resume;      // folder of a run to continue
  std::vector<std::string> overrides;
  int threads = 1;
  bool quiet = false;
  std::string language;   // of the report; "": English, or that of the resumed run
  std::string walls;      // number of walls with the model's scatter; "": one, without scatter
  std::string jobs;       // cores for walls; "": all
  bool replaces = false;  // over results of another model
};
int run(const RunArguments& arguments);

struct CheckArguments {
  std::string file;
  std::vector<std::string> overrides;
};
int check(const CheckArguments& arguments);

struct ContactArguments {
  std::string law, path, out;
};
int contact(const ContactArguments& arguments);
int materials(const std::string& name);

struct NewArguments {
  std::string kind, folder;
};
int new_starter(const NewArguments& arguments);

struct StudioArguments {
  std::string model, out = "studio.html";
};
int studio(const StudioArguments& arguments);

struct DrawingArguments {
  std::string file, unit, outline = "outline", openings = "openings", lintels = "lintels";
};
int drawing(const DrawingArguments& arguments);

struct LimitArguments {
  std::string model, out, with, language = "en";
  std::vector<std::string> overrides;
  std::vector<std::string> only;  // of lp, infinite, macro_block_1, macro_block_2; empty: all
  bool assessment = false;
  bool replaces = false;  // over results of another model
  bool quiet = false;
};
int limit(const LimitArguments& arguments);

}  // namespace wythe::app
