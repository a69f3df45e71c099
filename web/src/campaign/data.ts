// A campaign as its page uses it: samples with curves, inputs, modes; and the reader's choices.
import type { Bundle, Numbers } from "../base/bundle";
import type { CampaignHeader } from "../headers/campaign";
import type { Maybe } from "../headers/common";
import type { InputSummary, QuantityKey, Statistics } from "../headers/statistics";
import { pageUnit, phrase, say, type Said } from "../base/texts";

export interface Sample {
  sample: number;
  status: string;
  reason: Said;
  answered: boolean;
  mode: string;
  sentence: Said;
  readAt: number | null; // displacement for which the mode was evaluated [mm]
  readEarly: boolean; // before the requested one, because the push had ended
  response: (number | null)[];
  censored: boolean[]; // the value is a lower bound
  stateHash: string;
  displacement: Numbers;
  reaction: Numbers; // [mm], [kN]
}
export interface Input {
  name: string;
  title: string;
  unit: string;
  path: string;
  random: boolean;
  distribution?: string;
  formula?: string;
  density: { x: number[]; y: number[] } | null;
  values: Numbers; // one for each drawn sample, in the displayed unit
}
export interface Quantity {
  name: string;
  unit: string;
  canBeCensored: boolean;
  key: QuantityKey;
}

// Share of lower bounds up to which a mean hardly changes.
export const kFew = 0.05;
// If the force still rises at the end of a push, its peak is a lower bound too.
const kOfPeak = ["peak_reaction", "displacement_at_peak"];

const isPaperMode = (mode: string): boolean => /^FM-[1-5]$/.test(mode);

// Style class of a mode's colour: FM-1 ... FM-5 have their own, other names share the rest in turn.
export function modeClass(modes: string[], mode: string): string {
  if (isPaperMode(mode)) return `m${mode[3]}`;
  if (mode === "unclear") return "m0";
  const others = modes
    .slice(0, Math.max(0, modes.indexOf(mode)))
    .filter((m) => !isPaperMode(m) && m !== "unclear").length;
  // a campaign without the paper's modes has the paper's colours for its own
  return modes.some(isPaperMode) ? `m${6 + (others % 3)}` : `m${1 + (others % 8)}`;
}

export class Bounds {
  readonly count: number;
  private readonly least: number;
  constructor(
    readonly of: number,
    censored: number[],
  ) {
    this.count = censored.length;
    this.least = Math.min(Infinity, ...censored);
  }
  get many(): boolean {
    return this.count > kFew * this.of;
  }
  // Whether an order statistic (least, median, ...) of recorded values is a lower bound: it is exact only below all bounds.
  reach(value: number | null): boolean {
    return value !== null && value >= this.least * (1 - 1e-6);
  }
  words(): string {
    return say("censored.of", { n: this.count, of: this.of });
  }
}
export const atLeast = (bound: boolean): string => (bound ? "≥ " : "");

export class Campaign {
  readonly header: CampaignHeader;
  readonly statistics: Statistics;
  readonly samples: Sample[];
  readonly answered: Sample[];
  readonly inputs: Input[];
  readonly quantities: Quantity[];
  readonly modes: string[];
  readonly loadHeight: number;

  // the reader's choices, and their listeners
  readonly hidden = new Set<string>();
  selected: Sample | null = null;
  picked = false; // by the reader, not by the page
  private readonly modeListeners: (() => void)[] = [];
  private readonly sampleListeners: (() => void)[] = [];

  constructor(readonly bundle: Bundle<CampaignHeader>) {
    this.header = bundle.header;
    this.statistics = this.header.statistics;
    this.loadHeight = this.statistics.load_height_m ?? 0;
    this.quantities = this.header.quantities.map((q) => ({
      name: q.name,
      unit: q.unit,
      canBeCensored: q.can_be_censored,
      key: q.key,
    }));
    this.samples = this.readSamples();
    this.answered = this.samples.filter((s) => s.answered);
    const named = new Set(this.answered.map((s) => s.mode));
    this.modes = this.statistics.modes.filter((m) => named.has(m));
    this.inputs = this.readInputs();
  }

  private readSamples(): Sample[] {
    const displacement = this.bundle.array("curve.displacement_mm"),
      reaction = this.bundle.array("curve.reaction_kN");
    let at = 0;
    return this.header.samples.map((s) => {
      const from = at;
      at += s.rows;
      return {
        sample: s.sample,
        status: s.status,
        reason: s.reason,
        answered: s.answered,
        mode: s.mode ?? "",
        sentence: s.sentence ?? "",
        readAt: s.read_at_mm ?? null,
        readEarly: s.read_early ?? false,
        response: s.response ?? [],
        censored: (s.censored ?? []).map(
          (c, i) =>
            c || (s.still_rising === true && kOfPeak.includes(this.quantities[i].name)),
        ),
        stateHash: s.state_hash ?? "",
        displacement: displacement.subarray(from, at),
        reaction: reaction.subarray(from, at),
      };
    });
  }
  private readInputs(): Input[] {
    const drawn = this.header.drawn;
    const all = this.bundle.array("input");
    const scaled = (values: number[], by: number): number[] =>
      values.map((v) => (v === null ? null : v * by) as number);
    return this.header.inputs.map((input, k) => {
      const [unit, factor] = pageUnit(input.unit);
      const values = Float32Array.from(all.subarray(k * drawn, (k + 1) * drawn), (v: number) => v * factor);
      const density = input.density && {
        x: scaled(input.density.x, factor),
        y: scaled(input.density.y, 1 / factor),
      };
      return { ...input, unit, values, density };
    });
  }
  // A note that only some of very many samples are shown; "" where all are.
  get thinned(): string {
    return this.header.thinned ? say("thinned", this.header.thinned) : "";
  }
  // The statistics of an input, in the page's units.
  statisticsOf(name: string): { cov: Maybe; mean: Maybe; min: Maybe; max: Maybe } {
    const of: Partial<InputSummary> = this.statistics.inputs.find((i) => i.name === name) ?? {};
    const factor = pageUnit(of.unit ?? "")[1];
    const scaled = (v: number | null | undefined): number | null => (v == null ? null : v * factor);
    return { cov: of.cov ?? null, mean: scaled(of.mean), min: scaled(of.min), max: scaled(of.max) };
  }

  // The lower bounds of a quantity among the samples of these modes.
  bounds(quantity: Quantity, modes: string[] = this.modes): Bounds {
    const at = this.quantities.indexOf(quantity);
    const of = this.answered.filter((s) => modes.includes(s.mode));
    const censored = of.filter((s) => s.censored[at]).map((s) => s.response[at] ?? Infinity);
    return new Bounds(of.length, censored);
  }
  css(mode: string): string {
    return modeClass(this.statistics.modes, mode);
  }
  shown(mode: string): boolean {
    return !this.hidden.has(mode);
  }
  toggle(mode: string): void {
    if (!this.hidden.delete(mode)) this.hidden.add(mode);
    for (const tell of this.modeListeners) tell();
  }
  select(sample: Sample, byReader = true): void {
    this.selected = sample;
    this.picked ||= byReader;
    for (const tell of this.sampleListeners) tell();
  }
  onModes(tell: () => void): void {
    this.modeListeners.push(tell);
  }
  onSample(tell: () => void): void {
    this.sampleListeners.push(tell);
  }
  // Percent of drift for each millimetre; 0 where the load's height is not known.
  get driftPerMillimetre(): number {
    return this.loadHeight > 0 ? 0.1 / this.loadHeight : 0;
  }
}

export const inputLabel = (input: { name: string; unit: string }): string =>
  input.unit ? `${input.name} [${input.unit}]` : input.name;
export const quantityLabel = (q: Quantity): string => `${say(`quantity.${q.name}`)} [${q.unit}]`;
// "all" first, then the groups.
export const allFirst = (groups: string[]): string[] => [
  ...groups.filter((g) => g === "all"),
  ...groups.filter((g) => g !== "all"),
];
export const modeLabel = (mode: string): string => (mode === "all" ? say("all") : phrase(mode));

// Rows of a curve up to its first fall to 0.8 of the peak after it (Fig. 20b).
export function rowsToEighty(s: Sample): number {
  let peak = 0;
  s.reaction.forEach((r: number, i: number) => {
    if (r > s.reaction[peak]) peak = i;
  });
  for (let i = peak; i < s.reaction.length; ++i) if (s.reaction[i] < 0.8 * s.reaction[peak]) return i + 1;
  return s.reaction.length;
}

// Reaction at a displacement, linear between rows; NaN beyond the last row.
export function reactionAt(s: Sample, displacement: number, rows = s.displacement.length): number {
  const d = s.displacement;
  if (rows < 2 || displacement > d[rows - 1]) return NaN;
  let low = 0,
    high = rows - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (d[middle] <= displacement) low = middle;
    else high = middle;
  }
  const share = d[high] > d[low] ? (displacement - d[low]) / (d[high] - d[low]) : 0;
  return s.reaction[low] + share * (s.reaction[high] - s.reaction[low]);
}
