#include "storage/schema.hpp"

#include "storage/statement.hpp"

#include <array>
#include <chrono>
#include <map>
#include <set>
#include <sys/random.h>

namespace lamprey::storage {

namespace {

/// What a schema's fingerprint covers.
struct Shape {
  std::map<std::string, std::string> views;                                 ///< name → SQL
  std::map<std::pair<std::string, std::string>, std::string> descriptions;  ///< object, column → description

  bool operator==(const Shape&) const = default;
};

Shape shape_of_program() {
  Shape shape;
  const auto describe = [&](const SchemaObject& object) {
    shape.descriptions[{object.name, ""}] = object.description;
    for (const auto& column : object.columns) shape.descriptions[{object.name, column.name}] = column.description;
  };
  for (const auto& table : tables()) describe(table);
  for (const auto& view : views()) {
    describe(view);
    shape.views[view.name] = view_sql(view);
  }
  return shape;
}

/// Of the described views only: people may have added their own.
Shape shape_of_database(const Connection& connection) {
  Shape shape;
  Statement described(connection, "SELECT object, \"column\", description FROM schema_description");
  while (described.step()) {
    shape.descriptions[{std::string(described.text(0)), std::string(described.text(1))}] = described.text(2);
  }
  Statement stored(connection, "SELECT name, sql FROM sqlite_master WHERE type = 'view'");
  while (stored.step()) {
    std::string name(stored.text(0));
    if (shape.descriptions.contains({name, ""})) shape.views.emplace(std::move(name), stored.text(1));
  }
  return shape;
}

std::string fingerprint(const Shape& shape) {
  std::string text;
  for (const auto& [name, sql] : shape.views) text.append(name).append(1, '\0').append(sql).append(1, '\0');
  for (const auto& [where, description] : shape.descriptions) {
    text.append(where.first).append(1, '\0').append(where.second).append(1, '\0').append(description).append(1, '\0');
  }
  return experiment::to_hex(experiment::sha256(text));
}

experiment::Id128 random_id(const Connection& connection) {
  std::array<std::uint64_t, 2> bits{};
  if (getrandom(bits.data(), sizeof bits, 0) != static_cast<ssize_t>(sizeof bits)) {
    throw StorageError(StorageError::Kind::input_output, connection.path() + ": the system gives no random numbers");
  }
  return {bits[0], bits[1]};
}

}  // namespace

std::string quoted(const std::string& name) {
  return "\"" + name + "\"";
}

std::int64_t unix_milliseconds() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

void create_tables(const Connection& connection) {
  connection.execute("PRAGMA application_id = " + std::to_string(application_id));
  for (const auto& table : tables()) connection.execute(table_sql(table));
  record_schema_version(connection);
  const auto now = unix_milliseconds();
  const std::string id = experiment::to_hex(random_id(connection));
  Statement(connection, "INSERT INTO database VALUES (1, ?, ?, 0, ?, ?, '')")
      .with(std::string_view(id), experiment::science_version, now, now)
      .run();
}

int stored_schema_version(const Connection& connection) {
  Statement version(connection, "PRAGMA user_version");
  return version.step() ? static_cast<int>(version.integer(0)) : 0;
}

void record_schema_version(const Connection& connection) {
  connection.execute("PRAGMA user_version = " + std::to_string(schema_version));
  Statement(connection, "INSERT INTO schema_version VALUES (?, ?, ?)")
      .with(schema_version, unix_milliseconds(), std::string_view(LAMPREY_VERSION))
      .run();
}

bool refresh_views(const Connection& connection) {
  const Shape wanted = shape_of_program();
  const Shape stored = shape_of_database(connection);
  const std::string wanted_fingerprint = fingerprint(wanted);
  Statement read(connection, "SELECT fingerprint FROM database");
  const bool current = read.step() && read.text(0) == wanted_fingerprint;
  read.reset();
  if (current && stored == wanted) return false;

  std::set<std::string> names;
  for (const auto& [name, sql] : stored.views) names.insert(name);
  for (const auto& [name, sql] : wanted.views) names.insert(name);
  for (const auto& name : names) connection.execute("DROP VIEW IF EXISTS " + quoted(name));
  for (const auto& [name, sql] : wanted.views) connection.execute(sql);
  connection.execute("DELETE FROM schema_description");
  Statement insert(connection, "INSERT INTO schema_description VALUES (?, ?, ?)");
  for (const auto& [where, description] : wanted.descriptions) {
    insert.with(std::string_view(where.first), std::string_view(where.second), std::string_view(description)).run();
  }
  Statement(connection, "UPDATE database SET fingerprint = ?").with(std::string_view(wanted_fingerprint)).run();
  return true;
}

std::string stored_schema_fingerprint(const Connection& connection) {
  return fingerprint(shape_of_database(connection));
}

}  // namespace lamprey::storage
