// Creates elements without parsing markup: every string becomes text, so names from files cannot inject markup.

export type Child = Node | string | number | null | undefined | false | Child[];
export type Attributes = Record<string, unknown>;

const kSvg = "http://www.w3.org/2000/svg";

function fill(element: Element, attributes: Attributes, children: Child[]): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name.startsWith("on")) {
      element.addEventListener(name.slice(2), value as EventListener);
    } else {
      element.setAttribute(name, value === true ? "" : String(value));
    }
  }
  append(element, children);
}

export function append(element: Element, children: Child[]): void {
  for (const child of children) {
    if (Array.isArray(child)) append(element, child);
    else if (child instanceof Node) element.appendChild(child);
    else if (child !== null && child !== undefined && child !== false)
      element.appendChild(document.createTextNode(String(child)));
  }
}

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, attributes, children);
  return element;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const element = document.createElementNS(kSvg, tag) as SVGElementTagNameMap[K];
  fill(element, attributes, children);
  return element;
}

// Words only for the screen, because paper has nothing to click.
export const onScreen = (...children: Child[]): HTMLElement => h("span", { class: "no-print" }, ...children);

let count = 0;
export const fresh = (prefix: string): string => `${prefix}-${++count}`;

// Marks the sides where a scrolling element has more content (data-more of `frame`).
// Makes it reachable by the keyboard if it scrolls and contains nothing that is.
export function hintMore(slide: HTMLElement, frame: HTMLElement): void {
  const reachable = slide.querySelector("a, button") !== null;
  const mark = (): void => {
    const left = slide.scrollLeft > 2,
      right = slide.scrollLeft + slide.clientWidth < slide.scrollWidth - 2;
    frame.dataset.more = `${left ? "left" : ""} ${right ? "right" : ""}`.trim();
    if ((left || right) && !reachable) slide.setAttribute("tabindex", "0");
    else slide.removeAttribute("tabindex");
  };
  slide.addEventListener("scroll", mark, { passive: true });
  const watch = new ResizeObserver(mark);
  watch.observe(slide);
  if (slide.firstElementChild) watch.observe(slide.firstElementChild);
}

// Work that can wait until the page has been painted, one
// piece after the other; data-ready says that all is done.
const queue: (() => void)[] = [];
export function later(work: () => void): void {
  delete document.documentElement.dataset.ready;
  queue.push(work);
  if (queue.length === 1) setTimeout(next, 0);
}
function next(): void {
  const begun = performance.now();
  while (queue.length > 0 && performance.now() - begun < 30) {
    try {
      queue[0]();
    } finally {
      queue.shift();
    }
  }
  if (queue.length > 0) setTimeout(next, 0);
  else if (resting.size === 0) document.documentElement.dataset.ready = "yes";
}
// Work to be done at rest: when it has not been requested again for a while.
const kRest = 160; // longer than a step of an animation [ms]
const resting = new Map<object, { work: () => void; timer: number }>();
export function atRest(who: object, work: () => void): void {
  window.clearTimeout(resting.get(who)?.timer);
  delete document.documentElement.dataset.ready;
  resting.set(who, { work, timer: window.setTimeout(() => rest(who), kRest) });
}
function rest(who: object): void {
  const { work, timer } = resting.get(who)!;
  window.clearTimeout(timer);
  resting.delete(who);
  later(work);
}
// Runs all of it now, before printing.
export function finishLater(): void {
  for (const who of [...resting.keys()]) rest(who);
  while (queue.length > 0) queue.shift()!();
}
