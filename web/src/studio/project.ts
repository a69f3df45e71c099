// The wall under work: its text, what the drawing reads from it, what is selected, and every earlier text.
// One gesture is one step back. All else listens.
import { countOf, type Drawing, type Refusal, type Selected } from "./drawing";
import { isRefusal, readDrawing } from "./reading";
import type { PhotoPlace } from "./board/photo_store";
import { parse, TomlFault, type Doc } from "./file/toml";

export interface Fault {
  line: number;
  path: string;
  value: string;
  problem: string;
  cure: string;
}

interface Step {
  text: string;
  selection: Selected | null;
  photo: PhotoPlace | null;
}
export interface Steps {
  steps: Step[];
  undone: Step[];
}
const kSteps = 200;

export class Project {
  text = "";
  doc: Doc | null = null; // of the newest text that is TOML
  drawing: Drawing | null = null; // of that text too; it stays when a later text cannot be read
  refusal: Refusal | null = null; // why the drawing cannot show the text as it is
  broken: TomlFault | null = null; // the text is no TOML
  selection: Selected | null = null;
  photo: PhotoPlace | null = null; // where the photo under the drawing lies; beside the text, but undone with it
  private steps: Step[] = [];
  private undone: Step[] = [];
  private joined = ""; // what the last step was part of: typing in one field is one step
  private readonly listeners: ((why: "text" | "selection") => void)[] = [];

  listen(hear: (why: "text" | "selection") => void): void {
    this.listeners.push(hear);
  }
  private tell(why: "text" | "selection"): void {
    for (const hear of this.listeners) hear(why);
  }

  // The opening that is selected, or -1.
  get selected(): number {
    return this.selection?.kind === "opening" ? this.selection.k : -1;
  }
  // Whether gestures may change the text.
  get drawable(): boolean {
    return this.drawing !== null && this.refusal === null && this.broken === null;
  }

  open(text: string): void {
    this.steps = [];
    this.undone = [];
    this.joined = "";
    this.drawing = null;
    this.read(text, null);
  }
  // Another wall altogether, as one step: nothing of the drawing before stays.
  replace(text: string): void {
    this.joined = "";
    if (text !== this.text) this.drawing = null;
    this.change(text, null);
  }
  // A new text as one step; steps that are parts of one (`join`) become one.
  change(text: string, selected: Selected | number | null = this.selection, join = ""): void {
    const selection = typeof selected === "number" ? anOpening(selected) : selected;
    if (text === this.text) return this.choose(selection);
    if (join === "" || join !== this.joined) this.step();
    this.undone = [];
    this.joined = join;
    this.read(text, selection);
  }
  private step(): void {
    this.steps.push({ text: this.text, selection: this.selection, photo: this.photo });
    if (this.steps.length > kSteps) this.steps.shift();
  }
  // The photo elsewhere, as one step; steps that are parts of one (`join`) become one.
  placePhoto(place: PhotoPlace, join = ""): void {
    if (join === "" || join !== this.joined) this.step();
    this.undone = [];
    this.joined = join;
    this.photo = place;
    this.tell("selection");
  }
  // Another photo, or none: no step before knows where it lies, and those that only moved the other are gone.
  newPhoto(place: PhotoPlace | null): void {
    const edits = (steps: Step[]): Step[] => steps.filter((s, k) => s.text !== (steps[k + 1] ?? this).text);
    [this.steps, this.undone] = [edits(this.steps), edits(this.undone)];
    for (const step of [...this.steps, ...this.undone]) step.photo = null;
    this.joined = "";
    this.photo = place;
    this.tell("selection");
  }
  // The photo that the browser kept: no step goes.
  restorePhoto(place: PhotoPlace): void {
    this.photo = place;
    this.tell("selection");
  }
  select(index: number): void {
    this.choose(anOpening(index));
  }
  choose(selection: Selected | null): void {
    if (same(selection, this.selection) || !this.holds(selection)) return;
    this.endStep();
    this.selection = selection;
    this.tell("selection");
  }
  // Whether there is such a part still.
  holds(selection: Selected | null): boolean {
    return selection === null || (this.drawing !== null && selection.k < countOf(this.drawing, selection.kind));
  }
  get canUndo(): boolean {
    return this.steps.length > 0;
  }
  get canRedo(): boolean {
    return this.undone.length > 0;
  }
  undo(): void {
    this.swap(this.steps, this.undone);
  }
  redo(): void {
    this.swap(this.undone, this.steps);
  }
  private swap(from: Step[], to: Step[]): void {
    const step = from.pop();
    if (!step) return;
    to.push({ text: this.text, selection: this.selection, photo: this.photo });
    this.joined = "";
    this.photo = step.photo ?? this.photo;
    if (step.text !== this.text) return this.read(step.text, step.selection);
    this.selection = step.selection;
    this.tell("selection");
  }
  endStep(): void {
    this.joined = "";
  }
  // All steps, for a page that goes on with this text.
  get allSteps(): Steps {
    return { steps: this.steps, undone: this.undone };
  }
  goOn({ steps, undone }: Steps): void {
    [this.steps, this.undone] = [steps, undone];
    this.tell("selection");
  }

  private read(text: string, selection: Selected | null): void {
    this.text = text;
    this.broken = this.refusal = null;
    try {
      this.doc = parse(text);
      const drawing = readDrawing(this.doc);
      if (isRefusal(drawing)) this.refusal = drawing;
      else this.drawing = drawing;
    } catch (error) {
      if (!(error instanceof TomlFault)) throw error;
      this.broken = error;
    }
    this.selection = this.holds(selection) ? selection : null;
    this.tell("text");
  }
}

const anOpening = (k: number): Selected | null => (k < 0 ? null : { kind: "opening", k });
const same = (a: Selected | null, b: Selected | null): boolean => a?.kind === b?.kind && a?.k === b?.k;
