# Installs the runtime into an empty folder, builds the example against it alone, and looks at its picture.
set(work ${BUILD}/tests/install/work)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGV}\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=address,undefined")
endif()
run(${CMAKE_COMMAND} --install ${BUILD} --component runtime --prefix ${work}/prefix)
run(${CMAKE_COMMAND} -S ${EXAMPLE} -B ${work}/build -G Ninja -D CMAKE_PREFIX_PATH=${work}/prefix
    -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${flags} -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${work}/build)
run(${WRITER} ${work}/tree.bosk)
run(${work}/build/draw_tree ${work}/tree.bosk ${work}/tree.ppm)

# The ball that the sample is fills a good part of the picture, not all of it
if(NOT output MATCHES "([0-9]+) billboards, ([0-9]+) % of the picture")
  message(FATAL_ERROR "the example says: ${output}")
endif()
if(CMAKE_MATCH_1 LESS 500 OR CMAKE_MATCH_2 LESS 10 OR CMAKE_MATCH_2 GREATER 90)
  message(FATAL_ERROR "the example did not draw the tree: ${output}")
endif()
file(SIZE ${work}/tree.ppm bytes)
if(NOT bytes EQUAL 196623)  # 256 x 256 x 3 and a header of 15 bytes
  message(FATAL_ERROR "the picture has ${bytes} bytes")
endif()
