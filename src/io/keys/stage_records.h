// The records of every kind of stage beside each other, because visitors see the keys of all kinds
// (describe.h). A key that several kinds have is in `push`.
#pragma once

#include <variant>

#include "wythe/parts/wall_spec.h"

namespace wythe::io {

struct StageRecords {
  LoadStage load = {};
  PushStage push = {};
  BodyForceStage body_force = {};
  TiltStage tilt = {};
  HoldStage hold = {};
  ShakeStage shake = {};

  explicit StageRecords(const StageAction& action) {
    if (const auto* s = std::get_if<LoadStage>(&action))
      load = *s, push.at = s->at, push.as = s->as, push.on = s->on, push.drive.along = s->along;
    if (const auto* s = std::get_if<PushStage>(&action)) push = *s;
    if (const auto* s = std::get_if<BodyForceStage>(&action))
      body_force = *s, push.drive = s->drive;
    if (const auto* s = std::get_if<TiltStage>(&action)) tilt = *s, push.drive = s->drive;
    if (const auto* s = std::get_if<HoldStage>(&action)) hold = *s;
    if (const auto* s = std::get_if<ShakeStage>(&action)) shake = *s, push.fixity = s->fixity;
  }

  // The record of one kind.
  [[nodiscard]] StageAction of(StageKind kind) {
    load.at = push.at, load.as = push.as, load.on = push.on, load.along = push.drive.along;
    body_force.drive = tilt.drive = push.drive;
    shake.fixity = push.fixity;
    switch (kind) {
      case StageKind::kGravity: return GravityStage{};
      case StageKind::kLoad: return load;
      case StageKind::kPush: return push;
      case StageKind::kBodyForce: return body_force;
      case StageKind::kTilt: return tilt;
      case StageKind::kHold: return hold;
      case StageKind::kShake: return shake;
      case StageKind::kCut: return CutStage{};
    }
    return GravityStage{};
  }
};

}  // namespace wythe::io
