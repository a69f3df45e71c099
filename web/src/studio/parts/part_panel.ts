// The numbers of a part that is selected and is no opening.
import { h, type Child } from "../../base/dom";
import { say } from "../../base/texts";
import type { Selected } from "../drawing";
import { holdOf, kHolds, moveFloor, setFloorSpan, setHold, type Hold } from "./floors";
import { addExtra, addFrame, frameOf, isPutUp, kExtras, kFeet, kGrades, removeExtra, removeFrame, setGap, setProfile, type Extra } from "./frames";
import type { Panel } from "../panel";
import { kProfiles, profileNamed } from "./profiles";
import type { Project } from "../project";
import { moveStoreyLine, renameStorey, setStoreyHeight } from "./storeys";
import { forceOf, setTieEnds, setTieForce } from "./ties";
import { find, quoted, removeAt, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { isWord, lengthOf, readQuantity, setLength, writeQuantity } from "../file/units";
import { amount, kUnread } from "../words";

// What tells one set of fields from another.
export function partShape({ selection, doc, drawing }: Project): string {
  if (!selection || !doc || !drawing) return "";
  if (selection.kind === "opening") {
    const frame = frameOf(drawing, selection.k);
    const at: Path = ["frame", frame];
    return [frame, isPutUp(doc, frame), ...["profile", "beam_profile", "grade", "yield_strength", "anchors", "wedges"].map((key) => find(doc, [...at, key]) !== undefined), ...["yield_strength", "anchors.slip"].map((key) => isWord(doc, [...at, ...key.split(".")]))].join();
  }
  const at: Path = [selection.kind, selection.k];
  const words = [...Object.keys(kFloorUnits), "anchor_strength", "yield_strength"].map((key) => isWord(doc, [...at, key]));
  return [...words, sumsUp(doc, at), find(doc, [...at, "thickness"]) !== undefined].join();
}

export function partGroup(panel: Panel, part: Selected): HTMLElement {
  if (part.kind === "floor") return floorGroup(panel, part.k);
  if (part.kind === "tie") return tieGroup(panel, part.k);
  return storeyGroup(panel, part.k);
}
const removal = (panel: Panel, part: Selected, words: string): HTMLElement =>
  h("button", { class: "button", type: "button", onclick: () => panel.remove(part) }, words);

function storeyGroup(panel: Panel, k: number): HTMLElement {
  const { project } = panel;
  const d = () => project.drawing!;
  const storey = () => d().storeys[Math.min(k, d().storeys.length - 1)];
  const own: Path = ["storey", k, "thickness"];
  const thickness = (): number => lengthOf(valueAt(project.doc!, own)) ?? lengthOf(valueAt(project.doc!, ["wall", "thickness"])) ?? NaN;
  return panel.group(
    say("studio.storey"),
    panel.text(say("studio.name"), () => storey().name, (name) => renameStorey(project.text, d(), k, name), true),
    k > 0 && panel.length(say("studio.above.base"), () => storey().foot, (y) => (y > d().storeys[k - 1].foot && y < storey().foot + storey().height ? moveStoreyLine(project.text, d(), k, y) : null), "course"),
    panel.length(say("studio.height"), () => storey().height, (v) => (v > 0 ? setStoreyHeight(project.text, d(), k, v) : null), "course"),
    panel.length(say("studio.thickness"), thickness, (v) => setValue(project.text, own, quoted(writeQuantity(v, "m", "0.00"))), 0.01, "m", own),
    find(project.doc!, own) && h("button", { class: "button", type: "button", onclick: () => panel.edit(removeAt(project.text, own)) }, say("studio.storey.aswall")),
    k > 0 && removal(panel, { kind: "storey", k }, say("studio.storey.remove")),
  );
}

// What a floor may say of itself. Its load is a number, or the sum of others, which needs them all.
const kSum = ["g1", "g2", "q", "psi2", "span"];
const kFloorUnits: Record<string, string> = { load: "kN/m", g1: "kN/m^2", g2: "kN/m^2", q: "kN/m^2", span: "m", bearing: "mm", thrust: "kN", mass: "kg/m" };
const sumsUp = (doc: Doc, at: Path): boolean => !find(doc, [...at, "load"]) && kSum.some((key) => find(doc, [...at, key]));

function floorGroup(panel: Panel, k: number): HTMLElement {
  const { project } = panel;
  const d = () => project.drawing!;
  const floor = () => d().floors[Math.min(k, d().floors.length - 1)];
  const at: Path = ["floor", k];
  const has = (key: string): boolean => find(project.doc!, [...at, key]) !== undefined;
  const sum = sumsUp(project.doc!, at);
  const keys = [...(sum ? kSum : ["load", ...kSum.filter(has)]), "bearing", "thrust", "mass"];
  const needed = (key: string): string | undefined => (sum && kSum.includes(key) ? say("studio.floor.needed") : undefined);
  const inside = (y: number): boolean => y > 0 && y <= d().height + 1e-6;
  return panel.group(
    say("studio.floor"),
    panel.text(say("studio.name"), () => floor().name, (name) => setValue(project.text, ["floor", k, "name"], quoted(name)), true),
    panel.length(say("studio.above.base"), () => floor().y, (y) => (inside(y) ? moveFloor(project.text, d(), k, y) : null), "course"),
    keys.map((key) => (key === "psi2" ? panel.share(say("studio.floor.psi2"), [...at, key], needed(key)) : panel.optional(say(`studio.floor.${key}`), [...at, key], kFloorUnits[key], needed(key)))),
    panel.length(say("studio.left"), () => floor().x, (x) => (x < d().length ? setFloorSpan(project.text, d(), k, x, Math.min(floor().width, d().length - x)) : null), "half", "m", [...at, "x"]),
    panel.length(say("studio.width"), () => floor().width, (w) => (w > 0 && floor().x + w <= d().length + 1e-6 ? setFloorSpan(project.text, d(), k, floor().x, w) : null), "half", "m", [...at, "width"]),
    panel.choice(say("studio.floor.hold"), kHolds.map((hold) => [hold, say(`studio.floor.hold.${hold}`)]), () => holdOf(d(), k), (hold) => setHold(project.text, d(), k, hold as Hold), true),
    panel.hint(() => (say("studio.floor.sum", { load: amount(floor().load, 1e-3, "kN/m"), whole: amount(floor().load, floor().width / 1000, "kN") }))),
    removal(panel, { kind: "floor", k }, say("studio.delete")),
  );
}

function tieGroup(panel: Panel, k: number): HTMLElement {
  const { project } = panel;
  const tie = () => project.drawing!.ties[Math.min(k, project.drawing!.ties.length - 1)];
  const at = (key: string): Path => ["tie", k, key];
  const area = (): string => String(valueAt(project.doc!, at("area")) ?? "");
  const end = (which: "from" | "to"): HTMLElement | null =>
    tie()[which] && panel.length(say(`studio.tie.${which}`), () => tie()[which]?.x ?? NaN, (x) => setLength(project.text, [...at(which), "x"], x), "half");
  const force = (): string => {
    const value = forceOf(tie());
    return value === null ? kUnread : writeQuantity(Math.round(value), "kN");
  };
  const sum = (): string => {
    const { area, yields } = tie();
    const bar = amount(area === null ? null : Math.sqrt((4 * area) / Math.PI), 1000, "mm");
    return say(yields === Infinity ? "studio.tie.bar" : "studio.tie.sum", { bar, force: amount(area === null ? null : yields, (area ?? 0) / 1000, "kN") });
  };
  const level = (y: number): string => {
    const { from, to } = tie();
    return setTieEnds(project.text, k, { x: from!.x, y }, { x: to!.x, y: to!.y + y - from!.y });
  };
  return panel.group(
    say("studio.tie"),
    panel.text(say("studio.name"), () => tie().name, (name) => setValue(project.text, at("name"), quoted(name)), true),
    end("from"),
    end("to"),
    tie().from && tie().to && panel.length(say("studio.above.base"), () => tie().from?.y ?? NaN, level, "course"),
    readQuantity(area()) && panel.quantity(say("studio.tie.area"), area, (v) => setValue(project.text, at("area"), quoted(v))),
    panel.quantity(say("studio.tie.force"), force, (v) => setTieForce(project.text, tie(), k, readQuantity(v)?.value ?? -1), "", at("prestress")),
    panel.optional(say("studio.tie.yield_strength"), at("yield_strength"), "MPa"),
    panel.optional(say("studio.tie.anchor_strength"), at("anchor_strength"), "kN"),
    panel.hint(sum),
    removal(panel, { kind: "tie", k }, say("studio.delete")),
  );
}

// The steel frame of an opening: a button that adds one, or its choices.
export function frameFields(panel: Panel, k: number): Child[] {
  const { project } = panel;
  const frame = frameOf(project.drawing!, k);
  if (frame < 0 && project.drawing!.openings[k].arch) return []; // a frame needs a level head
  if (frame < 0) return [h("button", { class: "button", type: "button", onclick: () => panel.edit(addFrame(project.text, project.drawing!, k, say("studio.a.frame"))) }, say("studio.frame.add"))];
  const at = (key: string): Path => ["frame", frame, key];
  const word = (key: string): string => String(valueAt(project.doc!, at(key)) ?? "");
  const names = kProfiles.map(([name]): [string, string] => [name, name]);
  const count = (key: string): HTMLElement =>
    panel.number(say(`studio.frame.${key}`), () => Number(valueAt(project.doc!, at(key)) || valueAt(project.doc!, at("count")) || 1), (n) => setValue(project.text, at(key), String(n)), at(key));
  const has = (key: string): boolean => find(project.doc!, at(key)) !== undefined;
  return [
    h("h3", {}, say("studio.frame")),
    ...(find(project.doc!, at("profile"))
      ? [
          panel.choice(say("studio.frame.profile"), names, () => profileNamed(word("profile")), (name) => setProfile(project.text, frame, "profile", name)),
          panel.choice(say("studio.frame.beam_profile"), [["", say("studio.frame.as")], ...names], () => profileNamed(word("beam_profile")), (name) => setProfile(project.text, frame, "beam_profile", name)),
        ]
      : [h("p", { class: "hint" }, say("studio.frame.section"))]),
    panel.choice(say("studio.frame.feet"), kFeet.map((f) => [f, say(`studio.frame.feet.${f}`)]), () => word("feet"), (f) => setValue(project.text, at("feet"), quoted(f)), true),
    count("count"),
    has("beam_profile") && count("beam_count"),
    has("grade") && panel.choice(say("studio.frame.grade"), kGrades.map((g) => [g, g]), () => word("grade"), (g) => setValue(project.text, at("grade"), quoted(g))),
    (has("yield_strength") || !has("grade")) && panel.optional(say("studio.tie.yield_strength"), at("yield_strength"), "MPa"),
    panel.length(say("studio.frame.gap"), () => project.drawing!.frames[frame]?.gap ?? 0, (v) => setGap(project.text, frame, v), 0.001, "mm", at("gap")),
    extraFields(panel, frame, "anchors"),
    (has("wedges") || isPutUp(project.doc!, frame)) && extraFields(panel, frame, "wedges"),
    h("button", { class: "button wide", type: "button", onclick: () => panel.edit(removeFrame(project.text, frame)) }, say("studio.frame.remove")),
  ];
}
// Anchors or wedges: a button that puts them in, or their numbers and a button that takes them away.
function extraFields(panel: Panel, frame: number, extra: Extra): Child[] {
  const { project } = panel;
  const at = (key: string): Path => ["frame", frame, extra, key];
  const press = (words: string, edit: (text: string, k: number, extra: Extra) => string): HTMLElement =>
    h("button", { class: "button wide", type: "button", onclick: () => panel.edit(edit(project.text, frame, extra)) }, say(words));
  if (!find(project.doc!, ["frame", frame, extra])) return [press(`studio.frame.${extra}.add`, addExtra)];
  const show = (key: string) => (): string => String(valueAt(project.doc!, at(key)) ?? "");
  return [
    h("h3", {}, say(`studio.frame.${extra}`)),
    kExtras[extra].keys.filter((key) => readQuantity(show(key)())).map((key) => panel.quantity(say(`studio.frame.${extra}.${key}`), show(key), (v) => setValue(project.text, at(key), quoted(v)))),
    extra === "anchors" && panel.optional(say("studio.frame.anchors.slip"), at("slip"), "mm"),
    press(`studio.frame.${extra}.remove`, removeExtra),
  ];
}
