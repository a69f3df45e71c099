// Many runs: uncertain inputs, campaigns and their stores, statistics, options side by side, the verdict on a wall.
//
//   StudySpec ──► run_campaign() ──► Campaign ──► statistics, comparison, verdict
#pragma once

#include "wythe/parts/batch.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/shards.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/stored_states.h"
#include "wythe/parts/study.h"
#include "wythe/parts/study_notes.h"
#include "wythe/parts/verdict.h"
