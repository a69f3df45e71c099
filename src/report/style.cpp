#include "report/style.h"

namespace wythe::report {

std::string picture_style() {
  return R"css(
:root{--ink:#20242a;--soft:#636b75;--hair:#dfdbd2;--paper:#fff;--ground:#8b857a;
--stone0:#ece2cf;--stone1:#e5d9c2;--stone2:#f0e8d9;--stone3:#dfd2b9;--mortar:#b9ab91;--split:#d8cbb2;
--timber:#bb8a55;--plate:#aab3bd;--open:#d55e00;--slip:#0072b2;--crush:#8f0052;--closed:#8a4f24;
--curve:#0b5c8e;--shear:#d98a00;--mark:#20242a}
@media (prefers-color-scheme:dark){:root{--ink:#e8e6e1;--soft:#a2a8b0;--hair:#373b41;--paper:#1f2226;
--ground:#7d786e;--stone0:#575043;--stone1:#60584a;--stone2:#4f493d;--stone3:#686050;--mortar:#35312a;
--split:#47423a;--timber:#93683a;--plate:#6d7680;--open:#ff8a33;--slip:#56b4e9;--crush:#ff7ec0;
--closed:#d9a273;--curve:#6cc3f2;--shear:#f0b429;--mark:#e8e6e1}}
svg.wall,svg.curve{display:block;width:100%;height:auto;font:13px system-ui,"Segoe UI",Roboto,Helvetica,
Arial,sans-serif}
svg text{fill:var(--ink)}svg text.soft{fill:var(--soft)}svg text.small{font-size:11px;fill:var(--soft)}
svg text.bold{font-weight:600}
.stone0{fill:var(--stone0)}.stone1{fill:var(--stone1)}.stone2{fill:var(--stone2)}
.stone3{fill:var(--stone3)}.timber{fill:var(--timber)}.plate{fill:var(--plate)}
.stone0,.stone1,.stone2,.stone3,.timber,.plate{stroke:none}
.support{fill:var(--ground);opacity:.55}
.mortar{stroke:var(--mortar);stroke-width:.9;fill:none}.split{stroke:var(--split);stroke-width:.5;fill:none}
.zone{stroke:var(--split);stroke-width:.5;fill:none;opacity:.5}
.ground{stroke:var(--ground);stroke-width:1.6;fill:none}.hatch{stroke:var(--ground);stroke-width:.8;fill:none}
.rest{stroke:var(--soft);stroke-width:.8;stroke-dasharray:2 4;fill:none;opacity:.6}
.crack{fill:none;stroke-linecap:round}.open{stroke:var(--open)}.slip{stroke:var(--slip)}
.closed{stroke:var(--closed)}.softening{stroke:var(--closed);stroke-dasharray:2.5 3}
.crushed{fill:var(--crush);stroke:var(--paper);stroke-width:1}
.arrow{stroke:var(--ink);stroke-width:2.4;fill:none;stroke-linejoin:round;stroke-linecap:round}
.scale{stroke:var(--ink);stroke-width:1.6;fill:none}
.grid{stroke:var(--hair);stroke-width:1}.axis{stroke:var(--soft);stroke-width:1.2}
.force{stroke:var(--curve);stroke-width:2.4;fill:none;stroke-linejoin:round}
.base{stroke:var(--shear);stroke-width:1.1;fill:none}
.guide{stroke:var(--soft);stroke-width:1;stroke-dasharray:4 4;fill:none}
.mark{fill:var(--paper);stroke:var(--mark);stroke-width:1.4}.peak{fill:var(--curve);stroke:var(--paper);
stroke-width:1.5}svg text.markno{font-size:10px;font-weight:600}
svg text.halo{paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}
)css";
}

std::string page_style() {
  return R"css(
:root{color-scheme:light dark;--page:#f6f4ef;--good:#00734f;--warn:#a04a00}
@media (prefers-color-scheme:dark){:root{--page:#17191c;--good:#4fd1a5;--warn:#ffb066}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);font:16px/1.5 system-ui,"Segoe UI",Roboto,Helvetica,
Arial,sans-serif;font-variant-numeric:tabular-nums}
main{max-width:1180px;margin:0 auto;padding:36px 28px 60px}
header .kind{color:var(--soft);font-size:14px;letter-spacing:.02em;margin:0}
h1{font-size:30px;line-height:1.2;margin:2px 0 14px;font-weight:650;overflow-wrap:anywhere}
h2{font-size:19px;margin:44px 0 12px;font-weight:650}
h3{font-size:15px;margin:22px 0 8px;font-weight:650}
p.headline{font-size:21px;line-height:1.45;margin:0 0 8px;max-width:60em}
p.headline b{font-weight:650;white-space:nowrap}
p.soft,.soft{color:var(--soft)}p{max-width:72em}
.warning{border-left:4px solid var(--warn);background:var(--paper);padding:10px 16px;margin:16px 0;
border-radius:0 6px 6px 0}.warning b{color:var(--warn)}
.numbers{display:grid;grid-template-columns:repeat(auto-fit,minmax(205px,1fr));gap:14px;margin:26px 0 0}
.number{background:var(--paper);border:1px solid var(--hair);border-radius:8px;padding:14px 16px}
.number .value{font-size:27px;font-weight:650;line-height:1.2;white-space:nowrap}
.number .name{font-weight:600;margin-top:2px}.number .means{color:var(--soft);font-size:13.5px;
line-height:1.4;margin-top:4px}
figure{margin:0;background:var(--paper);border:1px solid var(--hair);border-radius:8px;padding:16px 18px}
figcaption{font-size:14px;color:var(--soft);margin-top:8px}figcaption b{color:var(--ink);font-weight:650}
.pictures{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,500px),1fr));gap:16px}
.legend{display:flex;flex-wrap:wrap;gap:6px 22px;margin:0 0 14px;padding:0;list-style:none;font-size:14px}
.legend svg{width:34px;height:14px;vertical-align:-2px;margin-right:7px;overflow:visible}
.scroll{overflow-x:auto}
table{border-collapse:collapse;font-size:14.5px;min-width:50%}
th,td{padding:5px 16px 5px 0;text-align:right;vertical-align:top;border-bottom:1px solid var(--hair)}
th{color:var(--soft);font-weight:600}th:first-child,td:first-child{text-align:left}
table.words th,table.words td{text-align:left}table.words td:first-child{white-space:nowrap}
table.last th:last-child,table.last td:last-child{text-align:left;padding-left:10px}
td code,code{font:13.5px ui-monospace,"DejaVu Sans Mono",Consolas,monospace;overflow-wrap:anywhere}
.bar{display:flex;height:26px;border-radius:5px;overflow:hidden;margin:4px 0 14px;max-width:900px;gap:2px}
.bar span{display:block;min-width:2px}.key{display:inline-block;width:11px;height:11px;border-radius:2px;
margin-right:8px}
.e0{background:#0072b2}.e1{background:#d55e00}.e2{background:#cc79a7}.e3{background:#999}.e4{background:#56b4e9}
.e5{background:#f0e442}.e6{background:#009e73}
table.second th:nth-child(2),table.second td:nth-child(2){text-align:left}
table.bare thead{display:none}
.verdict{font-size:17px}.two{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,430px),1fr));
gap:0 44px}
ol.marks{margin:10px 0 0;padding-left:22px;font-size:14px;columns:2 340px;column-gap:36px}
ol.marks li{break-inside:avoid}
footer{margin-top:48px;padding-top:14px;border-top:1px solid var(--hair);color:var(--soft);font-size:13.5px}
@media print{:root{--page:#fff;--ink:#000;--paper:#fff;--soft:#444}body{font-size:10.5pt}
main{padding:0;max-width:none}figure,.number{break-inside:avoid}h2{break-after:avoid}
.bar span,.key{print-color-adjust:exact;-webkit-print-color-adjust:exact}
.pictures{grid-template-columns:1fr 1fr}}
)css";
}

}  // namespace wythe::report
