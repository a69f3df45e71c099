// Commands that write the page or the tables of stored results anew.
#pragma once

#include <string>

namespace wythe::app {

struct ReportArguments {
  std::string folder, language = "en";
};
int report(const ReportArguments& arguments);

struct ExportArguments {
  std::string folder, out;
  bool hdf5 = false;
  bool replaces = false;  // over tables of other results
};
int export_tables(const ExportArguments& arguments);

}  // namespace wythe::app
