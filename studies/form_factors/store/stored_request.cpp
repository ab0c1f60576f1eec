#include "studies/form_factors/store/stored_request.hpp"

#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies::form_factors {
namespace {

std::string_view coverage_of(const Request& request) {
    return request.level_of == LevelOf::entry ? "entry" : "matrix";
}

}  // namespace

void StoredKeys::expect(bool sound, std::string_view what) const {
    if (!sound) report_damage(file_, fmt::format("{} that no run has written", what));
}

template <class Get>
auto StoredKeys::value(std::string_view key, Get get) const {
    Statement query(database_.handle(), fmt::format("SELECT value FROM {} WHERE key = ?", format_.keys));
    query.bind(0, key);
    expect(query.step(), key);
    return (query.*get)(0);
}

std::string StoredKeys::text(std::string_view key) const {
    return value(key, &Statement::text);
}

double StoredKeys::real(std::string_view key) const {
    return value(key, &Statement::real);
}

std::uint64_t StoredKeys::count(std::string_view key) const {
    const std::int64_t count = value(key, &Statement::integer);
    expect(count >= 0, key);
    return static_cast<std::uint64_t>(count);
}

void write_request(const Database& database, const StoreFormat& format, const SceneSource& source,
                   const Request& request) {
    Statement insert(database.handle(), fmt::format("INSERT INTO {} VALUES(?, ?)", format.keys));
    const auto write = [&](std::string_view key, const auto& value) { run_with(insert, key, value); };
    write("schema_version", format.version);
    write("scene", source.title());
    if (source.text) write("scene_text", *source.text);
    write("tolerance", request.tolerance);
    if (request.relative > 0) write("relative", request.relative);
    if (request.drop > 0) write("drop", request.drop);
    if (!request.surroundings.empty()) write("surroundings", request.surroundings);
    write("level", request.level);
    write("coverage", coverage_of(request));
    write("seed", request.seed.value);
    write("max_samples", request.max_samples);
}

std::string difference_between(const SceneSource& source, const Request& request, const SceneSource& wanted_source,
                               const Request& wanted) {
    if (source.written() != wanted_source.written()) return "the scene is another";
    const auto differs = [](std::string_view key, const auto& there, const auto& here) {
        return there == here ? std::string() : fmt::format("its {} is {}, not {}", key, there, here);
    };
    for (const std::string& difference :
         {differs("tolerance", request.tolerance, wanted.tolerance),
          differs("relative", request.relative, wanted.relative), differs("drop", request.drop, wanted.drop),
          differs("surroundings", request.surroundings, wanted.surroundings),
          differs("level", request.level, wanted.level), differs("coverage", coverage_of(request), coverage_of(wanted)),
          differs("seed", request.seed.value, wanted.seed.value),
          differs("max_samples", request.max_samples, wanted.max_samples)}) {
        if (!difference.empty()) return difference;
    }
    return {};
}

std::pair<SceneSource, Request> read_request(const StoredKeys& keys) {
    SceneSource source = scene_source(keys.text("scene"));
    if (keys.has("scene_text")) source.text = keys.text("scene_text");
    Request request;
    request.tolerance = keys.real("tolerance");
    if (keys.has("relative")) request.relative = keys.real("relative");
    if (keys.has("drop")) request.drop = keys.real("drop");
    if (keys.has("surroundings")) request.surroundings = keys.text("surroundings");
    request.level = keys.real("level");
    request.level_of = keys.text("coverage") == "entry" ? LevelOf::entry : LevelOf::matrix;
    request.seed = Seed{keys.count("seed")};
    request.max_samples = keys.count("max_samples");
    keys.expect(request.tolerance > 0 && request.tolerance < 1, "a tolerance");
    keys.expect(request.relative >= 0 && request.relative < 1, "a relative tolerance");
    keys.expect(request.drop >= 0 && request.drop < 1, "a factor to drop");
    keys.expect(request.level > 0 && request.level < 1, "a level");
    return {std::move(source), std::move(request)};
}

}  // namespace ff::studies::form_factors
