// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/frames.h"

#include "app/base/random.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace app {
namespace {

std::uint64_t wordAt(const char* at)
{
    std::uint64_t word = 0;
    std::memcpy(&word, at, sizeof word);
    return word;
}

/// The checksum of bytes that come in parts. Four independent sums keep the multiplier busy: some
/// GB/s.
class Checksum {
public:
    void add(std::string_view bytes)
    {
        size_ += bytes.size();
        if (waiting_ > 0) {
            const std::size_t count = std::min(group - waiting_, bytes.size());
            std::memcpy(rest_.data() + waiting_, bytes.data(), count);
            waiting_ += count;
            bytes.remove_prefix(count);
            if (waiting_ < group)
                return;
            addGroup(rest_.data());
        }
        for (; bytes.size() >= group; bytes.remove_prefix(group))
            addGroup(bytes.data());
        waiting_ = bytes.size();
        if (waiting_ > 0)
            std::memcpy(rest_.data(), bytes.data(), waiting_);
    }

    std::uint64_t of(std::uint64_t number)
    {
        const char* at = rest_.data();
        for (; waiting_ >= word; waiting_ -= word, at += word)
            addWord(sums_[0], wordAt(at));
        std::uint64_t rest = 0;
        std::memcpy(&rest, at, waiting_);
        addWord(sums_[0], rest);
        std::uint64_t all = mixed(number) ^ mixed(size_);
        for (const std::uint64_t sum : sums_)
            all = mixed(all ^ sum);
        return all;
    }

private:
    static constexpr std::size_t word = sizeof(std::uint64_t), group = 4 * word;

    static void addWord(std::uint64_t& sum, std::uint64_t next)
    {
        constexpr std::uint64_t prime = 0x9e3779b97f4a7c15;
        sum = (sum ^ next) * prime;
        sum ^= sum >> 32;
    }
    void addGroup(const char* at)
    {
        for (std::size_t i = 0; i < sums_.size(); ++i)
            addWord(sums_[i], wordAt(at + i * word));
    }

    std::array<std::uint64_t, 4> sums_{1, 2, 3, 4};
    std::array<char, group> rest_{}; ///< less than a group
    std::size_t waiting_ = 0;        ///< bytes in rest_
    std::uint64_t size_ = 0;
};

void putHeader(std::string& frame, std::uint64_t size, std::uint64_t checksum)
{
    std::memcpy(frame.data(), &size, sizeof size);
    std::memcpy(frame.data() + sizeof size, &checksum, sizeof checksum);
}

} // namespace

std::uint64_t frameChecksum(std::uint64_t number, std::string_view payload)
{
    Checksum sum;
    sum.add(payload);
    return sum.of(number);
}

void sealFrame(std::string& frame, std::uint64_t number)
{
    putHeader(frame, frame.size() - frameHeader,
              frameChecksum(number, std::string_view(frame).substr(frameHeader)));
}

std::vector<std::string_view> Frame::parts() const
{
    std::vector<std::string_view> parts;
    const std::string_view own = bytes;
    std::size_t done = 0;
    for (const auto& [before, elsewhere] : lent) {
        parts.push_back(own.substr(done, before - done));
        parts.push_back(elsewhere);
        done = before;
    }
    parts.push_back(own.substr(done));
    return parts;
}

std::size_t Frame::size() const
{
    std::size_t size = bytes.size();
    for (const LentBytes& each : lent)
        size += each.bytes.size();
    return size;
}

void sealFrame(Frame& frame, std::uint64_t number)
{
    auto parts = frame.parts();
    parts.front().remove_prefix(frameHeader);
    Checksum sum;
    for (const std::string_view part : parts)
        sum.add(part);
    putHeader(frame.bytes, frame.size() - frameHeader, sum.of(number));
}

std::optional<std::string_view> FrameReader::next()
{
    if (left_.size() < frameHeader)
        return std::nullopt;
    const std::uint64_t size = wordAt(left_.data());
    if (size > left_.size() - frameHeader)
        return std::nullopt;
    const std::string_view payload = left_.substr(frameHeader, size);
    if (wordAt(left_.data() + sizeof size) != frameChecksum(number_, payload))
        return std::nullopt;
    left_.remove_prefix(frameHeader + size);
    ++number_;
    return payload;
}

} // namespace app
