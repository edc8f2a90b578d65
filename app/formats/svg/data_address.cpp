// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/data_address.h"

#include "app/formats/svg/scanner.h"

#include <QByteArray>

namespace app::svg {
namespace {

std::string_view unquoted(std::string_view text)
{
    text = trimmed(text);
    const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'')
                        && text.back() == text.front();
    return quoted ? text.substr(1, text.size() - 2) : text;
}

} // namespace

std::optional<std::string> dataOf(std::string_view address)
{
    constexpr std::string_view scheme = "data:", url = "url(", packed = ";base64";
    address = trimmed(address);
    if (equalsIgnoringCase(address.substr(0, url.size()), url) && address.ends_with(')'))
        address = address.substr(url.size(), address.size() - url.size() - 1);
    address = unquoted(address);
    const auto comma = address.find(',');
    if (!equalsIgnoringCase(address.substr(0, scheme.size()), scheme) || comma == address.npos)
        return std::nullopt;
    const auto kind = trimmed(address.substr(0, comma));
    const auto data = address.substr(comma + 1);
    const QByteArray plain =
        QByteArray::fromPercentEncoding(QByteArray(data.data(), qsizetype(data.size())));
    return kind.ends_with(packed) ? QByteArray::fromBase64(plain).toStdString()
                                  : plain.toStdString();
}

} // namespace app::svg
