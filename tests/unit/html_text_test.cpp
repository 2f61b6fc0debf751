#include "dataflow/tools/report/html/html_text.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "dataflow/base/markup_text.hpp"
#include "faster/dataflow_names.hpp"

namespace dataflow::report::html_text_test {

TEST_CASE("Text in HTML shows as it is", "[html]") {
    CHECK(markup_escaped("plain text, 1 + 1 = 2") == "plain text, 1 + 1 = 2");
    CHECK(markup_escaped(R"(<b title="it's">&</b>)") == "&lt;b title=&quot;it&#39;s&quot;&gt;&amp;&lt;/b&gt;");
}

TEST_CASE("JSON in a script cannot end it and stays the same JSON", "[html]") {
    nlohmann::json const value{{"</script><!--", R"(<img src=x onerror="x">&amp;\u003c)"}};
    std::string const safe = script_safe(value.dump());
    CHECK(safe.find_first_of("<>&") == std::string::npos);
    CHECK(nlohmann::json::parse(safe) == value);
}

TEST_CASE("Base64 gives the vectors of RFC 4648", "[html]") {
    CHECK(base64("").empty());
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string("\0\xff\xfe", 3)) == "AP/+");
}

}  // namespace dataflow::report::html_text_test
