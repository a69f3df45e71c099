// The answer that stays on while one draws: the limit load of the text as it is, and its mechanism. A question that an edit
// overtakes is dropped, one that takes too long is ended; nothing that is shown belongs to an older text.
import { h, svg } from "../../base/dom";
import { qty, say } from "../../base/texts";
import { answerOf, faultsOf, type Answer, type Engine, type Progress } from "./engine";
import { readPicture } from "../board/picture";
import type { Fault } from "../project";
import { isKnown, said, whyOf } from "../file/said";

export const kPatience = 3000; // for a limit load, from when the worker is ready [ms]

interface LimitLoad {
  name: string;
  static_kN?: number;
  static?: number; // of a body force: a load factor
}

export class LiveLimit {
  readonly root: HTMLElement;
  private readonly words = h("div", { class: "limit-words", role: "status", "aria-live": "polite", "aria-atomic": "false" }); // what is added is told, not all again
  private readonly share = h("span"); // of the weight, which may be known later
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
      if (load) this.tell(load);
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
    this.compare();
  }

  private async answered(answer: Answer, isNewest: () => boolean): Promise<void> {
    const opinion = opinionOf(answer.texts);
    const load = answer.code === 0 && loadOf(opinion);
    if (load && !this.load) this.tell(load);
    if (this.load) return this.showPicture(answer, isNewest);
    if (answer.browser) return this.show(h("p", { class: "soft" }, `${say("studio.limit.none")}: ${whyOf(answer)}`));
    const [place, why] = reasonOf(faultsOf(answer)[0], opinion.refused?.[0]?.why ?? answer.texts.error ?? "");
    this.show(h("p", { class: "soft" }, why === "" ? say("studio.limit.none") : [`${say("studio.limit.none")}: `, place !== "" && [h("code", {}, place), " "], said(why)]));
  }
  // The number stays where its picture fails.
  private async showPicture(answer: Answer, isNewest: () => boolean): Promise<void> {
    const text = answer.texts["dry svg"];
    const picture = text ? await readPicture(text, 1, isNewest).catch(() => null) : null;
    if (!isNewest()) return;
    if (picture) {
      this.picture.setAttribute("viewBox", `0 0 ${picture.width} ${picture.height}`);
      this.picture.replaceChildren(picture.shapes);
    } else if (text || answer.code !== 0) {
      const why = whyOf(answer, faultsOf(answer)[0]);
      this.words.append(h("p", { class: "soft" }, `${say("studio.limit.nopicture")}${why && `: ${why}`}`));
    }
  }
  private tell(load: LimitLoad): void {
    this.load = load;
    const number = load.static_kN === undefined ? `λ = ${qty(load.static, "")}` : qty(load.static_kN, "kN");
    this.compare();
    this.words.replaceChildren(h("p", {}, h("b", {}, number), this.share), h("p", { class: "soft" }, say("studio.limit.dry")));
  }
  private compare(): void {
    const force = this.load?.static_kN;
    this.share.textContent = force !== undefined && this.weight ? ` = ${say("studio.limit.share", { share: qty((100 * force) / this.weight, "%", 2) })}` : "";
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
const opinionOf = (texts: Record<string, string>): Opinion => answerOf(texts.mechanisms, {});
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
