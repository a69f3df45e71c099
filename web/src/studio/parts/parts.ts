// What is said of any part that may be selected.
import type { Drawing, Selected } from "../drawing";
import { removeOpening } from "./openings";
import { removeFloor } from "./floors";
import { frameOf, removeFrame } from "./frames";
import { removeStoreyLine } from "./storeys";
import { removeTie } from "./ties";

// null: the file has something there that would be lost or moved.
export function removePart(text: string, d: Drawing, { kind, k }: Selected): string | null {
  if (kind === "opening") {
    const frame = frameOf(d, k);
    return removeOpening(frame < 0 ? text : removeFrame(text, frame), k);
  }
  if (kind === "floor") return removeFloor(text, d, k);
  if (kind === "tie") return removeTie(text, k);
  return k > 0 ? removeStoreyLine(text, d, k) : text;
}
