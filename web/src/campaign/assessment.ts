// The peak ground acceleration at which the samples reach each limit state: curves with their bands, the samples'
// own steps, and the numbers.
import { h, type Child } from "../base/dom";
import { Figure, legend, swatch } from "../base/figure";
import type { CampaignAssessment, PgaFragility } from "../headers/statistics";
import { Plot, type Point } from "../base/plot";
import { zip } from "../run/trust";
import { table } from "../base/tables";
import { num, phrase, qty, say } from "../base/texts";
import type { Campaign } from "./data";

const kDigits = 3;
const range = (pair: (number | null)[]): string => `${num(pair[0], kDigits)} – ${num(pair[1], kDigits)}`;

export function pgaFragility(campaign: Campaign): Child {
  const a = campaign.statistics.assessment;
  if (!a) return null;
  if (a.reason) return h("p", { class: "warning" }, say("pga.refused", { why: phrase(a.reason) }));
  const known = a.limit_states.filter((f) => f.median_pga_g !== null);
  return [
    a.not_to_be_signed > 0
      ? h("p", { class: "warning" }, say("pga.unsigned", { n: a.not_to_be_signed, of: a.answered }))
      : null,
    h("p", { class: "soft" }, say("pga.lead", { n: a.answered, without: a.without_answer })),
    known.length > 0 ? h("div", { class: "pair" }, known.map((f) => figure(f).element)) : h("p", {}, say("pga.none")),
    a.limit_states.length > 0 ? numbers(a) : null,
    h("ul", { class: "soft small" }, a.notes.map((note) => h("li", {}, phrase(note)))),
  ];
}

// The share of samples that reached it, with a step at each sample's acceleration.
function steps(samples: PgaFragility["samples"]): Point[] {
  const out: Point[] = [[0, 0]];
  samples.pga_g.forEach((x, i) => {
    out.push([x, out[out.length - 1][1]]);
    out.push([x, samples.share_reached[i]]);
  });
  return out;
}

export function drawFragility(f: PgaFragility, width: number, height: number, yLabel = say("pga.probability")): SVGSVGElement {
  const x = f.curve.pga_g;
  const plot = new Plot({
    width,
    height,
    x: [0, x[x.length - 1]],
    y: [0, 1],
    xLabel: say("pga.axis"),
    yLabel,
    title: say("pga.title", { state: say(`assessment.${f.limit_state}`) }),
  });
  const hasBand = f.curve.low.every((v) => v !== null);
  if (hasBand) plot.band(x, f.curve.low as number[], f.curve.high as number[], "spread curve");
  plot.line(steps(f.samples), "base");
  plot.line(zip(x, f.curve.probability), "force");
  if (f.demand_pga_g !== null && f.probability_at_demand !== null)
    plot.dot(f.demand_pga_g, f.probability_at_demand, 5, "peak");
  return plot.svg;
}

function figure(f: PgaFragility): Figure {
  const state = say(`assessment.${f.limit_state}`);
  const x = f.curve.pga_g;
  return new Figure({
    id: `pga-${f.limit_state}`,
    title: say("pga.title", { state }),
    caption: f.demand_pga_g !== null ? say("pga.caption.demand", { pga: qty(f.demand_pga_g, "g") }) : "",
    above: legend([
      [swatch("force"), say("pga.fit")],
      [swatch("base"), say("pga.samples")],
    ]),
    draw: (width) => drawFragility(f, width, Math.max(240, Math.min(340, 0.62 * width))),
    sheet: () => ({
      head: ["pga_g", "probability", "low", "high"],
      rows: x.map((v, i) => [v, f.curve.probability[i], f.curve.low[i], f.curve.high[i]]),
    }),
  });
}

function numbers(a: CampaignAssessment): Child {
  return table(
    [
      { head: say("assessment.state"), left: true },
      { head: say("pga.n") },
      { head: say("pga.bounds") },
      { head: say("pga.median") },
      { head: "β C" },
      { head: "β" },
      { head: say("pga.at_demand") },
    ],
    a.limit_states.map((f) => [
      say(`assessment.${f.limit_state}`),
      String(f.n),
      String(f.censored),
      [num(f.median_pga_g), h("span", { class: "pm" }, range(f.median_pga_g_interval))],
      [num(f.beta_capacity), h("span", { class: "pm" }, range(f.beta_capacity_interval))],
      num(f.beta),
      f.probability_at_demand === null
        ? "–"
        : [num(f.probability_at_demand), h("span", { class: "pm" }, range(f.probability_at_demand_interval))],
    ]),
    say("pga.table"),
  );
}
