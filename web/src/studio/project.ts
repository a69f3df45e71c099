// The wall under work: its text, what the drawing reads from it, what is selected, and every earlier text.
// One gesture is one step back. All else listens.
import { isRefusal, readDrawing, type Drawing, type Refusal } from "./drawing";
import { parse, TomlFault, type Doc } from "./toml";

export interface Fault {
  line: number;
  path: string;
  value: string;
  problem: string;
  cure: string;
}

interface Step {
  text: string;
  selected: number;
}
const kSteps = 200;

export class Project {
  text = "";
  doc: Doc | null = null; // of the newest text that is TOML
  drawing: Drawing | null = null; // of that text too; it stays when a later text cannot be read
  refusal: Refusal | null = null; // why the drawing cannot show the text as it is
  broken: TomlFault | null = null; // the text is no TOML
  selected = -1; // an opening
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

  // Whether gestures may change the text.
  get drawable(): boolean {
    return this.drawing !== null && this.refusal === null && this.broken === null;
  }

  open(text: string): void {
    this.steps = [];
    this.undone = [];
    this.joined = "";
    this.drawing = null;
    this.read(text, -1);
  }
  // Another wall altogether, as one step: nothing of the drawing before stays.
  replace(text: string): void {
    this.joined = "";
    if (text !== this.text) this.drawing = null;
    this.change(text, -1);
  }
  // A new text as one step; steps that are parts of one (`join`) become one.
  change(text: string, selected = this.selected, join = ""): void {
    if (text === this.text) return this.select(selected);
    if (join === "" || join !== this.joined) {
      this.steps.push({ text: this.text, selected: this.selected });
      if (this.steps.length > kSteps) this.steps.shift();
    }
    this.undone = [];
    this.joined = join;
    this.read(text, selected);
  }
  select(index: number): void {
    if (index === this.selected || index >= (this.drawing?.openings.length ?? 0)) return;
    this.selected = index;
    this.tell("selection");
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
    to.push({ text: this.text, selected: this.selected });
    this.joined = "";
    this.read(step.text, step.selected);
  }
  endStep(): void {
    this.joined = "";
  }

  private read(text: string, selected: number): void {
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
    this.selected = selected < (this.drawing?.openings.length ?? 0) ? selected : -1;
    this.tell("text");
  }
}
