// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/lenient_xml.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

constexpr QByteArrayView utf8Mark("\xef\xbb\xbf"), declaration("<?xml");

struct UsualPrefix {
    std::string_view prefix, uri;
};
constexpr std::array usualPrefixes{
    UsualPrefix{"svg", "http://www.w3.org/2000/svg"},
    UsualPrefix{"xlink", "http://www.w3.org/1999/xlink"},
    UsualPrefix{"inkscape", "http://www.inkscape.org/namespaces/inkscape"},
    UsualPrefix{"sodipodi", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"},
    UsualPrefix{"clearcut", "urn:clearcut:1"},
    UsualPrefix{"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"},
    UsualPrefix{"cc", "http://creativecommons.org/ns#"},
    UsualPrefix{"dc", "http://purl.org/dc/elements/1.1/"},
};

} // namespace

Beginning skipBlankBeginning(QIODevice& in)
{
    constexpr qint64 most = 1 << 16;
    const QByteArray head = in.peek(most);
    qsizetype i = 0;
    while (i < head.size()) {
        const bool mark = head.sliced(i).startsWith(utf8Mark);
        if (!mark && QByteArrayView(" \t\r\n").indexOf(head[i]) < 0)
            break;
        i += mark ? utf8Mark.size() : 1;
    }
    const bool usual = i == 0 || (i == utf8Mark.size() && head.startsWith(utf8Mark));
    if (usual || !head.sliced(i).startsWith(declaration))
        return {};
    in.skip(i);
    return {i, head.first(i).count('\n')};
}

std::string usualNamespace(std::string_view prefix)
{
    const auto usual = std::ranges::find(usualPrefixes, prefix, &UsualPrefix::prefix);
    return usual == usualPrefixes.end() ? "urn:undeclared:" + std::string(prefix)
                                        : std::string(usual->uri);
}

} // namespace app::svg
