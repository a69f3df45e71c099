// What went in: wall, openings, materials, stages and settings, and what every run takes for granted.
import { h, type Child } from "./dom";
import { table } from "./tables";
import { num, phrase, qty, say } from "./texts";

const shown = (value: unknown, unit: string): string =>
  value === "unlimited"
    ? say("unlimited")
    : typeof value === "number"
      ? qty(value, unit, 4)
      : value === null
        ? "–"
        : String(value);

const rowsOf = (rows: [string, unknown, string][]): Child[][] =>
  rows.map(([key, value, unit]) => [say(`input.${key}`), shown(value, unit)]);

const plain = [
  { head: "", left: true },
  { head: "", left: true },
];

function openingWords(o: any): string {
  const words = say("input.opening_words", {
    width: qty(o.width, "m", 4),
    height: qty(o.height, "m", 4),
    x: qty(o.x, "m", 4),
    y: qty(o.y, "m", 4),
  });
  return o.lintel === ""
    ? words
    : `${words}; ${say("input.lintel_words", {
        kind: phrase(o.lintel),
        depth: qty(o.lintel_depth_mm, "mm", 4),
        bearing: qty(o.lintel_bearing_mm, "mm", 4),
      })}`;
}

export function inputTables(inputs: any, note: string): Child {
  if (!inputs) return null;
  const wall = [
    ...rowsOf(inputs.wall),
    ...inputs.openings.map((o: any, i: number) => [
      o.name || say("input.opening", { n: i + 1 }),
      openingWords(o),
    ]),
  ];
  const stages = inputs.stages.map((s: any) => [
    s.name,
    [
      say(`stage.${s.kind}`),
      ...s.rows.map(([key, value, unit]: any) => `${say(`input.${key}`)} ${shown(value, unit)}`),
    ].join("; "),
  ]);
  const materials = inputs.materials;
  return [
    note ? h("p", {}, note) : null,
    h(
      "div",
      { class: "pair" },
      h("div", {}, table(plain, wall, say("input.wall"), "facts")),
      h(
        "div",
        {},
        table(plain, stages, say("input.stages"), "facts"),
        table(plain, rowsOf(inputs.settings), say("input.settings"), "facts"),
      ),
    ),
    materials.names.length > 0
      ? table(
          [{ head: "", left: true }, ...materials.names.map((n: string) => ({ head: n }))],
          materials.rows.map(([key, unit, cells]: any) => [
            [say(`input.${key}`), unit ? h("span", { class: "soft" }, ` [${unit}]`) : null],
            ...cells.map((c: any) => (c === "unlimited" ? say("unlimited") : num(c, 4))),
          ]),
          say("input.materials"),
        )
      : null,
    inputs.notes.length > 0
      ? [
          h("h3", {}, say("input.notes")),
          h(
            "ul",
            { class: "notes" },
            inputs.notes.map((n: string) => h("li", {}, phrase(n))),
          ),
        ]
      : null,
  ];
}

// What the method takes for granted, whatever the model.
export function assumptions(): HTMLElement {
  const keys = ["plane", "rigid", "contacts", "law", "quasi_static", "deterministic"];
  return h(
    "div",
    { class: "assumptions" },
    h("h3", {}, say("assumptions")),
    h(
      "ul",
      {},
      keys.map((k) => h("li", {}, say(`assumption.${k}`))),
    ),
  );
}

export function provenanceTable(rows: [string, string][]): HTMLElement {
  return table(
    plain,
    rows.map(([name, value]) => [name, h("code", {}, value)]),
    "",
    "facts",
  );
}
