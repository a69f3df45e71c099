// The engine behind the page: tasks of the C interface (docs/reference/c_interface.md), answered by a worker that
// the page makes from its own text. One worker answers one question at a time; to stop it is to end it.
import { unpacked } from "../file/packed";
import type { Fault } from "../project";

export interface Question {
  task: "run" | "check" | "limit" | "keys";
  texts: Record<string, string | string[]>;
  numbers?: Record<string, number>;
  want?: string[]; // names of the texts that are wanted
  first?: string[]; // and of those that come before the others are made
  bytes?: string[]; // of those that come as bytes: long ones, which textIn() reads when they are needed
  tables?: string[]; // and of the tables
  pieces?: boolean; // a run that shows the wall on its way, and that can pause
}
export interface Progress {
  what: string;
  share: number;
  displacement_mm: number;
  reaction_kN: number;
  svg?: string; // of a run in pieces now and then: the wall as it stands
  held?: boolean; // such a run has come to the pause that was asked for
  texts?: Record<string, string>; // that were asked for first
}
export interface Answer {
  code: number; // 0 done, 2 an input is not admissible, 3 stopped, others: texts.error
  texts: Record<string, string>;
  bytes?: Record<string, Uint8Array>;
  tables: Record<string, Record<string, Float64Array>>;
  address?: string; // of the page, where it has been opened
  browser?: Failure; // the browser ended the engine: texts.error has the browser's own words
}
export type Failure = "memory" | "start" | "stop";
// The value of a text that is JSON; `none` where the engine gave no such text.
export const answerOf = <T>(text: string | undefined, none?: T): T => (text || none === undefined ? JSON.parse(text ?? "") : none);
export function textIn(answer: Answer, name: string): string {
  const bytes = answer.bytes?.[name];
  return bytes ? new TextDecoder().decode(bytes) : (answer.texts[name] ?? "");
}
// A piece of a long text from the first place where `mark` stands (ASCII); "" where it stands nowhere.
export function pieceOf(answer: Answer, name: string, mark: string, length: number): string {
  const bytes = answer.bytes?.[name];
  if (!bytes) {
    const text = answer.texts[name] ?? "";
    const at = text.indexOf(mark);
    return at < 0 ? "" : text.slice(at, at + length);
  }
  const codes = [...mark].map((c) => c.charCodeAt(0));
  for (let at = bytes.indexOf(codes[0]); at >= 0; at = bytes.indexOf(codes[0], at + 1))
    if (codes.every((code, k) => bytes[at + k] === code)) return new TextDecoder().decode(bytes.subarray(at, at + length));
  return "";
}
export interface Engine {
  ask(question: Question, progress?: (p: Progress) => void, begun?: () => void): Promise<Answer>; // `begun`: the worker is ready and has it
  stop(): void; // the question under way is answered with code 3
  pause(on: boolean): void; // of a run in pieces
  rest(): void; // nothing is asked for a while
}
export const kStopped = 3;
const kNoMemory = 5; // a worker gives none back
const kDefect = 6; // of the engine itself

interface Message extends Partial<Answer> {
  ready?: boolean;
  id?: number;
  progress?: Progress;
  thrown?: boolean; // texts.error is the browser's
}
// Each browser says in words of its own that it has no memory.
const failure = (words: string, otherwise: Failure): Failure => (/out of memory|alloc/i.test(words) ? "memory" : otherwise);

export class WorkerEngine implements Engine {
  private worker: Promise<Worker> | null = null;
  private isAsked = false; // the worker has a question; before that it starts, and serves the next one as well
  private count = 0;
  private waiting: { id: number; done: (a: Answer) => void; progress?: (p: Progress) => void } | null = null;

  // Begins with a worker, which the first question finds.
  warm(): void {
    this.start().catch(() => undefined); // the question is told
  }
  private start(): Promise<Worker> {
    if (this.worker) return this.worker;
    const isOurs = (): boolean => this.worker === worker; // not given up meanwhile
    const worker = started((m) => this.hear(m), (why) => isOurs() && this.end(kDefect, why, "stop"));
    worker.catch(() => isOurs() && (this.worker = null)); // the next question has another
    return (this.worker = worker);
  }
  async ask(question: Question, progress?: (p: Progress) => void, begun?: () => void): Promise<Answer> {
    this.stop();
    const id = ++this.count;
    const answer = new Promise<Answer>((done) => (this.waiting = { id, done, progress }));
    try {
      const worker = await this.start();
      if (this.waiting?.id === id) {
        this.isAsked = true;
        worker.postMessage({ id, ...question });
        begun?.();
      }
    } catch (error) {
      if (this.waiting?.id === id) this.end(kDefect, error instanceof Error ? error.message : String(error), "start");
    }
    return answer;
  }
  stop(): void {
    if (this.waiting) this.end(kStopped, "");
  }
  pause(on: boolean): void {
    if (this.waiting) void this.worker?.then((w) => w.postMessage({ pause: on }), () => undefined);
  }
  // Ends an idle worker: its memory grew with the largest wall that it has had. The next one is there at once.
  rest(): void {
    if (this.waiting) return;
    this.worker?.then((w) => w.terminate(), () => undefined);
    this.worker = null;
  }
  // Ends the question under way with the worker that was at it.
  private end(code: number, error: string, otherwise?: Failure): void {
    if (this.isAsked || code !== kStopped) {
      this.worker?.then((w) => w.terminate(), () => undefined);
      this.worker = null;
    }
    this.isAsked = false;
    const waiting = this.waiting;
    this.waiting = null;
    waiting?.done({ code, texts: { error }, tables: {}, browser: otherwise && failure(error, otherwise) });
  }
  private hear(m: Message): void {
    const waiting = this.waiting;
    if (!waiting || m.id !== waiting.id) return;
    if (m.progress) return waiting.progress?.(m.progress);
    this.waiting = null;
    this.isAsked = false;
    if ((m.code ?? kDefect) >= kNoMemory) this.rest(); // it is spent: the next question has a worker of its own
    const browser = m.thrown ? failure(m.texts?.error ?? "", "stop") : undefined;
    waiting.done({ code: m.code ?? kDefect, texts: m.texts ?? {}, bytes: m.bytes ?? {}, tables: m.tables ?? {}, browser });
  }
}

const kLeft = 1000; // for a question that is overtaken [ms]

// Asks for the newest of many questions: one that is overtaken while the engine is busy is never asked, and the one under way is
// ended where it takes long, as that of a wall of a million stones.
export class Latest {
  private busy = false;
  private next: (() => void) | null = null;
  private timer = 0;
  constructor(
    private readonly engine: Engine,
    private readonly left = kLeft,
  ) {}
  ask(question: Question, done: (a: Answer) => void, told?: (p: Progress) => void): void {
    const go = async (): Promise<void> => {
      this.busy = true;
      const answer = await this.engine.ask(question, told);
      this.busy = false;
      window.clearTimeout(this.timer);
      this.timer = 0;
      const next = this.next;
      this.next = null;
      if (next) next();
      else done(answer);
    };
    if (!this.busy) return void go();
    this.next = go;
    this.timer ||= window.setTimeout(() => this.engine.stop(), this.left);
  }
}

// --- the worker of the page --------------------------------------------------------------------------

// Two elements of the page hold the engine: its script, and its code packed (packed.ts), which is compiled once for all workers.
let module: Promise<WebAssembly.Module | ArrayBuffer> | null = null;
const textOf = (id: string): string => document.getElementById(id)?.textContent ?? "";
function moduleOfPage(): Promise<WebAssembly.Module | ArrayBuffer> {
  module ??= unpacked(textOf("wythe-wasm")).then((code) => WebAssembly.compile(code).catch(() => code));
  module.catch(() => (module = null)); // the next question may find more memory
  return module;
}
export const hasEngine = (): boolean => {
  const script = textOf("wythe-worker").trim();
  return script !== "" && !script.includes("<!--");
};

// A worker that is ready. One that fails before is ended here; of one that fails later, `failed` hears.
async function started(hear: (m: Message) => void, failed: (why: string) => void): Promise<Worker> {
  if (!hasEngine()) throw new Error("this file holds no engine");
  const compiled = moduleOfPage();
  const url = URL.createObjectURL(new Blob([textOf("wythe-worker")], { type: "text/javascript" }));
  let worker: Worker | undefined;
  try {
    const begun = (worker = new Worker(url)); // it loads its script meanwhile
    await new Promise<void>((done, refuse) => {
      let isReady = false;
      begun.onmessage = ({ data }: MessageEvent<Message>) => {
        if (!data.ready) return hear(data);
        isReady = true;
        done();
      };
      begun.onerror = (e) => {
        e.preventDefault();
        if (isReady) failed(e.message ?? "");
        else refuse(new Error(e.message));
      };
      compiled.then((wasm) => begun.postMessage({ wasm })).catch(refuse);
    });
    return begun;
  } catch (error) {
    worker?.terminate();
    throw error;
  } finally {
    URL.revokeObjectURL(url);
  }
}

export function faultsOf(answer: Answer): Fault[] {
  return answerOf<Partial<Fault>[]>(answer.texts.faults, []).map((f) => ({ line: Number(f.line) || 1, path: String(f.path ?? ""), value: String(f.value ?? ""), problem: String(f.problem ?? ""), cure: String(f.cure ?? "") }));
}
