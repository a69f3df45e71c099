// Walls to begin with: the program's own examples, and an empty one.
import arch from "../../../../examples/arch/model.toml?raw";
import facade from "../../../../examples/brick_facade/model.toml?raw";
import palazzina from "../../../../examples/palazzina/model.toml?raw";
import pier from "../../../../examples/brick_pier/model.toml?raw";
import portal from "../../../../examples/brick_portal/model.toml?raw";
import frame from "../../../../examples/opening/after.toml?raw";
import ring from "../../../../examples/ring_beam/model.toml?raw";
import tied from "../../../../examples/tied_arch/model.toml?raw";
import tuff from "../../../../examples/tuff_wall/model.toml?raw";

// As the portal, without its door.
const kEmpty = `# A wall to draw on: change its size, put doors and windows in, push it.
name = "my wall"

[wall]
length = "4.00 m"
height = "2.92 m"
thickness = "0.25 m"
bond = "running"
fit = "cut"                        # any size will do: units are cut at the edges, as a mason would

[wall.unit]                        # sizes with one joint
length = "250 mm"
height = "73 mm"
density = "1800 kg/m^3"

[masonry]                          # typical values of a library, each with its source
use = "clay_brick_old"
vertical_stress = "0.2 MPa"        # mean, under the loads below: bricks under pressure crack sooner
shear_modulus = "rule"             # 0.4 E
unit_youngs_modulus = "rule"       # 300 times the strength of the bricks

[material.joint]
missing = "rule"                   # every number that is not here comes from [masonry] by a stated rule

[material.unit]
missing = "rule"

[[stage]]
name = "gravity"

[[stage]]
name = "floor above"
pressure = "0.2 MPa"               # on the whole top

[[stage]]
name = "push"
at = { x = "0 m", y = "2.6 m", courses = 3 }
damping = 0.2                      # no velocity: fast while in balance, slow at each crack
until = "20 mm"
`;

export const kStarters: [name: string, text: string][] = [
  ["empty", kEmpty],
  ["portal", portal],
  ["pier", pier],
  ["tuff", tuff],
  ["facade", facade],
  ["palazzina", palazzina],
  ["arch", arch],
  ["tied", tied],
  ["ring", ring],
  ["frame", frame],
];
export const starter = (name: string): string => kStarters.find(([n]) => n === name)![1];
