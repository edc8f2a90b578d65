// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <new>

// The heap of a test that watches what is taken, or runs short. Only the one source of a test
// program includes it. All forms are replaced that the standard library calls: one that is not
// would take from another heap than the one to which `delete` gives back.

/// Called for each piece of memory that is asked for; true: the heap refuses it.
bool heapRefuses(std::size_t size);

void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept
{
    return heapRefuses(size) ? nullptr : std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size)
{
    if (void* const taken = operator new(size, std::nothrow))
        return taken;
    throw std::bad_alloc();
}
void operator delete(void* given) noexcept { std::free(given); }
void operator delete(void* given, std::size_t) noexcept { std::free(given); }
void operator delete(void* given, const std::nothrow_t& /*unused*/) noexcept { std::free(given); }
