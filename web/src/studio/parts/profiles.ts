// Rolled sections of the program's library (src/geometry/wall/profiles.cpp) with their height in the wall's plane [mm],
// for a choice and to draw. A test compares them with it.
const kHeights: Record<string, string> = {
  IPE: "80 100 120 140 160 180 200 220 240 270 300 330 360 400 450 500 550 600",
  HEA: "100:96 120:114 140:133 160:152 180:171 200:190 220:210 240:230 260:250 280:270 300:290 320:310 340:330 360:350 400:390 450:440 500:490",
  HEB: "100 120 140 160 180 200 220 240 260 280 300 320 340 360 400 450 500",
  UPN: "80 100 120 140 160 180 200 220 240 260 280 300",
  SHS: "80x5 80x6.3 100x5 100x6.3 100x8 120x5 120x6.3 120x8 140x6.3 140x8 150x6.3 150x8 160x8 180x8 200x8 200x10",
};

export const kProfiles: [name: string, height: number][] = Object.entries(kHeights).flatMap(([series, sizes]) =>
  sizes.split(" ").map((size): [string, number] => {
    const [nominal, height] = size.split(":");
    return [`${series} ${nominal}`, Number(height ?? nominal.split("x")[0])];
  }),
);

// "HEB200", "HE 200 B": as the table writes it, or as it was.
export function profileNamed(text: string): string {
  const key = text.replace(/\s/g, "").toUpperCase().replace(/^HE(\d+)([AB])$/, "HE$2$1");
  return kProfiles.find(([name]) => name.replace(" ", "").toUpperCase() === key)?.[0] ?? text;
}
// [m]
export const heightOf = (text: string): number | null => {
  const name = profileNamed(text);
  const found = kProfiles.find((p) => p[0] === name);
  return found ? found[1] / 1000 : null;
};
