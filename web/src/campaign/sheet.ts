// The printed sheet of a campaign: cautions against signing, strength and failure of the
// walls, the ground acceleration of each limit state, and the assumptions. One A4 page.
import { append, h, svg, type Child } from "../base/dom";
import { legend, swatch } from "../base/figure";
import type { ModelInputs } from "../headers/inputs";
import type { CampaignAssessment, PgaFragility } from "../headers/statistics";
import type { Section } from "../page";
import { Plot, rangeOf, type Point } from "../base/plot";
import { crackKey, doubts, foot, head, keyNumbers, listed, materialLines, notModelledList } from "../run/sheet";
import { sheetOf, stageLines, verdict, type Standing } from "../run/sheet";
import { capital, num, phrase, qty, say } from "../base/texts";
import { drawFragility } from "./assessment";
import { modeLabel, reactionAt, type Campaign, type Sample } from "./data";
import type { SamplePanel } from "./sample";

const kRoom = 260; // letters of inputs, of materials, and of stages: this sheet has a third picture

const kGrid = 100, // points of a quantile's curve
  kModes = 6, // listed; more are counted
  kMany = 60, // curves; drawn thin
  kHalf = 0.5;

export function campaignSheet(campaign: Campaign, panel: SamplePanel | null): Section {
  return sheetOf(campaign.header, (onPaper) => sheet(campaign, panel, onPaper));
}

// Whether the numbers may be signed.
export function standingOf(campaign: Campaign): { standing: Standing; first: string } {
  const said = (standing: Standing, key: string): { standing: Standing; first: string } => ({
    standing,
    first: say(`sheet.${key}`),
  });
  const { grave, mild } = doubts(),
    a = campaign.statistics.assessment,
    peaks = campaign.answered.filter((s) => s.response[0] !== null);
  if (peaks.length === 0) return said("none", "none");
  if (a?.reason) return said("no", "no_assessment");
  if (grave || a?.cautions?.length! > 0 || a?.not_to_be_signed! > 0) return said("no", "no");
  const bounds = (quantity: number): number => campaign.answered.filter((s) => s.censored[quantity]).length;
  if (!a) {
    if (bounds(0) > kHalf * peaks.length) return said("bound", "bound.forces");
    if (bounds(2) > kHalf * peaks.length) return said("bound", "bound.displacements");
  }
  const { run, answered } = campaign.statistics.samples;
  const lost = run < campaign.header.drawn || answered < run;
  return { standing: mild || lost ? "reserve" : "yes", first: "" };
}

function sheet(campaign: Campaign, panel: SamplePanel | null, onPaper: boolean): HTMLElement {
  const s = campaign.statistics,
    { standing, first } = standingOf(campaign);
  return h(
    "div",
    { class: "a4 of-campaign", "data-standing": standing },
    head(campaign.header),
    verdict(standing === "yes", first),
    keyNumbers(),
    pictures(campaign, panel, onPaper),
    onPaper ? null : limitStates(s.assessment),
    fragilityRow(campaign, onPaper),
    h("div", { class: "a4-pair" }, assumed(campaign), notModelled(campaign)),
    foot(
      say("sheet.campaign.made", {
        program: campaign.header.provenance || "wythe",
        seed: s.seed,
        design: phrase(s.design),
      }),
      s,
      standing,
    ),
  );
}

// --- pictures ------------------------------------------------------------------------------------------

// The wall whose peak is nearest to the median, among walls with states in the page.
function typical(campaign: Campaign): Sample[] {
  const peaks = campaign.answered.filter((s) => s.response[0] !== null);
  const sorted = peaks.map((s) => s.response[0]!).sort((a, b) => a - b);
  const median = sorted[Math.floor((sorted.length - 1) / 2)];
  return peaks.sort((a, b) => Math.abs(a.response[0]! - median) - Math.abs(b.response[0]! - median));
}

function pictures(campaign: Campaign, panel: SamplePanel | null, onPaper: boolean): Child {
  const shown: HTMLElement[] = [];
  const width = 440,
    tall = onPaper ? 300 : 290;
  for (const s of typical(campaign)) {
    const wall = panel?.pictureOf(s, width, tall);
    if (!wall) continue;
    wall.insertBefore(crackKey(), wall.lastChild);
    wall.lastChild!.textContent = `${say("sheet.campaign.typical")} ${wall.lastChild!.textContent}`;
    shown.push(wall);
    break;
  }
  if (campaign.answered.length > 0) shown.push(curves(campaign, width, tall));
  return shown.length > 0 ? h("div", { class: "a4-pictures" }, shown) : null;
}

// The chart of the requested limit state, beside the modes; on paper there is no space for a wide table.
function fragilityRow(campaign: Campaign, onPaper: boolean): HTMLElement {
  const a = campaign.statistics.assessment,
    asked = a?.limit_states?.find((f) => f.is_checked && f.median_pga_g !== null);
  return h(
    "div",
    { class: "a4-pair" },
    asked ? figure(asked, onPaper ? 190 : 240) : null,
    h("div", {}, onPaper ? limitStates(a) : null, modes(campaign)),
  );
}
const figure = (f: PgaFragility, tall: number): HTMLElement =>
  h(
    "figure",
    { class: "a4-chart" },
    drawFragility(f, 440, tall, say("sheet.campaign.probability")),
    legend([
      [swatch("force"), say("pga.fit")],
      [swatch("base"), say("pga.samples")],
    ]),
    h("figcaption", {}, [say("pga.title", { state: say(`assessment.${f.limit_state}`) }), demandWords(f)].filter((w) => w).join(". ")),
  );
const demandWords = (f: PgaFragility): string =>
  f.demand_pga_g === null ? "" : say("pga.caption.demand", { pga: qty(f.demand_pga_g, "g") });

// Every curve, with the median and the 16 and 84 % quantiles of those that go so far.
function curves(campaign: Campaign, width: number, height: number): HTMLElement {
  const all = campaign.answered;
  const x = rangeOf([0, ...all.map((s) => s.displacement[s.displacement.length - 1])]),
    y = rangeOf([0, ...all.flatMap((s) => [Math.max(...s.reaction), Math.min(...s.reaction)])]);
  const plot = new Plot({
    width,
    height,
    x: [x[0], 1.02 * x[1]],
    y: [y[0] < -0.02 * y[1] ? 1.08 * y[0] : 0, 1.08 * y[1]],
    xLabel: say("axis.displacement"),
    yLabel: say("axis.reaction"),
    title: say("curves.alt", { n: all.length }),
  });
  const at: number[] = [],
    low: number[] = [],
    middle: Point[] = [],
    high: number[] = [];
  for (let i = 0; i <= kGrid; ++i) {
    const d = (x[1] * i) / kGrid;
    const values = all.map((s) => reactionAt(s, d)).filter(Number.isFinite).sort((a, b) => a - b);
    if (values.length < kHalf * all.length) break;
    const share = (p: number): number => {
      const place = p * (values.length - 1),
        below = Math.floor(place);
      return values[below] + (place - below) * ((values[below + 1] ?? values[below]) - values[below]);
    };
    at.push(d);
    low.push(share(0.16));
    middle.push([d, share(0.5)]);
    high.push(share(0.84));
  }
  const each = all.map((s) =>
    svg("path", {
      class: `sample ${all.length > kMany ? "many" : ""} ${campaign.css(s.mode)}`,
      d: plot.path(Array.from(s.displacement, (d, i): Point => [d, s.reaction[i]])),
    }),
  );
  const group = svg("g", { class: "samples faint" });
  append(group, each);
  plot.add(group);
  if (at.length > 1) plot.band(at, low, high, "spread all");
  plot.line(middle, "force");
  return h(
    "figure",
    {},
    plot.svg,
    legend([
      [swatch("force"), say("sheet.campaign.median")],
      [swatch("spread all", "box"), say("sheet.campaign.band")],
    ]),
    h("figcaption", {}, say("sheet.campaign.curves", { n: all.length }), campaign.thinned && ` ${campaign.thinned}`),
  );
}

// --- tables --------------------------------------------------------------------------------------------

function plain(heads: string[], rows: { cells: Child[]; chosen?: boolean }[]): HTMLElement {
  return h(
    "table",
    {},
    h("thead", {}, h("tr", {}, heads.map((words, i) => h("th", { scope: "col", class: i === 0 ? "left" : undefined }, words)))),
    h(
      "tbody",
      {},
      rows.map(({ cells, chosen }) =>
        h(
          "tr",
          { class: chosen ? "chosen" : undefined },
          h("th", { scope: "row", class: "left" }, cells[0]),
          cells.slice(1).map((cell) => h("td", {}, cell)),
        ),
      ),
    ),
  );
}

function limitStates(a: CampaignAssessment | undefined): Child {
  if (!a?.limit_states?.length) return null;
  const between = (pair: (number | null)[]): string =>
    typeof pair?.[0] === "number" ? ` (${num(pair[0])} – ${num(pair[1])})` : "";
  return h(
    "div",
    { class: "a4-states", tabindex: 0, role: "region", "aria-label": say("assessment.states") },
    plain(
      [say("assessment.state"), say("pga.median"), "β", say("pga.bounds"), say("pga.at_demand")],
      a.limit_states.map((f) => ({
        chosen: f.is_checked,
        cells: [
          say(`assessment.${f.limit_state}`),
          f.median_pga_g === null ? "–" : num(f.median_pga_g) + between(f.median_pga_g_interval),
          num(f.beta),
          `${f.censored} / ${f.n}`,
          f.probability_at_demand === null ? "–" : qty(100 * f.probability_at_demand, "%", 2),
        ],
      })),
    ),
    h("p", { class: "soft" }, say("sheet.unverified").replace("† ", "")),
  );
}

function modes(campaign: Campaign): Child {
  const shares = Object.entries(campaign.statistics.shares)
    .filter(([, s]) => s.modes.length === 1 && s.count > 0)
    .sort((a, b) => b[1].count - a[1].count);
  if (shares.length === 0) return null;
  const rows = shares.slice(0, kModes).map(([name, s]) => ({
    cells: [
      h("span", { class: "cut", style: "--lines:2" }, capital(modeLabel(name))),
      String(s.count),
      `${qty(100 * s.share, "%", 2)} (${num(100 * s.share_interval[0], 2)} – ${num(100 * s.share_interval[1], 2)})`,
    ],
  }));
  const more = shares.length - rows.length;
  return h(
    "div",
    { class: "a4-states" },
    plain([say("mode"), say("sheet.campaign.walls"), say("sheet.campaign.share")], rows),
    more > 0 ? h("p", { class: "soft" }, say("sheet.more", { n: more })) : null,
  );
}

// --- assumptions -----------------------------------------------------------------------------------------

function drawn(campaign: Campaign): Child[] {
  return campaign.inputs
    .filter((input) => input.random)
    .map((input) => {
      const of = campaign.statisticsOf(input.name);
      const spread = of.cov === null ? "" : `, CoV ${num(of.cov, 2)}`;
      return [
        h("b", {}, input.name),
        `: ${[phrase(input.distribution ?? ""), `${say("mean")} ${qty(of.mean, input.unit)}${spread}`].filter((w) => w).join(", ")}`,
      ];
    });
}

function assumed(campaign: Campaign): Child {
  const { inputs, model }: { inputs: Child[]; model: Partial<ModelInputs> } = { inputs: drawn(campaign), model: campaign.header.model ?? {} };
  return h(
    "div",
    {},
    h("h3", {}, say("sheet.assumed")),
    h("ul", {}, listed(inputs, kRoom), listed(materialLines(model), kRoom), listed(stageLines(model.stages ?? []), kRoom)),
  );
}

function notModelled(campaign: Campaign): Child {
  return h("div", {}, h("h3", {}, say("sheet.not_modelled")), notModelledList(campaign.statistics.assessment, Boolean(campaign.header.wall?.space), 0));
}
