# SPDX-License-Identifier: GPL-3.0-or-later
# Writes a source of several tests, each in a namespace of its own: cmake -DTESTS=A.cpp|B.cpp -DROOT=TESTS -DTO=FILE -P this
# Their headers come first, outside the namespaces; where a test includes them again they are skipped. Its `main`, which
# QTEST_MAIN writes, gets a name that the program's own `main` can call.
include(${CMAKE_CURRENT_LIST_DIR}/test_names.cmake)
string(REPLACE "|" ";" tests "${TESTS}")
set(headers "#include <QtCore/qmetatype.h>" "#include <memory>") # those of moc
set(body)
foreach(test IN LISTS tests)
  file(STRINGS ${test} lines REGEX "^#include")
  list(FILTER lines EXCLUDE REGEX "\\.moc\"")
  list(APPEND headers ${lines})
  name_of_test(${test} ${ROOT} name)
  string(MAKE_C_IDENTIFIER ${name} space)
  string(APPEND body "namespace ${space} {\n#include \"${test}\"\n}\n")
endforeach()
list(REMOVE_DUPLICATES headers)
list(JOIN headers "\n" headers)
file(WRITE ${TO} "${headers}\n\n#define main mainOfTest\n${body}")
