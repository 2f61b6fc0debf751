#include "dataflow/tools/budgets/measurement.hpp"

#include <stdexcept>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/run/config/plain_text.hpp"

namespace dataflow::budgets {

std::vector<Setting> accelerator_settings(std::vector<ResolvedKey> const& keys) {
    std::vector<Setting> settings;
    for (ResolvedKey const& key : keys)
        if (!key.is_default && key.key.rfind("accelerator.", 0) == 0)
            settings.push_back({key.key, plain_text(key.value)});
    return settings;
}

std::string to_text(Measurement const& measurement) {
    Json names = Json::array(), values = Json::array(), accelerator = Json::array();
    for (Figure const& figure : measurement.figures.all()) {
        names.push_back(figure.name);
        values.push_back(figure.value);
    }
    for (Setting const& setting : measurement.accelerator)
        accelerator.push_back({setting.key, setting.value});
    Json const json{{"kind", static_cast<int>(measurement.kind)},
                    {"message", measurement.message},
                    {"clock_mhz", measurement.clock_mhz},
                    {"configuration", measurement.configuration},
                    {"accelerator", accelerator},
                    {"names", names},
                    {"values", values}};
    return io::text_of(json);
}

Measurement measurement_from_text(std::string const& text) {
    try {
        Json const json = Json::parse(text);
        Measurement measurement;
        measurement.kind = static_cast<Measurement::Kind>(json.at("kind").get<int>());
        measurement.message = json.at("message").get<std::string>();
        measurement.clock_mhz = json.at("clock_mhz").get<double>();
        measurement.configuration = json.at("configuration").get<std::string>();
        for (Json const& setting : json.at("accelerator"))
            measurement.accelerator.push_back({setting.at(0).get<std::string>(), setting.at(1).get<std::string>()});
        Json const& values = json.at("values");
        for (std::size_t i = 0; i < values.size(); ++i)
            measurement.figures.set(json.at("names").at(i).get<std::string>(), values[i].get<std::uint64_t>());
        return measurement;
    } catch (Json::exception const& error) {
        throw std::runtime_error(std::string("no measurement: ") + error.what());
    }
}

}  // namespace dataflow::budgets
