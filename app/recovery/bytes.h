// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <bit>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// Values as bytes, in the order of this machine. Journals never leave the machine.

namespace app {

static_assert(std::endian::native == std::endian::little);

template <class T>
concept PlainBytes = std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>;

/// Bytes that are not copied: they lie where `bytes` points to, and come before the byte number
/// `before` of the copied ones.
struct LentBytes {
    std::size_t before;
    std::string_view bytes;
};

enum class Lending : std::uint8_t { No, Yes };

/// Appends values to a string of bytes.
class ByteWriter {
public:
    /// With Lending::Yes, long lists are not copied but lent.
    explicit ByteWriter(Lending lending = Lending::No) : lending_(lending) {}

    template <PlainBytes T>
    void put(const T& value)
    {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    /// The elements without their number.
    void putAll(const std::ranges::contiguous_range auto& values)
    {
        const std::span all(std::ranges::data(values), std::ranges::size(values));
        static_assert(PlainBytes<std::ranges::range_value_t<decltype(all)>>);
        bytes_.append(reinterpret_cast<const char*>(all.data()), all.size_bytes());
    }
    /// Makes room for so many more bytes: growing would copy all of them several times.
    void reserve(std::size_t more) { bytes_.reserve(bytes_.size() + more); }
    void putCount(std::size_t count) { put(std::uint32_t(count)); }
    void putList(const std::ranges::contiguous_range auto& values)
    {
        putCount(std::size_t(std::ranges::size(values)));
        putAll(values);
    }
    /// The same for a list that stays where it is until what was written is used. A long one is
    /// lent: copying it would touch as much new memory.
    void lendList(const std::ranges::contiguous_range auto& values)
    {
        const auto all = std::as_bytes(std::span(values));
        if (lending_ == Lending::No || all.size() < leastLent)
            return putList(values);
        putCount(std::ranges::size(values));
        lent_.push_back({bytes_.size(), {reinterpret_cast<const char*>(all.data()), all.size()}});
    }
    void put(const QString& text)
    {
        putList(std::u16string_view(reinterpret_cast<const char16_t*>(text.utf16()),
                                    std::size_t(text.size())));
    }
    std::string& bytes() { return bytes_; }
    Lending lending() const { return lending_; }
    std::vector<LentBytes>& lent() { return lent_; }

private:
    static constexpr std::size_t leastLent = 4096;

    Lending lending_;
    std::string bytes_;
    std::vector<LentBytes> lent_;
};

/// Reads values from untrusted bytes. After the first value that is not there or not valid, ok()
/// is false and every further value is empty. Never allocates more than the bytes can hold.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : left_(bytes) {}

    bool ok() const { return ok_; }
    bool atEnd() const { return left_.empty(); }
    void fail()
    {
        ok_ = false;
        left_ = {};
    }
    /// Fails unless `holds`.
    void require(bool holds)
    {
        if (!holds)
            fail();
    }

    template <PlainBytes T>
    T get()
    {
        T value{};
        if (left_.size() < sizeof value) {
            fail();
            return value;
        }
        std::memcpy(static_cast<void*>(&value), left_.data(), sizeof value);
        left_.remove_prefix(sizeof value);
        return value;
    }
    bool flag()
    {
        const auto value = get<std::uint8_t>();
        require(value <= 1);
        return value == 1;
    }
    /// An enumerator from 0 up to `last`.
    template <class Enum>
    Enum choice(Enum last)
    {
        const auto value = get<std::uint8_t>();
        require(value <= std::uint8_t(last));
        return ok_ ? Enum(value) : Enum{};
    }
    /// A number of elements, each of which takes at least `bytesEach` of the remaining bytes.
    std::size_t count(std::size_t bytesEach)
    {
        const auto value = get<std::uint32_t>();
        require(value <= left_.size() / bytesEach);
        return ok_ ? value : 0;
    }
    template <PlainBytes T>
    std::vector<T> all(std::size_t count)
    {
        require(count <= left_.size() / sizeof(T));
        std::vector<T> values(ok_ ? count : 0);
        if (!values.empty())
            std::memcpy(static_cast<void*>(values.data()), left_.data(), count * sizeof(T));
        left_.remove_prefix(values.size() * sizeof(T));
        return values;
    }
    template <PlainBytes T>
    std::vector<T> list()
    {
        return all<T>(count(sizeof(T)));
    }
    QString text()
    {
        const auto units = list<char16_t>();
        return QString::fromUtf16(units.data(), qsizetype(units.size()));
    }

private:
    std::string_view left_;
    bool ok_ = true;
};

} // namespace app
