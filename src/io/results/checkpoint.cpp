// The file of a checkpoint: a header that can be checked, then the complete unfinished run.
//
//   "wythe checkpoint"       16 bytes
//   format                   u32: kFormat
//   bytes of the program     u32
//   bytes of the content     u64
//   hash of the model        u64: spec_hash
//   hash of all the others   u64: of the file without these 8 bytes
//   program                  its version, commit, compiler: bits may depend on them
//   content                  RunOrder, State, RunRecord
//
// Numbers are stored as in this machine's memory. The arrays of a state follow the
// table of fields (model/fields.h), so a new one is stored without further code.
#include "wythe/parts/checkpoint.h"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <iterator>
#include <tuple>
#include <utility>

#include "core/files.h"
#include "core/hash.h"
#include "core/limits.h"
#include "core/messages.h"
#include "io/bodies/blocks_json.h"
#include "io/text/archive.h"
#include "model/fields.h"
#include "wythe/parts/error.h"
#include "wythe/parts/io.h"
#include "wythe/parts/provenance.h"

namespace wythe {
namespace {

using io::ArchiveIn;
using io::ArchiveOut;
using io::Damaged;

constexpr char kMagic[] = "wythe checkpoint";
constexpr std::uint32_t kFormat = 2;

struct Head {
  char magic[16];
  std::uint32_t format, program_bytes;
  std::uint64_t content_bytes, model, others;
};
static_assert(sizeof(Head) == 48 && sizeof kMagic == 17, "no gaps");

std::string program() {
  const Provenance p = provenance();
  return fmt::format("wythe {} ({}, {}, {}, {})", p.version, p.commit, p.compiler, p.flags,
                     p.build_type);
}

Head head_of(std::string_view bytes) {
  Head head;
  std::memcpy(&head, bytes.data(), sizeof head);
  return head;
}

std::uint64_t hash_of(Head head, std::string_view rest) {
  head.others = 0;
  Hash hash;
  hash.add(&head, sizeof head);
  hash.add(rest);
  return hash.value();
}

// --- the content: A is ArchiveOut (then the rest is const) or ArchiveIn ------------------------------------------

// The numbers of a State beside its arrays. A member that is in no list fails the assertion.
template <class S>
auto state_numbers(S& s) {
  auto& p = s.progress;
  auto& e = s.energy;
  return std::tie(s.stage, s.step, s.time, p.time, s.gravity_x, s.gravity_y, s.gravity_z,
                  p.body_factor, p.load_factor, p.balance, p.drive_displacement, p.travelled,
                  p.control_start, p.control_moved, p.control_furthest, p.turn_time, p.pace,
                  p.target, p.first_step, p.last_growth, p.moved_then, e.work_loads, e.work_drive,
                  e.work_damping, e.dissipated_friction, e.dissipated_fracture,
                  e.dissipated_crushing, e.lost_in_hand_over);
}

constexpr std::size_t kStateArrays =
    kStateFields.size() + 3;  // with load_scale, free_contacts, hand_overs
static_assert(sizeof(State) ==
                  kStateArrays * sizeof(std::vector<double>) +
                      std::tuple_size_v<decltype(state_numbers(std::declval<State&>()))> *
                          sizeof(double),
              "a member of State is missing here or in the table of fields");

// Whether these are two bodies that may touch, with existing parts and an edge of one of them.
bool are_bodies(const Model& model, std::int32_t a, std::int32_t b) {
  return a >= 0 && a < b && a < model.n_block && b < model.n_block + model.free.n_fixed;
}
bool is_contact_of(const Model& model, const FreeContact& c) {
  const FreeShapes& f = model.free;
  const auto part = [&](std::int32_t body, std::int32_t number) {
    return number >= 0 && number < f.part_begin[body + 1] - f.part_begin[body]
               ? f.part_begin[body] + number
               : -1;
  };
  const std::int32_t a = part(c.a, c.part_a), b = part(c.b, c.part_b);
  if (a < 0 || b < 0 || f.corner_begin.empty()) return a >= 0 && b >= 0;
  const std::size_t i = c.feature < 0 ? b : a;
  const std::int32_t edge = c.feature < 0 ? -1 - c.feature : c.feature;
  return edge < f.corner_begin[i + 1] - f.corner_begin[i];
}

template <class A, class S>
void walk_free_contacts(A& archive, const Model& model, S& state) {
  archive.list(state.free_contacts, [&](auto& c) {
    archive(c);
    archive.require(are_bodies(model, c.a, c.b) && is_contact_of(model, c),
                    "it has a free contact of other blocks");
  });
  archive.list(state.hand_overs, [&](auto& h) {
    archive(h);
    archive.require(are_bodies(model, h.a, h.b), "it has a hand-over of other blocks");
  });
}

template <class A, class S>
void walk_state(A& archive, const Model& model, S& state) {
  std::apply([&](auto&... number) { (archive(number), ...); }, state_numbers(state));
  for (const StateField& field : kStateFields)
    archive.array(state.*field.array, count_of(model, field));
  archive.array(state.load_scale, model.stages.size());
  walk_free_contacts(archive, model, state);
  const std::size_t stage = state.stage;
  archive.require(state.stage >= 0 && stage < model.stages.size(), "it is in no stage");
  const std::size_t targets = model.stages[stage].targets().size();
  archive.require(
      state.progress.target >= 0 && static_cast<std::size_t>(state.progress.target) <= targets,
      "it pushes to no target");
}

template <class A, class M>
void walk_message(A& archive, M& message) {
  std::string data = message_json(message);
  archive(data);
  if constexpr (A::kReads) message = message_of(data, data);
}

template <class A, class S>
void walk_states(A& archive, const Model& model, S& snapshots) {
  archive.list(snapshots, [&](auto& snapshot) {
    auto& [label, displacement, reaction, state, asked] = snapshot;
    archive(label);
    archive(displacement);
    archive(reaction);
    walk_state(archive, model, state);
    archive(asked);
  });
}

template <class A, class R>
void walk_recording(A& archive, const Model& model, R& recording) {
  archive(recording.numbers);
  const RecordingNumbers& n = recording.numbers;
  archive.require(
      n.next_state >= 0 && static_cast<std::size_t>(n.next_state) <= model.output.states.size(),
      "it keeps no such state");
  archive.array(recording.slid_off, n.under_way != 0 ? static_cast<std::size_t>(model.n_joint) : 0);
  for (auto& one : recording.side) {
    auto& [peak, peak_displacement, furthest, balanced, peak_state] = one;
    archive(peak);
    archive(peak_displacement);
    archive(furthest);
    archive(balanced);
    bool has_state = !peak_state.load_scale.empty();
    archive(has_state);
    if (has_state) walk_state(archive, model, peak_state);
  }
}

// The number of blocks as in MovedBlocks.
std::size_t moved_blocks(const Model& model) {
  const Space& space = model.space;
  return static_cast<std::size_t>(model.n_block + space.n_support) + model.solids.bodies.size() +
         space.solids.bodies.size();
}

// Without members that the end of a stage or of the run writes again.
template <class A, class R>
void walk_result(A& archive, const Model& model, R& result) {
  const auto plain = [&](auto& item) { archive(item); };
  auto curve_of = static_cast<std::int64_t>(result.curve_of);
  archive(curve_of);
  archive.require(curve_of >= 0 && curve_of < std::ssize(kStageKindWords),
                  "its curve is of no stage");
  if constexpr (A::kReads) result.curve_of = static_cast<StageKind>(curve_of);
  archive.list(result.curve, plain);
  archive.list(result.rise, plain);
  archive.list(result.strengthening.links, plain);
  archive.require(
      result.strengthening.links.empty() ||
          result.strengthening.links.size() == result.curve.size() * model.links.a.size(),
      "it has rows of other links");
  archive.list(result.strengthening.frame_rows, plain);
  archive.require(
      result.strengthening.frame_rows.empty() ||
          result.strengthening.frame_rows.size() == result.curve.size() * model.frames.a.size(),
      "it has rows of other frames");
  archive.list(result.strengthening.layer_rows, plain);
  archive.require(
      result.strengthening.layer_rows.empty() ||
          result.strengthening.layer_rows.size() == result.curve.size() * model.layers.name.size(),
      "it has rows of other layers");
  archive.list(result.joint_crack_displacement, plain);
  const std::size_t joints = result.joint_crack_displacement.size();
  archive.require(joints == 0 || joints == static_cast<std::size_t>(model.n_joint),
                  "it has cracks of other joints");
  auto& [overlap_lost, joints_off, where_off] = result.validity;
  archive(overlap_lost);
  archive(joints_off);
  walk_message(archive, where_off);
  archive.list(result.events, [&](auto& event) {
    auto& [name, displacement, reaction, where, is_beyond_limit] = event;
    walk_message(archive, name);
    archive(displacement);
    archive(reaction);
    walk_message(archive, where);
    archive(is_beyond_limit);
  });
  archive.list(result.stages, [&](auto& stage) {
    auto& [name, time, steps, unbalance_ratio, settled] = stage;
    archive(name);
    archive(time);
    archive(steps);
    archive(unbalance_ratio);
    archive(settled);
  });
  auto& [points, rows, motion, storeys, heights, tops] = result.history;
  archive.list(points, plain);
  archive.list(rows, plain);
  archive.list(motion, plain);
  archive.require(motion.size() == rows.size() * points.size(), "it has rows of other points");
  archive.list(storeys, plain);
  archive.list(heights, plain);
  archive.list(tops, plain);
  archive.require(heights.size() == storeys.size() && tops.size() == rows.size() * storeys.size(),
                  "it has rows of other storeys");
  archive(result.load_factor);
  archive(result.wall_seconds);
  walk_states(archive, model, result.states.snapshots);
  walk_states(archive, model, result.states.readings);
  archive.list(result.states.rise_shapes, [&](auto& shape) {
    archive(shape.displacement);
    archive.array(shape.moved, moved_blocks(model));
  });
  walk_states(archive, model, result.states.frames);
}

template <class A, class O>
void walk_order(A& archive, O& order) {
  auto& [model_file, model_text, blocks, language, every] = order;
  archive(model_file);
  archive(model_text);
  archive(blocks);
  archive(language);
  archive(every);
}

// --- the file -------------------------------------------------------------------------------------------

[[noreturn]] void refuse(const std::string& path, const std::string& problem,
                         const std::string& cure) {
  throw InputError({{.file = path, .problem = problem, .cure = cure}});
}

constexpr const char* kAgain = "remove it and start the run again";

// Reads the whole file; its size must be that in its header.
std::string read_all(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(std::filesystem::symlink_status(path, error)))
    refuse(path,
           "there is no checkpoint: the run was started without --checkpoint, had not yet written "
           "one, or came to its end",
           "start it with: wythe run MODEL.toml --out DIR --checkpoint \"60 s\"");
  check_output(path);  // a link may lead to a file of another user
  std::string bytes = read_file(path, kMostCheckpoint);
  if (bytes.size() < sizeof(Head))
    refuse(path, bytes.empty() ? "is empty" : fmt::format("is cut short: {} bytes", bytes.size()),
           kAgain);
  const Head head = head_of(bytes);
  if (std::memcmp(head.magic, kMagic, sizeof head.magic) != 0)
    refuse(path, "is no checkpoint of wythe", kAgain);
  if (head.format != kFormat)
    refuse(path, fmt::format("has format {}, this program reads {}", head.format, kFormat),
           "go on with the program that wrote it, or remove it and start the run again");
  const std::size_t rest = bytes.size() - sizeof head;
  if (head.program_bytes > rest || head.content_bytes != rest - head.program_bytes)
    refuse(path,
           fmt::format("is cut short or has more in it: {} bytes in the place of {}", rest,
                       head.content_bytes + head.program_bytes),
           kAgain);
  return bytes;
}

}  // namespace

RunOrder order_of(const ModelSpec& spec, const std::string& model_file) {
  return {.model_file = model_file,
          .model_text = write_model(spec),
          .blocks = spec.block.empty() && spec.body.empty() ? "" : io::blocks_text(spec, true),
          .language = "en"};
}

std::string checkpoint_bytes(const RunOrder& order, const Model& model, const State& state,
                             const RunRecord& record) {
  ArchiveOut archive;
  walk_order(archive, order);
  walk_state(archive, model, state);
  walk_recording(archive, model, record.recording);
  walk_result(archive, model, record.result);
  const std::string content = archive.take(), who = program();
  Head head{};
  std::memcpy(head.magic, kMagic, sizeof head.magic);
  head.format = kFormat;
  head.program_bytes = static_cast<std::uint32_t>(who.size());
  head.content_bytes = content.size();
  head.model = model.spec_hash;
  if (content.size() > kMostCheckpoint)
    throw IoError(fmt::format("the checkpoint has {} bytes, more than is read", content.size()));
  head.others = hash_of(head, who + content);
  return std::string(reinterpret_cast<const char*>(&head), sizeof head) + who + content;
}

Checkpoint read_checkpoint(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / kCheckpointFile).string();
  const std::string bytes = read_all(path);
  const Head head = head_of(bytes);
  const std::string_view rest = std::string_view(bytes).substr(sizeof head);
  if (hash_of(head, rest) != head.others)
    refuse(path, "is damaged: its content is not what was written", kAgain);
  const std::string_view who = rest.substr(0, head.program_bytes);
  if (who != program())
    refuse(path, fmt::format("was written by {}; this is {}", who, program()),
           "go on with that program, for another may give other bits; or remove it and start the "
           "run again");
  try {
    Checkpoint c;
    ArchiveIn archive(rest.substr(head.program_bytes));
    walk_order(archive, c.order);
    c.spec = parse_model(c.order.model_text, c.order.model_file, {}, c.order.blocks);
    if (spec_hash(c.spec) != head.model) refuse(path, "is of another model than it says", kAgain);
    c.model = compile(c.spec);
    c.model.spec_hash = head.model;
    walk_state(archive, c.model, c.state);
    walk_recording(archive, c.model, c.record.recording);
    walk_result(archive, c.model, c.record.result);
    archive.require(archive.at_end(), "more follows than belongs to it");
    return c;
  } catch (const Damaged& what) {
    refuse(path, fmt::format("is damaged: {}", what.what()), kAgain);
  }
}

}  // namespace wythe
