# Puts script and style into the page and writes it as a C++ string in pieces that any compiler
# takes: cmake -DTEMPLATE=… -DSCRIPT=… -DSTYLE=… -DOUTPUT=… -P embed.cmake
cmake_minimum_required(VERSION 3.25)

# Everything as hexadecimal digits: no character has a meaning to CMake then
file(READ "${TEMPLATE}" page HEX)
file(READ "${SCRIPT}" script HEX)
file(READ "${STYLE}" style HEX)
string(HEX "@SCRIPT@" script_place)
string(HEX "@STYLE@" style_place)
string(HEX "</script" script_end)
string(FIND "${script}" "${script_end}" ends)
if(NOT ends EQUAL -1)
  message(FATAL_ERROR "the report's script contains </script")
endif()
string(REPLACE "${style_place}" "${style}" page "${page}")
string(REPLACE "${script_place}" "${script}" page "${page}")

string(LENGTH "${page}" digits)
math(EXPR size "${digits} / 2")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${page}")
string(REGEX REPLACE "(................................................................................)"
  "\\1\n    " bytes "${bytes}")
file(WRITE "${OUTPUT}" "#include \"io/report_template.hpp\"\n\nnamespace floe::io {\nnamespace {\n\n"
  "constexpr unsigned char kPage[] = {\n    ${bytes}};\n\n}  // namespace\n\n"
  "const std::string_view kReportTemplate(reinterpret_cast<const char*>(kPage), ${size});\n\n"
  "}  // namespace floe::io\n")
