# %% [markdown]
# # Cases on a Dask cluster, of which one worker is killed
#
# Models are sent to the workers, and results return as arrays. Dask repeats the cases of a worker that
# disappears. The same code runs on any Dask cluster, for example with `dask_jobqueue.SLURMCluster`.

# %%
import os
import signal
import time

from dask.distributed import Client, LocalCluster, as_completed

import calyx

TORQUES = [float(torque) for torque in range(400, 1000, 25)]
OPTIONS = {"steps": 4, "fidelity": "plane", "error_estimates": "none"}


def solve(model, torque):
    return model.run(torque=torque, threads=1, **OPTIONS)


# %%
def main():
    pair = calyx.load("../../../examples/spur_pair.cx")
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            client.wait_for_workers(2)
            # The model is sent once to each worker.
            [model] = client.scatter([pair], broadcast=True)
            futures = [client.submit(solve, model, torque, pure=False) for torque in TORQUES]
            workers = client.run(os.getpid)
            solved = 0
            for future in as_completed(futures):
                future.result()
                solved += 1
                if solved == 4:
                    # The death of a worker, as by the queue of a cluster.
                    os.kill(next(iter(workers.values())), signal.SIGKILL)
            results = client.gather(futures)
            deadline = time.monotonic() + 60
            while len(client.run(os.getpid)) < 2 and time.monotonic() < deadline:
                time.sleep(0.2)
            replaced = set(client.run(os.getpid).values()) - set(workers.values())
    print(f"{len(results)} results; {len(replaced)} worker was replaced")
    assert len(results) == len(TORQUES) and replaced

    # Each result has the bits of a run in this process.
    for torque, found in list(zip(TORQUES, results))[::6]:
        alone = solve(pair, torque)
        assert all(found[name].si.tobytes() == alone[name].si.tobytes() for name in alone)


# Worker processes import this file.
if __name__ == "__main__":
    main()
