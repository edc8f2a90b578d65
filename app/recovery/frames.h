// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/bytes.h"

#include <memory>

// A journal's files are sequences of frames: size, checksum, payload. The checksum covers the
// frame's number too, so a frame is valid only at its own place.

namespace app {

/// A 64-bit checksum. It differs for any two inputs of the same size that differ in one aligned
/// word of 8 bytes, and otherwise by chance: one in 2^64.
std::uint64_t frameChecksum(std::uint64_t number, std::string_view payload);

constexpr std::size_t frameHeader = 16; ///< bytes before the payload

/// Fills the first `frameHeader` bytes of `frame`; the payload follows them.
void sealFrame(std::string& frame, std::uint64_t number);

/// A frame, of which some bytes lie elsewhere, in what `owner` keeps.
struct Frame {
    std::string bytes; ///< with room for the header
    std::vector<LentBytes> lent{};
    std::shared_ptr<const void> owner{};

    std::vector<std::string_view> parts() const; ///< all bytes, in order
    std::size_t size() const;                    ///< of all parts
};
void sealFrame(Frame& frame, std::uint64_t number);

/// Reads frames from untrusted bytes, up to the first one that is not complete or damaged.
class FrameReader {
public:
    FrameReader(std::string_view bytes, std::uint64_t firstNumber)
        : left_(bytes), number_(firstNumber)
    {
    }
    /// The payload of the next frame, inside the bytes.
    std::optional<std::string_view> next();
    std::uint64_t number() const { return number_; } ///< of the next frame
    bool atEnd() const { return left_.empty(); }     ///< all bytes were frames

private:
    std::string_view left_;
    std::uint64_t number_;
};

} // namespace app
