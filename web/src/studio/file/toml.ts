// A TOML text with the places of its values, so that one value can be changed and every other byte stays:
// comments, order, spaces and tables that nobody here knows.
//
//   parse(text)                       a tree whose leaves know where they stand, or a fault with its line
//   setValue(text, path, literal)     changes a value in place, or adds its key where it belongs
//   removeAt(text, path)              takes a key, a table or a member of a list away
//   appendTable(text, path, lines)    a new [[path]] after the last of its kind
//
// A path has names and, for members of lists, numbers: ["wall", "opening", 0, "x"].

export type Path = (string | number)[];

export interface Leaf {
  kind: "value";
  from: number;
  to: number;
  data: string | number | boolean | null; // null: a date or a number that is none here
}
export interface List {
  kind: "list"; // [ ... ] in a line
  from: number;
  to: number;
  items: Node[];
}
export interface Table {
  kind: "table";
  inline: boolean; // { ... }, else a section
  from: number;
  to: number;
  keys: Map<string, Entry>;
}
export interface Tables {
  kind: "tables"; // [[ ... ]] sections
  items: Table[];
}
export type Node = Leaf | List | Table | Tables;
export interface Entry {
  from: number; // of the key
  node: Node;
}
interface Section {
  path: Path;
  start: number; // of its header's line
  body: number; // after its last own key, or after its header
}
export interface Doc {
  text: string;
  root: Table;
  sections: Section[]; // in the order of the file; the first is the root
}
export class TomlFault extends Error {
  constructor(
    message: string,
    readonly line: number,
  ) {
    super(message);
  }
}

const kBare = /[A-Za-z0-9_-]/;
const kEscapes: Record<string, string> = { b: "\b", t: "\t", n: "\n", f: "\f", r: "\r", '"': '"', "\\": "\\" };

class Reader {
  at = 0;
  constructor(readonly text: string) {}

  fault(message: string): never {
    throw new TomlFault(message, this.text.slice(0, this.at).split("\n").length);
  }
  spaces(): void {
    while (this.text[this.at] === " " || this.text[this.at] === "\t") ++this.at;
  }
  comment(): void {
    if (this.text[this.at] === "#") while (this.at < this.text.length && this.text[this.at] !== "\n") ++this.at;
  }
  // Over spaces, comments and ends of lines.
  blank(): void {
    for (;;) {
      this.spaces();
      this.comment();
      if (this.text[this.at] === "\r" || this.text[this.at] === "\n") ++this.at;
      else return;
    }
  }
  lineEnd(): void {
    this.spaces();
    this.comment();
    if (this.text[this.at] === "\r") ++this.at;
    if (this.at < this.text.length && this.text[this.at] !== "\n") this.fault("something stands after the value");
  }
  take(sign: string): void {
    if (this.text[this.at] !== sign) this.fault(`lacks ${sign}`);
    ++this.at;
  }
  name(): string {
    const sign = this.text[this.at];
    if (sign === '"' || sign === "'") return this.string();
    const from = this.at;
    while (kBare.test(this.text[this.at] ?? "")) ++this.at;
    if (this.at === from) this.fault("lacks a key");
    return this.text.slice(from, this.at);
  }
  names(): string[] {
    const all: string[] = [];
    for (;;) {
      this.spaces();
      all.push(this.name());
      this.spaces();
      if (this.text[this.at] !== ".") return all;
      ++this.at;
    }
  }
  string(): string {
    const sign = this.text[this.at];
    const long = this.text.startsWith(sign.repeat(3), this.at);
    const close = long ? sign.repeat(3) : sign;
    this.at += close.length;
    if (long && this.text[this.at] === "\n") ++this.at;
    let out = "";
    for (;;) {
      if (this.at >= this.text.length || (!long && this.text[this.at] === "\n")) this.fault("lacks a quote");
      if (this.text.startsWith(close, this.at)) {
        while (long && this.text[this.at + 3] === sign) out += this.text[this.at++];
        this.at += close.length;
        return out;
      }
      const c = this.text[this.at++];
      out += c === "\\" && sign === '"' ? this.escape() : c;
    }
  }
  escape(): string {
    const c = this.text[this.at++];
    if (c === "u" || c === "U") {
      const digits = c === "u" ? 4 : 8;
      const code = parseInt(this.text.slice(this.at, this.at + digits), 16);
      if (!(code <= 0x10ffff)) this.fault("has an unknown escape");
      this.at += digits;
      return String.fromCodePoint(code);
    }
    if (c === "\n" || c === " ") {
      while (/\s/.test(this.text[this.at] ?? "")) ++this.at;
      return "";
    }
    return kEscapes[c] ?? this.fault("has an unknown escape");
  }
  value(depth = 0): Node {
    if (depth > 20) this.fault("is nested too deeply");
    const from = this.at;
    const sign = this.text[this.at];
    if (sign === '"' || sign === "'") {
      const data = this.string();
      return { kind: "value", from, to: this.at, data };
    }
    if (sign === "[") {
      const items: Node[] = [];
      ++this.at;
      for (;;) {
        this.blank();
        if (this.text[this.at] === "]") break;
        items.push(this.value(depth + 1));
        this.blank();
        if (this.text[this.at] === ",") ++this.at;
        else if (this.text[this.at] !== "]") this.fault("lacks ]");
      }
      ++this.at;
      return { kind: "list", from, to: this.at, items };
    }
    if (sign === "{") return this.inlineTable(depth);
    while (/[^\s,\]}#]/.test(this.text[this.at] ?? " ")) ++this.at;
    const word = this.text.slice(from, this.at);
    if (word === "") this.fault("lacks a value");
    const number = Number(word.replace(/_/g, ""));
    const data = word === "true" ? true : word === "false" ? false : Number.isFinite(number) ? number : null;
    if (data === null && !/^[-+]?(inf|nan)$|^\d{4}-|^\d\d:/.test(word)) this.fault("has a text without quotes");
    return { kind: "value", from, to: this.at, data };
  }
  inlineTable(depth: number): Table {
    const table: Table = { kind: "table", inline: true, from: this.at, to: this.at, keys: new Map() };
    this.take("{");
    for (;;) {
      this.blank();
      if (this.text[this.at] === "}") break;
      this.pair(table, depth + 1);
      this.blank();
      if (this.text[this.at] === ",") ++this.at;
      else if (this.text[this.at] !== "}") this.fault("lacks }");
    }
    ++this.at;
    table.to = this.at;
    return table;
  }
  // key = value, where the key may have dots.
  pair(into: Table, depth = 0): void {
    const from = this.at;
    const names = this.names();
    this.take("=");
    this.spaces();
    const last = names.pop()!;
    let table = into;
    for (const name of names) {
      let entry = table.keys.get(name);
      if (!entry) {
        entry = { from, node: { kind: "table", inline: true, from, to: from, keys: new Map() } };
        table.keys.set(name, entry);
      }
      if (entry.node.kind !== "table") this.fault(`${name} is no table`);
      table = entry.node as Table;
    }
    if (table.keys.has(last)) this.fault(`${last} stands twice`);
    table.keys.set(last, { from, node: this.value(depth) });
  }
}

export function parse(text: string): Doc {
  const reader = new Reader(text);
  const root: Table = { kind: "table", inline: false, from: 0, to: 0, keys: new Map() };
  const doc: Doc = { text, root, sections: [{ path: [], start: 0, body: 0 }] };
  let table = root;
  for (;;) {
    reader.blank();
    if (reader.at >= text.length) return doc;
    if (text[reader.at] === "[") table = header(reader, doc);
    else {
      reader.pair(table);
      doc.sections[doc.sections.length - 1].body = reader.at;
    }
    reader.lineEnd();
  }
}

// [a.b] or [[a.b]]: the table that it opens.
function header(reader: Reader, doc: Doc): Table {
  const start = reader.at;
  const many = doc.text.startsWith("[[", start);
  reader.at += many ? 2 : 1;
  const names = reader.names();
  reader.take("]");
  if (many) reader.take("]");
  const path: Path = [];
  let table = doc.root;
  names.forEach((name, k) => {
    const last = k === names.length - 1;
    path.push(name);
    let node = table.keys.get(name)?.node;
    if (!node) {
      node = last && many ? { kind: "tables", items: [] } : { kind: "table", inline: false, from: start, to: start, keys: new Map() };
      table.keys.set(name, { from: start, node });
    } else if (last && !many && node.kind === "table" && doc.sections.some((s) => same(s.path, path)))
      reader.fault(`[${names.join(".")}] stands twice`);
    if (node.kind === "tables") {
      if (last && many) node.items.push({ kind: "table", inline: false, from: start, to: start, keys: new Map() });
      else if (last) reader.fault(`[[${name}]] is a list`);
      path.push(node.items.length - 1);
      table = node.items[node.items.length - 1];
    } else if (node.kind === "table" && !(last && many)) table = node;
    else reader.fault(`${name} stands twice`);
  });
  doc.sections.push({ path, start, body: reader.at });
  return table;
}

const same = (a: Path, b: Path): boolean => a.length === b.length && a.every((part, k) => part === b[k]);
const below = (path: Path, head: Path): boolean => head.every((part, k) => part === path[k]);

export function find(doc: Doc, path: Path): Node | undefined {
  let node: Node | undefined = doc.root;
  for (const part of path) {
    if (node?.kind === "table") node = node.keys.get(String(part))?.node;
    else if (node?.kind === "tables" || node?.kind === "list") node = node.items[Number(part)];
    else return undefined;
  }
  return node;
}
export function valueAt(doc: Doc, path: Path): string | number | boolean | null | undefined {
  const node = find(doc, path);
  return node?.kind === "value" ? node.data : undefined;
}
// How many members a list of tables has, written as sections or in a line.
export function countAt(doc: Doc, path: Path): number {
  const node = find(doc, path);
  return node?.kind === "tables" || node?.kind === "list" ? node.items.length : 0;
}

// The values of a list in a line.
export function listAt(doc: Doc, path: Path): (string | number | boolean | null)[] {
  const node = find(doc, path);
  return node?.kind === "list" ? node.items.map((item) => (item.kind === "value" ? item.data : null)) : [];
}

export const quoted = (text: string): string =>
  JSON.stringify(text).replace(/\u007f/g, "\\u007F");
const keyName = (name: string): string => (/^[A-Za-z0-9_-]+$/.test(name) ? name : quoted(name));

// A comment that stands in a column after the value stays in its column where there is room.
function replaced(text: string, from: number, to: number, literal: string): string {
  const grows = literal.length - (to - from);
  const gap = /^[ ]{2,}(?=#)/.exec(text.slice(to))?.[0].length ?? 0;
  const kept = gap > 0 ? Math.max(1, gap - grows) : 0;
  return text.slice(0, from) + literal + " ".repeat(kept) + text.slice(to + gap);
}
const inserted = (text: string, at: number, what: string): string => text.slice(0, at) + what + text.slice(at);

export function setValue(text: string, path: Path, literal: string): string {
  const doc = parse(text);
  const node = find(doc, path);
  if (node && node.kind !== "tables" && (node.kind !== "table" || node.to > node.from))
    return replaced(text, node.from, node.to, literal);
  const name = path[path.length - 1] as string;
  const pair = `${keyName(name)} = ${literal}`;
  const parent = path.slice(0, -1);
  const section = doc.sections.find((s) => same(s.path, parent));
  if (section) {
    if (section.path.length === 0 && section.body === 0) {
      const first = doc.sections[1]?.start ?? text.length;
      const head = /^(?:[ \t]*#[^\n]*\n)*/.exec(text)![0].length; // after what is said of the file
      const at = Math.min(head, first);
      return inserted(text, at, `${pair}\n${at === first || text[at] === "\n" ? "" : "\n"}`);
    }
    const end = text.indexOf("\n", section.body);
    return end < 0 ? `${text}\n${pair}\n` : inserted(text, end, `\n${pair}`);
  }
  // a member that its list does not have (any more) takes no key
  if (parent.some((step, k) => typeof step === "number" && !find(doc, parent.slice(0, k + 1)))) return text;
  const table = find(doc, parent);
  if (table?.kind === "table" && table.inline && table.to > table.from) {
    const last = Math.max(table.from, ...[...table.keys.values()].map((e) => endOf(e.node)));
    return table.keys.size === 0
      ? replaced(text, table.from, table.to, `{ ${pair} }`)
      : inserted(text, last, `, ${pair}`);
  }
  if (table?.kind === "table" && table.inline) {
    // written with dots (a.b = 1): the new key stands behind its last sister
    const last = Math.max(...[...table.keys.values()].map((e) => endOf(e.node)));
    return inserted(text, lineEndAt(text, last), `\n${parent.slice(-1)[0]}.${pair}`);
  }
  const title = parent.filter((p) => typeof p === "string").map((p) => keyName(p as string)).join(".");
  return inserted(text, ...sectionPlace(doc, parent, `[${title}]\n${pair}\n`));
}

// Another key with another value in the place of one.
export function renameKey(text: string, path: Path, name: string, literal: string): string {
  const doc = parse(text);
  const parent = find(doc, path.slice(0, -1));
  const entry = parent?.kind === "table" ? parent.keys.get(String(path[path.length - 1])) : undefined;
  return entry ? replaced(text, entry.from, endOf(entry.node), `${keyName(name)} = ${literal}`) : text;
}

const endOf = (node: Node): number => (node.kind === "tables" ? 0 : node.to);
function lineEndAt(text: string, at: number): number {
  const end = text.indexOf("\n", at);
  return end < 0 ? text.length : end;
}

// Where a new section belongs: after the last that is below its nearest parent which the file has, with an
// empty line before it.
function sectionPlace(doc: Doc, path: Path, lines: string): [number, string] {
  const { text, sections } = doc;
  for (let n = path.length; n > 0; --n) {
    const head = path.slice(0, n);
    const last = sections.map((s) => below(s.path, head)).lastIndexOf(true);
    if (last < 0) continue;
    const at = lineEndAt(text, Math.max(sections[last].body, sections[last].start));
    return [at, `${at === text.length ? "\n" : ""}\n${at === text.length ? "" : "\n"}${lines.trimEnd()}${at === text.length ? "\n" : ""}`];
  }
  const gap = text === "" || text.endsWith("\n\n") ? "" : text.endsWith("\n") ? "\n" : "\n\n";
  return [text.length, gap + lines];
}

// A new member at the end of a list of tables. The first of its kind stands after the last section of those that
// `after` names.
export function appendTable(text: string, path: Path, pairs: [string, string][], after: string[] = []): string {
  const doc = parse(text);
  const node = find(doc, path);
  if (node?.kind === "list") {
    const member = `{ ${pairs.map(([k, v]) => `${keyName(k)} = ${v}`).join(", ")} }`;
    const last = node.items[node.items.length - 1];
    return last ? inserted(text, endOf(last), `, ${member}`) : replaced(text, node.from, node.to, `[${member}]`);
  }
  const title = path.filter((p) => typeof p === "string").map((p) => keyName(p as string)).join(".");
  const lines = [`[[${title}]]`, ...pairs.map(([k, v]) => `${keyName(k)} = ${v}`)].join("\n") + "\n";
  const last = node ? undefined : doc.sections.filter((s) => after.includes(String(s.path[0]))).pop();
  return inserted(text, ...sectionPlace(doc, last?.path ?? path, lines));
}
// A new member before member k of a list of tables, with the remarks above that left to it.
export function insertTable(text: string, path: Path, k: number, pairs: [string, string][]): string {
  const doc = parse(text);
  const node = find(doc, path);
  if (!node || (node.kind !== "tables" && node.kind !== "list") || k >= node.items.length) return appendTable(text, path, pairs);
  const lines = pairs.map(([key, v]) => `${keyName(key)} = ${v}`);
  if (node.kind === "list") return inserted(text, (node.items[k] as Table).from, `{ ${lines.join(", ")} }, `);
  const section = doc.sections.find((s) => same(s.path, [...path, k]))!;
  const title = path.filter((p) => typeof p === "string").map((p) => keyName(p as string)).join(".");
  return inserted(text, withRemarks(text, section.start), [`[[${title}]]`, ...lines].join("\n") + "\n\n");
}
// Where a section begins, with the lines of remarks right above it.
export function withRemarks(text: string, start: number): number {
  let at = text.lastIndexOf("\n", start - 1) + 1;
  for (;;) {
    const before = text.lastIndexOf("\n", at - 2) + 1;
    if (at === 0 || !/^[ \t]*#/.test(text.slice(before, at))) return at;
    at = before;
  }
}
// What stands in a place, as it would be written after a key.
export function literalOf(doc: Doc, path: Path): string {
  const write = (node: Node): string => {
    if (node.kind === "value" || node.kind === "list" || (node.kind === "table" && node.inline && node.to > node.from)) return doc.text.slice(node.from, node.to);
    if (node.kind === "tables") return `[${node.items.map(write).join(", ")}]`;
    return `{ ${[...node.keys].map(([key, entry]) => `${keyName(key)} = ${write(entry.node)}`).join(", ")} }`;
  };
  const node = find(doc, path);
  return node ? write(node) : "";
}

export function removeAt(text: string, path: Path): string {
  const doc = parse(text);
  const { sections } = doc;
  // sections below the path, each with its lines; comments before the next section stay with that
  const spans = sections
    .map((s, k) => ({ s, k }))
    .filter(({ s }) => s.path.length > 0 && below(s.path, path))
    .map(({ s }) => {
      let to = Math.min(text.length, lineEndAt(text, Math.max(s.body, s.start)) + 1);
      while (text[to] === "\n") ++to;
      return [s.start, to];
    });
  if (spans.length > 0) {
    let out = text;
    for (const [from, to] of spans.reverse()) out = out.slice(0, from) + out.slice(to);
    return out;
  }
  const parent = find(doc, path.slice(0, -1));
  const node = find(doc, path);
  if (!node || node.kind === "tables") return text;
  if (isDotted(node)) return [...node.keys.keys()].reverse().reduce((out, key) => removeAt(out, [...path, key]), text);
  if (parent?.kind === "list") return withoutMember(text, parent.items.map((i) => [i.kind === "tables" ? 0 : i.from, endOf(i)]), Number(path[path.length - 1]));
  if (parent?.kind !== "table") return text;
  const line = bracesAround(doc, path);
  const [from, to] = [[...parent.keys.values()].find((e) => e.node === node)!.from, endOf(node)];
  if (line) {
    const all = [...line.keys.values()].flatMap(leavesOf).sort((a, b) => a[0] - b[0]);
    return withoutMember(text, all, all.findIndex((span) => span[0] === from));
  }
  return text.slice(0, text.lastIndexOf("\n", from - 1) + 1) + text.slice(Math.min(text.length, lineEndAt(text, to) + 1));
}
// Written with dots (a.b = 1): no place of its own, only its keys'.
const isDotted = (node: Node): node is Table => node.kind === "table" && node.inline && node.to === node.from;
const leavesOf = ({ from, node }: Entry): number[][] => (isDotted(node) ? [...node.keys.values()].flatMap(leavesOf) : [[from, endOf(node)]]);
// The { ... } in which a key stands.
function bracesAround(doc: Doc, path: Path): Table | null {
  for (let n = path.length - 1; n > 0; --n) {
    const node = find(doc, path.slice(0, n));
    if (node?.kind !== "table" || !node.inline) return null;
    if (!isDotted(node)) return node;
  }
  return null;
}
// Of `a, b, c` one goes with the comma that parted it from its neighbour.
function withoutMember(text: string, spans: number[][], k: number): string {
  const [from, to] = spans[k];
  if (k > 0) return text.slice(0, spans[k - 1][1]) + text.slice(to);
  return text.slice(0, from) + (spans.length > 1 ? text.slice(spans[1][0]) : text.slice(to));
}

// The line on which a path stands, from 1; that of its nearest parent if it is missing.
export function lineOf(doc: Doc, path: Path): number {
  for (let n = path.length; n > 0; --n) {
    const head = path.slice(0, n);
    const node = find(doc, head);
    const section = doc.sections.find((s) => same(s.path, head));
    const at = section?.start ?? (node && node.kind !== "tables" ? node.from : undefined);
    if (at !== undefined) return doc.text.slice(0, at).split("\n").length;
  }
  return 1;
}
