// Tables: plain ones, and ones with sortable columns.
import { h, hintMore, type Child } from "./dom";
import { say } from "./texts";

export interface Column {
  head: Child;
  left?: boolean;
  title?: string;
}
export interface Cell {
  show: Child;
  sort?: number | string | null;
  title?: string;
}
const kLong = 8; // rows above which a table may break over two pages
// Letters of a text cell that stay on one line on a narrow screen; more for a long text.
const roomFor = (letters: number): number => (letters > 80 ? 34 : Math.min(letters, 18));
export type Row = (Cell | Child)[];
// A row that stays at the top in any order: all samples above their groups.
const pinned = new WeakSet<Row>();
export function pin(row: Row): Row {
  pinned.add(row);
  return row;
}

// The table in a card that shows when the table is cut off.
function framed(table: HTMLElement, rows: number, label: string): HTMLElement {
  const slide = h("div", { class: "slide", role: "group", "aria-label": label }, table);
  const frame = h("div", { class: rows > kLong ? "scroll long" : "scroll" }, slide);
  hintMore(slide, frame);
  return frame;
}

const isCell = (c: Cell | Child): c is Cell => typeof c === "object" && c !== null && "show" in c;

function bodyRow(row: Row, columns: Column[]): HTMLElement {
  return h(
    "tr",
    {},
    row.map((c, i) => {
      const cell = isCell(c) ? c : { show: c };
      const css = columns[i]?.left ? "left" : undefined;
      const element =
        i === 0
          ? h("th", { scope: "row", class: css, title: cell.title }, cell.show)
          : h("td", { class: css, title: cell.title }, cell.show);
      if (i === 0 || css) element.style.setProperty("--room", `${roomFor(element.textContent!.length)}ch`);
      return element;
    }),
  );
}

export function table(columns: Column[], rows: Row[], caption = "", css = ""): HTMLElement {
  const heads = columns.map((c) =>
    c.head === ""
      ? h("td")
      : h("th", { scope: "col", class: c.left ? "left" : undefined, title: c.title }, c.head),
  );
  const body = h(
    "tbody",
    {},
    rows.map((r) => bodyRow(r, columns)),
  );
  return framed(
    h(
      "table",
      { class: css },
      caption ? h("caption", {}, caption) : null,
      columns.some((c) => c.head !== "") ? h("thead", {}, h("tr", {}, heads)) : null,
      body,
    ),
    rows.length,
    caption || say("table"),
  );
}

const sortKey = (c: Cell | Child): number | string | null =>
  isCell(c)
    ? (c.sort ?? (typeof c.show === "string" ? c.show : null))
    : typeof c === "string" || typeof c === "number"
      ? c
      : null;

// Buttons in the headers sort the rows; a second press reverses the order.
export function sortable(columns: Column[], rows: Row[], caption: string): HTMLElement {
  const body = h("tbody");
  let by = -1,
    down = false;
  const heads = columns.map((c, i) => {
    const press = (): void => {
      down = by === i ? !down : i > 0;
      by = i;
      fill();
    };
    return h(
      "th",
      { scope: "col", class: c.left ? "left" : undefined, title: c.title },
      h(
        "button",
        { type: "button", class: "sort", onclick: press },
        c.head,
        h("span", { class: "arrow", "aria-hidden": "true" }),
      ),
    );
  });
  const fill = (): void => {
    const order = rows.filter((r) => !pinned.has(r));
    if (by >= 0)
      order.sort((a, b) => {
        const [x, y] = [sortKey(a[by]), sortKey(b[by])];
        if (x === null || y === null) return x === y ? 0 : x === null ? 1 : -1;
        const less =
          typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y));
        return down ? -less : less;
      });
    heads.forEach((head, i) => {
      head.setAttribute("aria-sort", i !== by ? "none" : down ? "descending" : "ascending");
      head.querySelector(".arrow")!.textContent = i !== by ? "" : down ? " ↓" : " ↑";
    });
    body.replaceChildren(...[...rows.filter((r) => pinned.has(r)), ...order].map((r) => bodyRow(r, columns)));
  };
  fill();
  return framed(
    h("table", {}, h("caption", {}, caption), h("thead", {}, h("tr", {}, heads)), body),
    rows.length,
    caption,
  );
}
