// Numbers as the studio says them.
import { num, qty } from "../base/texts";

// To the millimetre where it matters, never "1.2000001".
export const metres = (value: number): string => qty(Math.round(value * 1000) / 1000, "m", Math.abs(value) >= 10 ? 5 : 4);
export const whole = (value: number): string => num(Math.round(value), 7);
// What the file says in a way that is not read here.
export const kUnread = "–";
export const amount = (value: number | null, factor: number, unit: string): string => (value === null ? kUnread : qty(value * factor, unit));
