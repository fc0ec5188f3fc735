#include "geometry/mesh_format/meshio_script.hpp"

namespace searle::geometry {

const char* const meshio_script = R"(
import contextlib, io, os, sys
try:
    import meshio, numpy
except ImportError:
    sys.exit(7)

folder, target, dimension = sys.argv[1], sys.argv[2], int(sys.argv[3])
ending = os.path.splitext(target)[1].lower()

def refuse(why):
    print("a " + ending + " file cannot hold this mesh: " + why)
    sys.exit(9)

types, names = [], {}
for line in open(os.path.join(folder, "mesh.txt")):
    words = line.split()
    if words[0] == "block":
        types.append((words[1], int(words[2]), int(words[3])))
    elif words[0] == "name":
        names[int(words[1])] = (words[3], int(words[2]))
points = numpy.fromfile(os.path.join(folder, "points.bin")).reshape(-1, 3)
nodes = numpy.fromfile(os.path.join(folder, "cells.bin"), dtype="uint32").astype("int64")
numbers = numpy.fromfile(os.path.join(folder, "numbers.bin"), dtype="int32").astype("int64")
blocks, physical, at, cell = [], [], 0, 0
for kind, width, count in types:
    blocks.append((kind, nodes[at:at + width * count].reshape(count, width)))
    physical.append(numbers[cell:cell + count])
    at += width * count
    cell += count
if dimension == 2:
    points = points[:, :2]
# Shapes that meshio 5.0 writes but whose dimension it does not know.
for kind in ("wedge15", "pyramid13"):
    meshio._mesh.topological_dimension.setdefault(kind, 3)
mesh = meshio.Mesh(points, blocks, cell_data={"gmsh:physical": physical},
                   field_data={n: numpy.array([i, d]) for i, (n, d) in names.items()})

# Some writers of meshio 5.0 take a block of cells for a pair.
meshio.CellBlock.__iter__ = lambda block: iter((block.type, block.data))
options = {}
if ending == ".inp":
    # The plain element of each shape; meshio's table of the way back has the last of its variants.
    from meshio.abaqus import _abaqus
    _abaqus.abaqus_to_meshio_type["C3D5"] = "pyramid"
    _abaqus.meshio_to_abaqus_type.update(
        {"tetra": "C3D4", "tetra10": "C3D10", "pyramid": "C3D5", "wedge": "C3D6",
         "wedge15": "C3D15", "hexahedron": "C3D8", "hexahedron20": "C3D20", "triangle": "S3",
         "triangle6": "STRI65", "quad": "S4", "quad8": "S8R", "line": "T3D2", "line3": "T3D3"})
    mesh.cell_data, mesh.field_data = {}, {}
elif ending == ".med":
    mesh.cell_data = {"cell_tags": [-p for p in physical]}
    mesh.cell_tags = {-i: [n] for i, (n, d) in names.items()}
    mesh.field_data = {}
elif ending in (".bdf", ".nas", ".fem"):
    mesh.cell_data = {"nastran:ref": physical}
    # With meshio's 11 digits a negative number does not fit into its 16 letters.
    from meshio.nastran import _nastran
    _nastran._float_to_nastran_string = lambda value, length=16: numpy.format_float_scientific(
        value, exp_digits=1, precision=8).replace("e", "E")
elif ending in (".xdmf", ".xmf"):
    # meshio 5.0 reads mixed cells of the first order only; the file itself is after the standard.
    import meshio.xdmf.main
    from meshio.xdmf.common import xdmf_idx_to_meshio_type
    def cells_of(data):
        widths = dict(meshio._common.num_nodes_per_cell)
        found, at = [], 0
        while at < len(data):
            kind = xdmf_idx_to_meshio_type[int(data[at])]
            at += 2 if kind == "line" else 1
            if not found or found[-1][0] != kind:
                found.append((kind, []))
            found[-1][1].append(data[at:at + widths[kind]])
            at += widths[kind]
        return [meshio.CellBlock(kind, numpy.array(rows)) for kind, rows in found]
    meshio.xdmf.main.translate_mixed_cells = cells_of
    try:
        import h5py
    except ImportError:
        options["data_format"] = "XML"
# meshio prints advice of its own.
said = io.StringIO()
try:
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        meshio.write(target, mesh, **options)
        if ending == ".inp":
            # One set a name: meshio writes one a name and shape, and reads the last of them.
            everything = numpy.concatenate(physical)
            with open(target, "a") as out:
                for i, (n, d) in names.items():
                    members = [str(k + 1) for k in numpy.flatnonzero(everything == i)]
                    out.write("*ELSET, ELSET=%s\n" % n)
                    out.write(",\n".join(",".join(members[k:k + 8])
                                         for k in range(0, len(members), 8)) + "\n")
        back = meshio.read(target)
except ImportError as error:
    # netCDF4 is python3-netcdf4
    print("the Python module %s is missing; to get it: apt-get install python3-%s"
          % (error.name, error.name.lower()))
    sys.exit(8)
except KeyError as error:
    refuse("it has no cells of the shape %s" % error)
except (Exception, SystemExit) as error:
    text = str(error).strip() or (said.getvalue().strip().splitlines() or [""])[-1]
    refuse("%s%s" % (type(error).__name__, text and ": " + text))

# What was written is what is read back, or it is not offered.
if len(back.points) != len(points):
    refuse("%d of %d points come back" % (len(back.points), len(points)))
extent = abs(points).max()
flat = numpy.zeros((len(points), 3))
flat[:, :points.shape[1]] = points
again = numpy.zeros((len(points), 3))
again[:, :back.points.shape[1]] = back.points
off = abs(flat - again).max() / extent
if not off < 1e-6:
    refuse("points come back off by %.1g of the extent" % off)
def gathered(cells, data):
    found = {}
    for block, values in zip(cells, data):
        found.setdefault(block.type, []).append(
            numpy.column_stack((numpy.asarray(block.data), numpy.asarray(values))))
    return {kind: numpy.concatenate(parts) for kind, parts in found.items()}
def ordered(rows):
    return rows[numpy.lexsort(rows.T[::-1])]
def difference(asked, found):
    for kind, rows in asked.items():
        there = found.get(kind, rows[:0])
        if there.shape != rows.shape:
            return "%d of %d cells of the shape %s come back" % (len(there), len(rows), kind)
        if not ((there == rows).all() or (ordered(there) == ordered(rows)).all()):
            return "cells of the shape %s come back with other nodes" % kind
    return None
def bare(cells):
    return [numpy.zeros(len(block.data), dtype="int64") for block in cells]
fault = difference(gathered(mesh.cells, bare(mesh.cells)), gathered(back.cells, bare(back.cells)))
if fault:
    refuse(fault)
keeps_names = ending in (".inp", ".su2", ".med", ".xdmf", ".xmf")
keeps_numbers = any(
    len(data) == len(back.cells)
    and difference(gathered(mesh.cells, physical), gathered(back.cells, data)) is None
    for data in back.cell_data.values())
if not keeps_names and keeps_numbers:
    print("a %s file has no names of patches; their numbers in it are: %s"
          % (ending, ", ".join("%d %s" % (i, n) for i, (n, d) in sorted(names.items()))))
elif not keeps_names:
    print("a %s file holds neither names nor numbers of patches" % ending)
if off > 1e-12:
    print("a %s file holds points to %.0g of the extent" % (ending, off))

if ending == ".su2":
    text = open(target).read()
    for i, (n, d) in names.items():
        text = text.replace("MARKER_TAG= %d\n" % i, "MARKER_TAG= %s\n" % n)
    open(target, "w").write(text)
if ending in (".xdmf", ".xmf"):
    text = open(target).read()
    keys = "".join('<map key="%s" dim="%d">%d</map>' % (n, d, i) for i, (n, d) in names.items())
    place = text.index("<Grid") + text[text.index("<Grid"):].index(">") + 1
    text = (text[:place] + '<Information Name="patches" Value="%d"><![CDATA[<main>%s</main>]]>'
            '</Information>' % (len(names), keys) + text[place:])
    open(target, "w").write(text)
)";

} // namespace searle::geometry
