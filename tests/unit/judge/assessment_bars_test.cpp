// Cases without an assessment: its push must begin at rest and
// without force, and samples must share mass and spectrum.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "campaign/store/store.h"
#include "judge/assessment/assessment_parts.h"
#include "scenes/changed_store.h"
#include "scenes/small_study.h"
#include "unit/assessed_wall.h"
#include "wythe/parts/campaign.h"
#include "wythe/parts/error.h"
#include "wythe/parts/solve.h"
#include "wythe/parts/stored_states.h"

namespace wythe::assessment_bars_test {
namespace {

using namespace test;

// The wall of kAssessed with one more stage before its push.
std::string wall_with(const std::string& stage, const std::string& more = "") {
  std::string text = wall_text(kAssessed + more);
  const std::string push = "[[stage]]\nname = \"push\"\n";
  return text.insert(text.find(push), stage);
}
// Why a push of this file with a plain curve gets no answer.
Message why_not(const std::string& text) {
  const ModelSpec spec = parse_model(text, "wall.toml");
  Result result;
  result.curve = curve_of({});
  result.responses = read_responses(result.curve);
  const Model model = compile(spec);
  const CodeAssessment a = assess_run(spec, model, result);
  EXPECT_EQ(a.limit_states.empty(), !a.reason.empty());
  EXPECT_EQ(a.may_be_signed && !a.reason.empty(), false);
  return a.reason;
}

TEST(Assessment, has_no_answer_where_another_stage_drove_the_wall_before) {
  EXPECT_EQ(why_not(wall_with("")).code, "");
  EXPECT_EQ(why_not(wall_with("[[stage]]\nname = \"wait\"\nduration = \"0.1 s\"\n")).code, "");
  const Message pushed_twice =
      why_not(wall_with("[[stage]]\nname = \"first\"\nat = { x = \"0 m\", y = \"0.9 m\" }\n"
                        "direction = \"+x\"\nvelocity = \"20 mm/s\"\nuntil = \"2 mm\"\n"));
  EXPECT_EQ(pushed_twice.code, "assessment.driven_before");
  EXPECT_TRUE(says(pushed_twice, "first"));
  for (const char* direction : {"+x", "-x"}) {
    const std::string towards = std::string("direction = \"") + direction + "\"\n";
    EXPECT_EQ(
        why_not(wall_with("[[stage]]\nname = \"g\"\nrate = \"1 1/s\"\nfactor = 0.1\n" + towards))
            .code,
        "assessment.held_before");
    EXPECT_EQ(why_not(wall_with("[[stage]]\nname = \"g\"\ntilt_rate = \"1 deg/s\"\n"
                                "tilt_until = \"2 deg\"\n" +
                                towards))
                  .code,
              "assessment.held_before");
  }
}

TEST(Assessment, has_no_answer_where_a_dead_load_acts_along_the_push) {
  const auto floor = [](const std::string& name, const std::string& thrust) {
    return "[[floor]]\nname = \"" + name + "\"\ny = \"0.75 m\"\nload = \"20 kN/m\"\nthrust = \"" +
           thrust + "\"\n";
  };
  EXPECT_EQ(why_not(wall_with("", floor("a", "0 kN"))).code, "");
  EXPECT_EQ(why_not(wall_with("", floor("a", "2 kN"))).code, "assessment.thrust");
  EXPECT_EQ(why_not(wall_with("", floor("a", "-2 kN"))).code, "assessment.thrust");
  // what cancels in the sum still stands on the wall
  EXPECT_EQ(why_not(wall_with("", floor("a", "2 kN") + floor("b", "-2 kN"))).code,
            "assessment.thrust");
  // a tie that was drawn taut against a rigid anchor pulls at the wall too; one within it does not
  const std::string tie =
      "[[tie]]\nname = \"t\"\nfrom = { x = \"0.9 m\", y = \"0.6 m\" }\n"
      "area = \"100 mm^2\"\nyoungs_modulus = \"200 GPa\"\nprestress = \"50 MPa\"\n";
  EXPECT_EQ(
      why_not(wall_with("", tie + "anchored = true\nto = { x = \"2 m\", y = \"0.6 m\" }\n")).code,
      "assessment.thrust");
  EXPECT_EQ(why_not(wall_with("", tie + "to = { x = \"0.1 m\", y = \"0.6 m\" }\n")).code, "");
}

// All samples are judged with the mass and the spectrum of the base model: they must share them.
TEST(CampaignAssessment, has_no_answer_where_samples_do_not_share_mass_and_spectrum) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  const auto assessed = [&](const Campaign& campaign) {
    Statistics statistics = statistics_of(campaign);
    statistics.assessment = assess_campaign(campaign, base, model);
    return nlohmann::json::parse(statistics_json(statistics)).at("assessment");
  };
  for (const char* path : {"material.joint.cohesion", "masonry.masonry_strength", "",
                           "stage.push.velocity", "stage.push.damping", "stage.push.until"}) {
    Campaign campaign = campaign_of(25);
    campaign.study.variable.emplace_back().path = path;
    EXPECT_EQ(assessed(campaign).at("limit_states").size(), 3u) << path;
  }
  const auto refused = [&](const Campaign& campaign, const std::string& path) {
    const auto json = assessed(campaign);
    EXPECT_TRUE(json.at("limit_states").empty()) << path;
    ASSERT_TRUE(json.contains("reason")) << path;
    EXPECT_NE(json.at("reason").dump().find(path), std::string::npos) << path;
    EXPECT_EQ(json.at("answered"), 0);
    EXPECT_EQ(json.at("not_to_be_signed"), 25);  // none beside a reason is
    EXPECT_NE(json.at("sentence").dump().find("has no answer"), std::string::npos);
    EXPECT_EQ(json.at("notes").dump().find("base_mass"), std::string::npos);
  };
  for (const char* path : {"floor.roof.load", "wall.thickness", "wall.unit.density",
                           "material.lintel.density", "storey.0.height", "stage.floor.pressure",
                           "assessment.spectrum.ground_acceleration", "solve.gravity"}) {
    Campaign campaign = campaign_of(25);
    campaign.study.variable.emplace_back().path = "material.joint.cohesion";
    Campaign of_dependent = campaign, of_field = campaign;
    campaign.study.variable.emplace_back().path = path;
    refused(campaign, path);
    of_dependent.study.dependent.emplace_back().path = path;
    refused(of_dependent, path);
    of_field.study.field.push_back({.name = "f", .path = path});
    refused(of_field, path);
  }
}

TEST(CampaignAssessment, has_no_answer_where_its_push_has_none) {
  const ModelSpec base = parse_model(
      wall_with("[[stage]]\nname = \"g\"\nrate = \"1 1/s\"\nfactor = 0.1\n"), "wall.toml");
  const CampaignAssessment a = assess_campaign(campaign_of(25), base, compile(base));
  EXPECT_TRUE(a.fragility.empty());
  EXPECT_EQ(a.answered, 0);
}

TEST(Assessment, with_mass_of_floors_that_nothing_counts_is_not_signed) {
  const auto cautioned = [](const std::string& more, double added_mass) {
    ModelSpec spec = parse_model(
        wall_text(kAssessed + std::string("[[floor]]\nname = \"f\"\ny = \"0.75 m\"\n") + more),
        "wall.toml");
    spec.assessment.added_mass = added_mass;
    const Model model = compile(spec);
    const CodeAssessment a = assess_run(spec, model, {});
    const bool found = !a.cautions.empty() && says(a.cautions.front(), "floors f");
    EXPECT_EQ(says(a.sentence, "floors f"), found);
    EXPECT_EQ(says(sentence_of(assess_campaign(campaign_of(25), spec, model)), "floors f"), found);
    return found;
  };
  // 1 m of wall
  EXPECT_TRUE(cautioned("mass = \"2000 kg/m\"\n", 0));
  EXPECT_TRUE(cautioned("mass = \"2000 kg/m\"\n", 300));
  EXPECT_FALSE(cautioned("mass = \"2000 kg/m\"\n", 2000));
  EXPECT_TRUE(cautioned("load = \"10 kN/m\"\nmass = \"2000 kg/m\"\n", 900));
  EXPECT_FALSE(cautioned("load = \"10 kN/m\"\nmass = \"2000 kg/m\"\n", 1000));
  EXPECT_FALSE(cautioned("load = \"10 kN/m\"\n", 0));
}

// --- samples with drifts of their own

// Two piers beside a door, their mortar random.
StudySpec facade_study(int samples) {
  const std::string model = R"([wall]
length = "1.6 m"
height = "1.0 m"
thickness = "0.2 m"
[wall.unit]
length = "200 mm"
height = "100 mm"
split = "none"
density = "2000 kg/m^3"
[[wall.opening]]
x = "0.6 m"
y = "0 m"
width = "0.4 m"
height = "0.6 m"
[material.joint]
normal_stiffness = "5 GPa/m"
shear_stiffness = "2 GPa/m"
tensile_strength = "0.1 MPa"
cohesion = "0.1 MPa"
residual_cohesion = "0 MPa"
friction_angle = "30 deg"
residual_friction_angle = "30 deg"
mode_1_energy = "4 N/m"
mode_2_energy = "40 N/m"
compressive_strength = "unlimited"
[[stage]]
name = "gravity"
[[stage]]
name = "floor"
pressure = "0.1 MPa"
[[stage]]
name = "push"
at = { x = "0 m", y = "0.95 m" }
velocity = "4 mm/s"
damping = 0.1
until = "10 mm"
[output]
rows = 200
[assessment]
code = "circolare_2019"
limit_state = "near_collapse"
added_mass = "900 kg"
added_height = "0.8 m"
[assessment.spectrum]
kind = "en1998"
ground_acceleration = "2 m/s^2"
ground = "B"
)";
  return parse_study("[study]\nname = \"facade\"\nmodel = \"facade.toml\"\nmodel_text = '''\n" +
                         model + "'''\nsamples = " + std::to_string(samples) +
                         "\nseed = 5\n[variable.ft]\npath = "
                         "\"material.joint.tensile_strength\"\nunit = \"MPa\"\n"
                         "distribution = \"uniform\"\nlow = \"0.08 MPa\"\n"
                         "high = \"0.16 MPa\"\n",
                     "facade_study.toml");
}

// A store and its base model.
struct Facade {
  explicit Facade(const std::string& folder, int samples = 4) : study(facade_study(samples)) {
    run_campaign(study, model_builder(study), folder, {.jobs = 2});
    campaign = read_campaign(folder);
    base = model_builder(study)({});
    model = compile(base);
  }
  StudySpec study;
  Campaign campaign;
  ModelSpec base;
  Model model;
};

TEST(CampaignAssessment, of_a_facade_is_that_of_its_runs) {
  const scenes::TemporaryFolder folder;
  const Facade f(folder / "out");
  ASSERT_EQ(f.campaign.records.size(), 4U);
  // what statistics read is enough: a name without its scores would be firm
  const Campaign answers = read_answers(folder / "out");
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_FALSE(answers.records[k].failure_mode.scores.empty());
    EXPECT_EQ(texts_of(assess_sample(answers.records[k], f.base, f.model).cautions),
              texts_of(assess_sample(f.campaign.records[k], f.base, f.model).cautions));
  }
  std::vector<double> accelerations, masses;
  SolveOptions options;
  options.frames = 40;
  for (const SampleRecord& record : f.campaign.records) {
    const SampleRun run =
        run_sample(f.study, f.campaign.samples, record.sample, model_builder(f.study), options);
    ASSERT_GE(run.result.pushed.piers.size(), 2U);
    // as `wythe run` of this sample says, with its frames and from its own states
    Result result = run.result;
    result.pushed = {};
    const CodeAssessment own = assess_run(run.spec, run.model, result),
                         stored = assess_sample(record, f.base, f.model);
    ASSERT_TRUE(own.reason.empty()) << text_of(own.reason);
    EXPECT_EQ(stored.verdict, own.verdict);
    std::vector<Message> cautions = stored.cautions;  // a run is one push alone, and says so
    cautions.push_back({"assessment.caution.one_push"});
    EXPECT_EQ(texts_of(cautions), texts_of(own.cautions));
    EXPECT_FALSE(own.may_be_signed);
    EXPECT_EQ(stored.mass.participating, own.mass.participating);
    EXPECT_EQ(stored.mass.participation, own.mass.participation);
    EXPECT_FALSE(stored.mass.is_linear);
    masses.push_back(own.mass.participating);
    ASSERT_EQ(stored.limit_states.size(), own.limit_states.size());
    for (std::size_t k = 0; k < own.limit_states.size(); ++k) {
      const LimitStateCheck &a = own.limit_states[k], &b = stored.limit_states[k];
      EXPECT_EQ(b.displacement, a.displacement);
      EXPECT_EQ(b.acceleration, a.acceleration);
      EXPECT_EQ(b.governing, a.governing);
      EXPECT_EQ(b.at_least, a.at_least);
      ASSERT_EQ(b.criteria.size(), a.criteria.size());
      for (std::size_t c = 0; c < a.criteria.size(); ++c)
        EXPECT_EQ(b.criteria[c].displacement, a.criteria[c].displacement);
      if (a.is_asked && !a.at_least) accelerations.push_back(a.acceleration);
    }
  }
  const CampaignAssessment all = assess_campaign(f.campaign, f.base, f.model);
  EXPECT_EQ(all.answered, 4);
  std::sort(masses.begin(), masses.end());
  EXPECT_EQ(all.mass.participating,
            masses[1]);  // of the sample in the middle, not a linear shape's
  EXPECT_FALSE(all.mass.is_linear);
  for (const Message& say : cautions_of(all)) EXPECT_NE(say.code, "assessment.caution.whole_drift");
  std::sort(accelerations.begin(), accelerations.end());
  std::vector<double> points;
  for (const PgaFragility& of : all.fragility)
    for (const ExceedancePoint& p : of.point)
      if (of.is_checked) points.push_back(p.value);
  for (const double a : accelerations)
    EXPECT_NE(std::find(points.begin(), points.end(), a), points.end()) << a;
  EXPECT_FALSE(accelerations.empty());
}

// The weakest pier ends a wall, not the mean of piers: a pier with more drift
// lowers the result, and one that never reaches its limit makes it a bound.
TEST(CampaignAssessment, follows_the_drift_of_each_pier) {
  const scenes::TemporaryFolder folder;
  const Facade f(folder / "out", 2);
  SampleRecord record = f.campaign.records.front();
  record.failure_mode.elements.clear();  // mechanisms are not known: the lesser limit
  record.responses.censored_80 = true;   // the fall of the force ends nothing
  record.responses.displacement_at_80 = record.curve.back().displacement;
  const auto scaled = [&](double drift) {
    SampleRecord other = record;
    for (PierDrift& pier : other.pushed.piers)
      for (DriftPoint& at : pier.drifts) at.drift = drift * at.displacement;
    return *assess_sample(other, f.base, f.model).asked();
  };
  const LimitStateCheck early = scaled(2), late = scaled(1), never = scaled(1e-3);
  EXPECT_FALSE(early.at_least);
  EXPECT_NEAR(early.displacement, 2.5e-3, 1e-9);
  EXPECT_NEAR(late.displacement, 5e-3, 1e-9);
  EXPECT_TRUE(never.at_least);
  EXPECT_LT(early.acceleration, late.acceleration);
}

TEST(CampaignAssessment, is_not_signed_where_a_sample_lacks_its_pushed_wall) {
  const scenes::TemporaryFolder folder;
  Facade f(folder / "out", 2);
  f.campaign.records.back().pushed = {};  // one is enough
  const CampaignAssessment a = assess_campaign(f.campaign, f.base, f.model);
  EXPECT_EQ(a.doubtful, a.answered);
  EXPECT_EQ(text_of(sentence_of(a)).find("not to be signed: drifts of the samples"), 0U)
      << text_of(sentence_of(a));
}

// Drifts that somebody took away, or put elsewhere, would be drifts of another wall.
TEST(CampaignAssessment, refuses_a_store_whose_drifts_do_not_belong_together) {
  const scenes::TemporaryFolder folder;
  const Facade f(folder / "out", 2);
  const auto said = [&] {
    try {
      (void)read_campaign(folder / "out");
    } catch (const IoError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const auto change = [&](const std::string& sql) {
    study::Database(study::store_path(folder / "out"), study::Database::Access::kWrite)
        .execute(sql);
    scenes::renew_checksums(folder / "out");
  };
  EXPECT_EQ(said(), "");
  const std::string other = "ATTACH '" + (folder / "kept.db") + "' AS other; ";
  change(other + "CREATE TABLE other.kept AS SELECT * FROM pier_drift");
  change(
      "DELETE FROM pier_drift WHERE sample = 1 AND position = (SELECT max(position) FROM "
      "pier_drift WHERE sample = 1)");
  EXPECT_NE(said().find("a pier's drift is missing"), std::string::npos) << said();
  change("DELETE FROM pier_drift");
  change(other + "INSERT INTO pier_drift SELECT * FROM other.kept");
  EXPECT_EQ(said(), "");
  change("UPDATE pier_drift SET displacement_m = 0.5 WHERE sample = 2 AND position = 1");
  EXPECT_NE(said().find("are not those of its states"), std::string::npos) << said();
  change("DELETE FROM pier_drift WHERE sample = 2");
  const CampaignAssessment without =
      assess_campaign(read_campaign(folder / "out"), f.base, f.model);
  EXPECT_EQ(cautions_of(without).front().code, "assessment.caution.whole_drift");
  change("UPDATE moved SET displacement_m = 0 WHERE sample = 1 AND position = 1");
  EXPECT_NE(said().find("are not in order"), std::string::npos) << said();
}

// A wall that falls ends between two readings: shapes of its rise go on beyond the last, but not to the next.
TEST(CampaignAssessment, shapes_may_end_between_the_last_reading_and_the_next) {
  const scenes::TemporaryFolder folder;
  const Facade f(folder / "out", 2);
  const auto open = [&] {
    return study::Database(study::store_path(folder / "out"), study::Database::Access::kWrite);
  };
  const std::int64_t last = open().integer("SELECT max(position) FROM moved WHERE sample = 1");
  const auto said_with_a_shape = [&](double millimetres) {
    open().execute(fmt::format(
        "DELETE FROM moved WHERE sample = 1 AND position > {0}; INSERT INTO moved "
        "SELECT sample, position + 1, (CAST(1000 * displacement_m AS INTEGER) + {1}) / 1000, "
        "first_kg_m, second_kg_m2, mixed_kg_m2, storey_drift FROM moved WHERE sample = 1 "
        "AND position = {0}",
        last, millimetres));
    scenes::renew_checksums(folder / "out");
    try {
      (void)read_campaign(folder / "out");
    } catch (const IoError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(said_with_a_shape(0.999), "");
  const std::string said = said_with_a_shape(1.001);
  EXPECT_NE(said.find("a pier's drift is missing"), std::string::npos) << said;
}

// --- what a campaign must not vouch for

// Walls that fell before the push, or failed in the computation, carry nothing; the others would speak for them.
TEST(CampaignAssessment, is_not_signed_where_samples_were_lost) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  Campaign campaign = campaign_of(25);
  EXPECT_TRUE(cautions_of(assess_campaign(campaign, base, model)).empty());
  for (const char* status : {"collapsed", "unstable", "not_settled", "refused", "interrupted"}) {
    Campaign other = campaign;
    SampleRecord& lost = other.records.emplace_back();
    lost.sample = 26, lost.status = status;
    const CampaignAssessment a = assess_campaign(other, base, model);
    EXPECT_EQ(a.without_answer, 1) << status;
    EXPECT_EQ(a.doubtful, 25) << status;
    EXPECT_TRUE(says(sentence_of(a), "not to be signed: 1 of 26 samples have no answer")) << status;
  }
  // one of very many is within the whole per cents that are told
  Campaign many = campaign_of(200);
  many.records.emplace_back().status = "unstable";
  EXPECT_TRUE(cautions_of(assess_campaign(many, base, model)).empty());
}

TEST(CampaignAssessment, is_not_signed_for_a_median_that_no_sample_showed) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  Campaign campaign = campaign_of(30, 4e-3);  // ended early: bounds
  const Campaign whole = campaign_of(30);
  for (const int i : {3, 12, 20}) campaign.records[i] = whole.records[i];
  const CampaignAssessment a = assess_campaign(campaign, base, model);
  EXPECT_TRUE(says(sentence_of(a), "27 of 30 samples gave lower bounds alone"))
      << text_of(sentence_of(a));
  EXPECT_EQ(a.doubtful, 30);
}

// Pushes both ways are no capacity of one direction.
TEST(CampaignAssessment, has_no_answer_for_samples_pushed_both_ways) {
  const ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const Model model = compile(base);
  Campaign campaign = campaign_of(25);
  for (SampleRecord& record : campaign.records) record.responses.cyclic.sense = 1;
  EXPECT_EQ(assess_campaign(campaign, base, model).answered, 0);
  campaign.records.front().responses.cyclic.sense = 0;  // and some of each is not signed
  EXPECT_TRUE(says(sentence_of(assess_campaign(campaign, base, model)), "24 of 25 samples"));
}

// Samples without a stored wall: the drift of several piers is not known; that of a single pier is the wall's.
TEST(CampaignAssessment, of_more_than_one_pier_says_first_that_drifts_are_of_the_whole_wall) {
  const auto assessed = [](const std::string& openings) {
    std::string text = wall_text(kAssessed);
    text = "[wall]\nlength = \"3.0 m\"\n" + text.substr(text.find("height = "));
    const ModelSpec base = parse_model(text + openings, "wall.toml");
    return assess_campaign(campaign_of(25), base, compile(base));
  };
  const CampaignAssessment one = assessed("");
  EXPECT_TRUE(cautions_of(one).empty());
  EXPECT_TRUE(says(sentence_of(one), "near collapse: half of the walls carry"))
      << text_of(sentence_of(one));
  ModelSpec base = parse_model(wall_text(kAssessed), "wall.toml");
  const CampaignAssessment none = assess_campaign(campaign_of(3, 1.9e-3), base, compile(base));
  EXPECT_EQ(none.doubtful, 3);
  EXPECT_TRUE(says(sentence_of(none), "no sample has one; the first: the force still rises"))
      << text_of(sentence_of(none));
  const CampaignAssessment two = assessed(
      "[[wall.opening]]\nname = \"o\"\nx = \"1 m\"\ny = \"0 m\"\nwidth = \"1 m\"\n"
      "height = \"0.5 m\"\n");
  EXPECT_EQ(two.doubtful, 25);
  EXPECT_EQ(text_of(sentence_of(two))
                .find("not to be signed: drifts of the samples are those of the whole"),
            0u)
      << text_of(sentence_of(two));
}

TEST(Assessment, notes_masses_and_spectra_that_are_more_often_a_slip) {
  const auto notes = [](ModelSpec spec) {
    const CodeAssessment a = assess_run(spec, compile(spec), {});
    std::string all;
    for (const Message& note : a.notes) all += note.code + " ";
    return all;
  };
  const auto has = [](const std::string& all, const char* what) {
    return all.find(std::string("assessment.note.") + what) != std::string::npos;
  };
  const std::string floor = "[[floor]]\nname = \"f\"\ny = \"0.75 m\"\n";
  ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  for (const char* what : {"table_start", "floor_mass", "added_height"})
    EXPECT_FALSE(has(notes(spec), what)) << what;
  const auto with = [&](const std::string& more) {
    return notes(parse_model(wall_text(kAssessed + floor + more), "wall.toml"));
  };
  EXPECT_TRUE(has(with("mass = \"2000 kg/m\"\n"), "floor_mass"));
  EXPECT_TRUE(has(with("load = \"10 kN/m\"\nmass = \"2000 kg/m\"\n"), "floor_mass"));
  EXPECT_FALSE(has(with("load = \"10 kN/m\"\nmass = \"1000 kg/m\"\n"), "floor_mass"));
  spec.assessment.added_height = 1.5;
  EXPECT_TRUE(has(notes(spec), "added_height"));
  SpectrumSpec& s = spec.assessment.spectrum;
  s.kind = SpectrumKind::kNtc2018, s.corner_period = 0.3, s.amplification = 1.5;
  EXPECT_TRUE(faults_of(s).empty());
  s.amplification = 0.9;
  EXPECT_EQ(faults_of(s).size(), 1u);
  s.kind = SpectrumKind::kTable, s.periods = {0, 1}, s.accelerations = {0.01, 5};
  EXPECT_TRUE(has(notes(spec), "table_start"));
}

// A density of 180 kg/m^3 makes a wall ten times as strong as its demand: a note alone left such a verdict to be signed.
TEST(Assessment, inputs_that_no_masonry_has_bar_the_signature) {
  ModelSpec spec = parse_model(wall_text(kAssessed), "wall.toml");
  EXPECT_TRUE(study::cautions_of_inputs(spec, compile(spec)).empty());
  spec.wall.unit.density = 180;
  const std::vector<Message> said = study::cautions_of_inputs(spec, compile(spec));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].code, "assessment.caution.odd_inputs");
  EXPECT_EQ(said[0].number("count"), 1);
  EXPECT_NE(text_of(said[0]).find("wall.unit.density"), std::string::npos) << text_of(said[0]);
  // "1.800 kg/m^3": the note on the text stands for the note on the value
  spec.wall.unit.density = 1.8;
  spec.text_notes.push_back(
      {"value.thousands",
       {{"key", "wall.unit.density"}, {"value", "1.800 kg/m^3"}, {"thousands", "1800 kg/m^3"}}});
  const std::vector<Message> meant = study::cautions_of_inputs(spec, compile(spec));
  ASSERT_EQ(meant.size(), 1U);
  EXPECT_EQ(meant[0].code, "assessment.caution.odd_inputs");
}

// Demands that no code asks: a verdict on them vouches for something else than the site.
TEST(Assessment, values_that_no_code_has_bar_the_signature) {
  const auto codes = [](const AssessmentSpec& spec) {
    std::string all;
    for (const Message& caution : study::cautions_of_demand(spec))
      all += caution.code.substr(std::string("assessment.caution.").size()) + " ";
    return all;
  };
  AssessmentSpec spec;
  SpectrumSpec& s = spec.spectrum;
  s.kind = SpectrumKind::kNtc2018, s.amplification = 2.4, s.topography = 1.4;
  EXPECT_EQ(codes(spec), "");
  s.topography = 50;
  EXPECT_EQ(codes(spec), "topography ");
  EXPECT_EQ(study::cautions_of_demand(spec).front().number("most"), 1.4);
  s.topography = 1.6, s.kind = SpectrumKind::kEn1998;  // a loose layer on a ridge
  EXPECT_EQ(codes(spec), "");
  s.topography = 1.8;
  EXPECT_EQ(codes(spec), "topography ");
  s.topography = 1, spec.masonry_share = 0.5;
  EXPECT_EQ(codes(spec), "masonry_share ");
  spec.masonry_share = 1;
  s.kind = SpectrumKind::kNtc2018, s.amplification = 1.5;
  EXPECT_EQ(codes(spec), "amplification ");
  s.amplification = 2.4, s.corner_period = 0.3, s.ground = "A";
  s.ground_acceleration = 0.15;  // of a site with 0.15 g
  EXPECT_EQ(codes(spec), "ground_acceleration ");
  spec.limit_state = "damage_limitation";  // that comes more often, and weaker
  EXPECT_EQ(codes(spec), "");
  spec.limit_state = "life_safety", s.ground_acceleration = 1.5;
  spec.spectra.near_collapse = s;
  spec.spectra.near_collapse.topography = 50;  // of one limit state alone
  EXPECT_EQ(codes(spec), "topography ");
}

}  // namespace
}  // namespace wythe::assessment_bars_test
