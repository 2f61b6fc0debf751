#pragma once
namespace faster::poses {

/// The page of an evaluation without its data, page/evaluation.html with style and scripts; see report::filled_page().
extern char const* const evaluation_page;

}  // namespace faster::poses
