// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/write_result.h"

#include <new>

namespace app {

WriteResult resultOf(const std::function<std::optional<QString>()>& write,
                     const std::stop_token& stop, const QString& outOfMemory)
{
    try {
        const auto error = write();
        if (!error)
            return {};
        return {stop.stop_requested() ? WriteResult::End::Stopped : WriteResult::End::Failed,
                *error};
    } catch (const std::bad_alloc&) {
        return {WriteResult::End::Failed, outOfMemory};
    }
}

} // namespace app
