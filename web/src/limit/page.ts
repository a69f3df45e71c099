// The page of a limit analysis: macro-block mechanisms (mechanism.ts), the
// limit loads of the blocks, the comparison with runs, and all inputs.
import type { Bundle } from "../base/bundle";
import { h, type Child } from "../base/dom";
import { Figure } from "../base/figure";
import type { Bound, Bracket, LimitHeader, LimitLoad, LocalPart, Opinion } from "../headers/limit";
import { assumptions, inputTables, provenanceTable } from "../run/inputs";
import { hypothesisLabel, mechanisms, type Mechanism } from "./mechanism";
import type { Section } from "../page";
import { sortable, table } from "../base/tables";
import { capital, knows, num, pageUnit, phrase, qty, say, sentence } from "../base/texts";
import { collapseInSpace } from "./space";
import { canvasFor, drawWall } from "../wall/wall2d";
import { readWall, type Frames, type Wall } from "../wall/wall";

// --- limit loads of the blocks -------------------------------------------------------------------------

const loadOf = (l: LimitLoad, theorem: "static" | "kinematic"): string =>
  `${theorem}_kN` in l ? qty(l[`${theorem}_kN`], "kN", 4) : `λ = ${num(l[theorem], 4)}`;

// The collapse mechanism of the blocks as a state: velocities times a small time.
function collapse(wall: Wall, limits: LimitLoad[]): HTMLElement | null {
  const usable = limits.filter((l) => l.velocity_x?.length === wall.blocks);
  if (usable.length === 0) return null;
  let shown = usable[0],
    size = 0.05;
  const pick = h(
    "select",
    {},
    usable.map((l, i) => h("option", { value: i }, phrase(l.name))),
  );
  const slider = h("input", {
    type: "range",
    min: 0,
    max: 0.12,
    step: 0.005,
    value: size,
    "aria-label": say("collapse.size"),
  });
  const figure = new Figure({
    id: "collapse",
    title: say("collapse.title"),
    caption: say("collapse.caption"),
    above: h(
      "div",
      { class: "controls" },
      h("label", {}, h("span", {}, say("collapse.joints")), pick),
      h("label", {}, h("span", {}, say("collapse.size")), slider),
    ),
    draw: (width) => {
      const none = new Uint8Array(wall.joints),
        zero = new Float32Array(wall.joints);
      const largest =
        Math.max(...shown.velocity_x.map((v, b) => Math.hypot(v, shown.velocity_y[b]))) || 1;
      const s = (size * wall.height) / largest;
      const frame = {
        ux: Float32Array.from(shown.velocity_x, (v) => v * s),
        uy: Float32Array.from(shown.velocity_y, (v) => v * s),
        theta: Float32Array.from(shown.spin_per_m, (v) => v * s),
        nodeUx: null,
        nodeUy: null,
        opening: zero,
        slip: zero,
        damage: none,
        crushing: none,
        compression: null,
        shear: null,
        eccentricity: null,
        greater: null,
        smaller: null,
      };
      return drawWall(
        wall,
        { count: 1, at: () => frame } as unknown as Frames,
        { frame: 0, scale: 1, measure: "cracks", forces: false, numbers: false, lit: "", stressSteps: [] },
        canvasFor(wall, width, 460),
      );
    },
    sheet: () => ({
      head: ["block", "velocity_x", "velocity_y", "spin_per_m"],
      rows: shown.velocity_x.map((v, b) => [b, v, shown.velocity_y[b], shown.spin_per_m[b]]),
    }),
  });
  pick.addEventListener("change", () => {
    shown = usable[Number(pick.value)];
    figure.redraw();
  });
  slider.addEventListener("input", () => {
    size = Number(slider.value);
    figure.redraw();
  });
  return figure.element;
}

function limitLoads(opinion: Opinion, wall: Wall | null, bundle: Bundle<LimitHeader>): Child {
  const limits = opinion.limit_loads;
  if (limits.length === 0) return null;
  const list = table(
    [
      { head: say("collapse.joints"), left: true },
      { head: say("limit_load.static") },
      { head: say("limit_load.kinematic") },
      { head: say("limit_load.gap") },
      { head: say("limit_load.size") },
      { head: say("limit_load.seconds") },
    ],
    limits.map((l) => [
      phrase(l.name),
      loadOf(l, "static"),
      loadOf(l, "kinematic"),
      num(l.gap, 2),
      `${l.rows} × ${l.columns}`,
      qty(l.seconds, "s", 2),
    ]),
    say("limit_load.table"),
  );
  return [
    h("p", { class: "soft" }, say("limit_load.lead")),
    h("div", { id: "limit-loads" }, list, wall ? h("div", { class: "pair" }, collapse(wall, limits)) : collapseInSpace(bundle, limits)),
  ];
}

// --- verdict ---------------------------------------------------------------------------------------------

function verdict(opinion: Opinion): Child {
  const c = opinion.comparison;
  if (!c) return h("p", { class: "note" }, say("verdict.none"));
  const label = (name: string): string => {
    const m = opinion.mechanisms.find((x) => x.name === name);
    return m ? `${m.mode}, ${hypothesisLabel(m)}` : name;
  };
  const value = (b: Bound, key: "peak" | "bound"): string =>
    `${key}_kN` in b ? qty(b[`${key}_kN`], "kN", 4) : num(b[key], 4);
  const groups =
    c.groups.length > 0
      ? table(
          [
            { head: say("verdict.runs"), left: true },
            { head: say("verdict.mechanism"), left: true },
            { head: say("verdict.peak") },
            { head: say("verdict.ratio") },
            { head: say("verdict.gap") },
            { head: say("verdict.gap_share") },
          ],
          c.groups.map((g) => [
            `${g.mode} (${g.runs})`,
            label(g.mechanism),
            qty(g.mean_peak_kN, "kN"),
            num(g.mean_peak_ratio),
            qty(g.mean_post_peak_gap_kN, "kN"),
            qty(100 * g.mean_post_peak_gap_share_of_peak!, "%", 2),
          ]),
          say("verdict.groups"),
        )
      : null;
  const curves = h(
    "details",
    { open: c.groups.length === 0 },
    h("summary", {}, say("verdict.curves")),
    sortable(
      [
        { head: say("verdict.run"), left: true },
        { head: say("verdict.mechanism"), left: true },
        { head: say("verdict.ratio") },
        { head: say("verdict.gap") },
        { head: say("verdict.gap_share") },
      ],
      c.curves.map((v) => [
        v.run,
        label(v.mechanism),
        { show: num(v.peak_ratio), sort: v.peak_ratio },
        { show: qty(v.post_peak_gap_kN, "kN"), sort: v.post_peak_gap_kN },
        { show: qty(100 * v.post_peak_gap_share_of_peak!, "%", 2), sort: v.post_peak_gap_share_of_peak },
      ]),
      say("verdict.curves"),
    ),
  );
  const bounds =
    c.bounds.length > 0
      ? h(
          "details",
          { open: c.bounds.length < 12 || c.bounds.some((b) => !b.holds) },
          h("summary", {}, say("verdict.bounds")),
          sortable(
            [
              { head: say("verdict.run"), left: true },
              { head: say("quantity.peak_reaction") },
              { head: say("verdict.bound") },
              { head: say("verdict.allowance") },
              { head: say("verdict.holds") },
            ],
            [...c.bounds]
              .sort((a, b) => Number(a.holds) - Number(b.holds))
              .map((b) => [
                b.run,
                value(b, "peak"),
                value(b, "bound"),
                qty(100 * b.allowance, "%", 2),
                b.holds ? say("yes") : h("b", {}, say("no")),
              ]),
            say("verdict.bounds"),
          ),
        )
      : null;
  return [
    h("p", { class: "soft" }, say("verdict.lead", { with: lastName(c.with) })),
    bracket(c.bracket),
    groups,
    bounds,
    withoutBound(c.without_bound ?? []),
    curves,
  ];
}

// The last part of a path: pages are passed on, and folders of a machine mean nothing elsewhere.
const lastName = (path: string): string => path.replace(/[\\/]+$/, "").replace(/^([A-Za-z]:)?[\\/].*[\\/]/, "");

function bracket(b: Bracket | null | undefined): Child {
  if (!b) return null;
  const value = (key: "low" | "high" | "least_peak" | "most_peak"): string =>
    `${key}_kN` in b ? qty(b[`${key}_kN`], "kN") : `λ = ${num(b[key])}`;
  return h(
    "p",
    { id: "bracket" },
    say("verdict.bracket", {
      low: value("low"),
      high: value("high"),
      least: value("least_peak"),
      most: value("most_peak"),
      runs: b.runs,
      below: b.below,
      above: b.above,
    }),
    b.nominal ? ` ${say("verdict.bracket.nominal")}` : "",
  );
}

// Runs without a limit load of their own, grouped by the reason.
function withoutBound(list: { run: string; why: string }[]): Child {
  return [...new Set(list.map((r) => r.why))].map((why) =>
    h(
      "p",
      { class: "soft small" },
      say("verdict.without", { n: list.filter((r) => r.why === why).length, why: phrase(why) }),
    ),
  );
}

// Questions without an answer, and warnings of the program.
function doubts(opinion: Opinion): Child {
  const words: Child[] = [
    ...(opinion.refused ?? []).map((r) => [
      h("b", {}, say("doubts.refused", { what: phrase(r.what) })),
      `: ${r.why}`,
    ]),
    ...(opinion.notes ?? []).map((n) => capital(phrase(n))),
  ];
  if (words.length === 0) return null;
  return h(
    "ul",
    { class: "warning notes" },
    words.map((w) => h("li", {}, w)),
  );
}

function numbers(opinion: Opinion): Child {
  const all = opinion.mechanisms;
  if (all.length === 0) return null;
  const names = [...new Set(all.flatMap((m) => Object.keys(m.inputs)))];
  const unit = (name: string): string => pageUnit(all.find((m) => name in m.inputs)!.inputs[name].unit)[0];
  const show = (v: Mechanism["inputs"][string] | undefined): string =>
    v === undefined
      ? "–"
      : v.value === "unlimited"
        ? say("unlimited")
        : num(v.value === null ? null : (v.value as number) * pageUnit(v.unit)[1], 4);
  const assessed = all.filter((m) => m.assessment);
  return [
    table(
      [
        { head: say("numbers.name"), left: true },
        { head: say("unit"), left: true },
        ...all.map((m) => ({ head: [m.mode, h("span", { class: "pm" }, hypothesisLabel(m))] })),
      ],
      names.map((n) => [
        knows(`number.${n}`) ? say(`number.${n}`) : n.replace(/_/g, " "),
        unit(n),
        ...all.map((m) => show(m.inputs[n])),
      ]),
      say("numbers.title"),
    ),
    assessed.length > 0
      ? table(
          [
            { head: say("assessment.quantity"), left: true },
            ...assessed.map((m) => ({ head: [m.mode, h("span", { class: "pm" }, hypothesisLabel(m))] })),
          ],
          ([
            "alpha0",
            "alpha0_by_weights",
            "participating_mass_kg",
            "participating_mass_share",
            "acceleration0_m_per_s2",
            "displacement0_mm",
            "life_safety_displacement_mm",
            "near_collapse_displacement_mm",
            "spectral_displacement0_mm",
            "life_safety_spectral_displacement_mm",
            "near_collapse_spectral_displacement_mm",
          ] as const).map((key) => [say(`assessment.${key}`), ...assessed.map((m) => num(m.assessment![key], 4))]),
          say("assessment.title", { clause: phrase(assessed[0].assessment!.clause) }),
        )
      : null,
    assessed.length > 0 ? h("p", { class: "soft small" }, say("assessment.lead")) : null,
  ];
}

// Parts that fall on their face: the sentence of each, then its numbers, one column for each part.
function local(opinion: Opinion): Child {
  const parts = opinion.local ?? [];
  if (parts.length === 0) return null;
  const heads = [
    { head: say("assessment.quantity"), left: true },
    ...parts.map((p) => ({ head: [p.name, p.by === "part" || p.by === "found" ? null : h("span", { class: "pm" }, phrase(p.by))] })),
  ];
  const rows = <Key extends string>(keys: Key[], of: (p: LocalPart, key: Key) => number | null | undefined): Child[][] =>
    keys
      .filter((key) => parts.some((p) => of(p, key) !== null && of(p, key) !== undefined))
      .map((key) => [say(`local.${key}`), ...parts.map((p) => num(of(p, key) ?? null, 4))]);
  const states = [...new Set(parts.flatMap((p) => p.limit_states.map((s) => s.limit_state)))];
  return [
    parts.map((p) => h("p", {}, p.may_be_signed ? sentence(p.sentence) : h("b", {}, sentence(p.sentence)))),
    table(
      heads,
      rows(
        [
          "foot_m", "head_m", "hinge_m", "inset_mm", "masonry_kN", "floors_kN", "alpha0", "participating_mass_kg",
          "participating_mass_share", "confidence_factor", "acceleration0_m_per_s2", "acceleration0_to_the_end_m_per_s2",
          "displacement0_mm", "displacement0_of_top_mm", "slides_off_mm",
        ],
        (p, key) => p[key],
      ),
      say("local.title", { clause: phrase(parts[0].clause) }),
    ),
    states.map((state) =>
      table(
        heads,
        rows(
          [
            "pga_demand_g", "acceleration_demand_m_per_s2", "q", "capacity_over_demand_by_q", "displacement_mm", "secant_period_s",
            "displacement_demand_mm", "capacity_over_demand_by_displacement", "pga_capacity_g",
          ],
          (p, key) => p.limit_states.find((s) => s.limit_state === state)?.[key],
        ),
        capital(say(`assessment.${state}`)),
      ),
    ),
    parts.map((p) => h("details", {}, h("summary", {}, say("local.notes", { part: p.name })), h("ul", {}, p.notes.map((n) => h("li", {}, capital(phrase(n))))))),
    h("p", { class: "soft small" }, say("local.lead")),
  ];
}

export function limitSections(bundle: Bundle<LimitHeader>): Section[] {
  const header = bundle.header,
    opinion = header.opinion,
    wall = readWall(bundle),
    p = header.provenance;
  return [
    { id: "doubts", title: say("section.doubts"), content: doubts(opinion) },
    {
      id: "mechanisms",
      title: say("section.mechanisms"),
      content: opinion.mechanisms.length > 0 ? h("div", { class: "stack" }, mechanisms(opinion)) : null,
    },
    { id: "local", title: say("section.local"), content: local(opinion) },
    { id: "limits", title: say("section.limits"), content: limitLoads(opinion, wall, bundle) },
    { id: "verdict", title: say("section.verdict"), content: verdict(opinion) },
    { id: "numbers", title: say("section.numbers"), content: numbers(opinion) },
    { id: "inputs", title: say("section.inputs"), content: inputTables(header.inputs, header.note) },
    {
      id: "provenance",
      title: say("section.provenance"),
      content: [
        assumptions(header),
        provenanceTable([
          [say("provenance.program"), `wythe ${p.version} (${p.commit})`],
          [say("provenance.compiler"), `${p.compiler}, ${p.flags}`],
        ]),
        h(
          "details",
          {},
          h("summary", {}, say("provenance.model_text")),
          h("pre", { tabindex: 0 }, header.model_text),
        ),
      ],
    },
  ];
}
