// The masonry in the panel: typical values of the library, the knowledge level that divides them, what rules ask for besides, and
// where each number comes from.
import { h } from "../../base/dom";
import { capital, say } from "../../base/texts";
import { kMaterials } from "./materials";
import type { Panel } from "../panel";
import type { Fault } from "../project";
import { find, quoted, removeAt, setValue, valueAt, type Doc, type Path } from "../file/toml";
import { readQuantity } from "../file/units";

// No masonry of the library has all that rules ask for: a field is there where the file has a value or the engine lacks one.
export const kAsked: [key: string, unit: string][] = [
  ["masonry.unit_strength", "MPa"], ["masonry.mortar_strength", "MPa"], ["masonry.masonry_strength", "MPa"], ["masonry.initial_shear_strength", "MPa"],
  ["masonry.friction_tan", ""], ["masonry.youngs_modulus", "GPa"], ["masonry.vertical_stress", "MPa"], ["material.unit.tensile_strength", "MPa"],
];
const kUse: Path = ["masonry", "use"],
  kLevel: Path = ["masonry", "knowledge_level"];
const kLevels = ["LC1", "LC2", "LC3"];
// Typical values of a code that divides them by the knowledge level.
const hasLevels = (masonry: unknown): boolean => String(masonry ?? "").startsWith("circolare_");

// Keys that faults ask for: "the rule fb_from_fm needs masonry_strength, mortar_strength".
export function lackingOf(faults: Fault[]): Set<string> {
  const inputs = ({ problem }: Fault): string[] => / needs ([\w, ]+)$/.exec(problem)?.[1].split(", ").map((key) => `masonry.${key}`) ?? [];
  return new Set(faults.flatMap((fault) => [fault.path, ...inputs(fault)]));
}
function askedOf(doc: Doc, lacking: Set<string>): [key: string, unit: string][] {
  return kAsked.filter(([key, unit]) => {
    const value = valueAt(doc, key.split("."));
    return value === undefined ? lacking.has(key) : unit === "" ? typeof value === "number" : readQuantity(value) !== null;
  });
}
// What tells one set of fields from another.
export const masonryShape = (doc: Doc | null, lacking: Set<string>): string =>
  doc && find(doc, ["masonry"]) ? [hasLevels(valueAt(doc, kUse)), ...askedOf(doc, lacking)].join() : "";

export function masonryGroup(panel: Panel, lacking: Set<string>, origins: HTMLElement): HTMLElement {
  const { project } = panel;
  if (find(project.doc!, ["masonry"]) === undefined) return panel.group(say("studio.masonry"), h("p", { class: "hint" }, say("studio.masonry.numbers")), origins);
  const word = (path: Path) => (): string => String(valueAt(project.doc!, path) ?? "");
  const take = (masonry: string): string => {
    const text = setValue(project.text, kUse, quoted(masonry));
    return hasLevels(masonry) ? text : removeAt(text, kLevel);
  };
  const levels = [["", say("studio.knowledge.none")], ...kLevels.map((level) => [level, level])] as [string, string][];
  return panel.group(
    say("studio.masonry"),
    panel.choice(say("studio.material"), kMaterials.map((m) => [m, say(`studio.material.${m}`)]), word(kUse), take, true),
    hasLevels(word(kUse)()) && panel.choice(say("studio.knowledge"), levels, word(kLevel), (level) => (level === "" ? removeAt(project.text, kLevel) : setValue(project.text, kLevel, quoted(level))), true),
    askedOf(project.doc!, lacking).map(([key, unit]) => {
      const path = key.split("."),
        label = path[0] === "masonry" ? capital(say(`input.${path[1]}`)) : say("studio.unit.tensile_strength");
      return unit === "" ? panel.share(label, path) : panel.optional(label, path, unit);
    }),
    origins,
  );
}
