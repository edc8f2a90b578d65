// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"
#include "app/recovery/bytes.h"
#include "app/recovery/image_bytes.h"

#include <unordered_map>

namespace app {

/// Writes objects with all their bits; lends the columns of lines. Paths that share points share
/// them in the bytes of one writer, too.
class ObjectBytes {
public:
    void write(ByteWriter& out, const Objects& objects);
    void write(ByteWriter& out, const Object& object);
    KnownImages images{}; ///< of the layers that are written with the objects

private:
    void writePath(ByteWriter& out, const Path& path);

    std::unordered_map<const void*, std::uint32_t> known_; ///< number of each heap block of points
    std::vector<Path> kept_; ///< so that no other block gets the address of a known one
};

/// Reads what `ObjectBytes` wrote, in the same order.
class ObjectReader {
public:
    /// Appends the objects to `to`, whose style table they then use.
    void read(ByteReader& in, Objects& to);
    Object object(ByteReader& in);
    KnownImages images{};

private:
    struct Columns;
    Path path(ByteReader& in);
    Columns columns(ByteReader& in);

    std::vector<Path> known_;
};

void writeStyle(ByteWriter& out, const Style& style);
Style readStyle(ByteReader& in);

} // namespace app
