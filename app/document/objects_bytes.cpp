// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/shared.h"
#include "app/document/objects.h"

#include <functional>

namespace app {
namespace {

/// Sums the heap memory of paths and particulars, counting each shared part once.
class Parts {
public:
    // `beside`, if not null, has mostly the same parts in the same places.
    void add(const ObjectBlock& block, const ObjectBlock* beside = nullptr)
    {
        for (std::size_t i = 0; i < block.paths.size(); ++i)
            add(&ObjectBlock::pathPart, block, beside, i);
        for (std::size_t i = 0; i < block.particulars.size(); ++i)
            add(&ObjectBlock::particularsPart, block, beside, i);
    }

    std::size_t bytesNotIn(const Objects& others)
    {
        if (shared_.empty())
            return alone_;
        Parts theirs;
        for (const auto& block : others.blocks())
            theirs.add(*block);
        std::ranges::sort(theirs.shared_, before);
        std::ranges::sort(shared_, before);
        std::size_t bytes = alone_;
        const void* last = nullptr;
        for (const HeapPart& part : shared_) {
            if (part.address != last && !std::ranges::binary_search(theirs.shared_, part, before))
                bytes += part.bytes;
            last = part.address;
        }
        return bytes;
    }

private:
    using PartOf = HeapPart (ObjectBlock::*)(std::size_t) const;

    static bool before(const HeapPart& a, const HeapPart& b)
    {
        return std::less<>()(a.address, b.address);
    }

    void add(PartOf partOf, const ObjectBlock& block, const ObjectBlock* beside, std::size_t i)
    {
        const HeapPart part = (block.*partOf)(i);
        if (!part.shared)
            alone_ += part.bytes;
        else if (!beside || i >= beside->size() || (beside->*partOf)(i).address != part.address)
            shared_.push_back(part);
    }

    std::size_t alone_ = 0; ///< bytes of parts that are not shared
    std::vector<HeapPart> shared_;
};

} // namespace

std::size_t Objects::bytesNotIn(const Objects& other) const
{
    std::size_t sum = heapBytes(blocks_) + heapBytes(first_);
    Parts parts;
    forEachNotIn(other.blocks_, blocks_, [&](std::size_t i) {
        const bool hasBeside = i < other.blocks_.size() && other.first_[i] == first_[i];
        sum += heapBlock(Shared<ObjectBlock>::allocated()) + blocks_[i]->heapBytes();
        parts.add(*blocks_[i], hasBeside ? &*other.blocks_[i] : nullptr);
    });
    return sum + parts.bytesNotIn(other);
}

} // namespace app
