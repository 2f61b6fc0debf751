#pragma once
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {

template <class Member> KeyValue value_of(Member const& member) {
    if constexpr (std::is_enum_v<Member>) {
        return choice_name(member);
    } else if constexpr (std::is_integral_v<Member> && !std::is_same_v<Member, bool>) {
        return static_cast<std::int64_t>(member);
    } else {
        return member;
    }
}

template <class Member> void assign(Member& member, KeyValue const& value) {
    if constexpr (std::is_enum_v<Member>) {
        member = choice_from_name<Member>(std::get<std::string>(value));
    } else if constexpr (std::is_integral_v<Member> && !std::is_same_v<Member, bool>) {
        member = static_cast<Member>(std::get<std::int64_t>(value));
    } else {
        member = std::get<Member>(value);
    }
}

template <class Member> void assign(std::optional<Member>& member, KeyValue const& value) {
    assign(member.emplace(), value);
}

/// The part of a configuration that a KeyMaker's fields are of.
template <class Config, class Whole> auto& part_of(Whole& config) {
    if constexpr (std::is_same_v<Config, RunConfig>) {
        return config;
    } else if constexpr (std::is_same_v<Config, MachineSettings>) {
        return config.machine();
    } else {
        return config.template as<Config>();
    }
}

/// Makers of keys. `Config`: the design's class of DesignConfig, or MachineSettings, or RunConfig. A `Field` is a
/// generic lambda from it to a reference to one member, `[](auto& config) -> auto& { return config.window; }`: reading
/// and writing follow from it.
template <class Config> struct KeyMaker {
    template <class Field> static Key make_key(KeyText text, KeyKind kind, Field field) {
        Key key;
        key.text = std::move(text);
        key.kind = kind;
        key.read = [field](RunConfig const& config) { return value_of(field(part_of<Config>(config))); };
        key.write = [field](RunConfig& config, KeyValue const& value) {
            assign(field(part_of<Config>(config)), value);
        };
        return key;
    }

    template <class Field> static Key integer_key(KeyText text, IntegerRange range, Field field) {
        Key key = make_key(std::move(text), KeyKind::integer, field);
        key.integers = range;
        return key;
    }

    template <class Field> static Key number_key(KeyText text, NumberRange range, Field field) {
        Key key = make_key(std::move(text), KeyKind::number, field);
        key.numbers = range;
        return key;
    }

    template <class Field> static Key choice_key(KeyText text, Field field) {
        using Choice = std::remove_reference_t<decltype(field(std::declval<Config&>()))>;
        Key key = make_key(std::move(text), KeyKind::choice, field);
        key.choices = names_of_choices<Choice>();
        return key;
    }

    template <class Field> static Key boolean_key(KeyText text, Field field) {
        return make_key(std::move(text), KeyKind::boolean, field);
    }
};

template <class Whole, class Member> auto& member_of(Whole& whole, Member member) { return whole.*member; }

/// A member of a member, and so on: each of `deeper` is one of what the one before it leads to.
template <class Whole, class Member, class... Members> auto& member_of(Whole& whole, Member member, Members... deeper) {
    return member_of(whole.*member, deeper...);
}

/// Adds the keys of one part of a configuration, each of which is a member of the part's class:
/// `noise.number("sigma", "m", "Deviation of a reading.", "measured", {0, 1}, &Noise::sigma);`. Each returns the key,
/// for what else is to be said of it, up to the next. See key_section().
template <class Config, class Part> class KeySection {
    using Make = KeyMaker<Config>;
    using Text = std::string const&;

  public:
    KeySection(Keys& keys, std::string name, Part part) : keys_(keys), name_(std::move(name)), part_(part) {}

    template <class Member>
    Key& integer(Text name, Text unit, Text meaning, Text source, IntegerRange range, Member member) {
        return keys_.emplace_back(Make::integer_key(text(name, unit, meaning, source), range, field(member)));
    }
    template <class Member>
    Key& number(Text name, Text unit, Text meaning, Text source, NumberRange range, Member member) {
        return keys_.emplace_back(Make::number_key(text(name, unit, meaning, source), range, field(member)));
    }
    template <class Member> Key& choice(Text name, Text unit, Text meaning, Text source, Member member) {
        return keys_.emplace_back(Make::choice_key(text(name, unit, meaning, source), field(member)));
    }
    template <class Member> Key& boolean(Text name, Text unit, Text meaning, Text source, Member member) {
        return keys_.emplace_back(Make::boolean_key(text(name, unit, meaning, source), field(member)));
    }
    template <class Member> Key& of_kind(Text name, Text unit, Text meaning, Text source, KeyKind kind, Member member) {
        return keys_.emplace_back(Make::make_key(text(name, unit, meaning, source), kind, field(member)));
    }

  private:
    KeyText text(Text name, Text unit, Text meaning, Text source) const {
        return {name_ + '.' + name, unit, meaning, source};
    }
    template <class Member> auto field(Member member) const {
        return [part = part_, member](auto& config) -> decltype(auto) { return part(config).*member; };
    }

    Keys& keys_;
    std::string name_;
    Part part_;
};

/// For keys whose names begin with `name` and a dot; they go to `keys`. The members lead from the `Config` of KeyMaker
/// to the part: `auto noise = key_section(keys, "sensor.noise", &ToyConfig::sensor, &Sensor::noise);`.
template <class Config, class Member, class... Members>
auto key_section(Keys& keys, std::string name, Member Config::*first, Members... deeper) {
    auto part = [first, deeper...](auto& config) -> decltype(auto) { return member_of(config, first, deeper...); };
    return KeySection<Config, decltype(part)>(keys, std::move(name), part);
}

/// A key that may be changed without running the function again.
inline Key of_time(Key key) {
    key.decides_time = true;
    return key;
}

}  // namespace dataflow
