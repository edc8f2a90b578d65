// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace app {

/// While it lives, SIGTERM, SIGHUP and SIGINT end the process as they always do, but `last` is
/// called before, on a thread of its own: at once, even while all other threads are busy. One that
/// the program was started to ignore (nohup) stays ignored. There may be one at a time. Where there
/// are no such signals, or no thread can be had, it does nothing.
class SignalWatch {
public:
    explicit SignalWatch(std::function<void(int signal)> last);
    ~SignalWatch();
    SignalWatch(const SignalWatch&) = delete;
    SignalWatch& operator=(const SignalWatch&) = delete;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace app
