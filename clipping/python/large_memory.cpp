// SPDX-License-Identifier: MIT
#include "clipping/python/large_memory.h"

#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace clipping::python {
namespace {

constexpr std::size_t hugePage = std::size_t(1) << 21;
constexpr std::size_t header = 64; ///< before the memory: its size; keeps the memory aligned

struct Block {
    void* start = nullptr;
    std::size_t bytes = 0;
};

std::mutex keptMutex;
Block kept; ///< guarded by keptMutex

Block exchangeKept(Block block)
{
    const std::scoped_lock one(keptMutex);
    return std::exchange(kept, block);
}

bool isLarge(std::size_t bytes) { return bytes >= 2 * hugePage; }

// A block that is far too large is not used: it would keep its pages from the system.
Block keptFor(std::size_t bytes)
{
    const std::scoped_lock one(keptMutex);
    const bool fits = kept.bytes >= bytes && kept.bytes / 2 <= bytes;
    return fits ? std::exchange(kept, {}) : Block{};
}

Block newBlock(std::size_t bytes)
{
    const Block block{std::aligned_alloc(isLarge(bytes) ? hugePage : header, bytes), bytes};
    if (!block.start)
        throw std::bad_alloc();
#ifdef __linux__
    if (isLarge(bytes)) // a hundred thousand page faults take longer than clipping
        ::madvise(block.start, bytes, MADV_HUGEPAGE);
#endif
    return block;
}

} // namespace

void* takeMemory(std::size_t bytes)
{
    const std::size_t page = isLarge(bytes) ? hugePage : header;
    bytes = ((bytes + header) / page + 1) * page;
    Block block = isLarge(bytes) ? keptFor(bytes) : Block{};
    if (!block.start)
        block = newBlock(bytes);
    *static_cast<std::size_t*>(block.start) = block.bytes;
    return static_cast<char*>(block.start) + header;
}

void giveMemory(void* memory)
{
    if (!memory)
        return;
    void* const start = static_cast<char*>(memory) - header;
    Block block{start, *static_cast<std::size_t*>(start)};
    if (isLarge(block.bytes)) {
#ifdef MADV_FREE
        ::madvise(block.start, block.bytes, MADV_FREE);
#endif
        block = exchangeKept(block);
    }
    std::free(block.start);
}

} // namespace clipping::python
