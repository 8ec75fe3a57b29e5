#pragma once

#include <string>

namespace floe::numeric {

/// Multiplies, factors and solves small systems by the BLAS and LAPACK that the program was started
/// with and compares with plain sums: a library that was built for another processor gives wrong
/// numbers without a word. Takes less than a millisecond.
/// Throws Error naming the library, its processor core and what to do.
void require_working_blas();

/// Name and version of the BLAS with the processor core that it was made for, "OpenBLAS 0.3.21 …
/// (Haswell)"; "unknown" where it does not tell.
std::string blas_name();

/// What decides the last bits of results: the processor core for which BLAS has chosen its kernels
/// and the widest vectors, "Zen, 32-byte vectors".
std::string processor_kind();

}  // namespace floe::numeric
