# SPDX-License-Identifier: GPL-3.0-or-later
# name_of_test(SOURCE ROOT RESULT): tests/app/cut/cut_test.cpp is app.cut.cut_test; a drawing task is tasks.NAME.
function(name_of_test source root result)
  file(RELATIVE_PATH name ${root} ${source})
  string(REGEX REPLACE "\\.cpp$" "" name ${name})
  string(REPLACE "/" "." name ${name})
  string(REGEX REPLACE "^ui\\.tasks" "tasks" name ${name})
  set(${result} ${name} PARENT_SCOPE)
endfunction()
