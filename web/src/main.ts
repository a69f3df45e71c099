// The page: unpacks its data and builds the sections for their kind.
// Unreadable data are reported, and the static headline stays.
import "./style.css";
import { fromBase64, unpack, type Bundle } from "./base/bundle";
import { later } from "./base/dom";
import type { CampaignHeader } from "./headers/campaign";
import type { ComparisonHeader } from "./headers/comparison";
import type { LimitHeader } from "./headers/limit";
import type { RunHeader } from "./headers/run";
import { build, fail, type Section } from "./page";
import { learn, say, speak } from "./base/texts";
import { runSections } from "./run/page";
import { campaignSections } from "./campaign/page";
import { comparisonSections } from "./comparison";
import { limitSections } from "./limit/page";

async function start(): Promise<void> {
  speak(document.documentElement.lang);
  const holder = document.getElementById("wythe-data")!;
  const text = holder.textContent!.trim();
  holder.textContent = "";
  let sections: Section[];
  try {
    if (typeof DecompressionStream === "undefined") throw new Error(say("old_browser"));
    const bundle = await unpack(fromBase64(text));
    learn(bundle.header.names);
    switch (bundle.header.kind) {
      case "run":
        sections = runSections(bundle as Bundle<RunHeader>);
        break;
      case "campaign":
        sections = campaignSections(bundle as Bundle<CampaignHeader>);
        break;
      case "comparison":
        sections = comparisonSections(bundle as Bundle<ComparisonHeader>);
        break;
      case "limit":
        sections = limitSections(bundle as Bundle<LimitHeader>);
        break;
      default:
        throw new Error(`unknown kind of page: ${bundle.header.kind}`);
    }
    build(sections);
    later(() => undefined);
  } catch (error) {
    fail(error instanceof Error ? error.message : String(error));
  }
}
void start();
