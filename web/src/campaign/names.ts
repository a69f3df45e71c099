// How far the names of failure modes depend on the rules of evaluation, and how severe the damage is.
import { h, type Child } from "../base/dom";
import { sortable, table } from "../base/tables";
import { phrase, qty, say } from "../base/texts";
import type { Campaign } from "./data";
import { withInterval } from "./statistics";

// Evaluations that change no name are counted, not listed.
export function nameSensitivity(campaign: Campaign): Child {
  const all = campaign.statistics.name_sensitivity;
  if (all.length === 0) return null;
  const changing = all.filter((r) => r.differs > 0);
  if (changing.length === 0)
    return h("p", { id: "name-sensitivity", class: "soft" }, say("names.stable", { n: all.length }));
  return h(
    "div",
    { id: "name-sensitivity" },
    sortable(
      [
        { head: say("names.reading"), left: true },
        { head: say("samples") },
        { head: say("names.differs") },
        { head: say("names.share") },
      ],
      changing.map((r) => [
        phrase(r.reading),
        { show: String(r.n), sort: r.n },
        { show: String(r.differs), sort: r.differs },
        { show: withInterval(r.share, r.share_interval, 3, 100), sort: r.share },
      ]),
      say("names.title"),
    ),
    h(
      "p",
      { class: "soft small" },
      say("names.lead", { n: all.length }),
      all.length > changing.length ? ` ${say("names.others", { n: all.length - changing.length })}` : "",
    ),
  );
}

export function flags(campaign: Campaign): Child {
  const all = campaign.statistics.flags;
  if (all.length === 0) return null;
  const unit = (u: string): string => (u === "share" || u === "-" ? "" : u);
  return h(
    "div",
    { id: "flags" },
    table(
      [
        { head: say("failure.sign"), left: true },
        { head: say("flags.raised") },
        { head: say("names.share") },
      ],
      all.map((f) => [
        [
          `${phrase(f.element)}: ${phrase(f.measure)}`,
          h("span", { class: "pm" }, `≥ ${qty(f.threshold, unit(f.unit))}`),
        ],
        `${f.raised} / ${f.n}`,
        withInterval(f.share, f.share_interval, 3, 100),
      ]),
      say("flags.title"),
    ),
  );
}
