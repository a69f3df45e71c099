// The studio: draw a wall, see its stones, push it, watch it crack. Puts the parts together.
import "./studio.css";
import { h, svg } from "../base/dom";
import { pushOf, setDirection } from "./stages";
import { qty, say, speak } from "../base/texts";
import { setHead } from "./parts/arches";
import { Canvas } from "./board/canvas";
import { Commands, type Command } from "./commands";
import type { Pushed } from "./push/compare";
import { pathOf } from "./drawing";
import { answerOf, faultsOf, hasEngine, Latest, WorkerEngine, type Progress } from "./push/engine";
import { FaultList, openingOf } from "./file/faults";
import { FilePane } from "./file/file";
import { addFrame, frameOf, removeFrame } from "./parts/frames";
import { LiveLimit } from "./push/limit";
import { Panel } from "./panel";
import { removePart } from "./parts/parts";
import { TooOld } from "./file/packed";
import { Photo } from "./board/photo";
import { readPicture, type Picture } from "./board/picture";
import { Project, type Fault, type Steps } from "./project";
import { Push } from "./push/push";
import { saidOf, whyOf } from "./file/said";
import { kStarters, starter } from "./file/starters";
import * as store from "./file/store";
import { kTools, Tools, type Tool } from "./board/tools";
import { lineOf, valueAt } from "./file/toml";
import type { Varied } from "./push/varied";
import { whole } from "./words";

const kPause = 60; // after one edit of several, before the engine is asked for its stones [ms]
const kAlone = 300; // without another edit before it: such an edit does not wait [ms]
const kLanguages = [["en", "English"], ["it", "Italiano"], ["de", "Deutsch"], ["fr", "Français"], ["es", "Español"], ["pt", "Português"]];

const remembered = (key: string): string | null => {
  try {
    return localStorage.getItem(`wythe.studio.${key}`);
  } catch {
    return null;
  }
};
const remember = (key: string, value: string): void => {
  try {
    localStorage.setItem(`wythe.studio.${key}`, value);
  } catch {
    // the choice holds as long as the page
  }
};

const asked = new URLSearchParams(location.search).get("language"); // by a page that may remember nothing
const language = [remembered("language"), asked, navigator.language.slice(0, 2)].find((code) => kLanguages.some(([known]) => known === code)) ?? "en";
speak(language);
document.documentElement.lang = language;
document.title = say("studio.title");
const kThemes = ["auto", "light", "dark"];
const prefersDark = matchMedia("(prefers-color-scheme: dark)");
let theme = Math.max(0, kThemes.indexOf(remembered("theme") ?? "auto"));
function showTheme(): void {
  document.documentElement.dataset.theme = theme > 0 ? kThemes[theme] : prefersDark.matches ? "dark" : "light";
}
prefersDark.addEventListener("change", showTheme);
showTheme();

const project = new Project();
const canvas = new Canvas();
const stonesEngine = new WorkerEngine();
if (hasEngine()) stonesEngine.warm(); // it is unpacked and compiled while the page is built
const checker = new Latest(stonesEngine);
let faults: Fault[] = [];
let failed = false; // the engine, on the newest text: nobody knows its stones and faults
let stones: Picture | null = null; // of the newest text that the engine took
let fitNext = true;

// --- parts ----------------------------------------------------------------------------------------------

const photo = new Photo(canvas, project, tell);
const tools = new Tools(canvas, project, () => refreshBar(), tell, photo);
const vary = (number: Varied, opener: HTMLElement): void => push.family.open(number, opener);
const file = new FilePane(project, vary);
const panel = new Panel(project, () => canvas.draw(), tell, vary);
const list = new FaultList(project, (fault) => {
  showPane("file");
  file.show(fault.line, true);
  if (openingOf(fault) >= 0) project.select(openingOf(fault));
});
const limit = new LiveLimit(new WorkerEngine());
limit.root.hidden = !hasEngine();
const push = new Push(project, new WorkerEngine(), new WorkerEngine(), (picture) => showCracks(picture), (found) => showFaults(found), () => refreshBar());
const status = h("p", { class: "status", role: "status", "aria-live": "polite" });
const notes = h("details", { class: "notes", hidden: true });
const notice = h("div", { class: "notice", role: "status", hidden: true });
const reason = h("p", { class: "reason", role: "status", hidden: true });

const toolButtons = new Map<Tool, HTMLButtonElement>();
const toolIcons: Record<Tool, string> = {
  select: "M5 2V16L9 12.5L11.5 18L14 17L11.5 11.5H17Z",
  wall: "M2 3H20V17H2ZM2 7.7H20M2 12.3H20M8 3V7.7M14 7.7V12.3M8 12.3V17",
  door: "M2 17H20M6 17V3H16V17M13 10.5V11",
  window: "M3 4H19V16H3ZM11 4V16M3 10H19",
  storey: "M4 17V3M18 17V3M1 10H21M8 7L11 4L14 7",
  floor: "M1 14H21V17H1ZM5 3V11M2.5 8.5L5 11L7.5 8.5M11 3V11M8.5 8.5L11 11L13.5 8.5M17 3V11M14.5 8.5L17 11L19.5 8.5",
  photo: "M2 5H7L9 3H13L15 5H20V17H2ZM11 8A3 3 0 1 0 11 14A3 3 0 1 0 11 8",
  tie: "M3 4V16M19 4V16M3 10H19M1 10H3M19 10H21",
};
for (const tool of kTools)
  toolButtons.set(tool, h("button", { class: "tool-button", type: "button", "aria-pressed": "false", title: say(`studio.do.${tool}`), onclick: () => tools.choose(tool) }, h("span", { "aria-hidden": "true", class: "icon" }, svg("svg", { viewBox: "0 0 22 20" }, svg("path", { d: toolIcons[tool] }))), h("span", { class: "tool-name" }, say(`studio.tool.${tool}`))));

const button = (name: string, does: () => void, css = "button"): HTMLButtonElement => h("button", { class: css, type: "button", title: say(`studio.do.${name}`), onclick: does }, say(`studio.button.${name}`));
const themeName = (): string => `${say("theme")}: ${say(`theme.${kThemes[theme]}`)}`;
const themes = h("button", { class: "button", type: "button", title: say("studio.do.theme"), onclick: nextTheme }, themeName());
const undo = h("button", { class: "button icon-only", type: "button", title: say("studio.do.undo"), "aria-label": say("studio.do.undo"), onclick: () => project.undo() }, "↶");
const redo = h("button", { class: "button icon-only", type: "button", title: say("studio.do.redo"), "aria-label": say("studio.do.redo"), onclick: () => project.redo() }, "↷");
const go = h("button", { class: "button primary", type: "button", onclick: () => togglePush() });
const snapButtons = (["masonry", "objects"] as const).map((key) =>
  h("button", { class: "chip-button", type: "button", "aria-pressed": "true", "data-snap": key, onclick: () => toggleSnap(key) }, say(`studio.snap.${key}`)),
);
const starters = h("select", { class: "starters", "aria-label": say("studio.begin") }, h("option", { value: "" }, say("studio.begin")), ...kStarters.map(([name]) => h("option", { value: name }, say(`studio.starter.${name}`))));
starters.addEventListener("change", () => {
  if (starters.value !== "") begin(starter(starters.value));
  starters.value = "";
});
const languages = h("select", { class: "language", "aria-label": say("studio.language") }, ...kLanguages.map(([code, name]) => h("option", { value: code, selected: code === language }, name)));
languages.addEventListener("change", () => void speakAnother());
const input = h("input", { type: "file", accept: ".toml,text/plain", hidden: true, "aria-label": say("studio.do.open"), tabindex: "-1" });
input.addEventListener("change", () => {
  if (input.files?.[0]) void openFile(input.files[0]);
  input.value = "";
});

// --- engine -----------------------------------------------------------------------------------------------

let timer = 0,
  askedAt = -kAlone;
function ask(): void {
  window.clearTimeout(timer);
  document.documentElement.dataset.checking = "yes"; // until the stones are those of the text
  const now = performance.now();
  timer = window.setTimeout(check, now - askedAt < kAlone ? kPause : 0);
  askedAt = now;
}
function check(): void {
  if (!hasEngine()) {
    status.textContent = say("studio.noengine");
    delete document.documentElement.dataset.checking;
    return localFaults();
  }
  const text = project.text;
  const isNewest = (): boolean => text === project.text;
  const isFirst = stones === null; // it has the processor for itself: the limit load is asked for behind it
  let shown: Promise<void> | null = null;
  const told = ({ texts }: Progress): void => {
    if (texts?.counts && isNewest()) shown = showStones(answerOf(texts.counts), texts.svg ?? "", isNewest).then(() => void (isFirst && isNewest() && askLimit()));
  };
  const askLimit = (): void => {
    limit.ask(text);
    if (weight !== null) limit.weighs(weight);
  };
  weight = null;
  if (!isFirst) askLimit();
  checker.ask(
    { task: "check", texts: { model: text, language }, first: ["counts", "svg"], want: ["check", "model"] },
    async (answer) => {
      await shown;
      if (!isNewest() || (answer.code === 0 && !shown)) return; // stones that came while the text was another are asked for again
      delete document.documentElement.dataset.checking;
      panel.took(answer.code === 0 ? (answer.texts.model ?? "") : "");
      if (answer.code === 0) return sayCounts(answerOf(answer.texts.check));
      showNotes([]);
      if (answer.code === 2) {
        status.textContent = say("studio.notbuilt");
        showFaults(faultsOf(answer));
      } else {
        status.textContent = say("studio.failed", { why: whyOf(answer) });
        showFaults([], true);
      }
      if (shown) push.edited(); // a wall that the engine failed at is not pushed by itself
      else if (isFirst) askLimit();
    },
    told,
  );
}
interface Counts {
  blocks: number;
  weight_kN: number;
  length_m: number;
  notes: string[];
  expected_seconds?: number; // known later: the engine tries some steps
}
let weight: number | null = null; // of the text as it is [kN]
async function showStones(c: Counts, picture: string, isNewest: () => boolean): Promise<void> {
  const drawn = await readPicture(picture, c.length_m, isNewest);
  if (!isNewest()) return;
  stones = drawn;
  weight = c.weight_kN;
  if (!canvas.readOnly) canvas.setPicture(stones);
  sayCounts(c);
  showNotes(c.notes);
  limit.weighs(c.weight_kN);
  showFaults([]);
  push.ready(c.length_m);
}
function sayCounts({ blocks, weight_kN, expected_seconds: time }: Counts): void {
  const counts = { blocks: whole(blocks), weight: qty(weight_kN, "kN") };
  status.textContent = time === undefined ? say("studio.counted", counts) : say("studio.counts", { ...counts, seconds: time < 120 ? qty(time, "s", 2) : qty(time / 60, "min", 2) });
}
function showNotes(list: string[]): void {
  notes.hidden = list.length === 0;
  notes.replaceChildren(h("summary", {}, say(list.length === 1 ? "studio.note" : "studio.notes", { count: list.length })), h("ul", {}, ...list.map((n) => h("li", {}, n))));
}
function localFaults(): void {
  showFaults(project.broken ? [{ line: project.broken.line, path: "", value: "", problem: project.broken.message, cure: "" }] : []);
}
function showFaults(found: Fault[], unknown = false): void {
  faults = found;
  failed = unknown;
  list.show(found);
  file.mark(found);
  panel.lacks(found);
  canvas.faulty = new Map(found.filter((f) => openingOf(f) >= 0).map((f) => [openingOf(f), saidOf(f.problem)]));
  canvas.faultyParts = new Map(found.map((f) => [f.path.split(".").slice(0, 2).join(" "), saidOf(f.problem)]));
  canvas.root.classList.toggle("outdated", found.length > 0 || unknown);
  canvas.draw();
  refreshBar();
}

// --- what is shown ------------------------------------------------------------------------------------------

let shownSize = ""; // of the wall: another one is fitted into the window
project.listen((why) => {
  canvas.drawing = project.drawing;
  const size = project.drawing ? `${project.drawing.length} ${project.drawing.height}` : shownSize;
  fitNext ||= size !== shownSize;
  shownSize = size;
  canvas.selection = project.selection;
  if (why === "selection") {
    if (project.selection && project.doc && !file.hasFocus) file.show(lineOf(project.doc, pathOf(project.selection)), false);
    canvas.draw();
    return refreshBar();
  }
  reason.hidden = project.drawable || project.broken !== null;
  reason.textContent = project.refusal ? say(`studio.why.${project.refusal.why}`, { path: project.refusal.path.join(".") }) : "";
  push.edited();
  limit.forget();
  if (fitNext && project.drawing) {
    fitNext = false;
    canvas.fit();
  } else canvas.draw();
  if (!starting) edited();
  ask();
  refreshBar();
});

// What a page opens with is kept elsewhere, or stands in its address, until it is edited.
let starting = true;
let isKept = true;
function edited(): void {
  store.forgetLink();
  const wasKept = isKept;
  isKept = store.keep(project.text);
  if (wasKept && !isKept) tell(say("studio.notkept"));
}
// The page is loaded anew, with the steps back and the push that is kept. A wall that the browser does not keep goes along in the address.
// What cannot go along is asked about.
interface Along {
  text: string;
  steps: Steps;
  kept: Pushed | null;
}
async function speakAnother(): Promise<void> {
  const hasPhoto = await photo.isKept();
  if (push.busy) return void (languages.value = language); // begun meanwhile
  const along: Along = { text: project.text, steps: project.allSteps, kept: push.kept };
  const isWhole = store.handOver(along) || (!project.canUndo && !project.canRedo && !push.kept);
  const lost = [push.hasMore && say("studio.lost.pushes"), !isWhole && say("studio.lost.steps"), !hasPhoto && say("studio.lost.photo")].filter(Boolean).join(", ");
  if (lost !== "" && !window.confirm(say("studio.language.lost", { lost }))) {
    languages.value = language;
    return store.takeNothing();
  }
  remember("language", languages.value);
  if (isKept) return location.reload();
  const link = await store.linkTo(project.text);
  isKept = true; // from here on
  location.replace(link.replace(/(\?[^#]*)?#/, `?language=${languages.value}#`));
}
// Before the page goes, what was typed last counts. What is kept nowhere is asked about.
window.addEventListener("beforeunload", (e) => {
  (document.activeElement as HTMLElement | null)?.blur();
  if (!isKept) e.preventDefault();
});
function showCracks(picture: Picture | null): void {
  canvas.readOnly = picture !== null;
  canvas.showOpenings = picture === null;
  canvas.root.classList.toggle("cracked", picture !== null);
  canvas.setPicture(picture ?? stones);
  canvas.draw();
  refreshBar();
}
function refreshBar(): void {
  undo.disabled = !project.canUndo;
  redo.disabled = !project.canRedo;
  for (const [tool, b] of toolButtons) {
    b.setAttribute("aria-pressed", String(tools.tool === tool));
    b.disabled = !project.drawable && tool !== "select" && tool !== "photo";
  }
  canvas.root.dataset.tool = tools.tool;
  go.textContent = say(push.running ? "studio.button.stop" : "studio.button.push");
  go.title = say(push.running ? "studio.do.stop" : "studio.do.push");
  go.disabled = !push.running && (!hasEngine() || project.broken !== null || faults.length > 0 || failed);
  go.classList.toggle("running", push.running);
  languages.disabled = push.busy;
  languages.title = push.busy ? say("studio.language.push") : "";
  for (const b of snapButtons) b.setAttribute("aria-pressed", String(tools.snapping[b.dataset.snap as "masonry" | "objects"]));
}
function tell(text: string): void {
  notice.replaceChildren(text, h("button", { class: "button small", type: "button", onclick: () => (notice.hidden = true) }, say("studio.close")));
  notice.hidden = false;
}
function showPane(name: "numbers" | "file"): void {
  document.documentElement.dataset.pane = name;
  for (const tab of tabs) tab.setAttribute("aria-selected", String(tab.dataset.pane === name));
}

// --- what can be done ------------------------------------------------------------------------------------------

function begin(text: string): void {
  if (canvas.readOnly) push.leave();
  fitNext = true;
  if (project.text === "") project.open(text);
  else project.replace(text);
  canvas.fit();
}
async function openFile(from: File): Promise<void> {
  if (from.size > store.kLongest) return tell(say("studio.toolong", { name: from.name, size: whole(Math.ceil(from.size / 1e3)), limit: whole(Math.floor(store.kLongest / 1e3)) }));
  try {
    begin(await store.readFile(from));
  } catch {
    tell(say("studio.notopened", { name: from.name }));
  }
}
const title = (): string => String((project.doc && valueAt(project.doc, ["name"])) ?? "");
function togglePush(): void {
  file.take();
  if (push.running) push.stop();
  else if (!go.disabled) void push.start();
}
function toggleSnap(key: "masonry" | "objects"): void {
  tools.snapping[key] = !tools.snapping[key];
  refreshBar();
}
async function share(): Promise<void> {
  const { text } = project;
  const link = await store.linkTo(text);
  if (text === project.text) history.replaceState(null, "", link);
  try {
    await navigator.clipboard.writeText(link);
    tell(say("studio.linked"));
  } catch {
    tell(say("studio.link.address"));
  }
}
function remove(): void {
  if (!project.drawable || !project.drawing || !project.selection || tools.tool === "photo") return;
  const text = removePart(project.text, project.drawing, project.selection);
  if (text === null) return tell(say("studio.hinder.file"));
  project.endStep();
  project.change(text, null);
}
// An arch over the selected opening, or a lintel again.
function arch(): void {
  const { drawing, selected } = project;
  if (!drawing || !project.drawable || canvas.readOnly) return;
  if (selected < 0) return tell(say("studio.choose.opening"));
  project.endStep();
  project.change(setHead(project.text, drawing, selected, drawing.openings[selected].arch ? "lintel" : "segmental"));
}
// A steel frame in the selected opening, or none again.
function frame(): void {
  const { drawing, selected } = project;
  if (!drawing || !project.drawable || canvas.readOnly) return;
  if (selected < 0) return tell(say("studio.choose.opening"));
  const there = frameOf(drawing, selected);
  if (there < 0 && drawing.openings[selected].arch) return tell(say("studio.frame.arch"));
  project.endStep();
  project.change(there < 0 ? addFrame(project.text, drawing, selected, say("studio.a.frame")) : removeFrame(project.text, there));
}
function turn(): void {
  const now = project.doc && pushOf(project.doc);
  if (now && project.drawing && project.drawable) {
    project.endStep();
    project.change(setDirection(project.text, project.drawing, now.direction === "-x" ? "+x" : "-x"));
  }
}
// The number at the cursor of the file, or the one of the panel that was used last.
function varyNumber(): void {
  const there = document.documentElement.dataset.pane === "file" ? file.vary() : panel.varyLast();
  if (!there) tell(say("studio.vary.none"));
}
function nextTheme(): void {
  theme = (theme + 1) % kThemes.length;
  remember("theme", kThemes[theme]);
  showTheme();
  themes.textContent = themeName();
}
function escape(): void {
  if (tools.tool === "photo" && photo.escape()) return;
  if (tools.tool !== "select") tools.choose("select");
  else if (canvas.readOnly) push.leave();
  else project.select(-1);
}
const arrow = (dx: number, dy: number, fine: boolean) => (): void => {
  if (canvas.readOnly) push.step(dx);
  else tools.nudge(dx, dy, fine);
};
const all: Command[] = [
  { name: "select", keys: ["v"], does: () => tools.choose("select") },
  { name: "wall", keys: ["w"], does: () => tools.choose("wall") },
  { name: "door", keys: ["d"], does: () => tools.choose("door") },
  { name: "window", keys: ["o"], does: () => tools.choose("window") },
  { name: "arch", keys: ["a"], does: arch },
  { name: "storey", keys: ["e"], does: () => tools.choose("storey") },
  { name: "floor", keys: ["g"], does: () => tools.choose("floor") },
  { name: "tie", keys: ["i"], does: () => tools.choose("tie") },
  { name: "frame", keys: ["k"], does: frame },
  { name: "photo", keys: ["b"], does: () => tools.choose("photo") },
  { name: "photo.show", keys: ["h"], does: () => photo.toggle() },
  { name: "place", keys: ["Enter"], does: () => tools.place(), hidden: true },
  { name: "delete", keys: ["Delete", "Backspace"], does: remove },
  { name: "undo", keys: ["Ctrl+z"], does: () => project.undo() },
  { name: "redo", keys: ["Ctrl+y", "Ctrl+Shift+z"], does: () => project.redo() },
  { name: "fit", keys: ["f"], does: () => canvas.fit() },
  { name: "larger", keys: ["+", "="], does: () => canvas.zoom(1.25) },
  { name: "smaller", keys: ["-"], does: () => canvas.zoom(0.8) },
  { name: "push", keys: ["p", "Ctrl+Enter"], does: togglePush, typing: true },
  { name: "pause", keys: [" "], does: () => push.pause() },
  { name: "turn", keys: ["r"], does: turn },
  { name: "snap", keys: ["s"], does: () => {
    const on = !(tools.snapping.masonry && tools.snapping.objects);
    tools.snapping = { masonry: on, objects: on };
    refreshBar();
  } },
  { name: "numbers", keys: ["n"], does: () => {
    showPane("numbers");
    panel.root.querySelector<HTMLInputElement>("input:not([disabled])")?.focus();
  } },
  { name: "file", keys: ["t"], does: () => {
    showPane("file");
    file.root.querySelector("textarea")?.focus();
  } },
  { name: "vary", keys: ["y"], does: varyNumber },
  { name: "save", keys: ["Ctrl+s"], does: () => store.save(store.fileName(title()), project.text), typing: true },
  { name: "open", keys: ["Ctrl+o"], does: () => input.click(), typing: true },
  { name: "share", keys: [], does: () => void share() },
  { name: "report", keys: [], does: () => push.openReport() },
  { name: "theme", keys: [], does: nextTheme },
  { name: "escape", keys: ["Escape"], does: escape, hidden: true },
  { name: "palette", keys: ["Ctrl+k"], does: () => commands.openPalette(), hidden: true, typing: true },
  { name: "keys", keys: ["?"], does: () => commands.openSheet() },
  ...kStarters.map(([name]): Command => ({ name: `begin.${name}`, keys: [], does: () => begin(starter(name)) })),
  { name: "left", keys: ["ArrowLeft"], does: arrow(-1, 0, false), hidden: true },
  { name: "right", keys: ["ArrowRight"], does: arrow(1, 0, false), hidden: true },
  { name: "up", keys: ["ArrowUp"], does: arrow(0, 1, false), hidden: true },
  { name: "down", keys: ["ArrowDown"], does: arrow(0, -1, false), hidden: true },
  { name: "fine", keys: ["Shift+ArrowLeft"], does: arrow(-1, 0, true), hidden: true },
  { name: "fine", keys: ["Shift+ArrowRight"], does: arrow(1, 0, true), hidden: true },
  { name: "fine", keys: ["Shift+ArrowUp"], does: arrow(0, 1, true), hidden: true },
  { name: "fine", keys: ["Shift+ArrowDown"], does: arrow(0, -1, true), hidden: true },
];
const commands = new Commands(all);

document.addEventListener("keydown", (e) => {
  if (commands.palette.open || commands.sheet.open) return;
  const target = e.target as HTMLElement;
  const inField = target.matches("input:not([type=range]):not([type=checkbox]), textarea, select");
  if (!inField && tools.key(e)) return e.preventDefault();
  const onButton = target.matches("button, summary, [type=range], [type=checkbox]") && (e.key === "Enter" || e.key === " " || e.key.startsWith("Arrow"));
  if (onButton && !e.ctrlKey) return;
  if (inField && e.key === "Escape") return canvas.root.focus();
  const isUntouched = (e.ctrlKey || e.metaKey) && target instanceof HTMLInputElement && target.dataset.shown === target.value; // Ctrl+Z is of the wall
  if (commands.key(e, inField && !isUntouched)) e.preventDefault();
});
document.addEventListener("dragover", (e) => e.preventDefault());
document.addEventListener("drop", (e) => {
  e.preventDefault();
  const dropped = e.dataTransfer?.files[0];
  if (dropped && (dropped.type.startsWith("image/") || /\.dxf$/i.test(dropped.name))) {
    tools.choose("photo");
    void photo.open(dropped);
  } else if (dropped) void openFile(dropped);
});
new ResizeObserver(() => canvas.fit()).observe(canvas.root);
// Paper is white and has another width: drawing and curve are scaled to it.
window.addEventListener("beforeprint", () => {
  document.documentElement.dataset.theme = "light";
  for (const { root } of [canvas, push.curve]) root.setAttribute("viewBox", `0 0 ${root.clientWidth} ${root.clientHeight}`);
});
window.addEventListener("afterprint", () => {
  showTheme();
  for (const { root } of [canvas, push.curve]) root.removeAttribute("viewBox");
});

// --- the page ----------------------------------------------------------------------------------------------------

const tabs = (["numbers", "file"] as const).map((name) => h("button", { class: "tab", type: "button", role: "tab", "data-pane": name, "aria-controls": `pane-${name}`, onclick: () => showPane(name) }, say(`studio.pane.${name}`)));
document.body.prepend(
  h("header", { class: "top", onfocusin: (e: FocusEvent) => (e.target as Element).scrollIntoView({ block: "nearest", inline: "nearest" }) }, // it may scroll sideways
    h("h1", {}, say("studio.title")),
    h("div", { class: "top-group" }, starters, button("open", () => input.click()), button("save", () => store.save(store.fileName(title()), project.text)), button("share", () => void share())),
    h("div", { class: "top-group" }, undo, redo),
    h("span", { class: "gap" }),
    h("div", { class: "top-group" }, languages, themes, h("button", { class: "button icon-only", type: "button", title: say("studio.do.keys"), "aria-label": say("studio.do.keys"), onclick: () => commands.openSheet() }, "?")),
    go,
    input),
  h("main", { class: "desk" },
    h("nav", { class: "tools", "aria-label": say("studio.tools") }, ...toolButtons.values()),
    h("section", { class: "board", "aria-label": say("studio.drawing") }, photo.bar, canvas.root, tools.typing, reason, h("div", { class: "snaps", role: "group", "aria-label": say("studio.snap") }, ...snapButtons, h("button", { class: "chip-button", type: "button", onclick: () => canvas.fit() }, say("studio.button.fit")))),
    h("aside", { class: "side", "aria-label": say("studio.side") },
      h("div", { class: "tabs", role: "tablist" }, ...tabs),
      h("div", { id: "pane-numbers", class: "pane", role: "tabpanel", "aria-label": say("studio.pane.numbers") }, panel.root),
      h("div", { id: "pane-file", class: "pane", role: "tabpanel", "aria-label": say("studio.pane.file") }, file.root),
      list.root),
    h("div", { class: "below" }, h("div", { class: "status-line" }, status, notes), h("div", { class: "answers" }, limit.root, push.root))),
  notice, commands.palette, commands.sheet,
);
showPane("numbers");

async function start(): Promise<void> {
  const kept = store.kept(),
    fresh = store.given ?? starter("portal");
  const along = store.handedOver() as Along | null;
  let text = kept ?? store.given;
  const isOfBefore = kept !== null && kept !== fresh;
  const before: (string | null)[] = isOfBefore ? [store.keptByAnother(), kept] : [store.keptByAnother() ?? store.keptPlain()]; // what undo brings back, the tab's own first
  let unread = ""; // why a link is not
  let linked = false; // another's wall: the photo stays hidden
  if (store.hasLink())
    try {
      text = await store.textOfLink();
      linked = text !== kept;
      if (!before.some((wall) => wall !== null)) before.push(store.given);
    } catch (error) {
      unread = say(error instanceof TooOld ? "studio.badlink.browser" : "studio.badlink");
      if (!(error instanceof TooOld)) store.forgetLink(); // a newer browser reads it
    }
  const goesOn = along !== null && along.text === text;
  const earlier = goesOn ? [] : before.filter((wall): wall is string => wall !== null && wall !== text);
  for (const wall of new Set([...earlier, text ?? fresh])) begin(wall);
  starting = false;
  if (!store.hasLink()) store.keepOwn(project.text); // another tab's edits do not change what this one shows
  if (goesOn) {
    project.goOn(along.steps);
    push.kept = along.kept;
  }
  await photo.restore(!linked);
  const told = unread || (earlier.length > 0 ? say("studio.lastwall") : isOfBefore ? say("studio.restored") : "");
  if (told !== "") tell(told);
  document.documentElement.dataset.ready = "yes";
}
void start();
// A link that is pasted into the address is opened as in a new tab: this tab's wall is kept, and undo brings it back.
window.addEventListener("hashchange", () => store.hasLink() && location.reload());
