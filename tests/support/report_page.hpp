#pragma once
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace faster::test {

/// The content of the JSON element with this id in a page.
inline nlohmann::ordered_json json_element(std::string const& page, std::string const& id) {
    std::string const start = "<script type=\"application/json\" id=\"" + id + "\">";
    std::size_t const begin = page.find(start);
    if (begin == std::string::npos)
        throw std::runtime_error("no element " + id + " in the page");
    std::size_t const end = page.find("</script>", begin);
    return nlohmann::ordered_json::parse(page.substr(begin + start.size(), end - begin - start.size()));
}

}  // namespace faster::test
