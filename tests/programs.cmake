# SPDX-License-Identifier: GPL-3.0-or-later
# The programs of the tests: one for each room of app/ and ui/, one for all of clipping/, one for resources/, and one for
# the tests that read the sources alone. A test has a program of its own only if it is listed here.
set(own_programs
  # They replace functions of the C library or of the standard library.
  app/document/edited_document_test app/formats/full_disk_test app/formats/svg/writer_test app/recovery/journal_full_disk_test
  app/recovery/journal_thread_test app/recovery/too_little_memory_test app/recovery/unsaved_work_test
  app/settings/settings_test app/view/picking_test ui/dialogs/questions_test ui/files/files_busy_test
  ui/files/slow_save_test
  # They start themselves as another process, or their QApplication is not the usual one.
  app/recovery/kill_test ui/canvas/painting_test ui/editor/recovery_test ui/editor/start_test ui/first_light_test
  # OpenGL: each in an X server of its own.
  app/experiment/opengl_target_gl_test ui/canvas/canvas_gl_test ui/canvas/panes_gl_test
  # oneTBB has functions that are called as Qt's `emit`.
  clipping/parallel/clip_all_test)

# test_main.cpp, compiled once for the programs without widgets and once for those with them.
foreach(kind IN ITEMS gui widgets)
  add_library(test_main_${kind} OBJECT test_main.cpp)
  target_compile_definitions(test_main_${kind} PRIVATE SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_include_directories(test_main_${kind} PRIVATE ${PROJECT_SOURCE_DIR})
endforeach()
target_link_libraries(test_main_gui PRIVATE Qt6::Gui Qt6::Test)
target_link_libraries(test_main_widgets PRIVATE Qt6::Widgets Qt6::Test)

# name_of_test(SOURCE RESULT): tests/app/cut/cut_test.cpp is app.cut.cut_test; a drawing task is tasks.NAME.
function(name_of_test source result)
  file(RELATIVE_PATH name ${CMAKE_CURRENT_SOURCE_DIR} ${source})
  string(REGEX REPLACE "\\.cpp$" "" name ${name})
  string(REPLACE "/" "." name ${name})
  string(REGEX REPLACE "^ui\\.tasks" "tasks" name ${name})
  set(${result} ${name} PARENT_SCOPE)
endfunction()

function(program_of_test source result)
  file(RELATIVE_PATH path ${CMAKE_CURRENT_SOURCE_DIR} ${source})
  string(REGEX REPLACE "\\.cpp$" "" stem ${path})
  if(stem IN_LIST own_programs)
    name_of_test(${source} program)
  elseif(path MATCHES "^(app|ui)/[^/]+/")
    string(REGEX REPLACE "^([a-z]+)/([^/]+)/.*" "\\1.\\2" program ${path})
  elseif(path MATCHES "^([a-z]+)/")
    set(program ${CMAKE_MATCH_1}.tests)
  else()
    set(program sources.tests)
  endif()
  set(${result} ${program} PARENT_SCOPE)
endfunction()

# add_program_of_tests(PROGRAM TEST...). Sets own_main_of_PROGRAM if its test has a `main` of its own, which takes no
# name of a class.
function(add_program_of_tests program)
  set(sources ${ARGN})
  foreach(source IN LISTS ARGN)
    file(RELATIVE_PATH path ${PROJECT_SOURCE_DIR} ${source})
    string(REGEX REPLACE "cpp$" "moc" moc ${CMAKE_CURRENT_BINARY_DIR}/moc/${path})
    qt_generate_moc(${source} ${moc})
    list(APPEND sources ${moc})
  endforeach()
  list(GET ARGN 0 first)
  file(STRINGS ${first} own_main REGEX "^int main\\(")
  if(own_main)
    set(own_main_of_${program} TRUE PARENT_SCOPE)
  endif()
  qt_add_executable(${program} ${sources})
  target_include_directories(${program} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/moc ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${program} PRIVATE SOURCE_DIR="${PROJECT_SOURCE_DIR}" CLEARCUT_BINARY="$<TARGET_FILE:clearcut>")
  string(REGEX MATCH "^[a-z]+" layer ${program})
  link_tests(${program} ${layer})
  if(NOT own_main)
    set(main test_main_gui)
    if(layer MATCHES "^(ui|resources)$")
      set(main test_main_widgets)
    endif()
    target_link_libraries(${program} PRIVATE ${main})
  endif()
  if(CLEARCUT_PRECOMPILE AND NOT program MATCHES "^clipping[.]parallel")
    precompile_headers_of_tests(${program} ${layer})
    set_target_properties(${program} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 16)
    target_compile_options(${program} PRIVATE ${compiled_together})
  endif()
  if(build STREQUAL optimised AND layer MATCHES "^(app|ui)$") # they call the program; what they compute is little
    target_compile_options(${program} PRIVATE -Og -Wno-maybe-uninitialized) # it warns of std::stop_token, wrongly
  endif()
endfunction()

function(link_tests program layer)
  if(program MATCHES "^clipping[.]parallel")
    target_link_libraries(${program} PRIVATE clipping_parallel TBB::tbb)
  elseif(layer STREQUAL clipping)
    target_link_libraries(${program} PRIVATE clipping oracle)
  elseif(layer STREQUAL app)
    target_link_libraries(${program} PRIVATE app oracle)
  elseif(NOT layer STREQUAL sources) # which are read, whether they compile or not
    target_link_libraries(${program} PRIVATE ui)
  endif()
  target_link_libraries(${program} PRIVATE Qt6::Gui Qt6::Test)
endfunction()

# Once for all tests of a layer, which are compiled alike.
function(precompile_headers_of_tests program layer)
  get_property(first DIRECTORY PROPERTY first_tests_of_${layer})
  if(first)
    target_precompile_headers(${program} REUSE_FROM ${first})
  else()
    set_property(DIRECTORY PROPERTY first_tests_of_${layer} ${program})
    target_precompile_headers(${program} PRIVATE <QTest> ${headers_of_${layer}})
  endif()
endfunction()
