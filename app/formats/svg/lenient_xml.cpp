// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/lenient_xml.h"

#include "app/formats/svg/html_entities.h"
#include "app/formats/svg/limits.h"

#include <QXmlStreamReader>

#include <algorithm>
#include <array>
#include <vector>

namespace app::svg {
namespace {

constexpr QByteArrayView utf8Mark("\xef\xbb\xbf"), declaration("<?xml");

struct UsualPrefix {
    QLatin1StringView prefix, uri;
};
constexpr std::array usualPrefixes{
    UsualPrefix{QLatin1StringView("svg"), QLatin1StringView("http://www.w3.org/2000/svg")},
    UsualPrefix{QLatin1StringView("xlink"), QLatin1StringView("http://www.w3.org/1999/xlink")},
    UsualPrefix{QLatin1StringView("inkscape"),
                QLatin1StringView("http://www.inkscape.org/namespaces/inkscape")},
    UsualPrefix{QLatin1StringView("sodipodi"),
                QLatin1StringView("http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd")},
    UsualPrefix{QLatin1StringView("clearcut"), QLatin1StringView("urn:clearcut:1")},
    UsualPrefix{QLatin1StringView("rdf"),
                QLatin1StringView("http://www.w3.org/1999/02/22-rdf-syntax-ns#")},
    UsualPrefix{QLatin1StringView("cc"), QLatin1StringView("http://creativecommons.org/ns#")},
    UsualPrefix{QLatin1StringView("dc"), QLatin1StringView("http://purl.org/dc/elements/1.1/")},
};

QString uriOf(const QString& prefix)
{
    const auto usual = std::ranges::find(usualPrefixes, prefix, &UsualPrefix::prefix);
    return usual == usualPrefixes.end() ? QStringLiteral("urn:undeclared:") + prefix
                                        : QString(usual->uri);
}

/// Follows the declarations of the open elements.
class Declarations {
public:
    void open(const QXmlStreamReader& xml)
    {
        scopes_.emplace_back();
        for (const auto& attribute : xml.attributes())
            if (const auto name = attribute.qualifiedName(); name.startsWith(u"xmlns:")) {
                scopes_.back().push_back(name.sliced(6).toString());
                ++declared_[scopes_.back().back()];
            }
        use(xml.qualifiedName(), xml.lineNumber());
        for (const auto& attribute : xml.attributes())
            use(attribute.qualifiedName(), xml.lineNumber());
    }
    void close()
    {
        for (const QString& prefix : scopes_.back())
            --declared_[prefix];
        scopes_.pop_back();
    }
    std::size_t depth() const { return scopes_.size(); }
    const UsedPrefixes& undeclared() const { return undeclared_; }

private:
    void use(QStringView name, qint64 line)
    {
        const auto colon = name.indexOf(u':');
        const QString prefix = name.first(std::max<qsizetype>(colon, 0)).toString();
        const bool builtIn = prefix.isEmpty() || prefix == u"xml" || prefix == u"xmlns";
        const auto declared = declared_.find(prefix);
        if (!builtIn && (declared == declared_.end() || declared->second == 0))
            undeclared_.try_emplace(prefix, UsedPrefix{uriOf(prefix), line});
    }

    std::vector<std::vector<QString>> scopes_; ///< the declarations of each open element
    std::map<QString, int> declared_;          ///< how many open elements declare a prefix
    UsedPrefixes undeclared_;
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

UsedPrefixes undeclaredPrefixes(QIODevice& in)
{
    constexpr std::size_t most = 100; // prefixes
    Report report;
    QXmlStreamReader xml(&in);
    HtmlEntities entities(xml, 0, report);
    xml.setNamespaceProcessing(false);
    xml.setEntityResolver(&entities);
    Declarations declarations;
    while (!xml.atEnd() && !xml.hasError() && declarations.undeclared().size() < most
           && declarations.depth() <= deepestNesting) {
        const auto token = xml.readNext();
        if (token == QXmlStreamReader::StartElement)
            declarations.open(xml);
        else if (token == QXmlStreamReader::EndElement)
            declarations.close();
    }
    return declarations.undeclared();
}

} // namespace app::svg
