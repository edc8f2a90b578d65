// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/about.h"

#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/limits.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

using Kind = XmlToken::Kind;

constexpr std::string_view svgUri = "http://www.w3.org/2000/svg", ownUri = "urn:clearcut:1";

// The prefixes that the root of a written file declares.
std::vector<std::pair<std::string, std::string>> writersScope()
{
    return {{"", std::string(svgUri)},
            {"xml", "http://www.w3.org/XML/1998/namespace"},
            {"inkscape", "http://www.inkscape.org/namespaces/inkscape"},
            {"sodipodi", "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"},
            {"clearcut", std::string(ownUri)}};
}

// Whether a namespace is needed only for drawing; its prefixes are not copied into the metadata.
bool forDrawing(std::string_view uri)
{
    static const auto scope = writersScope();
    return uri == "http://www.w3.org/1999/xlink"
           || std::ranges::find(scope, uri, &std::pair<std::string, std::string>::second)
                  != scope.end();
}

constexpr std::string_view blank = " \t\r\n";

std::string_view trimmedXml(std::string_view text)
{
    const auto first = std::min(text.find_first_not_of(blank), text.size());
    return text.substr(first, text.find_last_not_of(blank) + 1 - first);
}

QString asText(std::string_view text)
{
    const auto part = trimmedXml(text);
    return QString::fromUtf8(part);
}

std::string commentOf(const XmlToken& xml) { return "<!--" + std::string(xml.text) + "-->"; }

} // namespace

std::optional<ElementNote> AboutReader::take(const XmlToken& xml)
{
    std::optional<ElementNote> note;
    if (xml.kind == Kind::Start)
        open(xml);
    else if (xml.kind == Kind::End)
        note = close(xml);
    else if (xml.kind == Kind::Comment && depth_ == 0 && !tooLarge_)
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

void AboutReader::open(const XmlToken& xml)
{
    ++depth_;
    if (depth_ == 1)
        return openRoot(xml);
    if (!section_)
        if (std::string* const section = sectionOf(xml))
            begin(section);
    if (!section_)
        return;
    if (skipped_ > 0 || (depth_ > sectionDepth_ && xml.name.uri == ownUri))
        ++skipped_;
    else
        writeStart(xml);
    dropped_ = dropped_ || depth_ - sectionDepth_ > deepestNote;
}

void AboutReader::openRoot(const XmlToken& xml)
{
    bare_ = xml.name.uri.empty();
    id_ = QString::fromUtf8(xml.valueOf("id"));
    for (const XmlDeclaration& declared : xml.declared)
        outer_.emplace_back(declared.prefix, declared.uri);
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

std::string* AboutReader::sectionOf(const XmlToken& xml)
{
    if (!xml.name.uri.empty() && xml.name.uri != svgUri)
        return nullptr;
    const std::array<std::pair<std::string_view, std::string*>, 3> sections{
        {{"title", &title_}, {"desc", &description_}, {"metadata", &metadata_}}};
    for (const auto& [name, text] : sections)
        if (xml.name.local == name)
            return text;
    return nullptr;
}

std::optional<ElementNote> AboutReader::close(const XmlToken& xml)
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
            *section_ += "</" + std::string(xml.name.qualified) + '>';
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

void AboutReader::write(const XmlToken& xml)
{
    endStart();
    const bool isText = xml.kind == Kind::Text;
    if (xml.kind == Kind::Comment)
        *section_ += commentOf(xml);
    else if (xml.kind == Kind::Instruction)
        *section_ += "<?" + std::string(xml.name.qualified) + ' ' + std::string(xml.text) + "?>";
    else if (isText)
        *section_ += escapedContent(QString::fromUtf8(xml.text));
    const bool says = isText && xml.text.find_first_not_of(blank) != std::string_view::npos;
    saysAnything_ = saysAnything_ || says || (section_ == &metadata_ && !isText);
}

void AboutReader::writeStart(const XmlToken& xml)
{
    endStart();
    const std::size_t outside = scope_.size();
    *section_ += '<' + std::string(xml.name.qualified);
    for (const XmlDeclaration& declared : xml.declared)
        declare(declared.prefix, declared.uri);
    declare(xml.name.prefix, xml.name.uri);
    for (const XmlAttribute& attribute : xml.attributes)
        if (!attribute.name.prefix.empty())
            declare(attribute.name.prefix, attribute.name.uri);
    if (section_ == &metadata_ && marks_.empty())
        for (const auto& [prefix, uri] : outer_) {
            const bool redeclared =
                std::any_of(scope_.begin() + std::ptrdiff_t(outside), scope_.end(),
                            [&prefix = prefix](const Prefix& own) { return own.first == prefix; });
            if (!prefix.empty() && !redeclared && !forDrawing(uri))
                declare(prefix, uri);
        }
    for (const XmlAttribute& attribute : xml.attributes)
        appendAttribute(*section_, attribute.name.qualified,
                        escaped(QString::fromUtf8(attribute.value)));
    if (section_ == &metadata_) // in metadata, elements and attributes count as content, too
        saysAnything_ = saysAnything_ || depth_ > 2 || !xml.attributes.empty();
    marks_.push_back(outside);
    inStart_ = true;
}

void AboutReader::endStart()
{
    if (inStart_)
        *section_ += '>';
    inStart_ = false;
}

void AboutReader::declare(std::string_view prefix, std::string_view given)
{
    const std::string_view uri = given.empty() && bare_ ? svgUri : given;
    const auto known = std::find_if(scope_.rbegin(), scope_.rend(),
                                    [&](const Prefix& one) { return one.first == prefix; });
    if (known == scope_.rend() ? uri.empty() : known->second == uri)
        return;
    appendAttribute(*section_, prefix.empty() ? "xmlns" : "xmlns:" + std::string(prefix),
                    escaped(QString::fromUtf8(uri)));
    scope_.emplace_back(prefix, uri);
}

} // namespace app::svg
