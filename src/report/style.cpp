// One style sheet for all pictures: rules name colours by variables, and dark mode only changes the variables.
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
.link{stroke:var(--curve);stroke-width:2;fill:none}.link.diaphragm{stroke-width:4;opacity:.55}
.link.slack{stroke-dasharray:5 4}.link-end{fill:var(--curve)}.level{stroke:var(--soft);stroke-width:1}
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

}  // namespace wythe::report
