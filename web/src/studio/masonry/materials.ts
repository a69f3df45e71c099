// Names of the program's library of masonry (`wythe materials`), for a choice. A test compares them with it.
export const kMaterials = [
  "clay_brick_old", "clay_brick_new", "clay_perforated_new", "clay_brick_eindhoven", "tuff_pozzolanic", "granite_dry", "granite_lime", "limestone_dry",
  "circolare_rubble", "circolare_rough_blocks", "circolare_split_stone", "circolare_soft_stone_irregular", "circolare_soft_stone_regular",
  "circolare_squared_stone", "circolare_brick_lime", "circolare_perforated_brick_cement",
  "en1996_clay_m1", "en1996_clay_m2_5", "en1996_clay_m5", "en1996_clay_m10", "en1996_clay_m20", "en1996_calcium_silicate_m5", "en1996_calcium_silicate_thin",
];
