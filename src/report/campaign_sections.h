// The parts of a campaign's page, each a piece of markup; campaign_report.cpp puts them in order.
#pragma once

#include <string>

#include "wythe/campaign.h"
#include "wythe/statistics.h"

namespace wythe::report {

// campaign_sections.cpp: the answers
[[nodiscard]] std::string campaign_headline(const Statistics& s);
[[nodiscard]] std::string campaign_warning(const Statistics& s);  // "" when every sample answered
[[nodiscard]] std::string campaign_cards(const Statistics& s);
[[nodiscard]] std::string table_section(const Statistics& s);
[[nodiscard]] std::string shares_section(const Statistics& s);
[[nodiscard]] std::string capacity_section(const Statistics& s);
// campaign_evidence.cpp: why, how sure, from what
[[nodiscard]] std::string influence_section(const Campaign& campaign, const Statistics& s);
[[nodiscard]] std::string precision_section(const Campaign& campaign, const Statistics& s);
[[nodiscard]] std::string study_section(const Campaign& campaign, const Statistics& s);
[[nodiscard]] std::string unanswered_section(const Statistics& s);
[[nodiscard]] std::string replay_section(const Campaign& campaign, const Statistics& s);

// An estimate in a table: the value, its interval small beneath it.
[[nodiscard]] std::string with_interval(const Estimate& e, double scale, int digits = 3);

}  // namespace wythe::report
