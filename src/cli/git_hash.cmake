# cmake -D SOURCE=<root of the project> -D OUTPUT=<file> -P git_hash.cmake
# writes a header with the commit of the sources; "unknown" in a tree without git.
set(hash unknown)
# Without the check, git would answer for a repository that merely contains this tree.
if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE
                  ERROR_QUIET RESULT_VARIABLE failed)
  if(failed EQUAL 0)
    set(hash ${commit})
    # Only the sources of the program count: an edited chapter does not make a result doubtful.
    execute_process(COMMAND git -C ${SOURCE} --no-optional-locks status --porcelain -- src CMakeLists.txt
                            CMakePresets.json
                    OUTPUT_VARIABLE changes)
    if(changes)
      string(APPEND hash -dirty)
    endif()
  endif()
endif()
file(WRITE ${OUTPUT} "constexpr char git_hash[] = \"${hash}\";\n")
