// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/frames.h"

#include "app/base/checksum.h"

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

} // namespace

// Four independent sums keep the multiplier busy: some GB/s.
std::uint64_t frameChecksum(std::uint64_t number, std::string_view payload)
{
    constexpr std::uint64_t prime = 0x9e3779b97f4a7c15;
    constexpr std::size_t word = sizeof(std::uint64_t);
    std::array<std::uint64_t, 4> sums{1, 2, 3, 4};
    const auto add = [](std::uint64_t& sum, std::uint64_t next) {
        sum = (sum ^ next) * prime;
        sum ^= sum >> 32;
    };
    const char* at = payload.data();
    std::size_t left = payload.size();
    for (; left >= sums.size() * word; left -= sums.size() * word, at += sums.size() * word)
        for (std::size_t i = 0; i < sums.size(); ++i)
            add(sums[i], wordAt(at + i * word));
    for (; left >= word; left -= word, at += word)
        add(sums[0], wordAt(at));
    std::uint64_t rest = 0;
    if (left > 0)
        std::memcpy(&rest, at, left);
    add(sums[0], rest);
    std::uint64_t all = mixed(number) ^ mixed(payload.size());
    for (const std::uint64_t sum : sums)
        all = mixed(all ^ sum);
    return all;
}

void sealFrame(std::string& frame, std::uint64_t number)
{
    const std::uint64_t size = frame.size() - frameHeader;
    const std::uint64_t checksum =
        frameChecksum(number, std::string_view(frame).substr(frameHeader));
    std::memcpy(frame.data(), &size, sizeof size);
    std::memcpy(frame.data() + sizeof size, &checksum, sizeof checksum);
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
