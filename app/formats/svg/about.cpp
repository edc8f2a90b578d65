// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/about.h"

#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/limits.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

const QString svgUri = QStringLiteral("http://www.w3.org/2000/svg");
const QString ownUri = QStringLiteral("urn:clearcut:1");

// The prefixes that the root of a written file declares.
std::vector<std::pair<QString, QString>> writersScope()
{
    return {
        {QString(), svgUri},
        {QStringLiteral("xml"), QStringLiteral("http://www.w3.org/XML/1998/namespace")},
        {QStringLiteral("inkscape"), QStringLiteral("http://www.inkscape.org/namespaces/inkscape")},
        {QStringLiteral("sodipodi"),
         QStringLiteral("http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd")},
        {QStringLiteral("clearcut"), ownUri}};
}

// Whether a namespace is needed only for drawing; its prefixes are not copied into the metadata.
bool forDrawing(const QString& uri)
{
    static const auto scope = writersScope();
    return uri == QLatin1StringView("http://www.w3.org/1999/xlink")
           || std::ranges::find(scope, uri, &std::pair<QString, QString>::second) != scope.end();
}

std::string_view trimmedXml(std::string_view text)
{
    constexpr std::string_view blank = " \t\r\n";
    const auto first = std::min(text.find_first_not_of(blank), text.size());
    return text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

QString asText(std::string_view text)
{
    const auto part = trimmedXml(text);
    return QString::fromUtf8(part.data(), qsizetype(part.size()));
}

std::string commentOf(const QXmlStreamReader& xml)
{
    return "<!--" + xml.text().toString().toStdString() + "-->";
}

} // namespace

std::optional<ElementNote> AboutReader::take(const QXmlStreamReader& xml)
{
    std::optional<ElementNote> note;
    const auto token = xml.tokenType();
    if (token == QXmlStreamReader::StartElement)
        open(xml);
    else if (token == QXmlStreamReader::EndElement)
        note = close(xml);
    else if (token == QXmlStreamReader::Comment && depth_ == 0 && !tooLarge_)
        comments_ += commentOf(xml) + '\n';
    else if (section_ && skipped_ == 0)
        write(xml);
    const auto size = comments_.size() + title_.size() + description_.size() + metadata_.size();
    tooLarge_ = tooLarge_ || size > mostMetadata;
    if (note_.size() > mostNotes) {
        dropped_ = true;
        note_.clear();
    }
    if (tooLarge_ && size > 0)
        for (std::string* text : {&comments_, &title_, &description_, &metadata_})
            text->clear();
    return note;
}

About AboutReader::about() const
{
    return {id_, asText(comments_), asText(title_), asText(description_), asText(metadata_)};
}

void AboutReader::open(const QXmlStreamReader& xml)
{
    ++depth_;
    if (depth_ == 1)
        return openRoot(xml);
    if (!section_)
        if (std::string* const section = sectionOf(xml))
            begin(section);
    if (!section_)
        return;
    if (skipped_ > 0 || (depth_ > sectionDepth_ && xml.namespaceUri() == ownUri))
        ++skipped_;
    else
        writeStart(xml);
    dropped_ = dropped_ || depth_ - sectionDepth_ > deepestNote;
}

void AboutReader::openRoot(const QXmlStreamReader& xml)
{
    bare_ = xml.namespaceUri().isEmpty();
    id_ = xml.attributes().value(QLatin1StringView("id")).toString();
    for (const auto& declared : xml.namespaceDeclarations())
        outer_.emplace_back(declared.prefix().toString(), declared.namespaceUri().toString());
}

void AboutReader::begin(std::string* section)
{
    kind_ = section;
    sectionDepth_ = depth_;
    note_.clear();
    section_ = depth_ == 2 ? section : &note_;
    begin_ = section_->size();
    saysAnything_ = false;
    dropped_ = false;
    scope_ = writersScope();
}

std::string* AboutReader::sectionOf(const QXmlStreamReader& xml)
{
    if (!xml.namespaceUri().isEmpty() && xml.namespaceUri() != svgUri)
        return nullptr;
    const std::array<std::pair<QLatin1StringView, std::string*>, 3> sections{
        {{QLatin1StringView("title"), &title_},
         {QLatin1StringView("desc"), &description_},
         {QLatin1StringView("metadata"), &metadata_}}};
    for (const auto& [name, text] : sections)
        if (xml.name() == name)
            return text;
    return nullptr;
}

std::optional<ElementNote> AboutReader::close(const QXmlStreamReader& xml)
{
    const int depth = depth_--;
    if (!section_)
        return std::nullopt;
    if (skipped_ > 0) {
        --skipped_;
    } else if (!marks_.empty()) {
        if (inStart_)
            *section_ += "/>";
        else
            *section_ += "</" + xml.qualifiedName().toString().toStdString() + '>';
        inStart_ = false;
        scope_.resize(marks_.back());
        marks_.pop_back();
    }
    return depth > sectionDepth_ ? std::nullopt : endSection();
}

std::optional<ElementNote> AboutReader::endSection()
{
    const bool ofElement = section_ == &note_;
    if (!saysAnything_ && !tooLarge_)
        section_->resize(begin_); // an empty title, or metadata with clip windows alone
    *section_ += '\n';
    section_ = nullptr;
    if (!ofElement || !saysAnything_)
        return std::nullopt;
    ++ofElements_;
    if (kind_ == &metadata_ || dropped_ || noteBytes_ + note_.size() > mostNotes)
        return std::nullopt;
    noteBytes_ += note_.size();
    return ElementNote{kind_ == &title_, asText(note_)};
}

void AboutReader::write(const QXmlStreamReader& xml)
{
    endStart();
    if (xml.isComment()) {
        *section_ += commentOf(xml);
    } else if (xml.isProcessingInstruction()) {
        *section_ += "<?" + xml.processingInstructionTarget().toString().toStdString() + ' '
                     + xml.processingInstructionData().toString().toStdString() + "?>";
    } else if (xml.isCharacters()) {
        *section_ += escapedContent(xml.text().toString());
    }
    const bool text = xml.isCharacters() && !xml.isWhitespace();
    saysAnything_ = saysAnything_ || text || (section_ == &metadata_ && !xml.isCharacters());
}

void AboutReader::writeStart(const QXmlStreamReader& xml)
{
    endStart();
    const std::size_t outside = scope_.size();
    *section_ += '<' + xml.qualifiedName().toString().toStdString();
    for (const auto& declared : xml.namespaceDeclarations())
        declare(declared.prefix().toString(), declared.namespaceUri().toString());
    declare(xml.prefix().toString(), xml.namespaceUri().toString());
    for (const auto& attribute : xml.attributes())
        if (!attribute.prefix().isEmpty())
            declare(attribute.prefix().toString(), attribute.namespaceUri().toString());
    if (section_ == &metadata_ && marks_.empty())
        for (const auto& [prefix, uri] : outer_) {
            const bool redeclared =
                std::any_of(scope_.begin() + std::ptrdiff_t(outside), scope_.end(),
                            [&prefix = prefix](const Prefix& own) { return own.first == prefix; });
            if (!prefix.isEmpty() && !redeclared && !forDrawing(uri))
                declare(prefix, uri);
        }
    for (const auto& attribute : xml.attributes())
        appendAttribute(*section_, attribute.qualifiedName().toString().toStdString(),
                        escaped(attribute.value().toString()));
    if (section_ == &metadata_) // in metadata, elements and attributes count as content, too
        saysAnything_ = saysAnything_ || depth_ > 2 || !xml.attributes().isEmpty();
    marks_.push_back(outside);
    inStart_ = true;
}

void AboutReader::endStart()
{
    if (inStart_)
        *section_ += '>';
    inStart_ = false;
}

void AboutReader::declare(const QString& prefix, const QString& given)
{
    const QString& uri = given.isEmpty() && bare_ ? svgUri : given;
    const auto known = std::find_if(scope_.rbegin(), scope_.rend(),
                                    [&](const Prefix& one) { return one.first == prefix; });
    if (known == scope_.rend() ? uri.isEmpty() : known->second == uri)
        return;
    appendAttribute(*section_, prefix.isEmpty() ? "xmlns" : "xmlns:" + prefix.toStdString(),
                    escaped(uri));
    scope_.emplace_back(prefix, uri);
}

} // namespace app::svg
