// wythe studio: the page for drawing walls, with a model in it if one is named, as a file that can be passed on.
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "commands.h"
#include "wythe/error.h"
#include "wythe/io.h"

namespace wythe::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "<!--wythe:model-->";
// The limit for files of the page, web/src/studio/file/store.ts [bytes].
constexpr std::size_t kLongest = 1 << 20;

// Installed beside the program, or built beside its build folder; "" if there is none.
std::string studio_page() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& place : {folder / "../share/wythe/studio.html", folder / "../studio.html"})
    if (fs::exists(place, error)) return place.lexically_normal().string();
  return "";
}

// Opens the page if a user is at this terminal; returns whether a browser was started.
bool open_in_browser(const std::string& page) {
  if (::isatty(STDOUT_FILENO) == 0 ||
      (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr))
    return false;
  std::string program = "xdg-open", path = page;
  char* words[] = {program.data(), path.data(), nullptr};
  pid_t child = 0;
  return ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ) == 0;
}

// In hexadecimal digits, so that no text of the model can end the HTML element with it.
std::string in_digits(const std::string& text) {
  std::string out;
  for (const char c : text) out += fmt::format("{:02x}", static_cast<unsigned char>(c));
  return out;
}

// The text of a file that may still have faults; the studio shows them at their places.
std::string model_text(const std::string& path) {
  std::string text = read_data(path);
  const auto refuse = [&](const char* problem, const char* cure) {
    throw InputError({{.file = path, .problem = problem, .cure = cure}});
  };
  if (text.size() > kLongest) refuse("is longer than 1 MB", "name a model file");
  std::string letters = text;  // line ends and tabs are text too
  std::erase_if(letters, [](char c) { return c == '\n' || c == '\r' || c == '\t'; });
  if (readable(letters, letters.size()) != letters)
    refuse("holds bytes that are no UTF-8, or control characters", "name a model file");
  if (is_study(path)) refuse("is a study", "name its base model");
  return text;
}

}  // namespace

int studio(const StudioArguments& a) {
  const std::string page = studio_page();
  if (page.empty())
    throw InputError({{.file = "wythe studio",
                       .problem = "this installation has no studio",
                       .cure = "build it in the sources with make studio, then make "
                               "install or make package"}});
  check_answer_file(a.out, {a.model, page}, "<title>wythe studio</title>");
  std::string text = read_data(page);
  const std::string model = a.model.empty() ? "" : model_text(a.model);
  const std::size_t at = text.find(kMark);
  if (at == std::string::npos)
    throw IoError(page + ": is no studio of this version; make studio builds it again");
  text.replace(at, std::string_view(kMark).size(), in_digits(model));
  write_text(a.out, text);
  const std::string whole = fs::absolute(a.out).string();
  fmt::print("{} {}\n", open_in_browser(whole) ? "opens" : "open in a browser:", readable(whole));
  return 0;
}

}  // namespace wythe::app
