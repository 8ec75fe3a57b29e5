# What the program prints about itself goes into files that are installed: manual page and completion
set(floe_documents ${PROJECT_BINARY_DIR}/documents)
file(MAKE_DIRECTORY ${floe_documents})
add_custom_command(
  OUTPUT ${floe_documents}/floe.1 ${floe_documents}/floe.1.gz ${floe_documents}/floe.bash ${floe_documents}/_floe
    ${floe_documents}/floe.fish
  COMMAND floe man >${floe_documents}/floe.1
  COMMAND gzip -9nkf ${floe_documents}/floe.1
  COMMAND floe completion bash >${floe_documents}/floe.bash
  COMMAND floe completion zsh >${floe_documents}/_floe
  COMMAND floe completion fish >${floe_documents}/floe.fish
  DEPENDS floe COMMENT "Writing the manual page and the completion scripts")
add_custom_target(documents ALL DEPENDS ${floe_documents}/floe.1.gz)

install(FILES ${floe_documents}/floe.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${floe_documents}/floe.bash
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions RENAME floe)
install(FILES ${floe_documents}/_floe DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/zsh/vendor-completions)
install(FILES ${floe_documents}/floe.fish
  DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/fish/vendor_completions.d)
