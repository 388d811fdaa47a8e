"""What must hold at the end, whatever went wrong before."""
import sqlite3
import subprocess

from .cluster import ChaosFailed

ROWS = ("SELECT sweep.name, job.job, job.state, hex(job.identity), hex(job.digest) FROM job JOIN sweep USING (sweep) "
        "ORDER BY sweep.name, job.job")


def rows_of(database):
    connection = sqlite3.connect(f"file:{database}?mode=ro", uri=True)
    try:
        return connection.execute(ROWS).fetchall()
    finally:
        connection.close()


def undisturbed(bin_folder, folder, sweep_files, workers):
    """The same sweeps on this machine alone; returns their database."""
    database = folder / "undisturbed.db"
    for file in sweep_files:
        subprocess.run([bin_folder / "lamprey", "run", file, "--database", database, "--workers", str(workers),
                        "--quiet"], check=True, stdout=subprocess.DEVNULL)
    return database


def check(cluster, jobs):
    """The sweeps have finished, and the database agrees with itself."""
    unfinished = cluster.rows("SELECT name, state, jobs, done FROM sweep WHERE state <> 'finished' OR done <> jobs")
    if unfinished:
        raise ChaosFailed(f"sweeps that are not finished, or not done: {unfinished}")
    stored = cluster.rows("SELECT count(*) FROM job")[0][0]
    if stored != jobs:
        raise ChaosFailed(f"{stored} rows instead of {jobs}")
    for kind in ("divergence", "job_quarantined"):
        events = cluster.rows(f"SELECT count(*) FROM event WHERE kind = '{kind}'")[0][0]
        if events:
            raise ChaosFailed(f"{events} events of kind {kind}")
    if cluster.rows("SELECT count(*) FROM divergence")[0][0]:
        raise ChaosFailed("there are divergences")
    verified = subprocess.run([cluster.bin / "lamprey", "verify", cluster.database], capture_output=True, text=True,
                              check=False)
    if verified.returncode != 0:
        raise ChaosFailed(f"lamprey verify: {verified.stdout}{verified.stderr}")


def compare(disturbed, quiet):
    """Row for row: name of the sweep, job, state, identity, digest."""
    if disturbed == quiet:
        return
    differing = sorted(set(disturbed) ^ set(quiet))
    raise ChaosFailed(f"{len(differing)} rows differ from those of the undisturbed run, the first: {differing[:6]}")
