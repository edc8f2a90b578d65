// SPDX-License-Identifier: MIT
#include "clipping/python/large_memory.h"

#include "clipping/ieee_numbers.h"

#include <cassert>
#include <cstdlib>
#include <mutex>
#include <new>
#include <sys/mman.h>
#include <utility>

namespace clipping::python {
namespace {

constexpr std::size_t hugePage = std::size_t(1) << 21;
constexpr std::size_t header = 64; ///< before the memory: the block's size; keeps it aligned

/// A large block is mapped: whole pages, in which nothing else is. A small one is malloc's.
struct Block {
    void* start = nullptr;
    std::size_t bytes = 0;
};

/// Decided on the final size of a block, never on the size that was asked for.
bool isLarge(std::size_t blockSize) { return blockSize >= 2 * hugePage; }

std::size_t roundedUp(std::size_t bytes, std::size_t unit)
{
    return (bytes + unit - 1) / unit * unit;
}

std::size_t blockSizeFor(std::size_t bytes)
{
    const std::size_t size = roundedUp(bytes + header, header);
    return isLarge(size) ? roundedUp(size, hugePage) : size;
}

Block newSmallBlock(std::size_t size)
{
    void* const start = std::aligned_alloc(header, size);
    if (!start)
        throw std::bad_alloc();
    return {start, size};
}

Block newLargeBlock(std::size_t size)
{
    void* const start =
        ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (start == MAP_FAILED)
        throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
    ::madvise(start, size, MADV_HUGEPAGE); // 100,000 page faults take longer than clipping
#endif
    return {start, size};
}

std::mutex keptMutex;
Block kept; ///< a large block, or none; guarded by keptMutex

// A block that is far too large is not used: it would keep its pages from the system.
Block keptFor(std::size_t size)
{
    const std::scoped_lock one(keptMutex);
    const bool fits = kept.bytes >= size && kept.bytes / 2 <= size;
    return fits ? std::exchange(kept, {}) : Block{};
}

void keep(Block block)
{
    assert(isLarge(block.bytes) && block.bytes % hugePage == 0);
#ifdef MADV_FREE
    ::madvise(block.start, block.bytes, MADV_FREE);
#endif
    {
        const std::scoped_lock one(keptMutex);
        std::swap(kept, block);
    }
    if (block.start)
        ::munmap(block.start, block.bytes);
}

Block largeBlock(std::size_t size)
{
    const Block block = keptFor(size);
    return block.start ? block : newLargeBlock(size);
}

} // namespace

void* takeMemory(std::size_t bytes)
{
    const std::size_t size = blockSizeFor(bytes);
    const Block block = isLarge(size) ? largeBlock(size) : newSmallBlock(size);
    *static_cast<std::size_t*>(block.start) = block.bytes;
    return static_cast<char*>(block.start) + header;
}

void giveMemory(void* memory)
{
    if (!memory)
        return;
    void* const start = static_cast<char*>(memory) - header;
    const std::size_t size = *static_cast<std::size_t*>(start);
    if (isLarge(size))
        keep({start, size});
    else
        std::free(start);
}

} // namespace clipping::python
