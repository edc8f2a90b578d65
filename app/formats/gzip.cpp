// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/gzip.h"

#include <QIODevice>

#include <array>
#include <zlib.h>

namespace app {
namespace {

constexpr int gzipOnly = 16, ofEither = 32; // added to the size of the window

std::array<Bytef, 1 << 16> emptyBlock() { return {}; }

Bytef* bytesOf(QByteArray& text) { return reinterpret_cast<Bytef*>(text.data()); }

} // namespace

bool isZipped(QIODevice& in) { return in.peek(2) == "\x1f\x8b"; }

std::optional<QByteArray> unzipped(QIODevice& in, std::size_t most)
{
    z_stream stream{};
    if (inflateInit2(&stream, ofEither + MAX_WBITS) != Z_OK)
        return std::nullopt;
    QByteArray result;
    auto block = emptyBlock();
    int state = Z_OK;
    while (state == Z_OK) {
        QByteArray part = in.read(qint64(block.size()));
        if (part.isEmpty())
            break; // before the end
        stream.next_in = bytesOf(part);
        stream.avail_in = uInt(part.size());
        do {
            stream.next_out = block.data();
            stream.avail_out = uInt(block.size());
            state = inflate(&stream, Z_NO_FLUSH);
            result.append(reinterpret_cast<const char*>(block.data()),
                          qsizetype(block.size() - stream.avail_out));
        } while (state == Z_OK && stream.avail_out == 0 && std::size_t(result.size()) <= most);
        if (state == Z_BUF_ERROR)
            state = Z_OK; // it needs more
        if (std::size_t(result.size()) > most)
            state = Z_DATA_ERROR;
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END ? std::optional(result) : std::nullopt;
}

QByteArray zipped(const QByteArray& text)
{
    z_stream stream{};
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzipOnly + MAX_WBITS, 9,
                     Z_DEFAULT_STRATEGY)
        != Z_OK)
        return {};
    QByteArray from = text;
    QByteArray result(qsizetype(deflateBound(&stream, uLong(from.size()))), Qt::Uninitialized);
    stream.next_in = bytesOf(from);
    stream.avail_in = uInt(from.size());
    stream.next_out = bytesOf(result);
    stream.avail_out = uInt(result.size());
    deflate(&stream, Z_FINISH);
    result.truncate(qsizetype(stream.total_out));
    deflateEnd(&stream);
    return result;
}

} // namespace app
