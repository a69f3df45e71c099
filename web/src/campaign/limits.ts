// The code's drift limits as vertical lines, with labels in as few rows above the chart as avoid
// overlaps. Labels have words if there is room, else only values (the caption then explains them).
import { svg } from "../base/dom";
import type { DriftLimit } from "../headers/statistics";
import { kLeft, type Plot, type Range } from "../base/plot";
import { num, phrase } from "../base/texts";

interface Limit {
  value: number; // [%]
  only: boolean; // of life safety only
  words: string;
}
interface Label {
  limit: Limit;
  row: number;
  atRight: boolean; // the label ends at its line
}
export interface LimitRows {
  labels: Label[];
  top: number; // room above the chart [px]
  short: boolean; // values alone
}

const kPixel = 6.3, // width of a letter
  kRow = 15,
  kMostRows = 3;

const percent = (value: number): string => `${num(value, 4)}\u202f%`;

// Limits with one value share a line.
function merged(limits: DriftLimit[]): Limit[] {
  const values = [...new Set(limits.map((l) => l.limit_drift_percent))].sort((a, b) => a - b);
  return values.map((value) => {
    const of = limits.filter((l) => l.limit_drift_percent === value);
    return {
      value,
      only: of.every((l) => l.state === "life safety"),
      words: [...new Set(of.map((l) => phrase(l.label)))].join("; "),
    };
  });
}

// "0.5 % pier, shear; 1 % pier, rocking"
export const limitList = (limits: DriftLimit[]): string =>
  merged(limits)
    .map((l) => `${percent(l.value)} ${l.words}`)
    .join("; ");

const wordsOf = (limit: Limit, short: boolean): string =>
  short ? percent(limit.value) : `${percent(limit.value)} ${limit.words}`;

// Each label is in the lowest row where it overlaps no other, the rightmost first. With words:
// null if they need too many rows, or if a line would pass through a label on its way up.
function placed(limits: Limit[], x: (v: number) => number, right: number, short: boolean): Label[] | null {
  const ends: [number, number][][] = [];
  const labels: Label[] = [];
  for (const limit of [...limits].reverse()) {
    const long = kPixel * wordsOf(limit, short).length,
      at = x(limit.value),
      atRight = at + long > right;
    const from = atRight ? at - long : at,
      to = atRight ? at : at + long;
    let row = 0;
    const meets = (r: number): boolean => (ends[r] ?? []).some(([a, b]) => from < b + 8 && to > a - 8);
    while (meets(row)) ++row;
    const passes = ends.slice(0, row).some((spans) => spans.some(([a, b]) => a < at - 1 && at + 1 < b));
    if (!short && (row >= kMostRows || passes)) return null;
    (ends[row] ??= []).push([from, to]);
    labels.push({ limit, row, atRight });
  }
  return labels;
}

// For a chart of width `width` whose axis shows `span`, with `right` pixels beside it.
export function limitRows(
  limits: DriftLimit[],
  span: Range,
  width: number,
  right: number,
  only?: string,
): LimitRows {
  const inside = merged(
    limits.filter((l) => (!only || l.state === only) && l.limit_drift_percent <= span[1]),
  );
  const end = width - right,
    x = (v: number): number => kLeft + ((end - kLeft) * (v - span[0])) / (span[1] - span[0]);
  const inWords = placed(inside, x, end + Math.max(0, right - 4), false);
  const labels = inWords ?? placed(inside, x, end + Math.max(0, right - 4), true)!;
  const rows = Math.max(0, ...labels.map((l) => l.row + 1));
  return { labels, top: 14 + kRow * rows, short: inWords === null };
}

export function drawLimits(plot: Plot, { labels, short }: LimitRows): void {
  for (const { limit, row } of labels) {
    const x = plot.X(limit.value);
    plot.marks.appendChild(
      svg("line", {
        class: limit.only ? "limit life" : "limit",
        x1: x,
        x2: x,
        y1: plot.top,
        y2: plot.bottom,
        "data-limit": limit.value,
      }),
    );
    plot.over.appendChild(
      svg("line", { class: "limit-tick", x1: x, x2: x, y1: plot.top, y2: plot.top - 5 - kRow * row }),
    );
  }
  for (const { limit, row, atRight } of labels)
    plot.text(plot.X(limit.value) + (atRight ? -2 : 0), plot.top - 9 - kRow * row, wordsOf(limit, short), "small halo limit-label", {
      "text-anchor": atRight ? "end" : "start",
    });
}
