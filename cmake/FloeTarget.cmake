# Compile settings that every target of floe shares; warnings stay private to us.
function(floe_configure_target target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wpedantic -Wnon-virtual-dtor
    -Wno-unknown-pragmas -fno-math-errno)
  if(FLOE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
endfunction()
