// Decides which cautions about the drift or mode of one push are dropped for many walls, and gives the others a new
// cure. They are dropped if pushes slow down at cracks: slow, adapting, with little damping, in the plane, without
// free contacts. A push too fast for its force keeps its caution, because that error always has the same sign.
#include "statistics/one_push.h"

#include <variant>

#include "wythe/parts/reading.h"

namespace wythe::study {
namespace {

// The reason why one push cannot give its drift or mode; null for any other caution.
const Message* reason_of_one_push(const Message& caution) {
  if (caution.code != "assessment.caution.drift" && caution.code != "assessment.caution.mode")
    return nullptr;
  for (const Argument& argument : caution.arguments)
    if (const auto* why = std::get_if<std::vector<Message>>(&argument.value); why && !why->empty())
      return &why->front();
  return nullptr;
}

bool may_wait(const Model& model) {
  return dimension_of(model) == 2 && model.solve.contacts != Contacts::kFree;
}

// The reason with the cure for many walls; the cure for one push is to run many walls.
Message cured(Message why, const Message& cure) {
  const std::string code = why.code;
  if (code == "promise.threshold" || code == "promise.name") {
    why.code = code == "promise.name" ? "verdict.name" : "verdict.threshold";
    why.arguments.emplace_back("cure", cure);
  }
  for (Argument& argument : why.arguments)
    if (argument.name == "cure") argument = Argument("cure", cure);
  return why;
}

}  // namespace

bool waits_at_cracks(const Model& model) {
  constexpr double kNearBalance = 1e-4, kMostDamping = 0.2, kRounding = 1 + 1e-9;
  if (!may_wait(model)) return false;
  for (auto stage = model.stages.rbegin(); stage != model.stages.rend(); ++stage) {
    const PushStage* push = stage->push();
    if (push == nullptr) continue;
    return push->fast_velocity > push->velocity && push->velocity <= kWaitingVelocity * kRounding &&
           push->fast_velocity <= kAdaptedVelocity * kRounding &&
           push->fast_below <= kNearBalance * kRounding &&
           stage->spec.damping <= kMostDamping * kRounding;
  }
  return false;
}

bool is_left_to_the_scatter(const Message& caution, bool waits) {
  const Message* why = reason_of_one_push(caution);
  return waits && why != nullptr && why->code != "promise.force";
}

void leave_to_the_scatter(const Model& model, std::vector<Message>& cautions) {
  const bool waits = waits_at_cracks(model);
  const Message cure{may_wait(model) ? "verdict.cure.wait" : "verdict.cure.slower"};
  std::erase_if(cautions,
                [&](const Message& caution) { return is_left_to_the_scatter(caution, waits); });
  for (Message& caution : cautions)
    if (const Message* why = reason_of_one_push(caution))
      caution.arguments = {{"why", cured(*why, cure)}};
}

}  // namespace wythe::study
