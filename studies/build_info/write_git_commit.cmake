# Writes OUTPUT with the commit of SOURCE_DIR, only when it changed, so that nothing is rebuilt in vain.
# Modified sources get the mark "+changes": such a result cannot be repeated from the commit alone.
set(commit "unknown")
find_program(GIT git)
if(GIT AND EXISTS "${SOURCE_DIR}/.git")
  execute_process(COMMAND "${GIT}" -C "${SOURCE_DIR}" describe --always --abbrev=40 --exclude=* --dirty=+changes
    OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit "${described}")
  endif()
endif()
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "#define GURNEY_GIT_COMMIT \"${commit}\"\n")
