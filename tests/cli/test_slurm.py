#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The job array of examples/hpc on a Slurm of its own: two nodes on this machine, started and stopped here, in a folder of their own.

usage: test_slurm.py TOUCHSTONE SOURCE

Nothing outside that folder is read or written, no service of the machine is used, and no account but the caller's. Exit code 77 where Slurm is
not installed (Debian: slurm-wlm).
"""
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, SOURCE = pathlib.Path(sys.argv.pop(1)).resolve(), pathlib.Path(sys.argv.pop(1)).resolve()
STORED = SOURCE / "data/reference"
SKIPPED = 77
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"  # where daemons are, and a user's PATH often is not
TOOLS = {name: shutil.which(name, path=PATH) for name in ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol")}
NODES = ("a", "b")
TABLE, SHARES = "archard_alpha", 6
LONGEST = 600  # seconds: an end to waiting for what never comes, on any machine
CREDENTIAL = 5  # seconds a credential is good for: Slurm waits so long before it starts a task again


def free_ports(count):
    open_at_once = [socket.socket() for _ in range(count)]
    for s in open_at_once:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in open_at_once]
    for s in open_at_once:
        s.close()
    return ports


class Cluster:
    """Two nodes of one core each. Every process of the cluster has `mark` in its environment, and so has every task."""

    def __init__(self, folder, path):
        self.folder, self.mark = folder, str(folder)
        controller, *ports = free_ports(1 + len(NODES))
        host = socket.gethostname().split(".")[0]
        user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
        (folder / "key").write_bytes(os.urandom(128))
        (folder / "key").chmod(0o600)
        (folder / "state").mkdir()
        (folder / "slurm.conf").write_text("\n".join((
            "ClusterName=touchstone", f"SlurmctldHost={host}(127.0.0.1)", f"SlurmctldPort={controller}", f"SlurmUser={user}", f"SlurmdUser={user}",
            "AuthType=auth/munge", "CredType=cred/munge", f"AuthInfo=socket={folder}/munge,cred_expire={CREDENTIAL}",
            f"StateSaveLocation={folder}/state", f"SlurmdSpoolDir={folder}/spool-%n", f"SlurmctldPidFile={folder}/slurmctld.pid", f"SlurmdPidFile={folder}/%n.pid",
            f"SlurmctldLogFile={folder}/slurmctld.log", f"SlurmdLogFile={folder}/%n.log", "ProctrackType=proctrack/linuxproc", "TaskPlugin=task/none",
            "SwitchType=switch/none", "MpiDefault=none", "JobAcctGatherType=jobacct_gather/none", "SelectType=select/cons_tres", "SelectTypeParameters=CR_CPU",
            "SlurmdParameters=config_overrides", "ReturnToService=2", "JobRequeue=0",
            "SchedulerParameters=batch_sched_delay=0,sched_interval=1,bf_interval=1", "EpilogMsgTime=0",
            *(f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1 State=UNKNOWN" for node, port in zip(NODES, ports)),
            f"PartitionName=all Nodes={','.join(NODES)} Default=YES MaxTime=INFINITE State=UP", "")))
        self.env = dict(os.environ, PATH=f"{path}:{PATH}", SLURM_CONF=str(folder / "slurm.conf"), TOUCHSTONE_CLUSTER=self.mark, HOME=str(folder))
        self.daemons = []

    def start(self):
        self.daemon("munged", "--foreground", "--force", f"--socket={self.folder}/munge", f"--key-file={self.folder}/key", f"--pid-file={self.folder}/munge.pid",
                    f"--log-file={self.folder}/munge.log", f"--seed-file={self.folder}/seed")
        self.wait("munge's socket", (self.folder / "munge").exists)
        self.daemon("slurmctld", "-D")
        for node in NODES:
            self.daemon("slurmd", "-D", "-N", node, TOUCHSTONE_NODE=f"{self.mark}/{node}")
        for node in NODES:
            self.wait(f"node {node}", lambda: self.state(node) == "IDLE")

    def daemon(self, name, *words, **more):
        with open(self.folder / "daemons.txt", "a") as log:
            self.daemons.append(subprocess.Popen([TOOLS[name], *words], env=dict(self.env, **more), stdin=subprocess.DEVNULL, stdout=log, stderr=log, cwd=self.folder))

    def run(self, name, *words):
        done = subprocess.run([TOOLS[name], *map(str, words)], env=self.env, capture_output=True, text=True, stdin=subprocess.DEVNULL, cwd=self.folder, timeout=LONGEST)
        return done.stdout if done.returncode == 0 else ""

    def state(self, node):
        return "".join(re.findall(r"State=(\S+)", self.run("scontrol", "show", "node", node)))

    def wait(self, what, there):
        end = time.monotonic() + LONGEST
        while not there():
            if time.monotonic() > end:
                logs = "\n".join(f"{log.name}: {log.read_text(errors='replace')[-1500:]}" for log in (*self.folder.glob("*.log"), self.folder / "daemons.txt"))
                raise AssertionError(f"waited in vain for {what}\n{self.run('squeue')}\n{logs}")
            time.sleep(0.1)

    def submit(self, *words):
        if not self.run("sbatch", *words):
            raise AssertionError(f"sbatch {words} failed")

    def finished(self):
        self.wait("the end of all tasks", lambda: len(self.run("squeue").splitlines()) == 1)  # the heading alone

    def kill(self, name, value):
        """SIGKILL for every process that has this in its environment: no warning, as when a machine loses power."""
        wanted = f"{name}={value}".encode()
        while True:
            found = [int(p.name) for p in pathlib.Path("/proc").iterdir() if p.name.isdigit() and wanted in environment(p).split(b"\0")]
            for pid in found:
                try:
                    os.kill(pid, signal.SIGKILL)
                except ProcessLookupError:
                    pass
            for daemon in self.daemons:
                daemon.poll()  # a dead child of ours is not seen again
            if not found:
                return
            time.sleep(0.05)

    def stop(self):
        self.kill("TOUCHSTONE_CLUSTER", self.mark)


def environment(process):
    try:
        return (process / "environ").read_bytes()
    except OSError:
        return b""


class Slurm(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.shares, self.ran = self.folder / "shares", self.folder / "ran"
        bin = self.folder / "bin"
        bin.mkdir()
        # The program as a task finds it: it says where it runs, dies once if `dies` names its share, and on node b waits until it may go on.
        (bin / "touchstone").write_text(f"""#!/bin/sh
echo "$SLURMD_NODENAME $SLURM_ARRAY_TASK_ID" >> '{self.ran}'
if [ -e '{self.folder}/dies' ] && [ "$(cat '{self.folder}/dies')" = "$SLURM_ARRAY_TASK_ID" ]; then rm '{self.folder}/dies'; kill -9 $$; fi
while [ "$SLURMD_NODENAME" = b ] && [ -e '{self.folder}/hold' ]; do sleep 0.1; done
exec '{PROGRAM}' "$@"
""")
        (bin / "touchstone").chmod(0o755)
        self.cluster = Cluster(self.folder, bin)
        self.addCleanup(self.cluster.stop)
        self.cluster.start()

    def submit(self, array=f"--array=1-{SHARES}", *more, to=None):
        self.cluster.submit(array, *more, SOURCE / "examples/hpc/slurm.sh", TABLE, to or self.shares)

    def tasks_of(self, node):
        return [line.split()[1] for line in self.ran.read_text().splitlines() if line.split()[0] == node] if self.ran.exists() else []

    def merged(self, folder=None):
        return subprocess.run([PROGRAM, "merge", folder or self.shares], capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=LONGEST)

    def is_the_table(self, folder=None):
        r = self.merged(folder)
        self.assertEqual(r.returncode, 0, r.stderr)
        self.assertEqual(((folder or self.shares) / f"{TABLE}.txt").read_bytes(), (STORED / f"{TABLE}.txt").read_bytes())

    def test_a_worker_is_killed(self):
        """One share of one is what N shares are; what a killed worker leaves out, merge names, and sbatch takes it as it is."""
        (self.folder / "dies").write_text("3")
        self.submit()
        self.cluster.finished()
        self.assertEqual(sorted(self.tasks_of("a") + self.tasks_of("b")), [str(i) for i in range(1, SHARES + 1)])
        r = self.merged()
        self.assertEqual((r.returncode, r.stdout), (1, "--array=3\n"), r.stderr)
        self.submit(r.stdout.strip(), f"--export=ALL,SHARES={SHARES}")
        self.cluster.finished()
        self.is_the_table()
        self.submit("--array=1-1", to=self.folder / "one")
        self.cluster.finished()
        self.is_the_table(self.folder / "one")

    def test_a_node_is_drained(self):
        """What runs there ends there, nothing more is started there, the other node does the rest."""
        (self.folder / "hold").touch()
        self.submit()
        self.cluster.wait("a task on node b", lambda: self.tasks_of("b"))
        self.cluster.run("scontrol", "update", "nodename=b", "state=drain", "reason=test")
        self.cluster.wait("the drain", lambda: "DRAIN" in self.cluster.state("b"))
        (self.folder / "hold").unlink()
        self.cluster.finished()
        self.assertEqual(len(self.tasks_of("b")), 1)
        self.assertEqual(len(self.tasks_of("a")), SHARES - 1)
        self.is_the_table()

    def test_a_node_is_lost(self):
        """Its daemon and its task end by SIGKILL in the middle: the task is queued again (--requeue) and made on the other node."""
        (self.folder / "hold").touch()
        self.submit()
        self.cluster.wait("a task on node b", lambda: self.tasks_of("b"))
        lost = self.tasks_of("b")
        self.cluster.kill("TOUCHSTONE_NODE", f"{self.folder}/b")
        self.cluster.run("scontrol", "update", "nodename=b", "state=down", "reason=test")
        self.cluster.wait("node b to be down", lambda: "DOWN" in self.cluster.state("b"))
        self.cluster.finished()
        self.assertEqual(len(lost), 1)
        self.assertIn(lost[0], self.tasks_of("a"))
        self.is_the_table()


if __name__ == "__main__":
    missing = sorted(name for name, where in TOOLS.items() if where is None)
    if missing:
        print(f"skipped: no {', '.join(missing)} here (Debian: apt-get install --no-install-recommends slurm-wlm)")
        sys.exit(SKIPPED)
    unittest.main(verbosity=1)
