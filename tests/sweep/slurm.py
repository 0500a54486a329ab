"""Runs Slurm with one node, in a folder and with ports of its own, for the duration of a test.

Its programs are those of Debian (slurm-wlm, which installs munge) and run as the current user. The
test does not change any other Slurm on the machine.
"""

import getpass
import os
import pathlib
import secrets
import socket
import subprocess
import tempfile
import time

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
SlurmctldPort={ctld_port}
SlurmdPort={slurmd_port}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=8
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
JobRequeue=1
# A job that is queued again waits until its credential, above, has expired.
SchedulerParameters=sched_interval=1,bf_interval=1,batch_sched_delay=0,sched_min_interval=1000,sched_max_job_start=0
SlurmdTimeout=10
ReturnToService=2
MinJobAge=300
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN
PartitionName=test Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Slurm:
    """A context manager that starts this Slurm and stops it at the end."""

    def __init__(self, cpus):
        self.cpus = cpus

    def __enter__(self):
        self._scratch = tempfile.TemporaryDirectory(prefix="stokesbook-slurm-")
        self.folder = pathlib.Path(self._scratch.name)
        self.folder.chmod(0o755)  # munge requires that its socket can be found
        self._daemons = []
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        configuration = self.folder / "slurm.conf"
        configuration.write_text(CONFIGURATION.format(
            host=socket.gethostname().split(".")[0], user=getpass.getuser(), folder=self.folder,
            ctld_port=free_port(), slurmd_port=free_port(), cpus=self.cpus))
        # These tests do not limit tasks by cgroups. The older cgroup plugin is chosen because only
        # this plugin starts without /sys, as in a chroot.
        (self.folder / "cgroup.conf").write_text("CgroupPlugin=cgroup/v1\n")
        self.environment = {**os.environ, "SLURM_CONF": str(configuration),
                            "PATH": os.environ["PATH"] + ":/usr/sbin"}
        try:
            self._start_munge()
            self._start("slurmctld", "-D", "-f", configuration)
            self.start_node()
            self.wait_until("the node is up", lambda: "idle" in self("sinfo", "-h", "-o", "%T"))
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        for daemon in reversed(self._daemons):
            if daemon.poll() is None:
                daemon.terminate()
                try:
                    daemon.wait(20)
                except subprocess.TimeoutExpired:
                    daemon.kill()
                    daemon.wait()
        self._scratch.cleanup()

    def __call__(self, *command, check=True):
        """Returns the output of a command of Slurm."""
        result = subprocess.run([*map(str, command)], env=self.environment, capture_output=True,
                                text=True)
        if check and result.returncode != 0:
            raise RuntimeError(f"{command}: {result.stdout}{result.stderr}\n{self.logs()}")
        return result.stdout

    def logs(self):
        return "\n".join(f"{path.name}:\n{path.read_text()[-3000:]}"
                         for path in self.folder.glob("*.log"))

    def start_node(self):
        self._node = self._start("slurmd", "-D", "-f", self.folder / "slurm.conf")

    def kill_node(self):
        """Kills the daemon of the node; the caller must also kill the processes that it started."""
        self._node.kill()
        self._node.wait()

    def miss_node(self):
        """Waits until Slurm has noticed the loss of the node."""
        self.wait_until("the node is missed", lambda: "down" in self("sinfo", "-h", "-o", "%T"))

    def wait_until(self, what, holds, seconds=60):
        end = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > end:
                raise TimeoutError(f"{what}: not within {seconds} s\n{self.logs()}")
            time.sleep(0.1)

    def _start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(secrets.token_bytes(128))
        key.chmod(0o600)
        options = {"key-file": key, "socket": self.folder / "munge.socket",
                   "pid-file": self.folder / "munge.pid", "log-file": self.folder / "munge.log",
                   "seed-file": self.folder / "munge.seed"}
        self._start("munged", "--foreground", "--force", "--num-threads=1",
                    *(f"--{name}={path}" for name, path in options.items()))
        self.wait_until("munge listens", (self.folder / "munge.socket").exists)

    def _start(self, *command):
        with open(self.folder / f"{command[0]}.out.log", "ab") as log:
            daemon = subprocess.Popen([*map(str, command)], env=self.environment, stdout=log,
                                      stderr=log)
        self._daemons.append(daemon)
        return daemon
