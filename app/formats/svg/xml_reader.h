// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIODevice>
#include <QString>

#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

struct XML_ParserStruct;

namespace app::svg {

/// A name in UTF-8, with its namespace.
struct XmlName {
    std::string_view qualified{}; ///< as it is written, such as "xlink:href"
    std::string_view prefix{}, local{};
    std::string_view uri{}; ///< of the namespace; empty: none
};
struct XmlAttribute {
    XmlName name;
    std::string_view value;
};
/// The declaration of a namespace; an empty prefix: that of names without one.
struct XmlDeclaration {
    std::string_view prefix, uri;
};

/// A part of a file, valid until the next one. All text is UTF-8.
struct XmlToken {
    enum class Kind : std::uint8_t { Start, End, Text, Comment, Instruction } kind;
    XmlName name{};                             ///< of an element; of an instruction its target
    std::span<const XmlAttribute> attributes{}; ///< without declarations
    std::span<const XmlDeclaration> declared{};
    std::string_view text{}; ///< content; of text perhaps only a part

    std::string_view valueOf(std::string_view attribute) const; ///< empty: it has none
};

/// Why a file is not XML.
struct XmlError {
    enum class Kind : std::uint8_t { Incomplete, UndefinedEntity, UnknownEncoding, Other } kind;
    QString reason;
    qint64 line;
    std::string encoding;                        ///< that the file declares
    std::set<std::string, std::less<>> entities; ///< that it declares so far
};

/// Takes the parts of a file in order. What it throws ends the reading and is thrown by it.
class XmlHandler {
public:
    virtual ~XmlHandler() = default;
    virtual void take(const XmlToken& token) = 0;
    /// A prefix that is not declared is used for the first time; it gets its usual namespace.
    virtual void takeUndeclared(std::string_view prefix) = 0;
};

/// Reads XML with Expat, in one pass. Namespaces are resolved here, because Expat refuses prefixes
/// without a declaration. External entities are never fetched.
class XmlReader {
public:
    /// `isUtf8`: whatever encoding the file declares.
    explicit XmlReader(XmlHandler& handler, bool isUtf8 = false);

    /// Throws XmlError, and what the handler throws.
    void read(QIODevice& in);
    qint64 line() const; ///< where the last token begins; the first is 1

private:
    struct Callbacks;
    struct Prefix {
        std::string prefix, uri;
    };

    template <class Act>
    void guarded(Act act);
    void start(const char* name, const char** attributes);
    void end(const char* name);
    void declareNamespaces(const char** attributes);
    XmlName nameOf(std::string_view qualified, bool hasDefault);
    std::string_view uriOf(std::string_view prefix);
    void checkReferences() const;
    bool isKnownEntity(std::string_view name) const;
    XmlError error() const;
    XmlError error(XmlError::Kind kind, const QString& reason) const;
    XmlError undefinedEntity(std::string_view name) const;

    XmlHandler& handler_;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> parser_;
    std::exception_ptr thrown_; ///< by the handler: not through the functions of Expat
    std::uint64_t tokens_ = 0;

    std::vector<Prefix> scope_;        ///< declared at this place
    std::vector<std::size_t> outside_; ///< size of scope_ outside each open element
    std::map<std::string, std::string, std::less<>> undeclared_; ///< prefixes and namespaces
    std::vector<XmlDeclaration> declared_;
    std::vector<XmlAttribute> attributes_;

    bool hasDoctype_ = false;
    std::string encoding_;
    std::set<std::string, std::less<>> entities_;
};

} // namespace app::svg
