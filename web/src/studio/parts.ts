// What is said of any part that may be selected.
import { removeOpening, type Drawing, type Selected } from "./drawing";
import { removeStoreyLine } from "./storeys";

export function removePart(text: string, d: Drawing, part: Selected): string {
  if (part.kind === "opening") return removeOpening(text, part.k);
  return part.k > 0 ? removeStoreyLine(text, d, part.k) : text;
}
