// report_page(): inserts the headline and the data into the built viewer (assets/viewer.html).
#include "core/check.h"
#include "core/text.h"
#include "report/assets.h"
#include "report/bundle.h"
#include "report/headline.h"
#include "report/html.h"
#include "report/texts.h"
#include "wythe/parts/report.h"

namespace wythe {
namespace {

using namespace report;

void put(std::string& page, std::string_view mark, const std::string& content) {
  const std::size_t at = page.find(mark);
  WYTHE_ASSERT(at != std::string::npos, "the viewer lacks one of its marks");
  page.replace(at, mark.size(), content);
}

std::span<const std::uint8_t> bytes_of(const std::string& data) {
  return {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()};
}

}  // namespace

std::string report_page(const std::string& data, const std::string& language) try {
  const Texts texts(language);
  const Json header = header_of(data);
  const std::string kind = header.at("kind"), title = header.value("title", "");
  std::string page(kViewerHtml);
  put(page, "<html lang=\"en\"", "<html lang=\"" + language + "\"");
  put(page, "<title>wythe</title>",
      "<title>" + escaped(title.empty() ? texts.say("untitled." + kind) : title) +
          ": wythe</title>");
  put(page, "<!--wythe:headline-->",
      headline_of(header, texts) + "<noscript><p class=\"warning\">" + texts.say("noscript") +
          "</p></noscript>");
  put(page, "<!--wythe:texts-->", texts_for_page(language));
  put(page, "<!--wythe:data-->", base64(bytes_of(data)));
  return page;
} catch (const Json::exception&) {
  refuse_data("are damaged");
}

std::vector<std::string> report_languages() { return languages(); }

}  // namespace wythe
