// The time of a moving wall: a slider over its states, and play. If animation is allowed
// and `between` can draw it, play moves evenly from state to state; else it steps.
import { h } from "./dom";
import { say } from "./texts";

const kState = 120; // duration of a state in play [ms]

export class Player {
  readonly element: HTMLElement;
  first = 0; // of the selectable states
  last = 0;
  private readonly slider = h("input", { type: "range", min: 0, step: 1, "aria-label": say("wall.time") });
  private readonly button = h("button", { type: "button", class: "play", "aria-label": say("wall.play") }, "▶");
  private stopNow: (() => void) | null = null; // while it plays

  constructor(
    private readonly show: (frame: number) => void,
    private readonly between?: (at: number) => void,
  ) {
    this.slider.addEventListener("input", () => {
      this.stop();
      this.show(Number(this.slider.value));
    });
    this.button.addEventListener("click", () => (this.stopNow ? this.stop() : this.start()));
    this.element = h("div", { class: "time" }, this.button, this.slider);
  }
  choose(first: number, last: number): void {
    this.stop();
    this.first = first;
    this.last = last;
    this.slider.min = String(first);
    this.slider.max = String(last);
    this.slider.value = String(last);
    this.element.hidden = last <= first;
  }
  // Selects the nearest of the selectable states.
  put(frame: number): number {
    const chosen = Math.min(Math.max(this.first, frame), this.last);
    this.slider.value = String(chosen);
    return chosen;
  }
  tell(words: string): void {
    this.slider.setAttribute("aria-valuetext", words);
  }
  stop(): void {
    this.stopNow?.();
    this.stopNow = null;
    this.button.textContent = "▶";
    this.button.setAttribute("aria-label", say("wall.play"));
  }

  private get now(): number {
    return Number(this.slider.value);
  }
  private start(): void {
    if (this.now >= this.last) this.show(this.first);
    this.button.textContent = "❚❚";
    this.button.setAttribute("aria-label", say("wall.pause"));
    const still = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.stopNow = this.between && !still ? this.run(this.between) : this.step();
  }
  private step(): () => void {
    const timer = window.setInterval(() => {
      if (this.now >= this.last) this.stop();
      else this.show(this.now + 1);
    }, kState);
    return () => window.clearInterval(timer);
  }
  private run(between: (at: number) => void): () => void {
    const from = this.now;
    let begun = -1,
      request = 0;
    const move = (time: number): void => {
      if (begun < 0) begun = time;
      const at = from + (time - begun) / kState;
      if (at >= this.last) {
        this.stop();
        return this.show(this.last);
      }
      between(at);
      request = requestAnimationFrame(move);
    };
    request = requestAnimationFrame(move);
    return () => cancelAnimationFrame(request);
  }
}
