// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/xml_reader.h"

#include "app/base/text.h"
#include "app/formats/svg/lenient_xml.h"

#include <algorithm>
#include <array>
#include <expat.h>
#include <optional>

namespace app::svg {
namespace {

constexpr std::size_t mostUndeclared = 100, mostDeclared = 1000; // prefixes; each name is looked up
constexpr int leastChunk = 1 << 18, mostChunk = 1 << 28;         // bytes
constexpr std::array<std::string_view, 5> predefined{"amp", "apos", "gt", "lt", "quot"};

bool isIncomplete(XML_Error code)
{
    return code == XML_ERROR_NO_ELEMENTS || code == XML_ERROR_UNCLOSED_TOKEN
           || code == XML_ERROR_PARTIAL_CHAR || code == XML_ERROR_UNCLOSED_CDATA_SECTION;
}

/// The prefix that an attribute declares; empty: it is none that declares.
std::optional<std::string_view> declaredPrefix(std::string_view attribute)
{
    constexpr std::string_view declares = "xmlns";
    if (attribute == declares)
        return "";
    if (attribute.starts_with(declares) && attribute[declares.size()] == ':')
        return attribute.substr(declares.size() + 1);
    return {};
}

} // namespace

std::string_view XmlToken::valueOf(std::string_view attribute) const
{
    const auto found = std::ranges::find_if(
        attributes, [&](const XmlAttribute& one) { return one.name.qualified == attribute; });
    return found == attributes.end() ? std::string_view() : found->value;
}

/// The functions that Expat calls with each part of a file.
struct XmlReader::Callbacks {
    static XmlReader& of(void* reader) { return *static_cast<XmlReader*>(reader); }

    static void start(void* reader, const char* name, const char** attributes)
    {
        of(reader).guarded([&] { of(reader).start(name, attributes); });
    }
    static void end(void* reader, const char* name)
    {
        of(reader).guarded([&] { of(reader).end(name); });
    }
    static void text(void* reader, const char* text, int size)
    {
        of(reader).guarded([&] {
            of(reader).handler_.take(
                {.kind = XmlToken::Kind::Text, .text = {text, std::size_t(size)}});
        });
    }
    static void comment(void* reader, const char* text)
    {
        of(reader).guarded(
            [&] { of(reader).handler_.take({.kind = XmlToken::Kind::Comment, .text = text}); });
    }
    static void instruction(void* reader, const char* target, const char* data)
    {
        of(reader).guarded([&] {
            of(reader).handler_.take({.kind = XmlToken::Kind::Instruction,
                                      .name = {.qualified = target, .local = target},
                                      .text = data});
        });
    }
    static void xmlDeclaration(void* reader, const char*, const char* encoding, int)
    {
        of(reader).guarded([&] { of(reader).encoding_ = encoding ? encoding : ""; });
    }
    static void doctype(void* reader, const char*, const char*, const char*, int)
    {
        of(reader).hasDoctype_ = true;
    }
    static void entity(void* reader, const char* name, int isParameter, const char*, int,
                       const char*, const char*, const char*, const char*)
    {
        if (!isParameter)
            of(reader).guarded([&] { of(reader).entities_.emplace(name); });
    }
    static void skippedEntity(void* reader, const char* name, int isParameter)
    {
        if (!isParameter)
            of(reader).guarded([&] { throw of(reader).undefinedEntity(name); });
    }
};

XmlReader::XmlReader(XmlHandler& handler, bool isUtf8)
    : handler_(handler), parser_(XML_ParserCreate(isUtf8 ? "UTF-8" : nullptr), XML_ParserFree)
{
    if (!parser_)
        throw std::bad_alloc();
    XML_Parser parser = parser_.get();
    XML_SetUserData(parser, this);
    XML_SetElementHandler(parser, Callbacks::start, Callbacks::end);
    XML_SetCharacterDataHandler(parser, Callbacks::text);
    XML_SetCommentHandler(parser, Callbacks::comment);
    XML_SetProcessingInstructionHandler(parser, Callbacks::instruction);
    XML_SetXmlDeclHandler(parser, Callbacks::xmlDeclaration);
    XML_SetStartDoctypeDeclHandler(parser, Callbacks::doctype);
    XML_SetEntityDeclHandler(parser, Callbacks::entity);
    XML_SetSkippedEntityHandler(parser, Callbacks::skippedEntity);
}

// A token that is longer than what was read is scanned again with more: twice as much each time, or
// one of 100 MB would take minutes.
void XmlReader::read(QIODevice& in)
{
    int chunk = leastChunk;
    for (bool isLast = false; !isLast;) {
        void* const buffer = XML_GetBuffer(parser_.get(), chunk);
        if (!buffer)
            throw std::bad_alloc();
        const qint64 size = std::max<qint64>(in.read(static_cast<char*>(buffer), chunk), 0);
        isLast = size == 0;
        const std::uint64_t before = tokens_;
        const XML_Status status = XML_ParseBuffer(parser_.get(), int(size), isLast);
        if (thrown_)
            std::rethrow_exception(std::exchange(thrown_, {}));
        if (status != XML_STATUS_OK && XML_GetErrorCode(parser_.get()) == XML_ERROR_NO_MEMORY)
            throw std::bad_alloc();
        if (status != XML_STATUS_OK)
            throw error();
        chunk = tokens_ == before ? std::min(2 * chunk, mostChunk) : leastChunk;
    }
}

qint64 XmlReader::line() const { return qint64(XML_GetCurrentLineNumber(parser_.get())); }

template <class Act>
void XmlReader::guarded(Act act)
{
    ++tokens_;
    if (thrown_)
        return;
    try {
        act();
    } catch (...) {
        thrown_ = std::current_exception();
        XML_StopParser(parser_.get(), XML_FALSE);
    }
}

void XmlReader::start(const char* name, const char** attributes)
{
    if (hasDoctype_)
        checkReferences();
    outside_.push_back(scope_.size());
    declareNamespaces(attributes);
    const XmlName element = nameOf(name, true);
    attributes_.clear();
    for (; *attributes; attributes += 2)
        if (!declaredPrefix(attributes[0]))
            attributes_.push_back({nameOf(attributes[0], false), attributes[1]});
    handler_.take({.kind = XmlToken::Kind::Start,
                   .name = element,
                   .attributes = attributes_,
                   .declared = declared_});
}

void XmlReader::end(const char* name)
{
    handler_.take({.kind = XmlToken::Kind::End, .name = nameOf(name, true)});
    scope_.resize(outside_.back());
    outside_.pop_back();
}

void XmlReader::declareNamespaces(const char** attributes)
{
    declared_.clear();
    for (; *attributes; attributes += 2)
        if (const auto prefix = declaredPrefix(attributes[0]))
            scope_.push_back({std::string(*prefix), attributes[1]});
    if (scope_.size() > mostDeclared)
        throw error(XmlError::Kind::Other,
                    Text::tr("more than %1 namespaces declared at one place").arg(mostDeclared));
    for (std::size_t i = outside_.back(); i < scope_.size(); ++i)
        declared_.push_back({scope_[i].prefix, scope_[i].uri});
}

/// `hasDefault`: without a prefix it is in the default namespace.
XmlName XmlReader::nameOf(std::string_view qualified, bool hasDefault)
{
    const std::size_t colon = qualified.find(':');
    if (colon != std::string_view::npos)
        return {qualified, qualified.substr(0, colon), qualified.substr(colon + 1),
                uriOf(qualified.substr(0, colon))};
    return {qualified, {}, qualified, hasDefault ? uriOf({}) : std::string_view()};
}

std::string_view XmlReader::uriOf(std::string_view prefix)
{
    for (auto declared = scope_.rbegin(); declared != scope_.rend(); ++declared)
        if (declared->prefix == prefix)
            return declared->uri;
    if (prefix.empty())
        return {};
    if (prefix == "xml")
        return "http://www.w3.org/XML/1998/namespace";
    const auto found = undeclared_.find(prefix);
    if (found != undeclared_.end())
        return found->second;
    if (undeclared_.size() == mostUndeclared)
        throw error(XmlError::Kind::Other,
                    Text::tr("more than %1 prefixes without a declaration").arg(mostUndeclared));
    handler_.takeUndeclared(prefix);
    return undeclared_.emplace(prefix, usualNamespace(prefix)).first->second;
}

// With a DTD that it does not read, Expat takes unknown entities for declared there; in attributes
// it leaves them out without a word.
void XmlReader::checkReferences() const
{
    int offset = 0, size = 0;
    const char* const input = XML_GetInputContext(parser_.get(), &offset, &size);
    if (!input)
        return;
    const std::string_view tag(input + offset, std::size_t(XML_GetCurrentByteCount(parser_.get())));
    for (std::size_t at = tag.find('&'); at != std::string_view::npos; at = tag.find('&', at + 1)) {
        const std::size_t end = tag.find(';', at);
        if (end == std::string_view::npos)
            return;
        const std::string_view name = tag.substr(at + 1, end - at - 1);
        const bool isWide = name.find('\0') != std::string_view::npos; // in UTF-16
        if (!isWide && !name.starts_with('#') && !isKnownEntity(name))
            throw undefinedEntity(name);
    }
}

bool XmlReader::isKnownEntity(std::string_view name) const
{
    return std::ranges::find(predefined, name) != predefined.end() || entities_.contains(name);
}

XmlError XmlReader::undefinedEntity(std::string_view name) const
{
    return error(XmlError::Kind::UndefinedEntity,
                 Text::tr("undefined entity “%1”").arg(QString::fromUtf8(name)));
}

XmlError XmlReader::error(XmlError::Kind kind, const QString& reason) const
{
    return {kind, reason, line(), encoding_, entities_};
}

XmlError XmlReader::error() const
{
    const XML_Error code = XML_GetErrorCode(parser_.get());
    const auto kind = isIncomplete(code)                   ? XmlError::Kind::Incomplete
                      : code == XML_ERROR_UNDEFINED_ENTITY ? XmlError::Kind::UndefinedEntity
                      : code == XML_ERROR_UNKNOWN_ENCODING ? XmlError::Kind::UnknownEncoding
                                                           : XmlError::Kind::Other;
    const QString reason = code == XML_ERROR_INVALID_TOKEN
                               ? Text::tr("a character that is not allowed here")
                               : QString::fromLatin1(XML_ErrorString(code));
    return error(kind, reason);
}

} // namespace app::svg
