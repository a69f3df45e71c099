// Decides which cautions and doubts about the drift or mode of one push are dropped for many walls, and gives the others a new
// cure. They are dropped if pushes slow down at cracks: slow, adapting, with little damping, in the plane, without
// free contacts. A push too fast for its force keeps its caution, because that error always has the same sign.
#include "statistics/one_push.h"

#include <variant>

#include "wythe/parts/comparison.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/reading.h"
#include "wythe/parts/slow_push.h"

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

// Whether the scatter of many pushes includes what is not known. Too fast a push errs to one side.
bool is_of_chance(const Message& why) { return why.code != "promise.force"; }

// The reason with other cures: the cure for one push is to run many walls.
Message cured(Message why, const std::vector<Message>& cure) {
  const std::string code = why.code;
  if (code == "promise.threshold" || code == "promise.name") {
    why.code = code == "promise.name" ? "verdict.name" : "verdict.threshold";
    why.arguments.emplace_back("cure", cure);
  }
  for (Argument& argument : why.arguments)
    if (argument.name == "cure") argument = Argument("cure", cure);
  return why;
}

Message cure_of_push(const Model& model) {
  return {may_wait(model) ? "verdict.cure.wait" : "verdict.cure.slower"};
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
  return waits && why != nullptr && is_of_chance(*why);
}

void leave_to_the_scatter(const Model& model, std::vector<Message>& cautions) {
  const bool waits = waits_at_cracks(model);
  const Message cure = cure_of_push(model);
  std::erase_if(cautions,
                [&](const Message& caution) { return is_left_to_the_scatter(caution, waits); });
  for (Message& caution : cautions)
    if (const Message* why = reason_of_one_push(caution))
      caution.arguments = {{"why", cured(*why, {cure})}};
}

}  // namespace wythe::study

namespace wythe {

std::map<int, PushDoubt> doubts_of(const Campaign& campaign, const Model& model) {
  const bool waits = study::waits_at_cracks(model), are_many = campaign.samples.n_sample() > 1;
  std::vector<Message> cure;
  if (!waits) cure.push_back(study::cure_of_push(model));
  if (!are_many && study::may_wait(model)) cure.push_back({"compare.cure_scatter"});
  const auto is_doubted = [&](const SlowPushVerdict& promise) {
    return promise.is_missing() && !(waits && are_many && study::is_of_chance(promise.reason));
  };
  std::map<int, PushDoubt> out;
  for (const SampleRecord& record : campaign.records) {
    if (!is_answered(record)) continue;
    const JudgedCurve curve{record.curve, record.responses, record.quasi_static};
    const SlowPushVerdict displacement = displacement_of_slow_push(model, curve);
    const FailureMode& mode = record.failure_mode;
    PushDoubt doubt;
    if (is_doubted(displacement)) doubt.displacement = study::cured(displacement.reason, cure);
    doubt.mode = is_doubted(mode_of_slow_push(model, curve, mode.read_at, is_firm(mode)));
    if (doubt.mode || !doubt.displacement.empty()) out[record.sample] = std::move(doubt);
  }
  return out;
}

}  // namespace wythe
