// Parts of every page: sections with a list of links to them, the bar at the top, printing.
import { finishLater, h, hintMore, type Child } from "./base/dom";
import { prepareFiguresForPrint, restoreFigures } from "./base/figure";
import { say } from "./base/texts";

export interface Section {
  id: string;
  title: string;
  content: Child;
  paper?: boolean; // only for print
  first?: boolean; // a first printed page instead of the headline; the rest is its appendix
}

function themeButton(): HTMLElement {
  const root = document.documentElement;
  const order = ["auto", "light", "dark"];
  let at = 0;
  const button = h("button", { type: "button", class: "bar-button" });
  const prefersDark = window.matchMedia("(prefers-color-scheme: dark)");
  const show = (): void => {
    root.dataset.theme = order[at] === "auto" ? (prefersDark.matches ? "dark" : "light") : order[at];
    button.textContent = `${say("theme")}: ${say(`theme.${order[at]}`)}`;
  };
  button.addEventListener("click", () => {
    at = (at + 1) % order.length;
    show();
    window.dispatchEvent(new Event("themechange"));
  });
  prefersDark.addEventListener("change", show);
  show();
  return button;
}

const before: (() => void)[] = [],
  after: (() => void)[] = [];
export function aroundPrint(prepare: () => void, restore: () => void): void {
  before.push(prepare);
  after.push(restore);
}

function watchPrinting(): void {
  let open: HTMLDetailsElement[] = [];
  window.addEventListener("beforeprint", () => {
    finishLater();
    open = [...document.querySelectorAll<HTMLDetailsElement>("details.print-open:not([open])")];
    for (const d of open) d.open = true;
    prepareFiguresForPrint();
    for (const work of before) work();
  });
  window.addEventListener("afterprint", () => {
    for (const d of open) d.open = false;
    restoreFigures();
    for (const work of after) work();
  });
}

// Puts the sections below the static headline.
export function build(sections: Section[]): void {
  const main = document.getElementById("page")!;
  main.querySelector("noscript")?.remove();
  const shown = sections.filter((s) => s.content);
  const links = h(
    "ul",
    {},
    shown.filter((s) => !s.paper).map((s) => h("li", {}, h("a", { href: `#${s.id}` }, s.title))),
  );
  const frame = h("div", { class: "bar-links" }, links);
  hintMore(links, frame);
  const nav = h(
    "nav",
    { class: "bar", "aria-label": say("contents") },
    h(
      "div",
      { class: "bar-inner" },
      frame,
      h(
        "div",
        { class: "bar-tools" },
        themeButton(),
        h("button", { type: "button", class: "bar-button", onclick: () => window.print() }, say("print")),
      ),
    ),
  );
  document.body.insertBefore(nav, main);
  for (const s of shown) {
    const section = h(
      "section",
      { id: s.id, class: s.paper ? "print-only" : undefined, "aria-labelledby": `${s.id}-title` },
      h("h2", { id: `${s.id}-title` }, s.title),
      s.content,
    );
    if (!s.first) main.appendChild(section);
    else document.getElementById("headline")!.after(section, h("p", { class: "print-only appendix" }, say("appendix")));
  }
  main.appendChild(h("footer", {}, say("footer")));
  watchPrinting();
  markHere(nav);
}

// Marks the link of the section in view.
function markHere(nav: HTMLElement): void {
  if (typeof IntersectionObserver === "undefined") return;
  const links = new Map([...nav.querySelectorAll("a")].map((a) => [a.getAttribute("href")!.slice(1), a]));
  const watch = new IntersectionObserver(
    (entries) => {
      for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        links.forEach((a, id) => a.toggleAttribute("aria-current", id === entry.target.id));
        const here = links.get(entry.target.id),
          list = nav.querySelector("ul")!;
        if (here) list.scrollLeft = here.offsetLeft - (list.clientWidth - here.offsetWidth) / 2;
      }
    },
    { rootMargin: "-15% 0px -75% 0px" },
  );
  for (const section of document.querySelectorAll("main > section[id]")) watch.observe(section);
}

export function fail(message: string): void {
  const main = document.getElementById("page")!;
  main.appendChild(h("p", { class: "warning", role: "alert" }, `${say("damaged")} ${message}`));
  document.documentElement.dataset.ready = "failed";
}
