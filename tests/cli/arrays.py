"""Reads .npy and .npz files where there is no NumPy: a matrix as a list of its rows."""
import ast
import struct
import zipfile

kinds = {"<f8": "d", "<i4": "i", "<i8": "q"}


def array(data):
    end = 10 + struct.unpack("<H", data[8:10])[0]
    header = ast.literal_eval(data[10:end].decode())
    if header["descr"] not in kinds:
        return data[end:]
    entries = [entry for (entry,) in struct.iter_unpack("<" + kinds[header["descr"]], data[end:])]
    if len(header["shape"]) < 2:
        return entries
    rows, columns = header["shape"]
    if header["fortran_order"]:
        return [entries[row::rows] for row in range(rows)]
    return [entries[row * columns:(row + 1) * columns] for row in range(rows)]


def load(file):
    if file.endswith(".npz"):
        with zipfile.ZipFile(file) as archive:
            return {name.removesuffix(".npy"): array(archive.read(name)) for name in archive.namelist()}
    with open(file, "rb") as npy:
        return array(npy.read())


def dense(sparse, columns):
    """The matrix of an .npz file of SciPy's, by compressed rows."""
    ends = sparse["indptr"]
    rows = [[0.0] * columns for _ in ends[1:]]
    for row, first, last in zip(rows, ends, ends[1:]):
        for column, entry in zip(sparse["indices"][first:last], sparse["data"][first:last]):
            row[column] = entry
    return rows
