// Names, symbols and definitions are those of UDUNITS-2 (2.2.28, files udunits2-*.xml, copyright 2008, 2009 University
// Corporation for Atmospheric Research; its notice is in debian/copyright). tests/unit/units/udunits_test.cpp compares
// each of them with that library. Only the symbol deg was added.
#include "units/unit_table.h"

namespace wythe {

// Symbols distinguish capitals, names do not. A name has the regular English plural, or the one after the slash in
// "foot/feet". "base" is a unit of SI, in the order of kBaseUnits. "K shifted" has another zero than K, so no factor
// converts it; nor does one convert a logarithm. Ω and Å stand twice, as letter and as Unicode sign.
const std::string_view kUnitLines = R"table(
# SI
base                             | m        | meter metre
base                             | kg       | kilogram
base                             | s        | second
base                             | A        | ampere
base                             | K        | kelvin
base                             | mol      | mole
base                             | cd       | candela
base                             | rad      | radian
rad^2                            | sr       | steradian
1/s                              | Hz       | hertz
1e-3 kg                          | g        | gram
m.kg/s^2                         | N        | newton
N/m^2                            | Pa       | pascal
N.m                              | J        | joule
J/s                              | W        | watt
s.A                              | C        | coulomb
W/A                              | V        | volt
C/V                              | F        | farad
V/A                              | Ω Ω      | ohm
A/V                              | S        | siemens
V.s                              | Wb       | weber
Wb/m^2                           | T        | tesla
Wb/A                             | H        | henry
K shifted                        | °C       | degree_Celsius/degrees_Celsius
cd.sr                            | lm       | lumen
lm/m^2                           | lx       | lux
mol/s                            | kat      | katal
# SI, for health
1/s                              | Bq       | becquerel
J/kg                             | Gy       | gray
J/kg                             | Sv       | sievert
# accepted beside SI
60 s                             | min      | minute
60 min                           | h hr     | hour
24 h                             | d        | day
3.141592653589793238462643383279 | π        | pi
(pi/180) rad                     | ° deg    | arc_degree angular_degree degree arcdeg
°/60                             | ' ′      | arc_minute angular_minute arcminute arcmin
'/60                             | " ″      | arc_second angular_second arcsecond arcsec
dm^3                             | L l      | liter litre
1000 kg                          | t        | metric_ton tonne
# found by experiment
1.60217733e-19 J                 | eV       | electronvolt electron_volt
1.6605402e-27 kg                 | u        | unified_atomic_mass_unit atomic_mass_unit atomicmassunit amu
1.49597870700e11 m               | au       | astronomical_unit
1.495979e11 m                    | ua       | astronomical_unit_BIPM_2006
# accepted for a time
1852 m                           |          | nautical_mile
nautical_mile/hour               |          | international_knot knot_international knot
1e-10 m                          | Å Å      | angstrom ångström
dam^2                            | a        | are
100 are                          |          | hectare
100 fm^2                         | b        | barn
1000 hPa                         |          | bar
cm/s^2                           |          | gal
3.7e10 Bq                        | Ci       | curie
2.58e-4 C/kg                     | R        | roentgen
cSv                              |          | rem
# synonyms
s                                |          | sec
A                                |          | amp
K                                | °K       | degree_kelvin/degrees_kelvin degree_K/degrees_K degreeK/degreesK deg_K/degs_K
K                                |          | degK/degsK
cd                               |          | candle
mole                             |          | einstein
Hz                               | Bd bps   | baud
degree_Celsius                   | ℃        | celsius degree_C/degrees_C degreeC/degreesC deg_C/degs_C degC/degsC
knot                             | kt kts   |
# constants
6.02214179e23/mol                |          | avogadro_constant
0.01                             | %        | percent
# shares of volume
1                                | ppv      |
1e-6                             | ppm ppmv |
1e-9                             | ppb ppbv |
1e-12                            | ppt pptv |
1e-15                            | ppq ppqv |
# angle
0.9 arc_degree                   |          | grade
2 pi rad                         |          | circle cycle turn revolution rotation
arc_degree                       |          | degree_north/degrees_north degree_N/degrees_N degreeN/degreesN
arc_degree                       |          | degree_east/degrees_east degree_E/degrees_E degreeE/degreesE
arc_degree                       |          | degree_true/degrees_true degree_T/degrees_T degreeT/degreesT
-1 degree_east                   |          | degree_west/degrees_west degree_W/degrees_W degreeW/degreesW
# mass
2.916667e-2 kg                   |          | assay_ton
2.834952e-2 kg                   |          | avoirdupois_ounce
0.45359237 kg                    | lb       | avoirdupois_pound pound
2e-4 kg                          |          | carat
6.479891e-5 kg                   | gr       | grain
5.080235e1 kg                    |          | long_hundredweight
1.555174e-3 kg                   |          | pennyweight
4.535924e1 kg                    |          | short_hundredweight
14.59390 kg                      |          | slug
3.110348e-2 kg                   |          | troy_ounce apothecary_ounce
3.732417e-1 kg                   |          | troy_pound apothecary_pound
20 grain                         |          | scruple
60 grain                         |          | apdram
avoirdupois_ounce/16             | dr       | dram
480 grain                        |          | apounce
5760 grain                       |          | appound
94 pound                         |          | bag
2000 pound                       |          | short_ton ton
2240 pound                       |          | long_ton
# length
1e-15 m                          |          | fermi
9.46073e15 m                     |          | light_year
1e-6 m                           |          | micron
2.54e-5 m                        |          | mil
3.085678e16 m                    |          | parsec
3.514598e-4 m                    |          | printers_point
2.011684e1 m                     |          | chain
12 printers_point                |          | printers_pica pica
nautical_mile                    |          | nmile
(1200/3937) m                    |          | US_survey_foot/US_survey_feet
3 US_survey_feet                 |          | US_survey_yard
5280 US_survey_feet              |          | US_survey_mile US_statute_mile
16.5 US_survey_feet              |          | rod pole perch
660 US_survey_feet               |          | furlong
6 US_survey_feet                 |          | fathom
2.54 cm                          | in       | international_inch inch
12 international_inches          | ft       | international_foot/international_feet foot/feet
3 international_feet             | yd       | international_yard yard
5280 international_feet          | mi       | international_mile mile
inch/72                          |          | big_point
inch/3                           |          | barleycorn
191.835 foot                     |          | arpentlin
# rate of angle
rotation/second                  | rps cps  | rotation_per_second/rotations_per_second
rotation/minute                  | rpm      |
# mass per length
1.111111e-7 kg/m                 |          | denier
1e-6 kg/m                        |          | tex
# permeance
5.72135e-11 kg/(Pa.s.m^2)        |          | perm_0C/perms_0C
5.74525e-11 kg/(Pa.s.m^2)        |          | perm_23C/perms_23C
# area
5.067075e-10 m^2                 |          | circular_mil
9.869233e-13 m^2                 |          | darcy
160 rod^2                        |          | acre
# volume
1.233489e3 m^3                   |          | acre_foot/acre_feet
2.359737e-3 m^3                  |          | board_foot/board_feet
3.523907e-2 m^3                  | bu       | bushel
bushel/4                         | pk       | peck
4.546090e-3 m^3                  |          | Canadian_liquid_gallon
4.404884e-3 m^3                  |          | US_dry_gallon
cm^3                             | cc       |
1 m^3                            |          | stere
2.831685 m^3                     |          | register_ton
US_dry_gallon/4                  |          | US_dry_quart dry_quart
US_dry_gallon/8                  |          | US_dry_pint dry_pint
3.785412e-3 m^3                  |          | US_liquid_gallon liquid_gallon gallon
42 US_liquid_gallon              | bbl      | barrel
barrel/4                         |          | firkin
US_liquid_gallon/4               |          | US_liquid_quart liquid_quart quart
US_liquid_gallon/8               | pt       | US_liquid_pint liquid_pint pint
US_liquid_gallon/16              |          | US_liquid_cup liquid_cup cup
US_liquid_gallon/32              |          | US_liquid_gill liquid_gill gill
US_liquid_gallon/128             | oz floz  | US_fluid_ounce US_liquid_ounce fluid_ounce liquid_ounce
US_fluid_ounce/2                 | Tbl Tbsp tbsp Tblsp tblsp| tablespoon
US_fluid_ounce/8                 | fldr     | fluid_dram
tablespoon/3                     | tsp      | teaspoon
4.546090e-3 m^3                  |          | UK_liquid_gallon
UK_liquid_gallon/4               |          | UK_liquid_quart
UK_liquid_gallon/8               |          | UK_liquid_pint
UK_liquid_gallon/16              |          | UK_liquid_cup
UK_liquid_gallon/32              |          | UK_liquid_gill
UK_liquid_gallon/160             |          | UK_fluid_ounce UK_liquid_ounce
logarithm                        | BZ       |
# time
1e-8 s                           |          | shake
8.616409e4 s                     |          | sidereal_day
3.590170e3 s                     |          | sidereal_hour
5.983617e1 s                     |          | sidereal_minute
0.9972696 s                      |          | sidereal_second
3.155815e7 s                     |          | sidereal_year
3.15569259747e7 s                | yr       | tropical_year year
29.530589 day                    |          | lunar_month
365 day                          |          | common_year
366 day                          |          | leap_year
365.25 day                       |          | Julian_year
365.2425 day                     |          | Gregorian_year
27.321661 day                    |          | sidereal_month
27.321582 day                    |          | tropical_month
14 day                           |          | fortnight
7 day                            |          | week
0.01 s                           |          | jiffy
1e9 year                         |          | eon
year/12                          |          | month
# volume per time
1e6 m^3/s                        |          | sverdrup
# acceleration
9.80665 m/s^2                    |          | standard_free_fall
standard_free_fall               |          | gravity
# weight per volume, for columns of water and mercury
gravity 1000 kg/m^3              | H2O h2o  | conventional_water water
gravity 999.972 kg/m^3           |          | water_4C/waters_4C water_39F/waters_39F
gravity 999.001 kg/m^3           |          | water_60F/waters_60F
gravity 13595.10 kg/m^3          | Hg       | mercury_0C/mercuries_0C mercury_32F/mercuries_32F
gravity 13595.10 kg/m^3          |          | conventional_mercury/conventional_mercuries
gravity 13556.8 kg/m^3           |          | mercury_60F/mercuries_60F
# force
standard_free_fall               |          | force
1e-5 N                           |          | dyne
9.80665e-3 N                     |          | pond
9.80665 N                        | kgf      | force_kilogram kilogram_force/kilograms_force
2.780139e-1 N                    | ozf      | force_ounce ounce_force/ounces_force
4.4482216152605 N                | lbf      | force_pound pound_force/pounds_force
1.382550e-1 N                    |          | poundal
gram force                       | gf       | gram_force/grams_force force_gram
2000 force_pound                 |          | force_ton ton_force/tons_force
1000 lbf                         |          | kip
# pressure
1.01325e5 Pa                     | atm      | standard_atmosphere atmosphere
1 kg gravity/cm2                 | at       | technical_atmosphere
cm H2O                           | cm_H2O cmH2O|
inch water_39F                   |          | inch_H2O_39F/inches_H2O_39F
inch water_60F                   |          | inch_H2O_60F/inches_H2O_60F
foot water                       | ftH2O fth2o| foot_water/feet_water foot_H2O/feet_H2O footH2O/feetH2O
cm Hg                            | cm_Hg cmHg|
mm mercury_0C                    |          | millimeter_Hg_0C/millimeters_Hg_0C
inch mercury_32F                 |          | inch_Hg_32F/inches_Hg_32F
inch mercury_60F                 |          | inch_Hg_60F/inches_Hg_60F
mm Hg                            | mm_Hg mm_hg mmHg mmhg| millimeter_Hg/millimeters_Hg torr
inch Hg                          | in_Hg inHg| inch_Hg/inches_Hg
1 pound gravity/in^2             | psi      |
kip/in^2                         | ksi      |
0.1 N/m^2                        |          | barie barye
logarithm                        | B_SPL    |
# viscosity
1e-1 Pa.s                        |          | poise
1e-4 m^2/s                       | St       | stokes
10/(Pa.s)                        |          | rhe
# energy
1e-7 J                           |          | erg
1.05505585262e3 J                |          | IT_Btu/IT_Btus Btu/Btus
1.05506e8 J                      |          | EC_therm
4.184 J                          |          | thermochemical_calorie
4.1868 J                         | cal      | IT_calorie calorie
4.184 MJ/kg                      |          | TNT
4.184e9 J                        |          | ton_TNT/tons_TNT
1.054804e8 J                     | thm      | US_therm therm
watt.hour                        |          | watthour
1e9 eV                           | bev      |
# power
V.A                              | VA       | voltampere
9.80950e3 W                      |          | boiler_horsepower
7.456999e2 W                     | hp       | shaft_horsepower horsepower
7.35499e2 W                      |          | metric_horsepower
7.460000e2 W                     |          | electric_horsepower
7.46043e2 W                      |          | water_horsepower
7.4570e2 W                       |          | UK_horsepower
12000 Btu/hr                     |          | refrigeration_ton ton_of_refrigeration/tons_of_refrigeration
logarithm                        | BW       |
logarithm                        | Bm       |
# heat
1.55e-1 K.m^2/W                  |          | clo
# electricity and magnetism
10 A                             |          | abampere
7.957747e-1 A                    |          | gilbert
3.335640e-10 A                   |          | statampere
10 A                             |          | biot
1e9 F                            |          | abfarad
1e-9 H                           |          | abhenry
1e9 S                            |          | abmho
1e-9 ohm                         |          | abohm
1e-8 V                           |          | abvolt
1.602176487e-19 C                | e        |
9.64957e4 C                      |          | chemical_faraday
9.65219e4 C                      |          | physical_faraday
9.648531e4 C                     |          | C12_faraday faraday
1e-9 T                           |          | gamma
1e-4 T                           |          | gauss
1e-8 Wb                          |          | maxwell
7.957747e1 A/m                   | Oe       | oersted
3.335640e-10 C                   |          | statcoulomb
1.112650e-12 F                   |          | statfarad
8.987554e11 H                    |          | stathenry
1.112650e-12 S                   |          | statmho
8.987554e11 ohm                  |          | statohm
2.997925e2 V                     |          | statvolt
1.256637e-7 Wb                   |          | unit_pole
logarithm                        | BV       |
logarithm                        | Bv       |
logarithm                        | BµV      |
# temperature
K/1.8                            | °R       | degree_rankine/degrees_rankine degreeR/degreesR degree_R/degrees_R degR/degsR
K/1.8                            |          | deg_R/degs_R
°R shifted                       | °F ℉     | fahrenheit degree_fahrenheit/degrees_fahrenheit degreeF/degreesF
°R shifted                       |          | degree_F/degrees_F degF/degsF deg_F/degs_F
# light
1.076391e-1 lx                   |          | footcandle
3.426259 cd/m^2                  |          | footlambert
(1e4/pi) cd/m^2                  |          | lambert
1e4 cd/m^2                       | sb       | stilb
1e4 lm/m^2                       | ph       | phot
1 cd/m^2                         | nt       | nit
4.184e4 J/m^2                    |          | langley
cd/(pi m^2)                      |          | blondel apostilb
# others
100/m                            |          | kayser
gravity                          | gp       | geopotential dynamic
2056 hours                       |          | work_year
work_year/12                     |          | work_month
1e-6 m^2 s^-1 K kg^-1            | PVU      | potential_vorticity_unit
1                                |          | count
1                                |          | bit
8                                |          | octet byte
446.2 micromoles/meter^2         | DU       | dobson
1/avogadro_constant              |          | molecule molec nucleon nuc
)table";

}  // namespace wythe
