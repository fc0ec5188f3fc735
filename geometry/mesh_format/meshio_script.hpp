#pragma once

namespace searle::geometry {

/// The Python program that hands a mesh to meshio. Arguments: folder, target, dimension. The folder
/// holds mesh.txt ("points N"; "block TYPE NODES COUNT" for each block of cells and of faces;
/// "name NUMBER DIMENSION NAME"), points.bin, cells.bin and numbers.bin (raw arrays of double,
/// uint32 and int32, block after block). It writes the target, reads it back and compares.
/// It prints what the format cannot hold, a line each. Exit codes: 0 written; 7 no meshio; 8 a
/// module that meshio needs is missing; 9 the format cannot hold the mesh (the last line says why).
extern const char* const meshio_script;

} // namespace searle::geometry
