export interface Scene { element: HTMLElement; draw(look: unknown): void; resize(w: number, h: number): void; png(): Promise<Blob> }
export function makeScene(..._: unknown[]): Scene | null { return null; }
