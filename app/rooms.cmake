# SPDX-License-Identifier: GPL-3.0-or-later
# A room is a folder and a library. The rooms of app/ and of ui/ stand in the order of their CMakeLists.txt, each
# on those that it names: it finds no header of any other, so an include that points up does not compile.
# tests/rooms_test.cpp checks the list and the includes.
set(folders_of_rooms ${PROJECT_BINARY_DIR}/rooms) # rooms/app_view has app/view and nothing else

# Where files are compiled together, one sees the names of another, and g++ takes a type that only one of them has for one
# that many have. What that would warn of is looked for where each file is compiled by itself, in the debug preset.
set(compiled_together $<$<CXX_COMPILER_ID:GNU>:-Wno-shadow$<SEMICOLON>-Wshadow=local$<SEMICOLON>-Wno-subobject-linkage>)

# link_headers(ROOM FOLDER): `#include "FOLDER/…"` is found in the include folder of ROOM.
function(link_headers room folder)
  get_filename_component(above ${folders_of_rooms}/${room}/${folder} DIRECTORY)
  file(MAKE_DIRECTORY ${above})
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${folder} ${folders_of_rooms}/${room}/${folder} SYMBOLIC)
endfunction()

# room(NAME [ON ROOM...] [NO_MOC] [USES LIBRARY...] [DATA FILE...]): the folder NAME beside the CMakeLists.txt, as the library
# app_NAME or ui_NAME, which the library `app` or `ui` brings with all others. Without ON it stands on the libraries in
# `ground`. USES are its own affair; DATA, below resources/, is in the program as :/FILE. The headers in `precompiled`
# are compiled once, with the first room. NO_MOC: none of its classes has Q_OBJECT.
# Where one has, its source ends with `#include "moc_x.cpp"`; without it, moc's code is compiled apart, which takes longer.
#
# Where headers are precompiled, the files of a room are compiled 16 at a time, which takes less time. For that no two of
# them may have the same name in their unnamed namespaces; tests/local_names_test.cpp names those that do.
function(room name)
  cmake_parse_arguments(room "NO_MOC" "" "ON;USES;DATA" ${ARGN})
  get_filename_component(layer ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(room ${layer}_${name})
  set(CMAKE_AUTOGEN_ORIGIN_DEPENDS OFF) # moc need not wait until the rooms below are built
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${name}/*.h ${name}/*.cpp)
  qt_add_library(${room} STATIC ${sources})
  if(room_NO_MOC)
    set_target_properties(${room} PROPERTIES AUTOMOC OFF)
  endif()
  if(CLEARCUT_PRECOMPILE)
    set_target_properties(${room} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    target_compile_options(${room} PRIVATE ${compiled_together})
  endif()
  link_headers(${room} ${layer}/${name})
  target_include_directories(${room} PUBLIC ${folders_of_rooms}/${room})
  if(room_ON)
    list(TRANSFORM room_ON PREPEND ${layer}_)
  else()
    set(room_ON ${ground})
  endif()
  target_link_libraries(${room} PUBLIC ${room_ON} PRIVATE ${room_USES})
  target_link_libraries(${layer} INTERFACE ${room})
  get_property(first DIRECTORY PROPERTY first_room)
  if(CLEARCUT_PRECOMPILE AND first)
    target_precompile_headers(${room} REUSE_FROM ${first})
  elseif(CLEARCUT_PRECOMPILE)
    target_precompile_headers(${room} PRIVATE ${precompiled})
    set_property(DIRECTORY PROPERTY first_room ${room})
  endif()
  if(room_DATA)
    set(CMAKE_AUTOMOC OFF) # of the library that the resources are
    list(TRANSFORM room_DATA PREPEND ${PROJECT_SOURCE_DIR}/resources/)
    file(GLOB data CONFIGURE_DEPENDS ${room_DATA})
    qt_add_resources(${room} data_of_${room} PREFIX / BASE ${PROJECT_SOURCE_DIR}/resources FILES ${data})
  endif()
endfunction()
