// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

// What libFuzzer calls, once for every input; each file *_fuzz.cpp defines it. Always 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// Ends the program with a sentence, so that the fuzzer keeps the input.
[[noreturn]] inline void found(const std::string& what)
{
    std::fprintf(stderr, "FOUND: %s\n", what.c_str());
    std::abort();
}
