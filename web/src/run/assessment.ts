// The assessment of a wall by a code: verdict, capacity and demand over displacement, limit states with their
// clauses, the system of one degree of freedom, what is not modelled.
import { h, svg, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { Judged } from "../headers/assessment";
import type { Summary } from "../headers/run";
import { Plot, rangeOf, type Point } from "../base/plot";
import { zip, type Curve } from "./trust";
import { table } from "../base/tables";
import { num, phrase, qty, say, sentence } from "../base/texts";

const kGravity = 9.81; // value of g in codes
const bound = (check: { at_least: boolean }): string => (check.at_least ? "≥ " : "");
const stateOf = (check: { state: string }): string => say(`assessment.${check.state}`);

export function assessmentSection(summary: Summary, curve: Curve): Child {
  const a = summary.assessment;
  if (!a) return null;
  const fine = a.may_be_signed && a.verdict !== "fails";
  return [
    h("p", { class: fine ? "lead" : "warning", id: "assessment-verdict" }, sentence(a.sentence)),
    a.limit_states ? [figure(a, curve).element, limitStates(a), criteria(a), system(a)] : null,
    h("ul", { class: "soft small" }, a.notes.map((note) => h("li", {}, phrase(note)))),
  ];
}

// Force over mass against displacement of the system with one degree of freedom, with the spectrum in the same axes.
function figure(a: Judged, curve: Curve): Figure {
  const e = a.equivalent,
    gamma = e.participation_factor,
    perMass = 1000 / (gamma * e.mass_kg * kGravity);
  const until = 1.15 * Math.max(e.ultimate_displacement_mm, a.demand?.equivalent_displacement_mm ?? 0);
  const capacity: Point[] = zip(
    curve.displacement.map((d) => d / gamma),
    curve.reaction.map((f) => f * perMass),
  );
  const bilinear: Point[] = [
    [0, 0],
    [e.yield_displacement_mm, e.acceleration_g],
    [e.ultimate_displacement_mm, e.acceleration_g],
  ];
  const asked: Point[] = a.spectrum ? zip(a.spectrum.displacement_mm, a.spectrum.acceleration_g) : [];
  const items: [SVGSVGElement, Child][] = [
    [swatch("force"), say("assessment.capacity")],
    [swatch("fit"), say("curve.bilinear")],
  ];
  if (a.spectrum) items.push([swatch("base"), say("assessment.spectrum")]);
  return new Figure({
    id: "assessment-chart",
    title: say("assessment.chart"),
    caption: say("assessment.caption"),
    above: legend(items),
    wide: true,
    draw: (width, onPaper) => {
      const plot = new Plot({
        width,
        height: onPaper ? 0.36 * width : Math.max(260, Math.min(440, 0.6 * width)),
        x: [0, until],
        y: rangeOf([0, ...asked.filter(([d]) => d <= until).map(([, s]) => 1.06 * s), 1.15 * e.acceleration_g]),
        xLabel: say("axis.equivalent"),
        yLabel: say("axis.acceleration"),
        title: say("assessment.chart"),
      });
      if (asked.length > 0) plot.line(asked, "base");
      plot.line(bilinear, "fit");
      plot.line(capacity, "force");
      for (const check of a.limit_states) {
        const x = plot.X(check.displacement_mm! / gamma);
        plot.add(svg("line", { class: "limit", x1: x, x2: x, y1: plot.top, y2: plot.bottom, "data-state": check.state }));
      }
      if (a.demand) {
        const at = a.demand.equivalent_displacement_mm,
          force = e.acceleration_g * Math.min(1, at / e.yield_displacement_mm);
        plot.dot(at, force, 5.5, "peak");
        plot.text(plot.X(at), plot.Y(force) - 11, say("assessment.demand"), "small halo", { "text-anchor": "middle" });
      }
      return plot.svg;
    },
    sheet: () => ({
      head: ["equivalent_displacement_mm", "acceleration_g"],
      rows: capacity.map(([d, s]) => [d, s]),
    }),
  });
}

function limitStates(a: Judged): Child {
  const withDemand = Boolean(a.spectrum);
  return table(
    [
      { head: say("assessment.state"), left: true },
      { head: say("displacement") },
      { head: say("drift") },
      ...(withDemand ? [{ head: say("assessment.ratio") }, { head: say("assessment.pga") }] : []),
      { head: say("assessment.governs"), left: true },
    ],
    a.limit_states.map((check) => [
      check.is_checked ? h("b", {}, stateOf(check)) : stateOf(check),
      bound(check) + qty(check.displacement_mm, "mm"),
      bound(check) + qty(check.drift_percent, "%"),
      ...(withDemand
        ? [bound(check) + num(check.capacity_over_demand), bound(check) + qty(check.pga_g, "g")]
        : []),
      phrase(check.criteria.find((c) => c.governs)?.words ?? ""),
    ]),
    say("assessment.states"),
  );
}

function criteria(a: Judged): Child {
  const rows: Child[][] = a.limit_states.flatMap((check) =>
    check.criteria.map((c, k) => [
      k === 0 ? stateOf(check) : "",
      phrase(c.words),
      c.clause,
      c.verified ? say("assessment.verified") : h("b", {}, say("assessment.unverified")),
      (c.reached ? "" : "> ") + qty(c.displacement_mm, "mm"),
    ]),
  );
  return h(
    "div",
    { class: "spaced" },
    table(
      [
        { head: say("assessment.state"), left: true },
        { head: say("assessment.rule"), left: true },
        { head: say("assessment.clause"), left: true },
        { head: say("assessment.print"), left: true },
        { head: say("assessment.met_at") },
      ],
      rows,
      say("assessment.rules"),
    ),
  );
}

function system(a: Judged): Child {
  const e = a.equivalent,
    m = a.mass,
    d = a.demand;
  const tonnes = (kg: number): string => qty(kg / 1000, "t");
  const rows: [string, string][] = [
    [say("assessment.mass.blocks"), tonnes(m.blocks_kg)],
    [say("assessment.mass.loads"), tonnes(m.loads_kg)],
    [say("assessment.mass.added"), tonnes(m.added_kg)],
    ["m*", tonnes(e.mass_kg)],
    ["Γ", num(e.participation_factor)],
    [
      say("assessment.shape"),
      m.shape === "linear"
        ? say("assessment.shape.linear")
        : say("assessment.shape.read", { at: qty(m.shape_read_at_mm, "mm") }),
    ],
    ["F*y", qty(e.force_kN, "kN")],
    ["d*y, d*u", `${qty(e.yield_displacement_mm, "mm")}, ${bound({ at_least: a.bilinear.censored })}${qty(e.ultimate_displacement_mm, "mm")}`],
    ["T*", qty(e.period_s, "s")],
  ];
  if (d) {
    rows.push(["q*", num(d.q)]);
    rows.push(["d*max", qty(d.equivalent_displacement_mm, "mm")]);
    rows.push([say("assessment.demand.control"), qty(d.displacement_mm, "mm")]);
  }
  if (a.spectrum) rows.push([say("assessment.pga.demand"), qty(a.spectrum.pga_g, "g")]);
  const half = Math.ceil(rows.length / 2),
    columns = [{ head: "", left: true }, { head: "" }];
  return h(
    "div",
    { class: "pair spaced" },
    table(columns, rows.slice(0, half), say("assessment.system")),
    table(columns, rows.slice(half), say("assessment.system.rest")),
  );
}
