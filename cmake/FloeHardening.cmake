# Hardens Release builds as Debian's packages are (dpkg-buildflags with hardening=+all): positions
# of code unknown to an attacker, stack and library calls checked, tables of the linker read-only.
include(CheckPIESupported)
check_pie_supported()
add_compile_options("$<$<CONFIG:Release>:-fstack-protector-strong;-Wformat;-Werror=format-security>")
add_compile_definitions($<$<CONFIG:Release>:_FORTIFY_SOURCE=2>)
add_link_options("$<$<CONFIG:Release>:-Wl,-z,relro;-Wl,-z,now>")
