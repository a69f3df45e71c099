// Messages of the engine as texts for a page: one text for each language
// of the table of words. So the page needs no words of the engine.
//
//   "reason": ["stage \"push\" did not settle: ...", "la fase “push” non ...", ]
#pragma once

#include "report/bundle.h"
#include "wythe/parts/message.h"
#include "wythe/parts/model.h"

namespace wythe::report {

// "" for an empty message, one text where it is the same in every language, or a list of texts.
[[nodiscard]] Json translated(const Message& message);
[[nodiscard]] Json translated(const std::vector<Message>& messages);
// The message without keys and commands in its cures, which are meant for
// the console: words of CODE.page replace those of CODE in all its parts.
[[nodiscard]] Message for_page(Message message);
// A list of damaged parts, shortened to the first three and the number of the others.
[[nodiscard]] Message shortened(Message sentence);
// Names of a wall's parts, as elements and flags use them: {"left pier": [...], ...}.
[[nodiscard]] Json names_of(const Model& model);
// Replaces messages in the JSON of a file (io/results/message_json.h): KEY gets the texts of KEY_message, and KEY_message is removed.
void translate_messages(Json& json);

}  // namespace wythe::report
