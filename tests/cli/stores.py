"""Changes that tests make to the store of a campaign."""
import struct


def checksum(database, tables, sample):
    """The checksum that a store keeps of a sample's rows (src/campaign/store/digest.h): FNV-1a, table after table."""
    data = b""
    for table in tables:
        order = "" if table in ("sample", "curve") else " ORDER BY position"
        data += table.encode()
        for row in database.execute(f"SELECT * FROM {table} WHERE sample = ?{order}", (sample,)):
            for cell in row:
                if isinstance(cell, int):
                    data += struct.pack("<iq", 1, cell)
                elif isinstance(cell, float):
                    data += struct.pack("<id", 2, cell)
                elif cell is None:
                    data += struct.pack("<i", 5)
                else:
                    raw = cell.encode() if isinstance(cell, str) else cell
                    data += struct.pack("<iq", 3 if isinstance(cell, str) else 4, len(raw)) + raw
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return value - (1 << 64) if value >> 63 else value


def renew_checksums(database):
    """After a change of what samples answered: as if it had been stored so."""
    lists = [name for (name,) in database.execute("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY rowid")
             if name not in ("study", "input", "sample_input", "sample", "curve", "state", "digest")]
    for (sample,) in database.execute("SELECT sample FROM digest").fetchall():
        database.execute("UPDATE digest SET record = ?, states = ? WHERE sample = ?",
                         (checksum(database, ["sample_input", "sample", "curve", *lists], sample),
                          checksum(database, ["state"], sample), sample))
