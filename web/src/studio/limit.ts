// The answer that stays on while one draws: the limit load of the text as it is, and its mechanism. A question that an edit
// overtakes is dropped, one that takes too long is ended; nothing that is shown belongs to an older text.
import { h, svg } from "../dom";
import { qty, say } from "../texts";
import type { Answer, Engine, Progress } from "./engine";
import { readPicture } from "./picture";
import type { Fault } from "./project";
import { faultsOf } from "./push";
import { isKnown, said, whyOf } from "./said";

export const kPatience = 3000; // for a limit load, from when the worker is ready [ms]

interface LimitLoad {
  name: string;
  static_kN?: number;
  static?: number; // of a body force: a load factor
}

export class LiveLimit {
  readonly root: HTMLElement;
  private readonly words = h("div", { class: "limit-words", role: "status", "aria-live": "polite" });
  private readonly picture = svg("svg", { class: "limit-picture", role: "img", "aria-label": say("studio.limit.picture") });
  private load: LimitLoad | null = null; // of the text as it is
  private weight: number | null = null; // [kN]
  private asked = 0; // the newest question
  private timer = 0;

  constructor(private readonly engine: Engine) {
    this.root = h("section", { class: "limit", "aria-label": say("studio.limit") }, h("h2", {}, say("studio.limit")), this.words, this.picture);
    this.forget();
  }

  // The text has changed: what was asked and what is shown is of the one before.
  forget(): void {
    ++this.asked;
    window.clearTimeout(this.timer);
    this.engine.stop();
    this.load = this.weight = null;
    this.show(h("p", { class: "soft" }, "…"));
    delete document.documentElement.dataset.limiting;
  }
  ask(text: string): void {
    this.forget();
    const asked = this.asked;
    document.documentElement.dataset.limiting = "yes"; // until there is an answer, or none
    const late = (): void => {
      this.forget();
      this.show(h("p", { class: "soft" }, say("studio.limit.late", { seconds: kPatience / 1000 })));
    };
    const begun = (): void => void (this.timer = window.setTimeout(late, kPatience));
    // the number, then its picture
    const told = ({ texts }: Progress): void => {
      if (asked !== this.asked || !texts) return;
      window.clearTimeout(this.timer);
      const load = loadOf(opinionOf(texts));
      if (load) this.tell((this.load = load));
    };
    void this.engine.ask({ task: "limit", texts: { model: text, only: ["lp"] }, numbers: { quick: 1 }, want: ["mechanisms", "dry svg"], first: ["mechanisms"] }, told, begun).then(async (answer) => {
      if (asked !== this.asked) return;
      window.clearTimeout(this.timer);
      await this.answered(answer, () => asked === this.asked);
      if (asked === this.asked) delete document.documentElement.dataset.limiting;
    });
  }
  // What `check` says of the same text.
  weighs(weight: number): void {
    this.weight = weight;
    if (this.load) this.tell(this.load);
  }

  private async answered(answer: Answer, isNewest: () => boolean): Promise<void> {
    const opinion = opinionOf(answer.texts);
    const load = loadOf(opinion);
    if (answer.browser) return this.show(h("p", { class: "soft" }, `${say("studio.limit.none")}: ${whyOf(answer)}`));
    if (answer.code !== 0 || !load) {
      const [place, why] = reasonOf(faultsOf(answer)[0], opinion.refused?.[0]?.why ?? answer.texts.error ?? "");
      return this.show(h("p", { class: "soft" }, why === "" ? say("studio.limit.none") : [`${say("studio.limit.none")}: `, place !== "" && [h("code", {}, place), " "], said(why)]));
    }
    this.tell((this.load = load));
    const picture = await readPicture(answer.texts["dry svg"] ?? "", 1, isNewest);
    if (!picture || !isNewest()) return;
    this.picture.setAttribute("viewBox", `0 0 ${picture.width} ${picture.height}`);
    this.picture.replaceChildren(picture.shapes);
  }
  private tell(load: LimitLoad): void {
    const force = load.static_kN;
    this.words.replaceChildren(
      force === undefined
        ? h("p", {}, h("b", {}, `λ = ${qty(load.static, "")}`))
        : h("p", {}, h("b", {}, qty(force, "kN")), this.weight ? ` = ${say("studio.limit.share", { share: qty((100 * force) / this.weight, "%", 2) })}` : ""),
      h("p", { class: "soft" }, say("studio.limit.dry")),
    );
  }
  private show(...words: Node[]): void {
    this.words.replaceChildren(...words);
    this.picture.replaceChildren();
  }
}

interface Opinion {
  limit_loads?: LimitLoad[];
  refused?: { why: string }[];
}
const opinionOf = (texts: Record<string, string>): Opinion => JSON.parse(texts.mechanisms || "{}");
const loadOf = (opinion: Opinion): LimitLoad | undefined => opinion.limit_loads?.find((l) => l.name === "dry");

// What has no limit load, as the file says it, and why. The engine may put both into one sentence: "path = value: problem; cure".
// Names may have colons, so the place ends at the last one after which a known problem stands.
export function reasonOf(fault: Fault | undefined, reason: string): [string, string] {
  const words = fault?.problem ?? reason;
  for (let at = words.lastIndexOf(": "); at >= 0; at = at === 0 ? -1 : words.lastIndexOf(": ", at - 1)) {
    const problem = words.slice(at + 2).split("; ")[0];
    if (isKnown(problem)) return [words.slice(0, at), problem];
  }
  return [fault?.value ? `${fault.path} = ${fault.value}` : (fault?.path ?? ""), words];
}
