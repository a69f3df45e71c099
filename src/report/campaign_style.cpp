// Colours and line styles of a campaign's charts.
//
// Okabe and Ito's palette, told apart with any colour vision: piers warm, spandrel blue, rocking
// green. Dark pages take lighter tones of the same.
#include <algorithm>
#include <string>
#include <vector>

#include "report/campaign_charts.h"
#include "report/html.h"

namespace wythe::report {
namespace {

constexpr int kOthers = 3;  // colours of names that are not FM-1 ... FM-5

bool is_paper_mode(const std::string& mode) {
  return mode.size() == 4 && mode.starts_with("FM-") && mode[3] >= '1' && mode[3] <= '5';
}

}  // namespace

std::string mode_class(const std::vector<std::string>& modes, const std::string& mode) {
  if (is_paper_mode(mode)) return std::string("m") + mode[3];
  if (mode == "unclear") return "m0";
  int others = 0;
  for (const std::string& name : modes) {
    if (name == mode) break;
    others += is_paper_mode(name) ? 0 : 1;
  }
  // a campaign without the paper's modes has the paper's colours for its own
  const bool free = std::none_of(modes.begin(), modes.end(), is_paper_mode);
  return "m" + std::to_string(free ? 1 + others % (5 + kOthers) : 6 + others % kOthers);
}

std::string mode_legend(const Statistics& s) {
  std::string out = "<ul class=\"legend\">\n";
  for (const std::string& mode : s.modes) {
    out += "<li><svg viewBox=\"0 0 34 14\"><line class=\"mean " + mode_class(s.modes, mode) +
           "\" x1=\"2\" y1=\"7\" x2=\"32\" y2=\"7\"/></svg>" + escaped(mode) + "</li>\n";
  }
  return out + "</ul>\n";
}

std::string campaign_style() {
  return R"css(
:root{--m0:#8a8f96;--m1:#d55e00;--m2:#e69f00;--m3:#0072b2;--m4:#45a6dd;--m5:#009e73;--m6:#cc79a7;
--m7:#6b4fa0;--m8:#7a5c3a}
@media (prefers-color-scheme:dark){:root{--m1:#ff7a1f;--m2:#f2b632;--m3:#4a9fe0;--m4:#8fd0f5;
--m5:#2fc79a;--m6:#e39ac2;--m7:#a58be0;--m8:#b8946a}}
.m0{--c:var(--m0)}.m1{--c:var(--m1)}.m2{--c:var(--m2)}.m3{--c:var(--m3)}.m4{--c:var(--m4)}
.m5{--c:var(--m5)}.m6{--c:var(--m6)}.m7{--c:var(--m7)}.m8{--c:var(--m8)}.all{--c:var(--ink)}
svg.chart{display:block;width:100%;height:auto;font:13px system-ui,"Segoe UI",Roboto,Helvetica,Arial,
sans-serif}
.thin,.mean,.whisker,.fit,.step{fill:none;stroke:var(--c,var(--ink));stroke-linejoin:round}
.thin{stroke-width:.8;opacity:.6}.few{stroke-width:1.5;opacity:.9}.mean{stroke-width:2.6}.whisker{stroke:var(--ink);stroke-width:1.3}
.fit{stroke-width:1.4;stroke-dasharray:6 4;stroke:var(--ink)}.step{stroke-width:2;stroke:var(--curve)}
.spread{fill:var(--c,var(--curve));opacity:.13;stroke:none}
.box{fill:var(--c,var(--curve));stroke:var(--paper);stroke-width:1}
.dot{fill:var(--c,var(--ink));opacity:.8;stroke:var(--paper);stroke-width:.6}
.limit{stroke:var(--m1);stroke-width:1.2;stroke-dasharray:2 3;fill:none}
svg text.mode{fill:var(--c);font-weight:650;paint-order:stroke;stroke:var(--paper);stroke-width:4px;
stroke-linejoin:round}
.key.m0,.key.m1,.key.m2,.key.m3,.key.m4,.key.m5,.key.m6,.key.m7,.key.m8{background:var(--c)}
.three{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,330px),1fr));gap:16px}
.pair{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,480px),1fr));gap:16px}
td .pm{color:var(--soft);font-size:12.5px;white-space:nowrap}td{white-space:nowrap}
table.last td:last-child{white-space:normal}
details{margin:14px 0}summary{cursor:pointer;color:var(--soft)}
pre{background:var(--paper);border:1px solid var(--hair);border-radius:8px;padding:12px 16px;
overflow-x:auto;font:13.5px ui-monospace,"DejaVu Sans Mono",Consolas,monospace}
)css";
}

}  // namespace wythe::report
