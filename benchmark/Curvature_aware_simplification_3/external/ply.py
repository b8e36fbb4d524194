"""Vertices of binary ply files."""

import numpy

NUMPY_TYPES = {
    "char": "i1", "int8": "i1", "uchar": "u1", "uint8": "u1",
    "short": "i2", "int16": "i2", "ushort": "u2", "uint16": "u2",
    "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4",
    "float": "f4", "float32": "f4", "double": "f8", "float64": "f8",
}


def read_header(file):
    """number of vertices and their fields; `file` is left at the first vertex"""
    if file.readline().strip() != b"ply":
        raise ValueError("not a ply file")
    vertices, fields, element = None, [], None
    for line in iter(lambda: file.readline().decode().split(), ["end_header"]):
        if not line:
            raise ValueError("ply file without an end of the header")
        if line[0] == "format" and line[1] != "binary_little_endian":
            raise ValueError(f"ply file of format {line[1]}")
        if line[0] == "element":
            element = line[1]
            if element == "vertex":
                vertices = int(line[2])
            elif vertices is None:
                raise ValueError("ply file whose vertices do not come first")
        if line[0] == "property" and element == "vertex":
            fields.append((line[2], "<" + NUMPY_TYPES[line[1]]))
    return vertices, fields


def read_vertices(name):
    with open(name, "rb") as file:
        vertices, fields = read_header(file)
        vertex = numpy.dtype(fields)
        data = file.read(vertices * vertex.itemsize)
    if len(data) != vertices * vertex.itemsize:
        raise ValueError("ply file that ends early")
    return numpy.frombuffer(data, vertex)


def read_points(name):
    """array of coordinates, float or double as in the file"""
    vertices = read_vertices(name)
    return numpy.stack([vertices[axis] for axis in "xyz"], axis=1)


def read_values(name, field):
    return read_vertices(name)[field]


def write_points(name, points):
    scalar = "float" if points.dtype == numpy.float32 else "double"
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(points)}"]
    header += [f"property {scalar} {axis}" for axis in "xyz"] + ["end_header", ""]
    with open(name, "wb") as file:
        file.write("\n".join(header).encode())
        file.write(numpy.ascontiguousarray(points).tobytes())
