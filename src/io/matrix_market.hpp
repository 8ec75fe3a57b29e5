#pragma once

#include <floe/numeric/types.hpp>

#include <string>
#include <string_view>

/// Matrices from Matrix Market files (NIST): a line `%%MatrixMarket matrix FORMAT FIELD SYMMETRY`,
/// comments %, sizes, entries. FIELD is real or integer, SYMMETRY general or symmetric. Faults are
/// MeshErrors that name the file and the line.
namespace floe::io {

/// FORMAT coordinate; both triangles of a symmetric one come back, entries given twice are refused.
SparseMatrix parse_sparse_matrix(std::string_view text, const std::string& file_name);

/// FORMAT array, general: column after column.
MatXd parse_dense_matrix(std::string_view text, const std::string& file_name);

}  // namespace floe::io
