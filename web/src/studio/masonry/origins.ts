// Where the numbers of the masonry come from. The engine gives back the model with every value that it took; beside those that the
// file does not state stands a line: "KEY VALUE: typical of NAME at LC2 (SOURCE)" or "KEY VALUE: derived by RULE from ...".
import { h } from "../../base/dom";
import { qty, say } from "../../base/texts";
import { listAt, parse, type Doc, type Path } from "../file/toml";

export interface Origin {
  key: string;
  value: string;
  kind: "typical" | "derived";
  by: string; // the source of what is typical, or the rule
}
export interface Table {
  name: string; // as the file calls it
  origins: Origin[];
}
const kLine = /^(\w+) (.+?): (typical|derived) (?:of|by) (\w+)(?: at (LC\d))?(?: \(([^)]*)\))?/;

function originsAt(doc: Doc, path: Path): Origin[] {
  return listAt(doc, [...path, "origin"]).flatMap((line) => {
    const found = kLine.exec(String(line));
    if (!found) return [];
    const [, key, value, kind, name, level, source] = found;
    return [{ key, value, kind: kind as Origin["kind"], by: [source ?? name, level].filter(Boolean).join(", ") }];
  });
}
export function originsIn(model: string): Table[] {
  const doc = parse(model);
  const materials = doc.root.keys.get("material")?.node;
  const names = materials?.kind === "table" ? [...materials.keys.keys()] : [];
  const paths: Path[] = [["masonry"], ...names.map((name): Path => ["material", name])];
  return paths.map((path) => ({ name: path.join("."), origins: originsAt(doc, path) })).filter((table) => table.origins.length > 0);
}

// "0.0603866 MPa" with four digits, "clay" as it is.
function shown(value: string): string {
  const [number, unit = ""] = value.split(/ (.*)/);
  return Number.isFinite(Number(number)) ? qty(Number(number), unit, 4) : value;
}
export function showOrigins(into: HTMLDetailsElement, tables: Table[]): void {
  into.hidden = tables.length === 0;
  into.replaceChildren(
    h("summary", {}, say("origin.title")),
    ...tables.map(({ name, origins }) => [
      h("h3", {}, h("code", {}, `[${name}]`)),
      h("dl", {}, ...origins.map((o) => h("div", {}, h("dt", {}, h("code", {}, o.key), ` ${shown(o.value)}`), h("dd", { class: "soft" }, `${say(`origin.${o.kind}`)}: ${o.by}`)))),
    ]).flat(),
  );
}
