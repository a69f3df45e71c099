// The page of a campaign, in the order of a reader's questions: strength,
// displacement, failure, influences, certainty, single samples, inputs.
import type { Bundle } from "../base/bundle";
import { h, later, type Child } from "../base/dom";
import type { CampaignHeader } from "../headers/campaign";
import { assumptions, inputTables, provenanceTable } from "../run/inputs";
import type { Section } from "../page";
import { projectSection } from "../run/sheet";
import { table } from "../base/tables";
import { asSentence, phrase, say, sentence } from "../base/texts";
import { pgaFragility } from "./assessment";
import { Curves, meanCurves } from "./curves";
import { Campaign, modeLabel } from "./data";
import { fragility, measuring, surrogateIndices } from "./fragility";
import { entangled, histograms, inputTable, modeBins, scatters, sensitivity, sensitivityTable } from "./inputs";
import { flags, nameSensitivity } from "./names";
import { SamplePanel } from "./sample";
import { campaignSheet } from "./sheet";
import { isShaken, limitStates, lostShakes, response } from "./shaken";
import { driftLimits, exceedance, medians, precision, running, shares, tableThree } from "./statistics";

const kListed = 200;

function unanswered(campaign: Campaign): Child {
  const list = campaign.statistics.samples.unanswered;
  if (list.length === 0) return null;
  return [
    table(
      [
        { head: say("sample"), left: true },
        { head: say("status"), left: true },
        { head: say("cause"), left: true },
      ],
      list
        .slice(0, kListed)
        .map((u) => [String(u.sample), phrase(u.status), u.reason ? sentence(u.reason) : "–"]),
      say("unanswered.title"),
    ),
    list.length > kListed
      ? h("p", { class: "soft small" }, say("unanswered.more", { n: kListed, of: list.length }))
      : null,
  ];
}

// The meanings of the modes, from the samples.
function modeWords(campaign: Campaign): Child {
  const rows = campaign.modes.map((mode) => {
    const sample = campaign.answered.find((s) => s.mode === mode && s.sentence !== "")!;
    const words = mode === "unclear" ? say("modes.unclear") : sample ? asSentence(phrase(sample.sentence)) : "–";
    return h(
      "div",
      { class: "mode-word" },
      h(
        "dt",
        {},
        h("span", { class: `dot-mark ${campaign.css(mode)}`, "aria-hidden": "true" }),
        modeLabel(mode),
      ),
      h("dd", {}, words),
    );
  });
  return h("div", { class: "panel" }, h("h3", {}, say("modes.words")), h("dl", {}, rows));
}

function study(campaign: Campaign): Child {
  const model = campaign.header.model;
  return [
    histograms(campaign),
    inputTable(campaign),
    model ? h("details", {}, h("summary", {}, say("study.base")), inputTables(model, "")) : null,
  ];
}

function provenance(campaign: Campaign): Child {
  return [
    isShaken(campaign) ? assumptions(campaign.header, ["rigid", "law", "base", "records", "single_shake"]) : assumptions(campaign.header),
    provenanceTable([
      [say("provenance.program"), campaign.header.provenance || "–"],
      [
        say("study.design"),
        `${phrase(campaign.statistics.design)}, ${say("seed", { seed: campaign.statistics.seed })}`,
      ],
      [say("study.model"), campaign.header.model_file || "–"],
    ]),
    h(
      "details",
      {},
      h("summary", {}, say("provenance.model_text")),
      h("pre", { tabindex: 0 }, campaign.header.model_text),
    ),
  ];
}

// Walls under records have other sections than pushed walls.
function shakenSections(campaign: Campaign): Section[] {
  return [
    projectSection(campaign.header),
    { id: "limit-states", title: say("section.limit_states"), content: limitStates(campaign) },
    { id: "intensities", title: say("section.intensities"), content: response(campaign) },
    { id: "lost-shakes", title: say("section.lost_shakes"), content: lostShakes(campaign) },
    { id: "unanswered", title: say("section.unanswered"), content: unanswered(campaign) },
    { id: "study", title: say("section.study"), content: campaign.inputs.length > 0 ? study(campaign) : null },
    { id: "provenance", title: say("section.provenance"), content: provenance(campaign) },
  ];
}

// A note where samples are shown one by one, but not all of them.
const some = (campaign: Campaign): Child =>
  campaign.thinned ? h("p", { class: "note thinned" }, campaign.thinned) : null;

export function campaignSections(bundle: Bundle<CampaignHeader>): Section[] {
  const campaign = new Campaign(bundle);
  if (isShaken(campaign)) return shakenSections(campaign);
  const any = campaign.answered.length > 0,
    several = campaign.answered.length > 1;
  const panel = campaign.samples.length > 0 ? new SamplePanel(campaign) : null;
  const sections: Section[] = [
    campaignSheet(campaign, panel),
    projectSection(campaign.header),
    { id: "all-curves", title: say("section.curves"), content: any ? [some(campaign), new Curves(campaign).element] : null },
    {
      id: "modes",
      title: say("section.modes"),
      content: several
        ? [
            h("div", { class: "pair" }, shares(campaign), modeWords(campaign)),
            meanCurves(campaign),
            h("div", { class: "spaced" }, tableThree(campaign)),
            h("div", { class: "pair spaced" }, nameSensitivity(campaign), flags(campaign)),
          ]
        : null,
    },
    {
      id: "capacity",
      title: say("section.capacity"),
      content: several
        ? [
            h(
              "div",
              { class: "pair" },
              ["peak_reaction", "displacement_at_80_percent", "displacement_max"].map((q) =>
                exceedance(campaign, q),
              ),
            ),
            medians(campaign),
            driftLimits(campaign),
          ]
        : null,
    },
    {
      id: "assessment",
      title: say("section.assessment"),
      content: several ? pgaFragility(campaign) : null,
    },
    {
      id: "influence",
      title: say("section.influence"),
      content:
        campaign.answered.length >= 5
          ? [
              some(campaign),
              scatters(campaign),
              h("div", { class: "spaced" }, sensitivity(campaign), entangled(campaign)),
              sensitivityTable(campaign),
              modeBins(campaign),
            ]
          : null,
    },
    {
      id: "fragility",
      title: say("section.fragility"),
      content:
        campaign.answered.length >= 5
          ? [fragility(campaign), measuring(campaign), surrogateIndices(campaign)]
          : null,
    },
    {
      id: "sure",
      title: say("section.sure"),
      content:
        campaign.answered.length >= 5
          ? h("div", { class: "pair" }, running(campaign), h("div", {}, precision(campaign)))
          : null,
    },
    { id: "sample", title: say("section.sample"), content: panel ? [some(campaign), panel.element] : null },
    { id: "unanswered", title: say("section.unanswered"), content: unanswered(campaign) },
    {
      id: "study",
      title: say("section.study"),
      content: campaign.inputs.length > 0 ? study(campaign) : null,
    },
    { id: "provenance", title: say("section.provenance"), content: provenance(campaign) },
  ];
  if (panel) later(() => campaign.select(campaign.answered[0] ?? campaign.samples[0], false));
  return sections;
}
