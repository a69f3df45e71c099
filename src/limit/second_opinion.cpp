// second_opinion(): all mechanisms and limit loads of a model. One without a result is stored with its reason, and the
// others continue.
#include "wythe/parts/second_opinion.h"

#include <algorithm>

#include "core/text.h"
#include "limit/limit_loads.h"
#include "wythe/parts/error.h"
#include "wythe/parts/quick_limit.h"
#include "wythe/parts/reading.h"

namespace wythe {
namespace {

constexpr const char* kLimitLoads = "lp";
constexpr const char* kParts = "parts";

bool is_asked(const OpinionAsked& asked, const char* what) {
  return asked.only.empty() ||
         std::find(asked.only.begin(), asked.only.end(), what) != asked.only.end();
}

template <class Answer>
void attempt(SecondOpinion& opinion, const Message& what, Answer answer) {
  try {
    answer();
  } catch (const InputError& error) {
    opinion.refused.push_back({what, error.what()});
  } catch (const LimitStopped& stopped) {
    opinion.refused.push_back({what, stopped.what()});
  }
}

void add_mechanisms(const OpinionAsked& asked, const Model& model, SecondOpinion& opinion) {
  std::vector<Hypothesis> hypotheses;
  for (const auto& [word, hypothesis] : kHypothesisWords)
    if (is_asked(asked, word)) hypotheses.push_back(hypothesis);
  const Stage* grows = limit::growing_stage(model);
  // its own mechanism is assessed (local_check.h)
  const bool is_body_force = grows != nullptr && grows->spec.kind() == StageKind::kBodyForce;
  if (asked.assessment && is_body_force && !is_asked(asked, kLimitLoads))
    opinion.refused.push_back({{"limit.assessment"}, text_of(Message{"limit.no_body_force"})});
  if (hypotheses.empty()) {
    if (asked.assessment && !is_body_force && !is_asked(asked, kParts))
      opinion.notes.push_back({"limit.no_mechanism_asked"});
    return;
  }
  attempt(opinion, {"limit.macro_blocks"}, [&] {
    const Portal portal = find_portal(model);
    for (const char* mode : {"FM-1", "FM-4"})
      for (const Hypothesis h : hypotheses)
        attempt(opinion, in_words(mode, h),
                [&] { opinion.mechanisms.push_back(cut_mechanism(model, portal, mode, h)); });
  });
  if (!asked.assessment) return;
  if (opinion.mechanisms.empty() && !is_body_force)
    opinion.refused.push_back({{"limit.assessment"},
                               text_of(Message{dimension_of(model) == 3 ? "limit.no_chain_in_space"
                                                                        : "limit.no_chain"})});
  for (const Mechanism& m : opinion.mechanisms)
    opinion.assessments.push_back(assess(m.chain, m.curve, model.solve.gravity, opinion.shares));
}

struct LimitCase {
  const char *name, *code;
  LimitOptions options;
};

// Whether any load acts on the blocks when the growing load begins.
bool presses_before(const Model& model, const Stage& grows) {
  for (const Stage& stage : model.stages) {
    if (&stage == &grows) break;
    for (const PointLoad& load : stage.loads)
      if (load.fy < 0) return true;
  }
  return false;
}

// Cases from fully broken bond to full bond at all joints at once; the first alone where it is quick.
std::vector<LimitCase> limit_cases(const Model& model, const OpinionAsked& asked) {
  if (!is_asked(asked, kLimitLoads)) return {};
  std::vector<LimitCase> cases = {
      {"dry", "strength.dry", {}},
      {"dry, residual friction, crushing",
       "strength.dry_crushing",
       {.friction = FrictionChoice::kResidual, .crushing = CrushingChoice::kPoints}}};
  if (has_bond(model))
    cases.push_back({"bonded", "strength.bonded", {.strength = JointStrength::kBonded}});
  const Stage* grows = limit::growing_stage(model);
  if (asked.assessment && grows != nullptr && grows->spec.kind() == StageKind::kBodyForce &&
      presses_before(model, *grows))
    cases.push_back({"dry, loads are masses", "strength.dry_masses", {.loads_are_masses = true}});
  if (asked.quick) cases.resize(1);
  return cases;
}

// Throws the reasons, each once, where no analysis succeeded.
void throw_if_nothing(const OpinionAsked& asked, const SecondOpinion& opinion,
                      const std::atomic<bool>* stop) {
  if (!opinion.mechanisms.empty() || !opinion.limits.empty() || asked.parts) return;
  if (stop != nullptr && *stop) throw LimitStopped();
  std::vector<Fault> faults;
  for (const Refusal& r : opinion.refused) {
    const auto same = [&](const Fault& f) { return f.problem == r.why; };
    if (std::none_of(faults.begin(), faults.end(), same))
      faults.push_back({.path = text_of(r.what), .problem = r.why});
  }
  if (faults.empty())
    faults.push_back({.value = kParts,
                      .problem =
                          "none is here to check: parts that fall on their face are of walls "
                          "in their plane, pushed along it or left to stand",
                      .cure = "ask for lp, or for a mechanism"});
  throw InputError(std::move(faults));
}

}  // namespace

void check_asked(const OpinionAsked& asked, const std::string& option) {
  std::vector<std::string> known;
  for (const auto& [word, hypothesis] : kHypothesisWords) known.emplace_back(word);
  known.emplace_back(kLimitLoads);
  known.emplace_back(kParts);
  FaultList faults;
  for (const std::string& word : asked.only)
    if (std::find(known.begin(), known.end(), word) == known.end())
      faults.add({.file = option,
                  .value = word,
                  .problem = "is nothing that limit analysis answers",
                  .cure = "write one of: " + joined(known, ", ")});
    else if (word == kParts && !asked.assessment)
      faults.add({.file = option,
                  .value = word,
                  .problem = "are checked by an assessment alone",
                  .cure = "add --assessment"});
  faults.throw_if_any();
}

bool asks_for_parts(const OpinionAsked& asked) {
  return asked.assessment && is_asked(asked, kParts);
}

OpinionCost cost_of(const Model& model, const OpinionAsked& asked) {
  const auto loads = static_cast<int>(limit_cases(model, asked).size());
  return {loads, expected_seconds(model) * loads};
}

SecondOpinion second_opinion(const Model& model, const OpinionAsked& asked,
                             const std::atomic<bool>* stop,
                             const std::function<void(const Message&, double)>& progress) {
  SecondOpinion opinion;
  opinion.notes = left_aside(model);
  add_mechanisms(asked, model, opinion);
  const std::vector<LimitCase> cases = limit_cases(model, asked);
  const auto load_of = asked.quick ? quick_limit_load : limit_load;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Message what{"limit.of_case", {{"case", Message{cases[i].code}}}};
    LimitMonitor monitor{.stop = stop};
    monitor.progress = [&](double share) {
      if (progress)
        progress(what, (static_cast<double>(i) + share) / static_cast<double>(cases.size()));
    };
    attempt(opinion, what, [&] {
      if (stop != nullptr && *stop) throw LimitStopped();
      opinion.limits.push_back({cases[i].name, load_of(model, cases[i].options, monitor)});
    });
  }
  if (asked.quick && !opinion.limits.empty()) opinion.notes.push_back({"limit.quick"});
  throw_if_nothing(asked, opinion, stop);
  return opinion;
}

}  // namespace wythe
