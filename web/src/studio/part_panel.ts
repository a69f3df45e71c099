// The numbers of a part that is selected and is no opening.
import { h } from "../dom";
import { say } from "../texts";
import type { Selected } from "./drawing";
import type { Panel } from "./panel";
import { removePart } from "./parts";
import type { Project } from "./project";
import { moveStoreyLine, renameStorey, setStoreyHeight } from "./storeys";
import { find, setValue, valueAt, quoted, removeAt, type Path } from "./toml";
import { lengthOf, writeQuantity } from "./units";

// What tells one set of fields from another.
export const partShape = ({ selection, doc }: Project): string =>
  selection?.kind === "storey" && doc ? String(find(doc, ["storey", selection.k, "thickness"]) !== undefined) : "";

export function partGroup(panel: Panel, part: Selected): HTMLElement {
  return storeyGroup(panel, part.k);
}
const removal = (panel: Panel, part: Selected, words: string): HTMLElement =>
  h("button", { class: "button", type: "button", onclick: () => panel.edit(removePart(panel.project.text, panel.project.drawing!, part), null) }, words);

function storeyGroup(panel: Panel, k: number): HTMLElement {
  const { project } = panel;
  const d = () => project.drawing!;
  const storey = () => d().storeys[Math.min(k, d().storeys.length - 1)];
  const own: Path = ["storey", k, "thickness"];
  const thickness = (): number => lengthOf(valueAt(project.doc!, own)) ?? lengthOf(valueAt(project.doc!, ["wall", "thickness"])) ?? NaN;
  return panel.group(
    say("studio.storey"),
    panel.text(say("studio.name"), () => storey().name, (name) => renameStorey(project.text, d(), k, name), true),
    k > 0 && panel.length(say("studio.storey.foot"), () => storey().foot, (y) => (y > d().storeys[k - 1].foot && y < storey().foot + storey().height ? moveStoreyLine(project.text, d(), k, y) : null), "course"),
    panel.length(say("studio.height"), () => storey().height, (v) => (v > 0 ? setStoreyHeight(project.text, d(), k, v) : null), "course"),
    panel.length(say("studio.thickness"), thickness, (v) => setValue(project.text, own, quoted(writeQuantity(v, "m", "0.00"))), 0.01),
    find(project.doc!, own) && h("button", { class: "button", type: "button", onclick: () => panel.edit(removeAt(project.text, own)) }, say("studio.storey.aswall")),
    k > 0 && removal(panel, { kind: "storey", k }, say("studio.storey.remove")),
  );
}
