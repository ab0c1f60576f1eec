# The manual and what shells complete command lines by, both from the definitions that --help shows.

set(FFSTUDY_MAN_PAGES ${PROJECT_BINARY_DIR}/man1)
add_custom_command(OUTPUT ${FFSTUDY_MAN_PAGES}/ffstudy.1
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${FFSTUDY_MAN_PAGES}
  COMMAND ffstudy man_pages ${FFSTUDY_MAN_PAGES}
  DEPENDS ffstudy
  COMMENT "Writing the man pages"
  VERBATIM)
add_custom_target(ff_man_pages ALL DEPENDS ${FFSTUDY_MAN_PAGES}/ffstudy.1)
install(DIRECTORY ${FFSTUDY_MAN_PAGES} DESTINATION ${CMAKE_INSTALL_MANDIR})

# What bash, zsh and fish load to complete its command lines.
set(FFSTUDY_ZSH_DIR ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Folder for the completion of zsh")
install(FILES ${PROJECT_SOURCE_DIR}/app/completion/ffstudy.bash RENAME ffstudy DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_SOURCE_DIR}/app/completion/_ffstudy DESTINATION ${FFSTUDY_ZSH_DIR})
install(FILES ${PROJECT_SOURCE_DIR}/app/completion/ffstudy.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
