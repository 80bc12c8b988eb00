# Writes the commit of the sources into a source file:
#     cmake -D GIT=... -D SOURCE=... -D OUTPUT=... -P commit.cmake
set(commit "$Format:%h$")  # filled in by git archive
if(commit MATCHES "Format")
  set(commit "")
  if(GIT)
    execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --show-toplevel
      OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(top STREQUAL SOURCE)  # not a repository that merely contains the sources
      execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=9 HEAD
        OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    endif()
  endif()
endif()
file(WRITE ${OUTPUT} "#include \"commit.hpp\"\n\nconst char* carom::commit() { return \"${commit}\"; }\n")
