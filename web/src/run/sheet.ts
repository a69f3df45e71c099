// The printed sheet: one A4 page before all others, also on a screen if the model names a
// project or a code. It begins with the verdict. Items without space are counted, and are
// in the appendix. Only the user's own texts longer than a line may be cut, in the header.
import { h, later, svg, type Child } from "../base/dom";
import { legend, swatch } from "../base/figure";
import type { Assessment } from "../headers/assessment";
import type { Bilinear, Noted, Project } from "../headers/common";
import type { ModelInputs, Shown, StageInputs } from "../headers/inputs";
import type { RunHeader, Summary } from "../headers/run";
import { aroundPrint, type Section } from "../page";
import { Plot, rangeOf } from "../base/plot";
import { drawEnvelopes, signOf, waysOf } from "./cyclic";
import { zip, type Curve } from "./trust";
import { table } from "../base/tables";
import { capital, num, phrase, qty, say, sentence, type Said } from "../base/texts";
import type { View } from "../wall/wallview";

const kListed = 5, // key numbers
  kRoom = 620, // letters of materials, and of stages; more are counted
  kRoomOfNotes = 1900, // letters of the verdict and of the effects that are not modelled
  kLeastNotes = 650,
  kFewWords = 1300, // letters
  kShort = 60, // letters of texts that are never cut
  kGapShown = 1e-4; // of the energy ledger; a smaller gap is given as less than this

export interface SheetSource {
  header: RunHeader;
  curve: Curve;
  view: View | null;
}

// Whether somebody may put a name under the numbers.
//   none: there is no strength;  no: something makes the numbers doubtful;  bound: they are lower bounds;
//   reserve: a slower push may move them;  yes
export type Standing = "none" | "no" | "bound" | "reserve" | "yes";
export interface Doubts {
  grave: boolean; // with a warning in the headline
  mild: boolean;
}
export function standingOf(s: Summary, { grave, mild }: Doubts): { standing: Standing; first: string } {
  const fell = s.status === "collapsed",
    a = s.assessment;
  const said = (standing: Standing, key: string): { standing: Standing; first: string } => ({
    standing,
    first: say(`sheet.${key}`),
  });
  if (!(s.peak_reaction_kN! > 0) && !(s.load_factor > 0)) return said("none", "none");
  if (grave || (s.status && s.status !== "completed" && !fell)) return said("no", "no");
  if (a && !a.limit_states) return said("no", "no_assessment");
  if (a && !a.may_be_signed) return said("no", "no");
  // the result of a code is known, or the sheet would not be signed
  if (!a && !fell && !(s.load_factor > 0)) {
    if (s.censored_peak) return said("bound", "bound.force");
    if (s.censored_80) return said("bound", "bound.displacement");
  }
  return { standing: mild ? "reserve" : "yes", first: judged(a) };
}
function judged(a: Assessment | undefined): string {
  const key = { holds: "holds", fails: "fails", "not shown": "not_shown" }[a?.verdict as "holds" | "fails" | "not shown"],
    state = a?.limit_states?.find((check) => check.is_checked)?.state;
  return key && state ? say(`sheet.${key}`, { state: capital(say(`assessment.${state}`)) }) : "";
}

// The answer in the page's static headline.
const answer = (): Element | null => document.querySelector("#headline .answer");
export const doubts = (): Doubts => {
  const all = [...(answer()?.querySelectorAll(".caution") ?? [])];
  return { grave: all.some((e) => !e.classList.contains("mild")), mild: all.length > 0 };
};

// The data of a run or a campaign for its sheet.
interface Handed {
  project?: Project;
  assessment?: unknown;
}
interface Titled {
  kind: string;
  title: string;
  summary?: Handed;
  statistics?: Handed;
}
const saidOf = (header: Titled): Handed => header.summary ?? header.statistics ?? {};

export function sheetSection(source: SheetSource): Section {
  return sheetOf(source.header, (onPaper) => sheet(source, onPaper));
}
// On a screen only if a project or a code is named.
export function sheetOf(header: Titled, draw: (onPaper: boolean) => HTMLElement): Section {
  const place = h("div", {}),
    asked = Boolean(saidOf(header).project || saidOf(header).assessment);
  const show = (): void => place.replaceChildren(...(asked ? [draw(false)] : []));
  later(show);
  aroundPrint(() => place.replaceChildren(draw(true)), show);
  return { id: "sheet", title: say("section.sheet"), content: place, paper: !asked, first: true };
}

function sheet(source: SheetSource, onPaper: boolean): HTMLElement {
  const s = source.header.summary,
    { standing, first } = standingOf(s, doubts());
  // with few words, paper has space for one above the other
  const words = (answer()?.textContent ?? "") + Object.values(s.project ?? {}).join(" ");
  const wide = onPaper && !s.assessment?.limit_states && words.length < kFewWords;
  return h(
    "div",
    { class: "a4", "data-standing": standing },
    head(source.header),
    verdict(standing === "yes" && !["fails", "not shown"].includes(s.assessment?.verdict!), first),
    keyNumbers(),
    pictures(source, wide),
    limitStates(s.assessment),
    h("div", { class: "a4-pair" }, assumed(source.header), notModelled(source.header)),
    foot(say("sheet.made", { version: s.provenance?.version ?? "", state: s.state_hash ?? "" }), s, standing),
  );
}

const titleOf = (header: Titled): string =>
  saidOf(header).project?.title || header.title || say(`untitled.${header.kind}`);

// The texts of the sheet's header that may have been cut.
export function projectSection(header: Titled): Section {
  const rows: [string, string][] = [[say("sheet.title"), titleOf(header)]];
  for (const [key, text] of factsOf(header)) rows.push([say(`sheet.${key}`), text]);
  const long = rows.some(([, text]) => text.length > kShort);
  const columns = [
    { head: "", left: true },
    { head: "", left: true },
  ];
  return {
    id: "project",
    title: say("section.project"),
    content: long ? table(columns, rows, "", "facts") : null,
    paper: true,
  };
}

// --- head ----------------------------------------------------------------------------------------

function factsOf(header: Titled): [string, string][] {
  const p = saidOf(header).project ?? {};
  const rows: [string, string | undefined][] = [
    ["wall", p.title ? header.title : undefined],
    ["place", p.place],
    ["client", p.client],
    ["author", p.author],
    ["date", p.date],
  ];
  return rows.filter((row): row is [string, string] => Boolean(row[1]));
}

export function head(header: Titled): Child {
  const own = titleOf(header),
    given = factsOf(header);
  return [
    h("p", { class: "a4-title cut", style: `--lines:${own.length > 90 ? 3 : 2}` }, own),
    given.length > 0
      ? h(
          "dl",
          { class: "a4-facts" },
          given.map(([key, text]) =>
            h("div", {}, h("dt", {}, say(`sheet.${key}`)), h("dd", { class: "cut", style: "--lines:3" }, text)),
          ),
        )
      : null,
  ];
}

export function verdict(fine: boolean, first: string): Child {
  const words = [...(answer()?.childNodes ?? [])].map((node) => node.cloneNode(true));
  if (first === say("sheet.no")) words.forEach(leaveOutUnsigned);
  const stopped = document.querySelector("#headline .warning")?.textContent ?? "";
  return h(
    "div",
    { class: fine ? "a4-verdict" : "a4-verdict doubtful" },
    h(
      "p",
      {},
      first ? [h("strong", {}, first), " "] : null,
      words,
      stopped ? ` ${stopped}` : null,
    ),
  );
}

// Removes the code's own "not to be signed", if the sheet says so already.
function leaveOutUnsigned(node: Node): void {
  const start = say("sheet.unsigned"),
    text = node.textContent ?? "",
    at = text.indexOf(start);
  if (node.nodeType !== Node.TEXT_NODE || at < 0) return;
  node.textContent = text.slice(0, at) + capital(text.slice(at + start.length));
}

export function keyNumbers(): Child {
  const cards = [...document.querySelectorAll("#page > .cards .card")];
  if (cards.length === 0) return null;
  return h(
    "dl",
    { class: "a4-numbers" },
    cards.slice(0, kListed).map((card) =>
      h(
        "div",
        {},
        h("dt", {}, card.querySelector(".name")?.textContent),
        h("dd", {}, [...(card.querySelector(".value")?.childNodes ?? [])].map((node) => node.cloneNode(true))),
      ),
    ),
  );
}

// --- wall and curve ------------------------------------------------------------------------------

function pictures({ header, curve, view }: SheetSource, wide: boolean): Child {
  const s = header.summary,
    shown: HTMLElement[] = [];
  if (view) {
    const picture = view.picture(frameShown(header), wide ? 780 : 440, wide ? 400 : 330);
    picture.insertBefore(crackKey(), picture.lastChild);
    shown.push(picture);
  }
  if (curve.displacement.length > 1) {
    const demand = demandWords(s.assessment);
    shown.push(
      h("figure", {}, drawCurve(s, curve, wide), curveKey(s), demand === "" ? null : h("figcaption", {}, demand)),
    );
  }
  return shown.length > 0 ? h("div", { class: wide ? "a4-pictures wide" : "a4-pictures" }, shown) : null;
}

// The state for which the failure mode was evaluated, else the last.
function frameShown(header: RunHeader): number {
  const frames = header.frames,
    at = header.summary.failure_mode?.read_at_mm;
  if (typeof at !== "number") return frames.length - 1;
  const off = frames.map((f) => Math.abs(Math.abs(f.displacement_mm) - Math.abs(at)));
  return off.lastIndexOf(Math.min(...off));
}

export const crackKey = (): HTMLElement =>
  legend([
    [swatch("crack open w2"), say("crack.open.short")],
    [swatch("crack slip w2"), say("crack.slip.short")],
    [swatch("crack closed w0"), say("crack.closed.short")],
    [swatch("crushed", "dot"), say("crack.crushed")],
  ]);

function curveKey(s: Summary): HTMLElement {
  const items: [SVGSVGElement, Child][] = [[swatch("force"), say(s.load_factor > 0 ? "curve.factor" : "curve.force")]];
  if (bilinearOf(s)) items.push([swatch("fit"), say("curve.bilinear")]);
  if (s.assessment?.limit_states) items.push([swatch("limit"), say("assessment.states")]);
  if (s.assessment?.demand) items.push([swatch("asked"), say("assessment.demand.control")]);
  return legend(items);
}

const bilinearOf = (s: Summary): Bilinear | null => {
  const b = s.assessment?.bilinear ?? s.bilinear;
  return !(s.load_factor > 0) && b?.force_kN! > 0 ? b : null;
};

function demandWords(a: Assessment | undefined): string {
  if (!a) return say("sheet.no_demand");
  if (!a.spectrum) return say("sheet.no_spectrum");
  return a.demand ? say("sheet.demand", { at: qty(a.demand.displacement_mm, "mm"), pga: qty(a.spectrum.pga_g, "g") }) : "";
}

function drawCurve(s: Summary, c: Curve, wide: boolean): SVGSVGElement {
  const byFactor = s.load_factor > 0,
    force = byFactor ? c.factor : c.reaction,
    a = s.assessment,
    asked = a?.demand?.displacement_mm;
  const x = rangeOf([0, ...c.displacement, asked ?? 0]),
    y = rangeOf([0, ...force]);
  const plot = new Plot({
    width: wide ? 780 : 440,
    height: wide ? 270 : 330,
    x: [x[0], 1.02 * x[1]],
    y: [y[0] < -0.02 * y[1] ? 1.08 * y[0] : 0, 1.08 * y[1]],
    xLabel: say("axis.displacement"),
    yLabel: say(byFactor ? "axis.factor" : "axis.reaction"),
    title: say("curve.alt", {
      force: byFactor ? num(s.load_factor) : qty(s.peak_reaction_kN, "kN"),
      at: qty(s.displacement_at_peak_mm, "mm"),
    }),
  });
  const b = bilinearOf(s),
    sign = signOf(s);
  if (b)
    plot.line(
      [
        [0, 0],
        [sign * b.yield_displacement_mm!, sign * b.force_kN!],
        [sign * b.ultimate_displacement_mm!, sign * b.force_kN!],
      ],
      "fit",
    );
  plot.line(zip(c.displacement, force), waysOf(s).length > 0 ? "force thin" : "force");
  drawEnvelopes(plot, s);
  if (!byFactor && s.peak_reaction_kN! > 0)
    plot.dot(sign * s.displacement_at_peak_mm!, sign * s.peak_reaction_kN!, 4.5, "peak");
  // labels of limit states at the bottom, of the demand at the top, because they may be at one place
  const upright = (at: number, css: string, words: string, high = false): void => {
    const px = plot.X(at);
    plot.add(svg("line", { class: css, x1: px, x2: px, y1: plot.top, y2: plot.bottom }));
    const place = `translate(${px - 4} ${high ? plot.top + 4 : plot.bottom - 6}) rotate(-90)`;
    plot.text(0, 0, words, "small halo", { transform: place, "text-anchor": high ? "end" : "start" });
  };
  for (const check of a?.limit_states ?? [])
    if (Number.isFinite(check.displacement_mm)) upright(check.displacement_mm!, "limit", say(`assessment.${check.state}`));
  if (Number.isFinite(asked)) upright(asked!, "asked", say("assessment.demand"), true);
  return plot.svg;
}

// --- assessment ----------------------------------------------------------------------------------

function limitStates(a: Assessment | undefined): Child {
  if (!a?.limit_states) return null;
  const withDemand = Boolean(a.spectrum);
  let anyUnverified = false;
  const rows = a.limit_states.map((check) => {
    const rule = check.criteria.find((c) => c.governs),
      bound = check.at_least ? "≥ " : "";
    anyUnverified ||= Boolean(rule && !rule.verified);
    return h(
      "tr",
      { class: check.is_checked ? "chosen" : undefined },
      h("th", { scope: "row", class: "left" }, say(`assessment.${check.state}`)),
      h("td", {}, bound + qty(check.displacement_mm, "mm")),
      h("td", {}, bound + qty(check.drift_percent, "%", 2)),
      withDemand ? [h("td", {}, bound + num(check.capacity_over_demand)), h("td", {}, bound + qty(check.pga_g, "g"))] : null,
      h("td", { class: "left" }, rule ? `${phrase(rule.words)}: ${rule.clause}${rule.verified ? "" : " †"}` : "–"),
    );
  });
  const heads = ["assessment.state", "displacement", "drift", ...(withDemand ? ["assessment.ratio", "assessment.pga"] : [])];
  return h(
    "div",
    { class: "a4-states" },
    h(
      "table",
      {},
      h(
        "thead",
        {},
        h(
          "tr",
          {},
          heads.map((key, i) => h("th", { scope: "col", class: i === 0 ? "left" : undefined }, say(key))),
          h("th", { scope: "col", class: "left" }, say("assessment.governs")),
        ),
      ),
      h("tbody", {}, rows),
    ),
    anyUnverified ? h("p", { class: "soft" }, say("sheet.unverified")) : null,
  );
}

// --- assumptions ---------------------------------------------------------------------------------

// As many items as fit [letters]; the others are counted.
export function listed(items: Child[], room = kRoom): Child {
  const all = items.map((item) => h("li", {}, item)),
    shown = all.filter((li) => (room -= li.textContent!.length) >= 0),
    more = all.length - shown.length;
  return [shown, more > 0 ? h("li", {}, say("sheet.more", { n: more })) : null];
}

const kStrengths: [string, string][] = [
  ["tensile_strength", "ft"],
  ["cohesion", "c"],
  ["friction_angle", "φ"],
  ["compressive_strength", "fc"],
  ["youngs_modulus", "E"],
  ["density", "ρ"],
];

export function materialLines({ materials, origins }: Partial<ModelInputs>): Child[] {
  return (materials?.names ?? []).map((name, i) => {
    const values = kStrengths.flatMap(([key, sign]) => {
      const row = materials!.rows.find((r) => r[0] === key),
        value = row?.[2][i];
      return typeof value === "number" ? [`${sign} ${qty(value, row![1])}`] : [];
    });
    const from = new Set<string>(
      (origins ?? [])
        .filter((r) => r[0] === name)
        .map((r) => say(`origin.${r[3]}`)),
    );
    return [
      h("b", {}, phrase(name)),
      `: ${values.join(", ")} `,
      h("span", { class: "soft" }, `(${from.size > 0 ? [...from].join(", ") : say("origin.given")})`),
    ];
  });
}

const kOfTheSolver = [
  ...["velocity", "fast_velocity", "damping", "duration", "ramp", "driven_blocks", "stop_below", "level", "share"],
  "load_height",
];
const shown = (value: Shown, unit: string): string =>
  typeof value === "number" ? qty(value, unit, 4) : phrase(value ?? "–");

export function stageLines(stages: StageInputs[]): Child[] {
  return stages.map((stage) => {
    const rows = stage.rows.filter(([key]) => !kOfTheSolver.includes(key));
    const words = rows.map(([key, value, unit]) => `${say(`input.${key}`)} ${shown(value, unit)}`);
    return [h("b", {}, stage.name), `: ${[say(`stage.${stage.kind}`), ...words].join("; ")}`];
  });
}

function assumed({ inputs, summary: s }: RunHeader): Child {
  const gap = s.energy_J?.gap_ratio;
  const trust = [
    s.quasi_static?.verdict ? sentence(s.quasi_static.verdict) : "",
    typeof gap === "number" ? say("sheet.energy", { gap: qty(100 * Math.max(Math.abs(gap), kGapShown), "%", 2) }) : "",
  ].filter((text) => text !== "");
  return h(
    "div",
    {},
    h("h3", {}, say("sheet.assumed")),
    h("ul", {}, listed(materialLines(inputs ?? {})), listed(stageLines(inputs?.stages ?? [])), listed(trust)),
  );
}

function notModelled({ summary: s, wall }: RunHeader): Child {
  return h("div", {}, h("h3", {}, say("sheet.not_modelled")), notModelledList(s.assessment, Boolean(wall?.space)));
}
export function notModelledList(a: Noted | undefined, inSpace = false, most = kRoomOfNotes): HTMLElement {
  const notes: Said[] = a?.notes ?? [];
  const own = notes.length > 0 ? notes.map((note) => phrase(note)) : [...(inSpace ? [] : [say("sheet.out_of_plane")]), say("sheet.one_push")];
  const always = ["rigid", "contacts", "deterministic"].map((key) => say(`assumption.${key}`));
  const room = Math.max(kLeastNotes, most - (answer()?.textContent ?? "").length);
  const items = listed([...own, ...always], room) as [HTMLElement[], Child];
  return h("ul", { "data-notes": items[0].length >= own.length ? "all" : "some" }, items);
}

// Space for a signature, only if the sheet may be signed.
export function foot(made: string, s: Handed, standing: Standing): Child {
  const author = s.project?.author;
  return h(
    "div",
    { class: "a4-foot" },
    h("span", {}, made),
    author && standing !== "none" && standing !== "no" ? h("span", { class: "a4-sign" }, say("sheet.signature")) : null,
  );
}
