// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/hershey_file.h"

#include "app/base/text.h"

#include <optional>
#include <string_view>

namespace app {
namespace {

constexpr qsizetype mostGlyphs = 10'000;
constexpr int headLength = 8, numberLength = 5;
constexpr int origin = 'R', baseline = 9; // y of the baseline below the origin

bool breaksLine(char c) { return c == '\n' || c == '\r'; }

/// The characters of the file without line breaks, one row after the other.
class Reader {
public:
    explicit Reader(const QByteArray& bytes) : bytes_(bytes) {}

    bool atEnd()
    {
        while (at_ < bytes_.size() && breaksLine(bytes_[at_]))
            ++at_;
        return at_ >= bytes_.size();
    }
    /// Empty: the file ends before.
    std::optional<QByteArray> take(int length)
    {
        QByteArray taken;
        while (taken.size() < length && at_ < bytes_.size())
            if (const char c = bytes_[at_++]; !breaksLine(c))
                taken += c;
        return taken.size() == length ? std::optional(taken) : std::nullopt;
    }

private:
    const QByteArray& bytes_;
    qsizetype at_ = 0;
};

std::optional<HersheyGlyph> readGlyph(Reader& reader)
{
    const auto head = reader.take(headLength);
    bool isNumber = false;
    const int pairs = head ? head->mid(numberLength).trimmed().toInt(&isNumber) : 0;
    const auto body = isNumber && pairs >= 1 ? reader.take(2 * pairs) : std::nullopt;
    if (!body)
        return std::nullopt;
    HersheyGlyph glyph{double(body->at(0) - origin), double(body->at(1) - origin)};
    bool lifted = true;
    for (int i = 2; i < body->size(); i += 2) {
        const char x = body->at(i), y = body->at(i + 1);
        if (x == ' ' && y == 'R') {
            lifted = true;
            continue;
        }
        if (std::exchange(lifted, false))
            glyph.strokes.emplace_back();
        glyph.strokes.back().emplace_back(x - origin, y - origin - baseline);
    }
    return glyph;
}

} // namespace

Result<std::vector<HersheyGlyph>> readHershey(const QByteArray& bytes)
{
    using R = Result<std::vector<HersheyGlyph>>;
    Reader reader(bytes);
    std::vector<HersheyGlyph> glyphs;
    while (!reader.atEnd()) {
        auto glyph = readGlyph(reader);
        if (!glyph || std::ssize(glyphs) == mostGlyphs)
            return R::failure(Text::tr("Glyph %1 is damaged: this is not a font of strokes.")
                                  .arg(glyphs.size() + 1));
        glyphs.push_back(std::move(*glyph));
    }
    return R::of(std::move(glyphs));
}

} // namespace app
