// The result of a run (curve, numbers, evidence) and its interpretation: failure mode, comparison with tests, assessment by codes.
//
//   Result ──► name_failure_mode(model, result) ──► FailureMode          assess_run(spec, model, result) ──► CodeAssessment
#pragma once

#include "wythe/parts/assessment.h"
#include "wythe/parts/curve.h"
#include "wythe/parts/element_forces.h"
#include "wythe/parts/failure_mode.h"
#include "wythe/parts/local_check.h"
#include "wythe/parts/mechanism.h"
#include "wythe/parts/pushed_wall.h"
#include "wythe/parts/responses.h"
#include "wythe/parts/result.h"
#include "wythe/parts/shaking.h"
#include "wythe/parts/slow_push.h"
#include "wythe/parts/tested_range.h"
