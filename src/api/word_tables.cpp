// Checks at compile time that each table of words of a public header names every enumerator once and no
// word twice (wythe/parts/words.h). The checks are here and not beside the tables, where they took a second
// for each source with these headers, a fifth of the whole build. tools/check_layers finds a missing table.
#include "wythe/parts/assessment.h"
#include "wythe/parts/builder.h"
#include "wythe/parts/comparison.h"
#include "wythe/parts/contact_law.h"
#include "wythe/parts/field.h"
#include "wythe/parts/free_contacts.h"
#include "wythe/parts/limit.h"
#include "wythe/parts/masonry.h"
#include "wythe/parts/model.h"
#include "wythe/parts/result.h"
#include "wythe/parts/statistics.h"
#include "wythe/parts/study.h"
#include "wythe/parts/wall_spec.h"
#include "wythe/parts/zone_spec.h"

namespace wythe {

// assessment.h
static_assert(names_all(kGroundTypeWords));
static_assert(names_all(kAssessmentCodeWords));
static_assert(names_all(kLimitStateWords));
static_assert(names_all(kAssessmentVerdictWords));

// builder.h
static_assert(names_all(kMeetingWords));

// comparison.h
static_assert(names_all(kChangeAnswerWords));

// contact_law.h
static_assert(names_all(kSofteningWords));
static_assert(names_all(kCouplingWords));
static_assert(names_all(kUnloadingWords));

// field.h
static_assert(names_all(kDistributionWords));
static_assert(names_all(kFieldByWords));
static_assert(names_all(kFieldKernelWords));

// free_contacts.h
static_assert(names_all(kContactsWords));

// limit.h
static_assert(names_all(kJointStrengthWords));
static_assert(names_all(kFrictionChoiceWords));
static_assert(names_all(kCrushingChoiceWords));
static_assert(names_all(kChainEndWords));
static_assert(names_all(kHypothesisWords));

// masonry.h
static_assert(names_all(kUnitTypeWords, 1));  // kUnstated is not written

// model.h
static_assert(names_all(kBlockRoleWords));
static_assert(names_all(kJointKindWords));
static_assert(names_all(kJointKindCodes));
static_assert(names_all(kLinkKindWords));

// result.h
static_assert(names_all(kSolveStatusWords));

// statistics.h
static_assert(names_all(kFragilityVerdictWords));
static_assert(names_all(kFragilityLawWords));
static_assert(names_all(kIndexVerdictWords));
static_assert(names_all(kLimitStateVerdictWords));
static_assert(names_all(kScatterVerdictWords));

// study.h
static_assert(names_all(kDesignWords));
static_assert(names_all(kIntensityMeasureWords));
static_assert(names_all(kPairingWords));

// wall_spec.h
static_assert(names_all(kBondWords));
static_assert(names_all(kSplitWords));
static_assert(names_all(kFitWords));
static_assert(names_all(kFreedomWords));
static_assert(names_all(kLintelModelWords));
static_assert(names_all(kDirectionWords));
static_assert(names_all(kArchKindWords, 1));   // kNone is not written
static_assert(names_all(kFrameFeetWords, 1));  // kNone is not written
static_assert(names_all(kDiaphragmKindWords));
static_assert(names_all(kStageKindWords));
static_assert(names_all(kMannerWords, 1));      // kDefault is not written
static_assert(names_all(kPatternWords, 1));     // kNone is not written
static_assert(names_all(kRecordUnitWords, 1));  // kNone is not written
static_assert(names_all(kPulseShapeWords, 1));  // kNone is not written
static_assert(names_all(kPointRuleWords, 1));   // kDefault is not written
static_assert(names_all(kDampingFormWords));
static_assert(names_all(kSpectrumKindWords, 1));  // kNone is not written
static_assert(names_all(kFallWords));

// zone_spec.h
static_assert(names_all(kZoneKindWords));
static_assert(names_all(kPlaneWords));

}  // namespace wythe
