"""What answers hold, as types for checkers and editors: plain dictionaries, lists, texts and numbers.

    from wythe.answers import Summary

    def strength(summary: Summary) -> Optional[float]:
        return summary["peak_reaction_kN"]

tools/answer_types writes this file from answers of the engine (make docs). A key of NotRequired is there for some models alone.
The unit is part of a key's name; the pages named below say what it means.
"""

from typing import NotRequired, Optional, TypedDict


class Message(TypedDict):
    """A sentence as data: docs/reference/results.md."""
    code: str
    arguments: dict[str, object]


class Collapse(TypedDict):
    """`collapse` of Summary."""
    displacement_mm: float
    censored: bool
    criterion: str
    criterion_message: NotRequired[Message]
    drift_percent: float


class Bilinear(TypedDict):
    """`bilinear` of Summary."""
    stiffness_kN_per_mm: Optional[float]
    force_kN: Optional[float]
    yield_displacement_mm: Optional[float]
    ultimate_displacement_mm: Optional[float]
    ductility: Optional[float]
    censored: bool


class Fall(TypedDict):
    """`falls[]` of Summary."""
    fraction: float
    displacement_mm: Optional[float]
    drift_percent: Optional[float]
    censored: bool
    first_mm: Optional[float]
    last_mm: Optional[float]


class Dip(TypedDict):
    """`drift_capacity.dips[]` of Summary."""
    left: float
    from_mm: float
    back_mm: float
    lowest_left: float
    before_peak: bool


class DriftCapacity(TypedDict):
    """`drift_capacity` of Summary."""
    left: list[float]
    first_mm: list[Optional[float]]
    lasting_mm: list[Optional[float]]
    last_mm: list[Optional[float]]
    lasting_drift_percent: list[Optional[float]]
    censored_first: list[bool]
    censored_last: list[bool]
    censored: list[bool]
    lasts_percent: float
    threshold_decides: Optional[bool]
    dips: list[Dip]


class FlatPeak(TypedDict):
    """`flat_peak` of Summary."""
    share: float
    from_mm: Optional[float]
    to_mm: Optional[float]
    is_bound: bool
    says_little: bool


class Mechanism(TypedDict):
    """`failure_mode.mechanism` of Summary."""
    name: str
    sentence: str
    sentence_message: NotRequired[Message]
    storeys: list[int]
    candidates: list[str]
    scores: dict[str, float]


class Evidence(TypedDict):
    """`failure_mode.evidence[]` of Summary."""
    element: str
    measure: str
    value: float
    threshold: float
    unit: str
    margin: float


class Sign(TypedDict):
    """`failure_mode.elements[].signs[]` of Summary."""
    state: str
    holds: bool
    measure: str
    value: float
    threshold: float
    unit: str
    displacement_first_mm: Optional[float]


class Element(TypedDict):
    """`failure_mode.elements[]` of Summary."""
    element: str
    kind: str
    mark: str
    storey: int
    state: str
    displacement_first_mm: Optional[float]
    signs: list[Sign]


class Flag(TypedDict):
    """`failure_mode.flags[]` of Summary."""
    element: str
    measure: str
    value: float
    threshold: float
    unit: str
    margin: float
    raised: bool


class Sensitivity(TypedDict):
    """`failure_mode.sensitivity[]` of Summary."""
    what: str
    what_message: Message
    name: str


class FailureMode(TypedDict):
    """`failure_mode` of Summary."""
    name: str
    sentence: str
    sentence_message: Message
    read_at_mm: float
    reading: str
    reading_message: NotRequired[Message]
    mechanism: Mechanism
    scores: dict[str, float]
    evidence: list[Evidence]
    elements: list[Element]
    flags: list[Flag]
    sensitivity: list[Sensitivity]


class Drift(TypedDict):
    """`tested_range.drift` of Summary."""
    masonry: str
    walls: int
    median_percent: Optional[float]
    nine_of_ten_percent: list[Optional[float]]
    own_walls: int
    own_ratio: Optional[float]
    own_factor: Optional[float]
    note: str
    note_message: NotRequired[Message]


class TestedRange(TypedDict):
    """`tested_range` of Summary."""
    kind: str
    walls: int
    bias: Optional[float]
    bias_interval: list[Optional[float]]
    scatter: Optional[float]
    note: str
    note_message: NotRequired[Message]
    drift: Drift


class Feature(TypedDict):
    """`features[]` of Summary."""
    name: str
    displacement_mm: float
    value_mm: float


class EnergyJ(TypedDict):
    """`energy_J` of Summary."""
    loads: float
    drive: float
    kinetic: float
    elastic: float
    friction: float
    fracture: float
    crushing: float
    damping: float
    gap: float
    gap_ratio: float
    hand_over: NotRequired[float]


class SlowPush(TypedDict):
    """`quasi_static.displacement` of Summary."""
    verdict: str
    reason: str
    reason_message: NotRequired[Message]


class QuasiStatic(TypedDict):
    """`quasi_static` of Summary."""
    verdict: str
    verdict_message: Message
    judgement: str
    lift_percent: Optional[float]
    force_beyond_percent: Optional[float]
    unbalance_ratio_mean: Optional[float]
    unbalance_ratio_max: Optional[float]
    kinetic_ratio_mean: Optional[float]
    kinetic_ratio_max: Optional[float]
    shear_gap: Optional[float]
    damping_share: Optional[float]
    displacement: SlowPush
    mode: SlowPush


class Validity(TypedDict):
    """`validity` of Summary."""
    overlap_lost_at_mm: Optional[float]
    joints: int
    where: str
    where_message: NotRequired[Message]


class Event(TypedDict):
    """`events[]` of Summary."""
    name: str
    name_message: Message
    displacement_mm: float
    reaction_kN: float
    where: str
    where_message: NotRequired[Message]


class Stage(TypedDict):
    """`stages[]` of Summary."""
    name: str
    time_s: float
    steps: int
    unbalance_ratio: float
    settled: bool


class Provenance(TypedDict):
    """`provenance` of Summary."""
    version: str
    commit: str
    compiler: str
    flags: str
    build_type: str
    spec_hash: str


class Project(TypedDict):
    """`project` of Summary."""
    title: str
    client: str
    author: str
    date: str
    place: str


class Spectrum(TypedDict):
    """`assessment.spectrum` of Summary."""
    kind: str
    ground_acceleration_g: float
    pga_g: float
    soil_factor: float
    topography: float
    eta: float
    amplification: float
    TB_s: float
    TC_s: float
    TD_s: float
    period_s: list[float]
    acceleration_g: list[float]
    displacement_mm: list[float]


class Mass(TypedDict):
    """`assessment.mass` of Summary."""
    blocks_kg: float
    loads_kg: float
    added_kg: float
    total_kg: float
    participating_kg: float
    participation_factor: float
    shape: str
    shape_read_at_mm: float


class Equivalent(TypedDict):
    """`assessment.equivalent` of Summary."""
    mass_kg: float
    participation_factor: float
    force_kN: float
    yield_displacement_mm: float
    ultimate_displacement_mm: float
    acceleration_g: float
    period_s: float


class Demand(TypedDict):
    """`assessment.demand` of Summary."""
    q: float
    elastic_displacement_mm: float
    equivalent_displacement_mm: float
    displacement_mm: float


class Criteria(TypedDict):
    """`assessment.limit_states[].criteria[]` of Summary."""
    name: str
    words: str
    words_message: Message
    clause: str
    verified: bool
    value: float
    unit: str
    displacement_mm: float
    reached: bool
    governs: bool


class LimitState(TypedDict):
    """`assessment.limit_states[]` of Summary."""
    state: str
    is_checked: bool
    verdict: str
    displacement_mm: float
    drift_percent: float
    at_least: bool
    governing: str
    capacity_over_demand: float
    spectrum_factor: float
    pga_g: float
    ground_acceleration_g: float
    demand_pga_g: float
    demand_displacement_mm: float
    q: float
    criteria: list[Criteria]


class Assessment(TypedDict):
    """`assessment` of Summary."""
    verdict: str
    may_be_signed: bool
    sentence: str
    sentence_message: Message
    cautions: list[str]
    cautions_message: list[Message]
    reason: str
    reason_message: NotRequired[Message]
    code: str
    limit_state: str
    confidence_factor: float
    masonry_share: float
    spectrum: Spectrum
    notes: list[str]
    notes_message: list[Message]
    decides: NotRequired[str]
    mass: NotRequired[Mass]
    bilinear: NotRequired[Bilinear]
    equivalent: NotRequired[Equivalent]
    demand: NotRequired[Demand]
    limit_states: NotRequired[list[LimitState]]


class Link(TypedDict):
    """`links[]` of Summary."""
    name: str
    kind: str
    stiffness_kN_per_mm: float
    largest_force_kN: float
    displacement_mm: float
    yields: bool
    plastic_mm: float


class Frame(TypedDict):
    """`frames[]` of Summary."""
    name: str
    use: float
    displacement_mm: float
    where: str
    where_message: Message
    yields: bool


class Layer(TypedDict):
    """`layers[]` of Summary."""
    name: str
    use: float
    displacement_mm: float
    where: str
    where_message: Message
    detached_percent: float
    broken_percent: float
    breaks: bool
    breaks_at_mm: float


class Debris(TypedDict):
    """`debris` of Summary."""
    blocks: int
    volume_m3: float
    mass_kg: float
    reach_m: float
    load_off_kN: float


class Envelope(TypedDict):
    """`cyclic.positive.envelope` of Summary."""
    displacement_mm: list[float]
    reaction_kN: list[float]


class Direction(TypedDict):
    """`cyclic.positive` of Summary."""
    peak_reaction_kN: float
    displacement_at_peak_mm: float
    displacement_at_80_percent_mm: float
    censored_80: bool
    first_fall_80_percent_mm: float
    censored_first_80: bool
    last_fall_80_percent_mm: float
    censored_last_80: bool
    displacement_max_mm: float
    censored_max: bool
    initial_stiffness_kN_per_mm: Optional[float]
    drift_capacity: DriftCapacity
    bilinear: Bilinear
    envelope: Envelope


class Cycle(TypedDict):
    """`cyclic.cycles[]` of Summary."""
    kind: str
    displacement_max_mm: Optional[float]
    displacement_min_mm: Optional[float]
    reaction_max_kN: Optional[float]
    reaction_min_kN: Optional[float]
    in_balance: bool
    residual_max_mm: Optional[float]
    residual_min_mm: Optional[float]
    stiffness_kN_per_mm: float
    dissipated_J: Optional[float]
    drag_J: Optional[float]
    damping_ratio: Optional[float]
    repeat: int
    strength_kept: float


class Cyclic(TypedDict):
    """`cyclic` of Summary."""
    read_in: str
    positive: Direction
    negative: Direction
    cycles: list[Cycle]
    work_J: float


class Point(TypedDict):
    """`shaking.points[]` of Summary."""
    name: str
    height_m: float
    peak_displacement_mm: float
    peak_at_s: float
    residual_displacement_mm: float


class Storey(TypedDict):
    """`shaking.storeys[]` of Summary."""
    name: str
    height_m: float
    peak_drift_percent: float
    peak_at_s: float
    residual_drift_percent: float


class Record(TypedDict):
    """`shaking.records[]` of Summary."""
    record: str
    hash: str
    along: list[float]
    of: str
    factor: float
    pga_g: float
    pgv_mm_per_s: float
    arias_m_per_s: float
    duration_s: float
    final_velocity_mm_per_s: float
    final_displacement_mm: float


class Viscous(TypedDict):
    """`shaking.damping[].mass` of Summary."""
    fraction: float
    frequency_Hz: float


class Damping(TypedDict):
    """`shaking.damping[]` of Summary."""
    stage: str
    local: float
    restitution: NotRequired[float]
    mass: NotRequired[Viscous]


class Shaking(TypedDict):
    """`shaking` of Summary."""
    collapsed: bool
    collapse_time_s: Optional[float]
    peak_drift_percent: float
    residual_drift_percent: float
    peak_base_shear_kN: float
    largest_opening_mm: float
    largest_slip_mm: float
    points: list[Point]
    storeys: list[Storey]
    records: list[Record]
    damping: list[Damping]
    sentence: str
    sentence_message: Message


class Summary(TypedDict):
    """`Result.summary`: summary.json, docs/reference/results.md."""
    status: str
    reason: str
    warning: str
    warning_message: NotRequired[Message]
    peak_reaction_kN: Optional[float]
    displacement_at_peak_mm: Optional[float]
    displacement_at_80_percent_mm: Optional[float]
    censored_80: bool
    displacement_max_mm: Optional[float]
    censored_max: bool
    initial_stiffness_kN_per_mm: Optional[float]
    drift_percent_max: float
    collapse: Collapse
    peak_reason: str
    censored_peak: bool
    peak_raw_kN: float
    displacement_at_peak_raw_mm: float
    load_height_m: float
    drift_percent_at_peak: Optional[float]
    drift_percent_at_80: Optional[float]
    work_to_peak_J: Optional[float]
    work_to_80_percent_J: Optional[float]
    work_total_J: float
    bilinear: Bilinear
    first_fall_80_percent_mm: Optional[float]
    censored_first_80: bool
    last_fall_80_percent_mm: Optional[float]
    censored_last_80: bool
    censored: bool
    falls: list[Fall]
    drift_capacity: DriftCapacity
    initial_stiffness_reason: str
    flat_peak: FlatPeak
    curve_of: str
    load_factor: float
    top_displacement_mm: float
    failure_mode: FailureMode
    tested_range: TestedRange
    features: list[Feature]
    energy_J: EnergyJ
    quasi_static: QuasiStatic
    validity: Validity
    events: list[Event]
    stages: list[Stage]
    blocks: int
    joints: int
    points: int
    steps: int
    time_step_s: float
    wall_seconds: float
    state_hash: str
    provenance: Provenance
    project: NotRequired[Project]
    peak_reason_message: NotRequired[Message]
    assessment: NotRequired[Assessment]
    initial_stiffness_reason_message: NotRequired[Message]
    links: NotRequired[list[Link]]
    frames: NotRequired[list[Frame]]
    layers: NotRequired[list[Layer]]
    zones: NotRequired[int]
    zone_nodes: NotRequired[int]
    zone_contacts: NotRequired[int]
    debris: NotRequired[Debris]
    reason_message: NotRequired[Message]
    cyclic: NotRequired[Cyclic]
    tilt_degrees: NotRequired[float]
    shaking: NotRequired[Shaking]


class Unanswered(TypedDict):
    """`samples.unanswered[]` of Statistics."""
    sample: int
    status: str
    reason: str


class Samples(TypedDict):
    """`samples` of Statistics."""
    asked: int
    run: int
    answered: int
    judgements: dict[str, int]
    still_rising: int
    named_earlier: int
    collapsed_before_push: int
    status: dict[str, int]
    unanswered: list[Unanswered]


class Interval(TypedDict):
    """`interval` of Statistics."""
    confidence: Optional[float]
    bootstrap_replicates: int


class Input(TypedDict):
    """`inputs[]` of Statistics."""
    name: str
    unit: str
    random: bool
    mean: Optional[float]
    cov: Optional[float]
    min: Optional[float]
    max: Optional[float]


class InputCorrelation(TypedDict):
    """`input_correlation[]` of Statistics."""
    a: str
    b: str
    spearman: Optional[float]


class Response(TypedDict):
    """`table[name].peak_reaction_kN` of Statistics."""
    n: int
    without_value: int
    mean: Optional[float]
    mean_interval: list[Optional[float]]
    cov: Optional[float]
    cov_interval: list[Optional[float]]
    median: Optional[float]
    median_interval: list[Optional[float]]
    standard_deviation: Optional[float]
    min: Optional[float]
    max: Optional[float]
    percentile_5: Optional[float]
    percentile_95: Optional[float]


class BoundedResponse(TypedDict):
    """`table[name].displacement_at_80_percent_mm` of Statistics."""
    n: int
    without_value: int
    censored: int
    mean: Optional[float]
    mean_interval: list[Optional[float]]
    cov: Optional[float]
    cov_interval: list[Optional[float]]
    median: Optional[float]
    median_interval: list[Optional[float]]
    standard_deviation: Optional[float]
    min: Optional[float]
    max: Optional[float]
    percentile_5: Optional[float]
    percentile_95: Optional[float]
    survival_mean: Optional[float]
    survival_mean_interval: list[Optional[float]]
    survival_median: Optional[float]
    survival_median_interval: list[Optional[float]]


class Group(TypedDict):
    """`table[name]` of Statistics."""
    modes: list[str]
    peak_reaction_kN: Response
    displacement_at_peak_mm: Response
    displacement_at_80_percent_mm: BoundedResponse
    displacement_max_mm: BoundedResponse
    initial_stiffness_kN_per_mm: Response
    displacement_at_50_percent_mm: BoundedResponse
    collapse_displacement_mm: BoundedResponse
    first_fall_80_percent_mm: BoundedResponse


class Share(TypedDict):
    """`shares[name]` of Statistics."""
    modes: list[str]
    count: int
    share: Optional[float]
    share_interval: list[Optional[float]]


class OfWall(TypedDict):
    """`walls.peak_reaction_kN` of Statistics."""
    n: int
    bounds: int
    median: Optional[float]
    median_interval: list[Optional[float]]
    at_least: Optional[float]
    smallest: Optional[float]
    largest: Optional[float]
    log_scatter: Optional[float]


class WallsDriftCapacity(TypedDict):
    """`walls.drift_capacity` of Statistics."""
    left: list[Optional[float]]
    n: list[int]
    median_mm: list[Optional[float]]
    at_least_mm: list[Optional[float]]
    low_mm: list[Optional[float]]
    high_mm: list[Optional[float]]
    bounds: list[int]


class WallsFailureMode(TypedDict):
    """`walls.failure_modes[name]` of Statistics."""
    count: int
    share: Optional[float]
    share_interval: list[Optional[float]]


class OfWalls(TypedDict):
    """`walls` of Statistics."""
    peak_reaction_kN: OfWall
    displacement_at_peak_mm: OfWall
    displacement_at_80_percent_mm: OfWall
    drift_capacity: WallsDriftCapacity
    failure_modes: dict[str, WallsFailureMode]


class NameSensitivity(TypedDict):
    """`name_sensitivity[]` of Statistics."""
    reading: str
    reading_message: Message
    state: Optional[str]
    threshold: Optional[str]
    factor: Optional[float]
    n: int
    differs: int
    share: Optional[float]
    share_interval: list[Optional[float]]


class StatisticsFlag(TypedDict):
    """`flags[]` of Statistics."""
    element: str
    measure: str
    threshold: Optional[float]
    unit: str
    n: int
    raised: int
    share: Optional[float]
    share_interval: list[Optional[float]]


class Precision(TypedDict):
    """`precision[]` of Statistics."""
    what: str
    half_width_asked: Optional[float]
    half_width_now: Optional[float]
    first_met_at: Optional[int]
    held_from: Optional[int]
    expected_at: Optional[int]


class DriftLimit(TypedDict):
    """`drift_limits[]` of Statistics."""
    element: str
    mechanism: str
    label: str
    state: str
    clause: str
    limit_drift_percent: Optional[float]
    below: int
    unknown: int
    share_below: Optional[float]
    share_below_interval: list[Optional[float]]
    share_below_is_lower_bound: bool


class Correlation(TypedDict):
    """`correlation[]` of Statistics."""
    group: str
    response: str
    input: str
    n: int
    censored: int
    pearson: Optional[float]
    pearson_interval: list[Optional[float]]
    spearman: Optional[float]
    spearman_interval: list[Optional[float]]
    partial_rank: Optional[float]
    partial_rank_interval: list[Optional[float]]


class FirstOrder(TypedDict):
    """`first_order[]` of Statistics."""
    response: str
    input: str
    bins: int
    index: Optional[float]
    index_interval: list[Optional[float]]
    entangled_with: list[str]


class BinShare(TypedDict):
    """`mode_against_input[].bins[].share[name]` of Statistics."""
    share: Optional[float]
    share_interval: list[Optional[float]]


class Bin(TypedDict):
    """`mode_against_input[].bins[]` of Statistics."""
    n: int
    low: Optional[float]
    high: Optional[float]
    mean: Optional[float]
    share: dict[str, BinShare]


class ModeAgainstInput(TypedDict):
    """`mode_against_input[]` of Statistics."""
    input: str
    unit: str
    bins: list[Bin]


class Fit(TypedDict):
    """`fragility[].inputs[].fits[]` of Statistics."""
    law: str
    slope: Optional[float]
    slope_interval: list[Optional[float]]
    half_at: Optional[float]
    half_at_interval: list[Optional[float]]
    beta: NotRequired[Optional[float]]
    beta_interval: NotRequired[list[Optional[float]]]
    log_likelihood: Optional[float]
    influence_p: Optional[float]
    fit_p: Optional[float]


class Curve(TypedDict):
    """`fragility[].inputs[].curve` of Statistics."""
    law: str
    input: list[Optional[float]]
    probability: list[Optional[float]]
    low: list[Optional[float]]
    high: list[Optional[float]]


class FragilityInput(TypedDict):
    """`fragility[].inputs[]` of Statistics."""
    input: str
    unit: str
    verdict: str
    entangled_with: list[str]
    fits: list[Fit]
    curve: NotRequired[Curve]
    parted_between: NotRequired[list[Optional[float]]]


class Pair(TypedDict):
    """`fragility[].pairs[]` of Statistics."""
    inputs: list[str]
    verdict: str
    intercept: NotRequired[Optional[float]]
    slope_1: NotRequired[Optional[float]]
    slope_1_interval: NotRequired[list[Optional[float]]]
    slope_2: NotRequired[Optional[float]]
    slope_2_interval: NotRequired[list[Optional[float]]]
    added_p: NotRequired[Optional[float]]
    fit_p: NotRequired[Optional[float]]


class Limits(TypedDict):
    """`fragility[].limits` of Statistics."""
    peak_drift_percent: NotRequired[Optional[float]]
    collapse: bool


class ByCounts(TypedDict):
    """`fragility[].by_counts` of Statistics."""
    median_m_per_s2: NotRequired[Optional[float]]
    beta: Optional[float]
    median_m_per_s: NotRequired[Optional[float]]


class FragilityCurve(TypedDict):
    """`fragility[].curve` of Statistics."""
    probability: list[Optional[float]]
    low: list[Optional[float]]
    high: list[Optional[float]]
    intensity_m_per_s2: NotRequired[list[Optional[float]]]
    intensity_m_per_s: NotRequired[list[Optional[float]]]


class Count(TypedDict):
    """`fragility[].counts[]` of Statistics."""
    intensity_m_per_s2: NotRequired[Optional[float]]
    n: int
    reached: int
    lost: int
    share: Optional[float]
    share_interval: list[Optional[float]]
    intensity_m_per_s: NotRequired[Optional[float]]


class Bracket(TypedDict):
    """`fragility[].brackets[]` of Statistics."""
    sample: int
    wall: int
    record: int
    not_at_m_per_s2: NotRequired[Optional[float]]
    reached_at_m_per_s2: NotRequired[Optional[float]]
    known: bool
    came_back: bool
    not_at_m_per_s: NotRequired[Optional[float]]
    reached_at_m_per_s: NotRequired[Optional[float]]


class Scatter(TypedDict):
    """`fragility[].scatter` of Statistics."""
    verdict: str
    records: int
    walls: int
    record_to_record: NotRequired[Optional[float]]
    record_to_record_interval: NotRequired[list[Optional[float]]]
    wall_to_wall: NotRequired[Optional[float]]
    wall_to_wall_interval: NotRequired[list[Optional[float]]]
    rest: NotRequired[Optional[float]]
    rest_interval: NotRequired[list[Optional[float]]]
    bracket: NotRequired[Optional[float]]


class MedianIfLost(TypedDict):
    """`fragility[].median_if_lost_m_per_s` of Statistics."""
    reached: Optional[float]
    not_reached: Optional[float]


class Fragility(TypedDict):
    """`fragility[]` of Statistics."""
    response: NotRequired[str]
    greater_than: NotRequired[Optional[float]]
    unit: NotRequired[str]
    n: int
    seen: NotRequired[int]
    unknown: NotRequired[int]
    repeated: NotRequired[int]
    not_slow_enough: NotRequired[int]
    lost: int
    share: NotRequired[Optional[float]]
    share_interval: NotRequired[list[Optional[float]]]
    sample: NotRequired[list[int]]
    outcome: NotRequired[list[Optional[float]]]
    inputs: NotRequired[list[FragilityInput]]
    pairs: NotRequired[list[Pair]]
    mode: NotRequired[str]
    limit_state: NotRequired[str]
    limits: NotRequired[Limits]
    measure: NotRequired[str]
    verdict: NotRequired[str]
    reached: NotRequired[int]
    came_back: NotRequired[int]
    median_m_per_s2: NotRequired[Optional[float]]
    median_m_per_s2_interval: NotRequired[list[Optional[float]]]
    beta: NotRequired[Optional[float]]
    beta_interval: NotRequired[list[Optional[float]]]
    interval_by: NotRequired[str]
    log_likelihood: NotRequired[Optional[float]]
    by_counts: NotRequired[ByCounts]
    curve: NotRequired[FragilityCurve]
    counts: NotRequired[list[Count]]
    brackets: NotRequired[list[Bracket]]
    scatter: NotRequired[Scatter]
    median_m_per_s: NotRequired[Optional[float]]
    median_m_per_s_interval: NotRequired[list[Optional[float]]]
    median_if_lost_m_per_s: NotRequired[MedianIfLost]


class Measuring(TypedDict):
    """`measuring[]` of Statistics."""
    response: str
    input: str
    n: int
    censored: int
    variance_share: Optional[float]
    variance_share_interval: list[Optional[float]]
    width_share: Optional[float]
    width_share_interval: list[Optional[float]]
    is_best: Optional[float]


class SurrogateIndexInput(TypedDict):
    """`surrogate_indices[].inputs[]` of Statistics."""
    input: str
    first_order: Optional[float]
    first_order_interval: list[Optional[float]]
    total: Optional[float]
    total_interval: list[Optional[float]]


class SurrogateIndex(TypedDict):
    """`surrogate_indices[]` of Statistics."""
    response: str
    verdict: str
    n: int
    q2: Optional[float]
    q2_asked: Optional[float]
    terms: int
    inputs: list[SurrogateIndexInput]


class Running(TypedDict):
    """`running[name]` of Statistics."""
    n: list[int]
    mean: list[Optional[float]]
    low: list[Optional[float]]
    high: list[Optional[float]]


class MeanCurve(TypedDict):
    """`mean_curves[name]` of Statistics."""
    curves: int
    displacement_mm: list[Optional[float]]
    drift_percent: list[Optional[float]]
    n: list[int]
    reaction_mean_kN: list[Optional[float]]
    reaction_standard_deviation_kN: list[Optional[float]]
    reaction_5_percent_kN: list[Optional[float]]
    reaction_95_percent_kN: list[Optional[float]]


class Lognormal(TypedDict):
    """`exceedance[name].lognormal` of Statistics."""
    median_kN: NotRequired[Optional[float]]
    median_kN_interval: NotRequired[list[Optional[float]]]
    beta: Optional[float]
    beta_interval: list[Optional[float]]
    misfit: Optional[float]
    median_mm: NotRequired[Optional[float]]
    median_mm_interval: NotRequired[list[Optional[float]]]


class Exceedance(TypedDict):
    """`exceedance[name]` of Statistics."""
    n: int
    censored: int
    value_kN: NotRequired[list[Optional[float]]]
    probability: list[Optional[float]]
    low: list[Optional[float]]
    high: list[Optional[float]]
    lognormal: Lognormal
    value_mm: NotRequired[list[Optional[float]]]


class LimitStateCurve(TypedDict):
    """`assessment.limit_states[].curve` of Statistics."""
    pga_g: list[Optional[float]]
    probability: list[Optional[float]]
    low: list[Optional[float]]
    high: list[Optional[float]]


class LimitStateSamples(TypedDict):
    """`assessment.limit_states[].samples` of Statistics."""
    pga_g: list[Optional[float]]
    share_reached: list[Optional[float]]


class AssessmentLimitState(TypedDict):
    """`assessment.limit_states[]` of Statistics."""
    limit_state: str
    is_checked: bool
    n: int
    censored: int
    median_pga_g: Optional[float]
    median_pga_g_interval: list[Optional[float]]
    beta_capacity: Optional[float]
    beta_capacity_interval: list[Optional[float]]
    beta: Optional[float]
    demand_pga_g: Optional[float]
    probability_at_demand: Optional[float]
    probability_at_demand_interval: list[Optional[float]]
    curve: LimitStateCurve
    samples: LimitStateSamples


class StatisticsAssessment(TypedDict):
    """`assessment` of Statistics."""
    code: str
    limit_state: str
    record_scatter: Optional[float]
    answered: int
    without_answer: int
    not_to_be_signed: int
    mass: Mass
    sentence: str
    sentence_message: Message
    cautions: list[str]
    cautions_message: list[Message]
    reason: str
    notes: list[str]
    notes_message: list[Message]
    limit_states: list[AssessmentLimitState]


class Lost(TypedDict):
    """`shaking.lost[]` of Statistics."""
    sample: int
    intensity_m_per_s: Optional[float]
    status: str
    reason: str


class Intensity(TypedDict):
    """`shaking.intensities[]` of Statistics."""
    intensity_m_per_s2: NotRequired[Optional[float]]
    n: int
    collapsed: int
    lost: int
    drift_percent_16: Optional[float]
    drift_percent_50: Optional[float]
    drift_percent_84: Optional[float]
    scatter_of_drift: Scatter
    intensity_m_per_s: NotRequired[Optional[float]]


class StatisticsShaking(TypedDict):
    """`shaking` of Statistics."""
    records: int
    walls: int
    samples: int
    shakes: int
    stood: int
    collapsed: int
    lost: list[Lost]
    damping_of_shakes: list[str]
    damping_of_shakes_message: list[Message]
    measure: str
    intensities: list[Intensity]


class Statistics(TypedDict):
    """`Campaign.statistics`: statistics.json, docs/reference/statistics.md."""
    study: str
    design: str
    seed: int
    samples: Samples
    load_height_m: Optional[float]
    read_modes_at_mm: Optional[float]
    interval: Interval
    inputs: list[Input]
    input_correlation: list[InputCorrelation]
    modes: list[str]
    table: dict[str, Group]
    shares: dict[str, Share]
    walls: OfWalls
    name_sensitivity: list[NameSensitivity]
    flags: list[StatisticsFlag]
    precision: list[Precision]
    drift_limits: list[DriftLimit]
    correlation: list[Correlation]
    first_order: list[FirstOrder]
    mode_against_input: list[ModeAgainstInput]
    fragility: list[Fragility]
    project: NotRequired[Project]
    measuring: list[Measuring]
    surrogate_indices: list[SurrogateIndex]
    running: dict[str, Running]
    mean_curves: dict[str, MeanCurve]
    exceedance: dict[str, Exceedance]
    assessment: NotRequired[StatisticsAssessment]
    shaking: NotRequired[StatisticsShaking]


class MechanismInput(TypedDict):
    """`mechanisms[].inputs[name]` of Mechanisms."""
    value: float
    unit: str


class Load(TypedDict):
    """`mechanisms[].bodies[].loads[]` of Mechanisms."""
    kind: str
    at_m: list[float]
    fx_kN: float
    fy_kN: float


class Body(TypedDict):
    """`mechanisms[].bodies[]` of Mechanisms."""
    name: str
    outline_m: list[list[float]]
    loads: list[Load]


class MechanismCurve(TypedDict):
    """`mechanisms[].curve` of Mechanisms."""
    ends_where: str
    displacement_mm: list[float]
    force_kN: list[float]
    rotation_rad: list[list[float]]
    rotation_ratio: list[list[float]]
    hinges_m: list[list[list[float]]]


class MechanismAssessment(TypedDict):
    """`mechanisms[].assessment` of Mechanisms."""
    clause: str
    note: str
    alpha0: float
    alpha0_by_weights: float
    participating_mass_kg: float
    participating_mass_share: float
    acceleration0_m_per_s2: float
    displacement0_mm: float
    spectral_share: float
    spectral_displacement0_mm: float
    life_safety_share_of_d0: float
    life_safety_displacement_mm: float
    near_collapse_share_of_d0: float
    near_collapse_displacement_mm: float
    life_safety_spectral_displacement_mm: float
    near_collapse_spectral_displacement_mm: float


class MechanismsMechanism(TypedDict):
    """`mechanisms[]` of Mechanisms."""
    name: str
    mode: str
    hypothesis: str
    force_at_rest_kN: float
    displacement_without_force_mm: float
    rotation_ratios: list[float]
    inputs: dict[str, MechanismInput]
    hinge_names: list[str]
    hinges_m: list[list[float]]
    hinge_forces_at_rest_kN: list[list[float]]
    bodies: list[Body]
    load_point_m: list[float]
    loaded_body: int
    direction: float
    curve: MechanismCurve
    assessment: NotRequired[MechanismAssessment]


class Building(TypedDict):
    """`local[].building` of Mechanisms."""
    height_m: float
    period_s: float
    storeys: int
    part_at_m: float
    share_of_first_mode: float


class LocalLimitState(TypedDict):
    """`local[].limit_states[]` of Mechanisms."""
    limit_state: str
    verdict: str
    pga_demand_g: float
    pga_capacity_g: float
    acceleration_demand_m_per_s2: float
    q: float
    capacity_over_demand_by_q: float
    displacement_mm: float
    secant_period_s: float
    displacement_demand_mm: float
    capacity_over_demand_by_displacement: float
    by_onset: bool


class Local(TypedDict):
    """`local[]` of Mechanisms."""
    name: str
    by: str
    clause: str
    verified: bool
    verdict: str
    may_be_signed: bool
    sentence: str
    sentence_message: Message
    cautions: list[str]
    cautions_message: list[Message]
    notes: list[str]
    notes_message: list[Message]
    foot_m: float
    head_m: float
    hinge_m: Optional[float]
    inset_mm: float
    masonry_kN: float
    floors_kN: float
    weight_kN: float
    alpha0: float
    participating_mass_kg: float
    participating_mass_share: float
    confidence_factor: float
    acceleration0_m_per_s2: float
    alpha0_to_the_end: float
    acceleration0_to_the_end_m_per_s2: float
    rotation0_rad: float
    displacement0_mm: float
    displacement0_of_top_mm: float
    slides_off_mm: Optional[float]
    lets_go_mm: Optional[float]
    building: Building
    limit_states: list[LocalLimitState]


class LimitLoad(TypedDict):
    """`limit_loads[]` of Mechanisms."""
    name: str
    joints: str
    friction: str
    crushing: str
    static_kN: NotRequired[float]
    kinematic_kN: NotRequired[float]
    gap: float
    accuracy: float
    rows: int
    columns: int
    tangents: int
    seconds: float
    velocity_x: list[float]
    velocity_y: list[float]
    spin_per_m: list[float]
    point_force_N: list[float]
    shear_force_N: list[float]
    static: NotRequired[float]
    kinematic: NotRequired[float]
    velocity_z: NotRequired[list[float]]
    spin_x_per_m: NotRequired[list[float]]
    spin_y_per_m: NotRequired[list[float]]
    shear_force_2_N: NotRequired[list[float]]
    friction_excess: NotRequired[float]


class Refused(TypedDict):
    """`refused[]` of Mechanisms."""
    what: str
    what_message: Message
    why: str


class Mechanisms(TypedDict):
    """`SecondOpinion.mechanisms`: mechanisms.json, docs/reference/limit.md."""
    wythe: str
    blocks: int
    joints: int
    mechanisms: list[MechanismsMechanism]
    local: list[Local]
    limit_loads: list[LimitLoad]
    refused: list[Refused]
    notes: list[str]
    notes_message: list[Message]
    block_id: list[str]
    comparison: None


class CheckFacts(TypedDict):
    """`Check.facts`."""
    blocks: int
    joints: int
    points: int
    weight_kN: float
    length_m: float
    height_m: float
    thickness_m: float
    in_space: bool
    notes: list[str]
    time_step_s: float
    steps: int
    expected_seconds: float


class Outcome(TypedDict):
    """`Campaign.outcome`: of the call that ran it."""
    done: int
    total: int
    precise_at: int
    until: str
    notes: list[str]


class Replay(TypedDict):
    """`Result.replay`: whether it equals the stored sample, and the sample's settings."""
    sample: int
    stored_state_hash: str
    equal: bool
    settings: list[str]


class Key(TypedDict):
    """A member of `wythe.keys()`."""
    path: str
    kind: str
    default: NotRequired[str]
    example: NotRequired[str]
    meaning: str
    unit: NotRequired[str]
    allowed: NotRequired[str]
    words: NotRequired[list[str]]
    unlimited: NotRequired[bool]
