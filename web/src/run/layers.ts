// Results of the layers in a run: a sentence for each.
import { h, type Child } from "../base/dom";
import type { RunHeader } from "../headers/run";
import { say, sentence } from "../base/texts";

// null: no layer.
export function layersSaid(header: RunHeader): Child {
  const said = header.layers_said ?? [];
  if (said.length === 0) return null;
  return [said.map((words) => h("p", {}, sentence(words))), h("p", { class: "note" }, say("layers.what"))];
}
