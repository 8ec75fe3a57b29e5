#pragma once

#include <dlfcn.h>

namespace floe::numeric {

/// Makes a threaded OpenBLAS work with one thread, so that results do not depend on the number of
/// processors; does nothing with another BLAS. The setter is looked up at run time because the
/// user may have switched the BLAS after the build.
inline void use_one_blas_thread() {
  using Setter = void (*)(int);
  if (void* const symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<Setter>(symbol)(1);
}

}  // namespace floe::numeric
