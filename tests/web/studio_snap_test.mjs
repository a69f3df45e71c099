// Where lines of a drawing come to lie: each kind of line that snaps, the order among them, the line that shows it, and what a switch turns off.
import assert from "node:assert/strict";
import { before, test } from "node:test";
import { viewerModule } from "./helpers.mjs";

let snapLine, snapMove, wall;
before(async () => {
  ({ snapLine, snapMove } = await viewerModule("studio/board/snap"));
  const { parse } = await viewerModule("studio/file/toml");
  const { readDrawing } = await viewerModule("studio/reading");
  // courses of 0.1 m, half units of 0.25 m; a door below, a window above it
  const opening = (storey, x, y, width) => `[[wall.opening]]\nstorey = "${storey}"\nx = "${x} m"\ny = "${y} m"\nwidth = "${width} m"\nheight = "1 m"\n`;
  const storey = (name, height) => `[[storey]]\nname = "${name}"\nheight = "${height} m"\n`;
  wall = readDrawing(parse(`[wall]\nlength = "6 m"\nfit = "cut"\n[wall.unit]\nlength = "500 mm"\nheight = "100 mm"\n${storey("low", 2.93)}${storey("high", 3)}${opening("low", 1, 0, 1.5)}${opening("high", 4.03, 1, 0.9)}`));
});
const kBoth = { masonry: true, objects: true };
const close = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} ${b}`);
const moved = (x, y, how = kBoth) => snapMove(wall, 0, { x, y, width: 1.5, height: 1 }, 0.05, how);

test("an opening that is moved comes to lie on the axis of the one above, and a line says so", () => {
  const axis = 4.03 + 0.45;
  const { box, guides } = moved(axis - 0.75 + 0.03, 0);
  close(box.x + 0.75, axis);
  assert.deepEqual(guides.map(({ axis, from, to }) => [axis, from, to]), [["x", 3.93, 4.93]]);
  close(guides[0].at, axis);
});

test("edges of other openings, ends and the middle of the wall, and lines of storeys count; each before half units and courses", () => {
  for (const [near, at] of [[4.06, 4.03], [4.9, 4.93], [5.97, 6], [2.97, 3], [0.02, 0]]) close(snapLine(wall, "x", near, 0, 0.05, kBoth).at, at);
  const line = snapLine(wall, "y", 2.96, 0, 0.05, kBoth);
  close(line.at, 2.93); // the storey's, not the course at 3 m
  assert.deepEqual(line.guides, [{ axis: "y", at: line.at, from: 0, to: 6 }]);
});

test("elsewhere there are half units, and courses from the storey's own foot, without a line", () => {
  assert.deepEqual(snapLine(wall, "x", 3.4, 0, 0.05, kBoth), { at: 3.5, guides: [] });
  close(snapLine(wall, "y", 3.31, 0, 0.05, kBoth).at, 2.93 + 0.4);
  close(snapLine(wall, "y", 1.24, 0, 0.05, kBoth).at, 1.2);
});

test("each of the two switches turns its own lines off; without both there are centimetres", () => {
  close(snapLine(wall, "x", 4.06, 0, 0.05, { masonry: true, objects: false }).at, 4);
  close(snapLine(wall, "x", 4.06, 0, 0.05, { masonry: false, objects: true }).at, 4.03);
  const free = snapLine(wall, "x", 4.064, 0, 0.05, { masonry: false, objects: false });
  close(free.at, 4.06);
  assert.deepEqual(free.guides, []);
  close(moved(3.757, 0, { masonry: false, objects: false }).box.x, 3.76);
});
