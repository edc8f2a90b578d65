// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace app::csv {

/// Divides the text of one record into its fields, without quotation marks. Reuses its buffers.
/// A record that needs no unquoting is not copied.
class RecordFields {
public:
    explicit RecordFields(char separator = ',') : separator_(separator) {}

    /// Valid until the next call, as long as `record`, which begins on the line `line` of its file.
    /// Throws Refused for text that is not CSV.
    std::span<const std::string_view> of(std::string_view record, std::size_t line);

private:
    void split(std::string_view record);
    void splitAtBlanks(std::string_view record);

    char separator_; ///< or anyBlanks
    std::vector<std::string_view> fields_;
    std::vector<std::string> unquoted_;
};

} // namespace app::csv
