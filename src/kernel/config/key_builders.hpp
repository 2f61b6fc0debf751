#pragma once
#include <type_traits>
#include <utility>

#include "kernel/config/enum_names.hpp"
#include "kernel/config/key.hpp"

namespace faster {

/// Makers of table entries. A `Field` is a generic lambda from a configuration to a reference to one member of it,
/// `[](auto& config) -> auto& { return config.accelerator.window; }`: reading and writing follow from it.

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

template <class Field> Key make_key(KeyText text, KeyKind kind, Field field) {
    Key key;
    key.text = std::move(text);
    key.kind = kind;
    key.read = [field](RunConfig const& config) { return value_of(field(config)); };
    key.write = [field](RunConfig& config, KeyValue const& value) { assign(field(config), value); };
    return key;
}

template <class Field> Key integer_key(KeyText text, IntegerRange range, Field field) {
    Key key = make_key(std::move(text), KeyKind::integer, field);
    key.integers = range;
    return key;
}

template <class Field> Key number_key(KeyText text, NumberRange range, Field field) {
    Key key = make_key(std::move(text), KeyKind::number, field);
    key.numbers = range;
    return key;
}

template <class Field> Key choice_key(KeyText text, Field field) {
    using Choice = std::remove_reference_t<decltype(field(std::declval<RunConfig&>()))>;
    Key key = make_key(std::move(text), KeyKind::choice, field);
    key.choices = names_of_choices<Choice>();
    return key;
}

template <class Field> Key boolean_key(KeyText text, Field field) {
    return make_key(std::move(text), KeyKind::boolean, field);
}

}  // namespace faster
