// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <mutex>

namespace abut {

/// What follows from the value that it stands in, made when it is first asked for: once for all copies of that value.
template <class T>
class Once {
public:
    /// make: the same whichever copy asks. May be asked by several threads.
    template <class Make>
    const T& operator()(Make make) const {
        std::call_once(state_->is_made, [&] { state_->value = make(); });
        return state_->value;
    }

private:
    struct State {
        std::once_flag is_made;
        T value{};
    };
    std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace abut
