// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/vector_registers.h"

namespace app {

#ifdef __x86_64__
namespace {

__attribute__((target("avx"))) void emptyByAvx() { __builtin_ia32_vzeroupper(); }

} // namespace

void emptyUpperHalves()
{
    if (__builtin_cpu_supports("avx"))
        emptyByAvx();
}
#else
void emptyUpperHalves() {}
#endif

} // namespace app
