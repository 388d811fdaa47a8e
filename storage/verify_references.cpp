#include "storage/verify_parts.hpp"

namespace lamprey::storage {

void add_rows(const Connection& connection, const std::string& sql, const std::string& column,
              std::vector<Discrepancy>& discrepancies) {
  Statement rows(connection, sql);
  while (rows.step()) {
    const auto job = rows.is_null(1) ? std::nullopt : std::optional(rows.bits(1));
    discrepancies.push_back({std::string(rows.text(0)), job, column, std::string(rows.text(2))});
  }
}

void verify_references(const Connection& connection, std::vector<Discrepancy>& discrepancies) {
  for (const std::string table : {"job", "divergence", "attempt", "checkpoint", "audit", "recording"}) {
    add_rows(connection,
             "SELECT sweep, " + std::string(table == "audit" ? "NULL" : "job") +
                 ", 'the row belongs to a sweep that does not exist' FROM " + table +
                 " WHERE sweep NOT IN (SELECT sweep FROM sweep)",
             table == "job" ? "sweep" : table + ".sweep", discrepancies);
  }
  add_rows(connection,
           "SELECT '', job, 'the row belongs to an audit that does not exist' FROM audit_job "
           "WHERE audit NOT IN (SELECT audit FROM audit)",
           "audit_job.audit", discrepancies);
  add_rows(connection,
           "SELECT s.name, d.job, 'it is not the digest of the stored job' FROM divergence AS d "
           "JOIN sweep AS s ON s.sweep = d.sweep LEFT JOIN job AS j ON j.sweep = d.sweep AND j.job = d.job "
           "WHERE d.stored IS NOT j.digest",
           "divergence.stored", discrepancies);
  add_rows(connection,
           "SELECT '', NULL, 'the row belongs to a recording that does not exist' FROM robot_evaluation "
           "WHERE recording NOT IN (SELECT recording FROM recording)",
           "robot_evaluation.recording", discrepancies);
  for (const std::string table : {"attempt", "checkpoint", "recording"}) {
    add_rows(connection,
             "SELECT s.name, t.job, 'the sweep has ' || s.jobs || ' jobs only' FROM " + table +
                 " AS t JOIN sweep AS s ON s.sweep = t.sweep WHERE t.job >= s.jobs",
             table + ".job", discrepancies);
  }
  add_rows(connection,
           "SELECT s.name, c.job, 'the job has ended' FROM checkpoint AS c JOIN sweep AS s ON s.sweep = c.sweep "
           "JOIN job AS j ON j.sweep = c.sweep AND j.job = c.job",
           "checkpoint.job", discrepancies);
}

void verify_audits(const Connection& connection, std::vector<Discrepancy>& discrepancies) {
  // The rows of a sweep that is being deleted go before what counts them.
  const std::string counted =
      "FROM audit AS a JOIN sweep AS s ON s.sweep = a.sweep AND s.state <> 'deleting' "
      "JOIN (SELECT audit.audit AS audit, count(*) FILTER (WHERE j.agreed = 1) AS agreed, "
      "count(*) FILTER (WHERE j.agreed = 0) AS diverged FROM audit LEFT JOIN audit_job AS j USING (audit) "
      "GROUP BY audit.audit) AS c ON c.audit = a.audit WHERE a.";
  for (const std::string column : {"agreed", "diverged"}) {
    add_rows(connection,
             "SELECT s.name, NULL, 'stored ' || a." + column + " || ', expected ' || c." + column + " " + counted +
                 column + " IS NOT c." + column,
             "audit." + column, discrepancies);
  }
  add_rows(connection,
           "SELECT s.name, r.job, 'it contradicts the digests of the audit and of the job' FROM audit_job AS r "
           "JOIN audit AS a ON a.audit = r.audit JOIN sweep AS s ON s.sweep = a.sweep "
           "LEFT JOIN job AS j ON j.sweep = a.sweep AND j.job = r.job WHERE r.agreed <> (r.digest IS j.digest)",
           "audit_job.agreed", discrepancies);
}

}  // namespace lamprey::storage
