// Bad input from outside: not files, too large, too deep, too many, and links where results go.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "campaign/store/folder_lock.h"
#include "core/files.h"
#include "core/limits.h"
#include "core/shape.h"
#include "core/text.h"
#include "io/bodies/dxf.h"
#include "io/text/csv.h"
#include "io/text/json.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "unit/io_helpers.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/model.h"

namespace wythe::input_test {
namespace {

namespace fs = std::filesystem;
using io_tests::kModel;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// The message of an InputError; "" if there was none.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void expect_words(const std::string& said, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_TRUE(has(said, word)) << word << " in: " << said;
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

std::string text_in(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

// --- files in ------------------------------------------------------------------------------------

class Files : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return folder_ / name; }
  TemporaryFolder folder_;
};

TEST_F(Files, what_is_no_file_is_refused_by_its_kind_and_not_waited_for) {
  fs::create_directory(at("folder"));
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un name{.sun_family = AF_UNIX, .sun_path = {}};
  at("socket").copy(name.sun_path, sizeof name.sun_path - 1);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&name), sizeof name), 0);
  for (const auto& [named, kind] :
       std::vector<std::pair<std::string, std::string>>{{at("folder"), "a folder"},
                                                        {at("pipe"), "a pipe"},
                                                        {at("socket"), "a socket"},
                                                        {"/dev/zero", "a device"},
                                                        {"/dev/null", "a device"}}) {
    const std::string& path = named;
    const std::vector<std::string> words = {path + ": is " + kind + ", not a file; "};
    expect_words(refusal([&] { (void)read_file(path, kMostJson); }), words);
    expect_words(refusal([&] { (void)read_model(path); }), words);
    expect_words(refusal([&] { (void)read_study(path); }), words);
    expect_words(refusal([&] { (void)read_law(path); }), words);
    expect_words(refusal([&] { (void)read_contact_path(path); }), words);
  }
  ::close(listener);
}

TEST_F(Files, a_link_is_followed_to_read_and_judged_by_where_it_leads) {
  write(at("file"), "text");
  fs::create_symlink("file", at("to_file"));
  fs::create_symlink("/dev/zero", at("to_device"));
  EXPECT_EQ(read_file(at("to_file"), 10), "text");
  expect_words(refusal([&] { (void)read_file(at("to_device"), 10); }), {"is a device"});
}

TEST_F(Files, a_file_beyond_the_limit_is_not_read) {
  write(at("sparse"), "");
  fs::resize_file(at("sparse"), std::uintmax_t{1} << 40);
  expect_words(refusal([&] { (void)read_model(at("sparse")); }),
               {"1.09951e+06 MB", "at most 4 MB", "limits.md"});
  write(at("eleven"), "12345678901");
  EXPECT_EQ(read_file(at("eleven"), 11).size(), 11U);
  expect_words(refusal([&] { (void)read_file(at("eleven"), 10); }), {"or more"});
}

TEST_F(Files, a_file_that_does_not_tell_its_size_or_grows_is_read_to_its_end_or_the_limit) {
  EXPECT_TRUE(has(read_file("/proc/self/status", 100'000), "Pid:"));  // says 0 bytes
  expect_words(refusal([&] { (void)read_file("/proc/self/status", 100); }), {"or more, at most"});
}

TEST_F(Files, a_file_that_is_empty_or_missing_is_told_from_one_that_is_wrong) {
  write(at("empty"), "");
  EXPECT_EQ(read_file(at("empty"), 10), "");
  EXPECT_THROW((void)read_file(at("none"), 10), IoError);
}

TEST_F(Files, a_text_is_utf8_without_zeros) {
  const auto said = [&](const std::string& text) {
    write(at("text"), text);
    return refusal([&] { (void)read_text(at("text"), 100); });
  };
  EXPECT_EQ(said("\xEF\xBB\xBFgr\xC3\xBC\xC3\x9F \xE2\x82\xAC \xF0\x9F\xA7\xB1"), "");
  expect_words(said("one\ntwo\xFC"), {"text:2: byte 0xfc", "UTF-8"});
  expect_words(said(std::string("a\0b", 3)), {"text:1: byte 0x00"});
  expect_words(said(std::string("\xFF\xFEm\0o\0", 6)), {"text:1: byte 0xff"});
  expect_words(said("cut \xE2\x82"), {"byte 0xe2"});
}

// --- files out -----------------------------------------------------------------------------------

TEST_F(Files, nothing_is_written_through_a_link_or_into_what_is_no_file) {
  write(at("mine"), "mine");
  fs::create_symlink("mine", at("link"));
  fs::create_symlink("nowhere", at("dangling"));
  fs::create_directory(at("folder"));
  ASSERT_EQ(::mkfifo(at("pipe").c_str(), 0600), 0);
  for (const auto& [named, kind] :
       std::vector<std::pair<std::string, std::string>>{{"link", "a link to mine"},
                                                        {"dangling", "a link"},
                                                        {"folder", "a folder"},
                                                        {"pipe", "a pipe"}}) {
    const std::string& name = named;
    expect_words(refusal([&] { write_file(at(name), "results"); }),
                 {at(name) + ": is " + kind, "remove it, or name another place"});
  }
  EXPECT_EQ(text_in(at("mine")), "mine");
  EXPECT_FALSE(fs::exists(at("nowhere")));
  expect_words(refusal([&] { write_contact_answer("/dev/full", {}, {}); }), {"is a device"});
}

TEST_F(Files, a_link_laid_where_a_part_is_written_is_not_followed) {
  write(at("mine"), "mine");
  fs::create_symlink("mine", at("a.txt.part" + std::to_string(::getpid())));
  write_file(at("a.txt"), "results");
  EXPECT_EQ(text_in(at("mine")), "mine");
  EXPECT_EQ(text_in(at("a.txt")), "results");
  EXPECT_FALSE(fs::is_symlink(at("a.txt")));
}

TEST_F(Files, a_folder_of_results_with_a_link_among_them_is_refused_before_anything_runs) {
  write(at("mine"), "mine");
  const std::string out = at("out");
  fs::create_directory(out);
  write(out + "/force_displacement.csv", "old");
  fs::create_symlink("../mine", out + "/summary.json");
  expect_words(refusal([&] { (void)replace_run(out); }), {"summary.json: is a link to ../mine"});
  expect_words(refusal([&] { Replacement(out, [](const std::string&) { return true; }); }),
               {"summary.json: is a link"});
  fs::remove(out + "/summary.json");
  for (const char* hidden : {".wythe_new", ".wythe_ready"}) {
    fs::create_directory(at("other"));
    write(at("other/model.toml"), "mine");
    fs::create_symlink("../other", out + "/" + hidden);
    expect_words(refusal([&] { (void)replace_run(out); }), {hidden, "is no folder", "remove it"});
    EXPECT_EQ(text_in(at("other/model.toml")), "mine");
    fs::remove(out + "/" + hidden);
    fs::remove_all(at("other"));
  }
  EXPECT_NE(replace_run(out), nullptr);
}

TEST_F(Files, a_campaign_locks_and_writes_nothing_through_links) {
  write(at("mine"), "mine");
  const std::string out = at("out");
  fs::create_directory(out);
  for (const char* name : {"campaign.lock", "samples.csv", "report.html"}) {
    fs::create_symlink("../mine", out + "/" + name);
    expect_words(refusal([&] { check_folder(out, FolderFor::kCampaign); }), {name, "is a link"});
    if (std::string(name) == "campaign.lock")
      expect_words(refusal([&] { const study::FolderLock lock(out); }), {"is a link"});
    fs::remove(out + "/" + name);
  }
  const StudySpec study = scenes::small_study(2);
  for (const char* name : {"campaign.db", "campaign.db-wal"}) {
    fs::create_symlink("../other", out + "/" + name);
    expect_words(refusal([&] { run_campaign(study, model_builder(study), out, {.jobs = 1}); }),
                 {name, "is a link to ../other"});
    fs::remove(out + "/" + name);
  }
  EXPECT_EQ(text_in(at("mine")), "mine");
  EXPECT_FALSE(fs::exists(at("other")));
}

TEST_F(Files, a_store_that_is_no_file_is_refused_by_its_kind) {
  for (const char* kind : {"a folder", "a pipe"}) {
    const std::string store = at("campaign.db");
    if (std::string(kind) == "a folder")
      fs::create_directory(store);
    else
      ASSERT_EQ(::mkfifo(store.c_str(), 0600), 0);
    expect_words(refusal([&] { (void)read_campaign(at("")); }), {"campaign.db: is ", kind});
    fs::remove(store);
  }
}

// --- shapes --------------------------------------------------------------------------------------

TEST(Shape, fifty_thousand_dots_and_a_hundred_thousand_brackets_are_refused_with_their_line) {
  for (const std::string& text :
       {"a" + repeated(".a", 50'000) + " = 1", "[a" + repeated(".a", 50'000) + "]\nx = 1",
        "[[a" + repeated(" . \"a\"", 50'000) + "]]", "a = " + repeated("[", 100'000),
        "a = " + repeated("{a = ", 100'000) + "1" + repeated("}", 100'000),
        "a = [\n" + repeated("[", 100'000) + repeated("]", 100'000) + "]"}) {
    const std::string said = refusal([&] { (void)parse_model("name = \"x\"\n" + text, "m.toml"); });
    expect_words(said, {"m.toml:", "nests deeper than 32 levels", "limits.md"});
    EXPECT_FALSE(has(said, "m.toml:1:")) << said;
  }
  for (const std::string& text : {repeated("[", 100'000) + repeated("]", 100'000),
                                  repeated("{\"a\": ", 100'000) + "1" + repeated("}", 100'000),
                                  "{\"units\": \"m\", \"blocks\": [" + repeated("[", 100'000)})
    expect_words(refusal([&] { (void)io::parse_json("\n" + text, "b.json"); }),
                 {"b.json:2: nests deeper than 32 levels"});
}

TEST(Shape, fifty_thousand_keys_are_refused) {
  for (const char* line :
       {"wall.k{} = 1\n", "k{}.a.b = 1\n", "[k{}]\n", "[[k{}]]\n", "k{} = {}\n"}) {
    std::string text;
    for (int k = 0; k < 50'000; ++k) {
      text += line;
      text.replace(text.rfind("k{"), 3, "k" + std::to_string(k));
    }
    expect_words(refusal([&] { (void)parse_model(text, "m.toml"); }),
                 {"m.toml:", "has more than 20000 keys"});
  }
}

TEST(Shape, what_stands_in_texts_and_comments_counts_for_nothing) {
  const std::string dots = repeated(".", 100), brackets = repeated("[", 100);
  for (const std::string& text : {"# " + dots + brackets, "note = \"" + dots + brackets + "\"",
                                  "note = '" + brackets + "\\'", "note = \"\\\"" + brackets + "\"",
                                  "note = \"\"\"\n" + brackets + "\"\"\"\"\"\nname = \"x\"",
                                  "note = '''" + brackets + "''''\nname = '" + brackets + "'",
                                  "note = \"\"\"\\\"\"\"" + brackets + "\"\"\""})
    EXPECT_EQ(refusal([&] { check_shape(text, Syntax::kToml, "m.toml"); }), "") << text;
  EXPECT_EQ(refusal([&] {
              check_shape("{\"a\": \"'" + brackets + "\\\"" + brackets + "\", \"b'\": [1.5]}",
                          Syntax::kJson, "b.json");
            }),
            "");
  // and nothing after them is hidden by them
  for (const std::string& begin : {std::string("a = \"x\"\n"), std::string("a = '''''' # \"\n"),
                                   std::string("a = \"\"\"\"\"\"\n"), std::string("a = '\\'\n")})
    EXPECT_NE(refusal([&] { check_shape(begin + "b = " + brackets, Syntax::kToml, ""); }), "")
        << begin;
}

TEST(Shape, a_setting_s_path_and_value_may_not_nest_deep_either) {
  const auto said = [](const std::string& set) {
    return refusal([&] { (void)parse_model(kModel, "m.toml", {set}); });
  };
  expect_words(said("a" + repeated(".a", 50'000) + "=1"),
               {"--set", "has 50001 steps", "at most 32"});
  for (const std::string& value :
       {repeated("[", 100'000), "1\nb" + repeated(".b", 50'000) + " = 1", repeated("{a=", 50'000)})
    expect_words(said("wall.length=" + value), {"--set", "wall.length"});
}

// --- odd texts -----------------------------------------------------------------------------------

TEST(OddToml, numbers_no_computer_has_are_refused_with_their_line) {
  const auto said = [](const std::string& value) {
    return refusal([&] {
      (void)parse_model(std::string(kModel) + "\n[solve]\nstep_fraction = " + value, "m.toml");
    });
  };
  for (const std::string& value :
       {repeated("1", 10'000), std::string("1e999"), "0." + repeated("1", 10'000) + "e999"})
    expect_words(said(value), {"m.toml:"});
  EXPECT_LT(said(repeated("1", 10'000)).size(), 1000U);
}

TEST(OddToml, a_mark_of_byte_order_is_skipped_and_a_key_given_twice_refused) {
  EXPECT_EQ(refusal([&] { (void)parse_model("\xEF\xBB\xBF" + std::string(kModel), "m.toml"); }),
            "");
  expect_words(refusal([&] { (void)parse_model("name = 'a'\nname = 'b'\n", "m.toml"); }),
               {"m.toml:2"});
}

TEST(OddJson, is_refused_with_file_and_cure) {
  const auto said = [](const std::string& text) {
    return refusal([&] { (void)io::parse_json(text, "b.json"); });
  };
  expect_words(said("{\"units\": \"m\",\n \"units\": \"mm\"}"), {"b.json: ", "\"units\" twice"});
  EXPECT_EQ(said("[{\"a\": 1}, {\"a\": {\"a\": 2}}]"), "");
  expect_words(said("[1e999]"), {"beyond 1.8e308"});
  EXPECT_EQ(said("[" + repeated("1", 10'000) + "e-9990]"), "");
  expect_words(said("\n{\"a\": "), {"b.json:2: not valid JSON"});
  expect_words(said(""), {"not valid JSON"});
}

TEST(OddCsv, lines_of_many_cells_and_files_of_many_rows_end_at_the_limit) {
  const std::string wide = repeated("1,", kMostColumns) + "1\n";
  expect_words(refusal([&] {
                 io::CsvLines lines(wide, "v.csv");
                 (void)lines.next();
               }),
               {"v.csv:1: has more than 1000 cells"});
  const std::string many = repeated("1\n", kMostRows + 2);
  expect_words(refusal([&] {
                 io::CsvLines lines(many, "v.csv");
                 while (lines.next()) continue;
               }),
               {"v.csv:10000002: has more than 10000000 rows"});
}

TEST(OddCsv, blank_lines_comments_and_ends_of_any_system_are_one_format) {
  const std::string text = "\xEF\xBB\xBF# of 2019\r\n\r\na , b\r\n +1,2\n3";
  const std::string file = "v.csv";
  io::CsvLines lines(text, file);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.cells(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(lines.line(), 3);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(io::number_in(lines.cells()[0]), 1);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.text(), "3");
  EXPECT_FALSE(lines.next());
  for (const char* cell : {"", "+", "1x", "nan", "inf", "1e999", "0x10", "1 2"})
    EXPECT_TRUE(std::isnan(io::number_in(cell))) << cell;
}

TEST(Limits, stand_in_their_page) {
  const std::string page = text_in(source_dir() + "/docs/reference/limits.md");
  const auto megabytes = [](std::size_t bytes) {
    return "| " + std::to_string(bytes / 1'000'000) + " MB |";
  };
  expect_words(
      page, {megabytes(kMostToml), megabytes(kMostJson), megabytes(kMostDxf), megabytes(kMostCsv),
             megabytes(kMostPacked), "| " + std::to_string(kMostDepth) + " levels |", "| 20 000 |",
             "| 1000 |", "| 10 000 000 |", "| " + std::to_string(kMostFaults) + " |"});
  EXPECT_EQ(kMostKeys, 20'000);
  EXPECT_EQ(kMostSettings, 2000);
  EXPECT_EQ(kMostColumns, 1000);
  EXPECT_EQ(kMostRows, 10'000'000);
}

// --- many faults ---------------------------------------------------------------------------------

TEST(ManyFaults, a_hundred_are_told_and_that_there_are_more) {
  std::string blocks = "{\"units\": \"m\", \"blocks\": [0" + repeated(",0", 1'000'000) + "]}";
  try {
    (void)parse_model(io_tests::with(kModel, "[wall]\n", "[wall]\nblocks = \"b.json\"\n"), "m.toml",
                      {}, blocks);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_LT(error.faults().size(), 2 * kMostFaults);
    expect_words(error.what(), {"and more like these; mend these first"});
  }
}

// 1000 doors in one place: half a million pairs of them overlap.
TEST(ManyFaults, openings_that_lie_on_each_other_are_not_told_in_pairs) {
  ModelSpec spec = parse_model(kModel, "m.toml");
  const OpeningSpec door = spec.wall.opening.at(0);
  spec.wall.opening.assign(1000, door);
  try {
    (void)compile(spec);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_LT(error.faults().size(), 10'000U);
    expect_words(error.what(), {"mend these first"});
  }
}

TEST(ManyFaults, long_names_and_long_lists_are_not_compared) {
  const std::string a(1'000'000, 'a');
  EXPECT_EQ(nearest_name(a, {a + "b"}), "");
  EXPECT_EQ(nearest_name("lenght", {"length", a}), "length");
  const std::vector<std::string> many(100'000, "name");
  EXPECT_LT(name_advice("nane", many).size(), 1000U);
}

// --- drawings ------------------------------------------------------------------------------------

class Drawings : public Files {
 protected:
  // What is said of a file with this content.
  std::string said(const std::string& text, const std::string& unit = "m") {
    write(at("stones.dxf"), text);
    return refusal([&] { (void)io::parse_drawing(at("stones.dxf"), unit); });
  }
  static std::string section(const std::string& entities) {
    return "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
  }
  static std::string polyline(const std::string& vertices, const char* flags = "1") {
    return std::string("0\nLWPOLYLINE\n5\n2F\n8\nstones\n70\n") + flags + "\n" + vertices;
  }
};

TEST_F(Drawings, that_are_none_are_refused_with_what_to_do) {
  expect_words(said("AutoCAD Binary DXF\r\n\x1a"), {"binary", "ASCII DXF"});
  expect_words(said("AC1032 and so on"), {"DWG", "ASCII DXF"});
  expect_words(said(""), {"is empty"});
  expect_words(said("0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n"), {"no EOF"});
  expect_words(said("0\nSECTION\n2"), {":3:", "not whole"});
  expect_words(said("hello\nworld\n"), {":1:", "hello", "no group code"});
  expect_words(said("0\nEOF\n"), {"no section ENTITIES"});
  expect_words(said(section(""), "furlong"), {"furlong", "mm"});
  expect_words(said(section(""), ""), {"does not say its unit", "blocks_unit"});
  expect_words(said(section(polyline("10\nwide\n20\n0\n"))), {"wide", "must be a number", ":14:"});
  expect_words(said(section(polyline("10\nnan\n20\n0\n"))), {"nan", "must be a number"});
  std::string zero = section("");
  zero[1] = '\0';
  expect_words(said(zero), {"no text"});
}

TEST_F(Drawings, at_their_largest_are_refused_before_they_are_read) {
  write(at("stones.dxf"), section(""));
  fs::resize_file(at("stones.dxf"), kMostDxf + 1);
  expect_words(refusal([&] { (void)io::parse_drawing(at("stones.dxf"), "m"); }), {"64 MB"});
}

TEST_F(Drawings, what_is_no_outline_is_kept_with_its_place) {
  const auto unread = [&](const std::string& entities) {
    write(at("stones.dxf"), section(entities));
    const io::Drawing drawing = io::parse_drawing(at("stones.dxf"), "m");
    EXPECT_TRUE(drawing.outlines.empty());
    return drawing.unread.size() == 1 ? to_string(io::fault_of(drawing.unread[0], "f.dxf")) : "";
  };
  const std::string corners = "10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n";
  expect_words(unread(polyline(corners, "0")),
               {"f.dxf:5:", "LWPOLYLINE 2F", "layer stones", "is open"});
  expect_words(unread("0\nARC\n8\n0\n"), {"ARC"});
  expect_words(unread(polyline("10\n0\n20\n0\n10\n1\n20\n0\n")), {"fewer than 3"});
  expect_words(unread(polyline("10\n0\n10\n1\n20\n0\n10\n1\n20\n1\n")), {"without x or y"});
  expect_words(unread(polyline("10\n1e9\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n")), {"10 km"});
  expect_words(unread(polyline("230\n-1\n" + corners)), {"another plane"});
  expect_words(unread("0\nSPLINE\n5\n3A\n8\narches\n"), {"SPLINE 3A", "layer arches", "straight"});
  expect_words(unread("0\nINSERT\n8\n0\n"), {"INSERT on layer 0", "explode"});
}

TEST_F(Drawings, of_an_old_code_page_keep_the_names_of_their_layers) {
  write(at("stones.dxf"), section("0\nLWPOLYLINE\n8\nT\xfc"
                                  "ff\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n"));
  const io::Drawing drawing = io::parse_drawing(at("stones.dxf"), "m");
  ASSERT_EQ(drawing.outlines.size(), 1U);
  EXPECT_EQ(drawing.outlines[0].layer,
            "T\xc3\xbc"
            "ff");
}

TEST_F(Drawings, of_many_faults_tell_a_hundred) {
  write(at("stones.dxf"), section(repeated("0\nSPLINE\n8\n0\n", 100'000)));
  write(at("model.toml"),
        "wall = { blocks = \"stones.dxf\", blocks_unit = \"m\", thickness = \"1 m\" }\n");
  const std::string said = refusal([&] { (void)read_model(at("model.toml")); });
  EXPECT_TRUE(has(said, "SPLINE"));
  EXPECT_LT(said.size(), 50'000U);
}

}  // namespace
}  // namespace wythe::input_test
