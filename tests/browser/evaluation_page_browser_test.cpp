#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "poses/judging/evaluation_json.hpp"
#include "support/browser.hpp"

namespace evaluation_page_browser_test {

using namespace faster;
using namespace faster::test;
using namespace faster::poses;

JudgedMethod method(std::string const& name, double error_m) {
    JudgedMethod judged;
    judged.name = name;
    for (int im_id : {0, 1, 2})
        judged.judgement.instances.push_back({{1, im_id}, 1, std::nullopt, error_m, error_m, error_m, 5});
    return judged;
}

std::string page() {
    bop::Dataset dataset;
    dataset.folder = "<i>data</i>";
    dataset.models[1].name = "</script>";
    return evaluation_html(evaluate(dataset, {method("one", 0.01), method("two", 0.03)}, {0, 1, 10}));
}

TEST_CASE("The browser draws the page of an evaluation", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("index.html", page());
    std::string const drawn = drawn_page(folder, "index.html");
    CHECK_THAT(drawn, Catch::Contains("&lt;i&gt;data&lt;/i&gt;: 3 instances of 1 object in 3 images"));
    CHECK_THAT(drawn, Catch::Contains("<canvas") && Catch::Contains("&lt;/script&gt;"));
    CHECK_THAT(drawn, Catch::Contains("100.0 (100.0 to 100.0)") && Catch::Contains("-100.0 (-100.0 to -100.0)"));
    CHECK_THAT(drawn, Catch::Contains("Points more than one"));
}

}  // namespace evaluation_page_browser_test
