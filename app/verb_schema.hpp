#pragma once

namespace searle::app {

enum class SchemaFormat { text, json, markdown };

struct SchemaOptions {
    SchemaFormat format = SchemaFormat::text;
};

/// `searle schema [--json | --markdown]`: prints every key of a case file to stdout, with its type,
/// unit, default, bounds and meaning. Returns the exit code 0.
[[nodiscard]] int schema(const SchemaOptions& options);

} // namespace searle::app
