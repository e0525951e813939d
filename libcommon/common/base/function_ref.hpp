#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace rockslope {

template <class Signature>
class FunctionRef;

/// A reference to a callable, for function parameters that are called before the function returns. The
/// callable must outlive the reference. Unlike std::function it allocates no memory.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
  public:
    template <class Function,
              class = std::enable_if_t<!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef>>>
    FunctionRef(const Function& function)
        : function_(std::addressof(function)), call_([](const void* f, Arguments... arguments) -> Result {
              return (*static_cast<const Function*>(f))(std::forward<Arguments>(arguments)...);
          }) {}

    Result operator()(Arguments... arguments) const {
        return call_(function_, std::forward<Arguments>(arguments)...);
    }

  private:
    const void* function_;
    Result (*call_)(const void*, Arguments...);
};

}  // namespace rockslope
