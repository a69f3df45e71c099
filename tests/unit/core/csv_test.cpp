// Cells of a CSV file: no spreadsheet takes one for a formula, and each reads back as it was written.
#include "io/text/csv.h"

#include <gtest/gtest.h>

#include <string>

namespace wythe::csv_test {
namespace {

TEST(CsvCell, a_text_that_a_spreadsheet_would_run_is_guarded) {
  EXPECT_EQ(io::csv_cell(std::string("=1+1")), "'=1+1");
  EXPECT_EQ(io::csv_cell(std::string("+1")), "'+1");
  EXPECT_EQ(io::csv_cell(std::string("-2")), "'-2");
  EXPECT_EQ(io::csv_cell(std::string("@SUM(A1)")), "'@SUM(A1)");
  EXPECT_EQ(io::csv_cell(std::string("\t=1")), "'\t=1");
  EXPECT_EQ(io::csv_cell(std::string("\r=1")), "\"'\r=1\"");
  EXPECT_EQ(io::csv_cell(std::string("\uFF1D1")), "'\uFF1D1");
  EXPECT_EQ(io::csv_cell(std::string("=HYPERLINK(\"a\",\"b\")")),
            "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\"");
}

TEST(CsvCell, other_texts_and_numbers_stay_as_they_are) {
  EXPECT_EQ(io::csv_cell(std::string("pier 1 = left")), "pier 1 = left");
  EXPECT_EQ(io::csv_cell(std::string("")), "");
  EXPECT_EQ(io::csv_cell(-0.5), "-0.5");
}

TEST(CsvCell, reads_back_as_what_was_written) {
  for (const char* text :
       {"", "=1", "'", "'=1", "''", "a", "a,b", "\"", "\"\"", "=\"a\"\n,'", "-", "a'b"})
    EXPECT_EQ(io::text_of_cell(io::csv_cell(std::string(text))), text);
}

}  // namespace
}  // namespace wythe::csv_test
