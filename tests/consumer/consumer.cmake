# cmake -DSOURCE=<root of the project> -DBUILD=<its build folder> -DCXX=<compiler>
#       -DCXX_FLAGS=<flags of the whole build, such as sanitizers> -P consumer.cmake
# builds and runs a small project, with the installed package and with the sources as a subproject.
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(folder ${BUILD}/tests/consumer)
file(REMOVE_RECURSE ${folder}/installed ${folder}/moved ${folder}/package ${folder}/subproject)
set(configure ${CMAKE_COMMAND} -G Ninja -S ${SOURCE}/tests/consumer/project
    -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${CXX} "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")

# The small project has none of the libraries' options, so it is compiled for any CPU. The data that
# it shares with libraries compiled for this CPU must still agree.
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/installed)
file(RENAME ${folder}/installed ${folder}/moved)  # users may move a package
run(${configure} -B ${folder}/package -D CMAKE_PREFIX_PATH=${folder}/moved)
run(${CMAKE_COMMAND} --build ${folder}/package)
foreach(program IN ITEMS one_library fast_sum mobility load_function)
  run(${folder}/package/${program})
endforeach()

run(${configure} -B ${folder}/subproject -D STOKESBOOK_SOURCE=${SOURCE})
run(${CMAKE_COMMAND} --build ${folder}/subproject --target one_library)
run(${folder}/subproject/one_library)
