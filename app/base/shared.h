// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace app {

/// A copy-on-write value with several owners, on any threads. A shared value is never written:
/// `own` copies it first. Unlike `std::shared_ptr::use_count`, `isShared` acquires: reads by a
/// former owner happen before it returns false. A moved-from object may only be assigned to or
/// destroyed.
template <class T>
class Shared {
public:
    Shared() : at_(new Counted) {}
    explicit Shared(T value) : at_(new Counted{{1}, std::move(value)}) {}
    Shared(const Shared& other) noexcept : at_(other.at_)
    {
        at_->owners.fetch_add(1, std::memory_order_relaxed);
    }
    Shared(Shared&& other) noexcept : at_(std::exchange(other.at_, nullptr)) {}
    Shared& operator=(Shared other) noexcept
    {
        std::swap(at_, other.at_);
        return *this;
    }
    ~Shared()
    {
        if (at_ && at_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1)
            delete at_;
    }

    /// The size in bytes of the allocation that owners share.
    static constexpr std::size_t allocated() { return sizeof(Counted); }

    const T& operator*() const { return at_->value; }
    const T* operator->() const { return &at_->value; }
    bool isShared() const { return at_->owners.load(std::memory_order_acquire) != 1; }
    /// The value for writing; copied first if it has other owners. The reference is valid until
    /// this owner is copied.
    T& own()
    {
        if (isShared())
            *this = Shared(**this);
        return at_->value;
    }

    friend bool sameAddress(const Shared& a, const Shared& b) { return a.at_ == b.at_; }
    /// Compares values; owners of the same address are equal without a comparison.
    friend bool operator==(const Shared& a, const Shared& b) { return a.at_ == b.at_ || *a == *b; }

private:
    struct Counted {
        std::atomic<std::uint32_t> owners{1};
        T value{};
    };
    Counted* at_;
};

/// Calls visit(i) for each index i of `mine` whose value `theirs` does not share. Elements that
/// both lists share at the beginning and at the end cost little.
template <class T, class Visit>
void forEachNotIn(const std::vector<Shared<T>>& theirs, const std::vector<Shared<T>>& mine,
                  const Visit& visit)
{
    const auto same = [](const Shared<T>& a, const Shared<T>& b) { return sameAddress(a, b); };
    const auto [from, theirFrom] =
        std::mismatch(mine.begin(), mine.end(), theirs.begin(), theirs.end(), same);
    const auto [end, theirEnd] =
        std::mismatch(mine.rbegin(), std::reverse_iterator(from), theirs.rbegin(),
                      std::reverse_iterator(theirFrom), same);
    std::vector<const T*> others;
    for (auto other = theirFrom; other != theirEnd.base(); ++other)
        others.push_back(&**other);
    std::ranges::sort(others, std::less<>());
    for (auto each = from; each != end.base(); ++each)
        if (!std::ranges::binary_search(others, &**each, std::less<>()))
            visit(std::size_t(each - mine.begin()));
}

} // namespace app
