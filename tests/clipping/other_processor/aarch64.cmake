# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=… -DWORK=… -DGENERATOR=… -P aarch64.cmake
# The library made for ARM, run under qemu, answers with the same bits: each fingerprint that it prints is that of
# fingerprints.txt. (Those of the kernels for x86 are not asked there.)
cmake_minimum_required(VERSION 3.25)
find_program(cxx aarch64-linux-gnu-g++)
find_program(qemu NAMES qemu-aarch64 qemu-aarch64-static)
if(NOT cxx OR NOT qemu)
  message("Skipped: needs Debian's g++-aarch64-linux-gnu and qemu-user-static")
  return()
endif()

# GLM is headers alone, and those of this machine do; the other headers beside them do not.
find_path(glm glm/glm.hpp PATHS /usr/local/include /usr/include REQUIRED)
file(MAKE_DIRECTORY ${WORK}/include ${WORK}/cmake)
file(CREATE_LINK ${glm}/glm ${WORK}/include/glm SYMBOLIC)
file(WRITE ${WORK}/cmake/glmConfig.cmake "add_library(glm::glm INTERFACE IMPORTED)
target_include_directories(glm::glm INTERFACE ${WORK}/include)\n")

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE output)
  set(output "${output}" PARENT_SCOPE)
endfunction()
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -G ${GENERATOR} -DCMAKE_SYSTEM_NAME=Linux
  -DCMAKE_SYSTEM_PROCESSOR=aarch64 -DCMAKE_CXX_COMPILER=${cxx} -DCMAKE_BUILD_TYPE=Release -Dglm_DIR=${WORK}/cmake)
run(${CMAKE_COMMAND} --build ${WORK}/build --target fingerprints)
run(${qemu} ${WORK}/build/fingerprints)

file(STRINGS ${SOURCE}/../fingerprints.txt kept)
string(REPLACE "\n" ";" lines "${output}")
list(REMOVE_ITEM lines "")
list(LENGTH lines asked)
foreach(line IN LISTS lines)
  if(NOT line IN_LIST kept)
    message(SEND_ERROR "Another answer on ARM: ${line}")
  endif()
endforeach()
if(asked LESS 50)
  message(SEND_ERROR "Only ${asked} questions were asked")
endif()
message("${asked} fingerprints are those of fingerprints.txt")
