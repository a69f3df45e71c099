// What is wrong with the file, in a list: where, why, and the cure. A cure that is a plain value is a button.
import { h } from "../../base/dom";
import { say } from "../../base/texts";
import type { Fault, Project } from "../project";
import { inWords, said } from "./said";
import { find, quoted, setValue, type Doc, type Path } from "./toml";

export function pathOf(text: string): Path {
  return text.split(".").map((part) => (/^\d+$/.test(part) ? Number(part) : part));
}
// The edits that a cure asks for, if it names values and not just examples.
export function editsOf(fault: Fault, doc: Doc | null): [Path, string][] | null {
  if (!doc || fault.path === "") return null;
  const path = pathOf(fault.path);
  const meant = /^did you mean ("[^"]*")\?$/.exec(fault.cure);
  if (meant && find(doc, path)) return [[path, meant[1]]];
  if (!fault.cure.startsWith("write ") || fault.cure.includes("e.g.") || fault.cure.includes("[")) return null;
  const parent = path.slice(0, -1);
  if (!find(doc, parent)) return null;
  const named = [...fault.cure.split(",")[0].matchAll(/([a-z_]+) = ("[^"]*"|[-\d.]+|true|false)(?= |$)/g)];
  if (named.length === 0) return null;
  return named.map((m) => [[...parent, m[1]], m[2].startsWith('"') ? quoted(m[2].slice(1, -1)) : m[2]]);
}
// The opening that a fault is about.
export function openingOf(fault: Fault): number {
  const match = /^wall\.opening\.(\d+)(\.|$)/.exec(fault.path);
  return match ? Number(match[1]) : -1;
}

export class FaultList {
  readonly root = h("div", { class: "faults", role: "status", "aria-live": "polite" });
  constructor(
    private readonly project: Project,
    private readonly go: (fault: Fault) => void,
  ) {}

  show(faults: Fault[]): void {
    this.root.replaceChildren(
      ...(faults.length === 0
        ? []
        : [
            h("h2", {}, say(faults.length === 1 ? "studio.faults.one" : "studio.faults.many", { count: faults.length })),
            h("ul", {}, ...faults.slice(0, 30).map((f) => this.item(f))),
          ]),
    );
  }
  private item(fault: Fault): HTMLElement {
    const { project } = this;
    const edits = editsOf(fault, project.broken ? null : project.doc);
    const value = `= ${fault.value}`; // the table has those that the engine says in words
    const what = [fault.path, fault.value !== "" && (inWords(value) ?? value)].filter(Boolean).join(" ");
    return h(
      "li", {},
      h("button", { class: "fault", type: "button", onclick: () => this.go(fault) },
        h("b", {}, say("studio.line", { line: fault.line })), " ", what !== "" && h("code", {}, what), " ", said(fault.problem)),
      fault.cure !== "" && h("p", { class: "cure" }, said(fault.cure)),
      edits && h("button", { class: "button small", type: "button", onclick: () => {
        let text = project.text;
        for (const [path, literal] of edits) text = setValue(text, path, literal);
        project.endStep();
        project.change(text);
      } }, say("studio.cure")),
    );
  }
}
