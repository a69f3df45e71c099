// Inputs: wall, openings, materials, stages and settings, and the assumptions of every run.
import { h, type Child } from "../base/dom";
import type { Carried, InputRow, ModelInputs, NoteGroup, Opening, OriginRow, Shown, Storey } from "../headers/inputs";
import type { Opinion } from "../headers/limit";
import type { WallHead } from "../headers/page";
import { table } from "../base/tables";
import { num, phrase, qty, say, type Said } from "../base/texts";

const shown = (value: Shown, unit: string): string =>
  value === "unlimited"
    ? say("unlimited")
    : typeof value === "number"
      ? qty(value, unit, 4)
      : value === null
        ? "–"
        : phrase(value);

const rowsOf = (rows: InputRow[]): Child[][] =>
  rows.map(([key, value, unit]) => [say(`input.${key}`), shown(value, unit)]);

const plain = [
  { head: "", left: true },
  { head: "", left: true },
];

// One row for each opening, because a facade has many.
function openings(list: Opening[]): Child {
  if (list.length === 0) return null;
  const sill = (o: Opening): string =>
    o.sill ? `; ${say("input.sill_words", { kind: phrase(o.sill), depth: qty(o.sill_depth_mm, "mm", 4) })}` : "";
  const lintel = (o: Opening): string =>
    o.arch
      ? say("input.arch_words", { kind: phrase(o.arch), depth: qty(o.arch_depth_mm, "mm", 4) })
      : o.lintel === ""
      ? "–"
      : say("input.lintel_words", {
          kind: phrase(o.lintel),
          depth: qty(o.lintel_depth_mm, "mm", 4),
          bearing: qty(o.lintel_bearing_mm, "mm", 4),
        });
  return table(
    [
      { head: "", left: true },
      { head: "x [m]" },
      { head: "y [m]" },
      { head: `${say("input.width")} [m]` },
      { head: `${say("input.height")} [m]` },
      { head: say("input.lintel"), left: true },
    ],
    list.map((o, i) => [
      o.name || say("input.opening", { n: i + 1 }),
      num(o.x, 4),
      num(o.y, 4),
      num(o.width, 4),
      num(o.height, 4),
      lintel(o) + sill(o),
    ]),
    say("input.openings"),
  );
}

// Storeys from the ground up.
function storeys(list: Storey[]): Child {
  if (list.length === 0) return null;
  return table(
    [
      { head: "", left: true },
      { head: `${say("input.foot")} [m]` },
      { head: `${say("input.height")} [m]` },
      { head: `${say("input.thickness")} [m]` },
    ],
    list.map((s) => [s.name, num(s.foot, 4), num(s.height, 4), num(s.thickness, 3)]),
    say("input.storeys"),
  );
}

// Loads on the wall, ties and restraints, one row each.
function carried(list: Carried[]): Child {
  if (list.length === 0) return null;
  return table(
    [
      { head: "", left: true },
      { head: say("input.where"), left: true },
      { head: "", left: true },
    ],
    list.map((c) => [
      [say(`input.${c.kind}`), c.name ? h("span", { class: "soft" }, ` ${c.name}`) : null],
      c.where,
      c.rows.map(([key, value, unit]) => `${say(`input.${key}`)} ${shown(value, unit)}`).join("; "),
    ]),
    say("input.carried"),
  );
}

// Origins of values that the file does not give: a mark at each value, explained below the tables.

const markOf = (rows: OriginRow[], table: string, key: string): Child => {
  const found = rows.find((r) => r[0] === table && r[1] === key && r[3] !== "given");
  return found ? h("sup", { class: "soft" }, ` ${say(`origin.mark.${found[3]}`)}`) : null;
};

// Four digits are enough for reading: 0.0724637681 MPa is 0.07246 MPa.
const brief = (text: string): string =>
  text.replace(/\d+\.\d{3,}(?:e[-+]?\d+)?/g, (n) => num(Number(n), 4));

function originNotes(rows: OriginRow[], anyRule: boolean): Child {
  if (rows.length === 0) return anyRule ? h("p", { class: "note" }, say("origin.all_given")) : null;
  const place = (name: string): string => (name === "masonry" ? say("input.masonry") : name);
  return h(
    "details",
    { class: "origins" },
    h("summary", {}, say("origin.title")),
    h("p", { class: "note" }, say("origin.lead")),
    table(
      [
        { head: say("origin.value"), left: true },
        { head: say("origin.how"), left: true },
      ],
      rows.map(([name, key, value, kind, by, inputs, formula, source]) => [
        [
          `${place(name)}: ${say(`input.${key}`)}`,
          h("div", {}, brief(value), h("span", { class: "soft" }, `, ${say(`origin.${kind}`)}`)),
        ],
        [
          h("code", {}, by),
          inputs ? `: ${brief(inputs)}` : null,
          formula ? h("div", {}, formula) : null,
          source ? h("div", { class: "soft" }, source) : null,
        ],
      ]),
      "",
    ),
  );
}

// Two tables side by side, because there are many rows with few words.
function masonryTables(rows: InputRow[], origins: OriginRow[]): Child {
  const half = Math.ceil(rows.length / 2);
  const part = (some: InputRow[], caption: string): HTMLElement =>
    table(
      plain,
      some.map(([key, value, unit]) => [say(`input.${key}`), [shown(value, unit), markOf(origins, "masonry", key)]]),
      caption,
      "facts",
    );
  return h(
    "div",
    { class: "pair" },
    part(rows.slice(0, half), say("input.masonry")),
    rows.length > half ? part(rows.slice(half), say("input.masonry.rest")) : null,
  );
}

export function inputTables(inputs: ModelInputs, note: string): Child {
  if (!inputs) return null;
  const wall = rowsOf(inputs.wall);
  const stages = inputs.stages.map((s) => [
    s.name,
    [
      say(`stage.${s.kind}`),
      ...s.rows.map(([key, value, unit]) => `${say(`input.${key}`)} ${shown(value, unit)}`),
    ].join("; "),
  ]);
  const materials = inputs.materials;
  const origins: OriginRow[] = inputs.origins ?? [];
  const masonry = inputs.masonry ?? [];
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
    storeys(inputs.storeys ?? []),
    openings(inputs.openings),
    carried(inputs.carried ?? []),
    materials.names.length > 0
      ? table(
          [{ head: "", left: true }, ...materials.names.map((n) => ({ head: phrase(n) }))],
          materials.rows.map(([key, unit, cells]) => [
            [say(`input.${key}`), unit ? h("span", { class: "soft" }, ` [${unit}]`) : null],
            ...cells.map((c, i) => [
              shown(c, ""),
              c === null ? null : markOf(origins, materials.names[i], key),
            ]),
          ]),
          say("input.materials"),
        )
      : null,
    masonry.length > 0 ? masonryTables(masonry, origins) : null,
    originNotes(origins, materials.names.length > 0),
    inputs.notes.length > 0
      ? [
          h("h3", {}, say("input.notes")),
          h(
            "ul",
            { class: "notes" },
            inputs.notes.map((n) =>
              (n as NoteGroup).members
                ? h(
                    "li",
                    {},
                    h("details", {}, h("summary", {}, phrase((n as NoteGroup).line)), h("ul", {}, (n as NoteGroup).members.map((m) => h("li", {}, phrase(m))))),
                  )
                : h("li", {}, phrase(n as Said)),
            ),
          ),
        ]
      : null,
  ];
}

// Assumptions of the method for any model; in space nothing keeps a wall in its plane.
export function assumptions(
  header: { wall?: WallHead; opinion?: Opinion },
  keys = [...(header.wall?.space || header.opinion?.local?.length ? [] : ["plane"]), "rigid", "contacts", "law", "quasi_static", "deterministic"],
): HTMLElement {
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
