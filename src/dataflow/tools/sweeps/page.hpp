#pragma once

namespace dataflow::sweeps {

/// The page of a sweep without its data: page/sweep.html with style and scripts in place; see report::filled_page().
extern char const* const sweep_page_template;

}  // namespace dataflow::sweeps
