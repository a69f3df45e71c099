// The photo that is traced, kept in the browser's own database: never in a link, never in a model file.
export interface KeptPhoto {
  name: string;
  type: string;
  bytes: ArrayBuffer;
  place: PhotoPlace;
  opacity: number;
  shown: boolean;
}
// Where it lies: its lower left corner, and how long one of its pixels is [m].
export interface PhotoPlace {
  x: number;
  y: number;
  metre: number;
}
const kStore = "photo";

function database(): Promise<IDBDatabase> {
  return new Promise((done, refuse) => {
    const asked = indexedDB.open("wythe.studio", 1);
    asked.onupgradeneeded = () => asked.result.createObjectStore(kStore);
    asked.onsuccess = () => done(asked.result);
    asked.onerror = asked.onblocked = () => refuse(asked.error);
  });
}
async function does<T>(mode: IDBTransactionMode, what: (store: IDBObjectStore) => IDBRequest<T>): Promise<T> {
  const db = await database();
  try {
    return await new Promise((done, refuse) => {
      const work = db.transaction(kStore, mode);
      const asked = what(work.objectStore(kStore));
      work.oncomplete = () => done(asked.result);
      work.onerror = work.onabort = () => refuse(work.error);
    });
  } finally {
    db.close();
  }
}
// false: the browser keeps nothing (no room, or not allowed).
export const keepPhoto = (photo: KeptPhoto): Promise<boolean> => does("readwrite", (s) => s.put(photo, "photo")).then(() => true, () => false);
export const forgetPhoto = (): Promise<void> => does("readwrite", (s) => s.delete("photo")).then(() => undefined, () => undefined);
export const keptPhoto = (): Promise<KeptPhoto | null> => does("readonly", (s) => s.get("photo") as IDBRequest<KeptPhoto | undefined>).then((p) => p ?? null, () => null);
