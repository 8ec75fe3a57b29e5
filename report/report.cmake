# The page of `floe report`: scripts and styles bundled by esbuild into one template, which becomes
# a string in the program. `scripts/setup` installs what is needed (npm ci in this folder).
set(report_folder ${PROJECT_SOURCE_DIR}/report)
set(report_template ${PROJECT_BINARY_DIR}/report/report_template.cpp)
set(esbuild ${report_folder}/node_modules/.bin/esbuild)
set(uplot ${report_folder}/node_modules/uplot/package.json)
if(NOT EXISTS ${esbuild} OR NOT EXISTS ${uplot})
  message(FATAL_ERROR "floe's report page needs its npm packages: run scripts/setup, or "
    "`npm ci` in ${report_folder}, or configure with -DFLOE_REPORT=OFF")
endif()
file(GLOB report_sources CONFIGURE_DEPENDS ${report_folder}/src/*.js ${report_folder}/src/*.css
  ${report_folder}/src/*.html)
add_custom_command(
  OUTPUT ${report_template}
  COMMAND ${esbuild} ${report_folder}/src/main.js --bundle --minify --charset=utf8
    --target=es2022 --log-level=warning --outfile=${PROJECT_BINARY_DIR}/report/report.js
  COMMAND ${CMAKE_COMMAND}
    -DTEMPLATE=${report_folder}/src/report.html
    -DSCRIPT=${PROJECT_BINARY_DIR}/report/report.js
    -DSTYLE=${PROJECT_BINARY_DIR}/report/report.css
    -DOUTPUT=${report_template} -P ${report_folder}/embed.cmake
  DEPENDS ${report_sources} ${uplot} ${report_folder}/embed.cmake
  VERBATIM COMMENT "Bundling the report's page")
target_sources(floe_engine PRIVATE ${report_template})
