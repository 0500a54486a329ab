# cmake -DSOURCE=<root of the project> -DBUILD=<build folder> -P clang.cmake
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} --preset clang -B ${BUILD}
                COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD}
                COMMAND_ERROR_IS_FATAL ANY)
