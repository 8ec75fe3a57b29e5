# Compile settings that every target of floe shares; warnings stay private to us.
function(floe_configure_target target)
  # -Wno-restrict: GCC 12 reports std::string additions that are fine (its bug 105329)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wpedantic -Wnon-virtual-dtor
    -Wno-unknown-pragmas $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict> -fno-math-errno)
  if(FLOE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
