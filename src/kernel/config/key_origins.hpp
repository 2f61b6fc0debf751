#pragma once
#include <map>
#include <string>
#include <utility>

namespace faster {

/// What gave a key its value, the strongest last.
enum class KeySource { default_value, preset, file, command_line, trace };

struct KeyOrigin {
    KeySource source = KeySource::default_value;
    std::string place;  ///< "FILE:LINE" (of a preset as well), "--set KEY=VALUE" or what was read, e.g. "trace"; empty
                        ///< for a default
};

/// Where every key that does not just have its default was set.
class KeyOrigins {
  public:
    KeyOrigin of(std::string const& key) const {
        auto const found = origins_.find(key);
        return found == origins_.end() ? KeyOrigin{} : found->second;
    }
    bool is_explicit(std::string const& key) const { return of(key).source != KeySource::default_value; }
    void record(std::string const& key, KeyOrigin origin) { origins_[key] = std::move(origin); }
    std::map<std::string, KeyOrigin> const& all() const { return origins_; }

  private:
    std::map<std::string, KeyOrigin> origins_;
};

}  // namespace faster
