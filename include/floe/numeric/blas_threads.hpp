#pragma once

#include <dlfcn.h>

namespace floe::numeric {

/// Sets the number of threads of OpenBLAS; does nothing with another BLAS. The setter is looked up
/// at run time because the user may have switched the BLAS after the build.
inline void set_blas_threads(int threads) {
  using Setter = void (*)(int);
  if (void* const symbol = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
    reinterpret_cast<Setter>(symbol)(threads);
}

/// Makes a threaded OpenBLAS work with one thread, so that results do not depend on the number of
/// processors.
inline void use_one_blas_thread() { set_blas_threads(1); }

/// Gives a threaded OpenBLAS back the threads that it had, for callers that use it too.
class KeptBlasThreads {
 public:
  KeptBlasThreads() {
    using Getter = int (*)();
    if (void* const symbol = dlsym(RTLD_DEFAULT, "openblas_get_num_threads"))
      before_ = reinterpret_cast<Getter>(symbol)();
  }
  ~KeptBlasThreads() {
    if (before_ > 0) set_blas_threads(before_);
  }
  KeptBlasThreads(const KeptBlasThreads&) = delete;
  KeptBlasThreads& operator=(const KeptBlasThreads&) = delete;

 private:
  int before_ = 0;
};

}  // namespace floe::numeric
