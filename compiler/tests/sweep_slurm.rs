//! Tests of `calyx sweep --on slurm`: with programs in place of the commands of Slurm, which run
//! the script of the job for each index immediately; and, in `.ci/full`, on a Slurm cluster of this
//! machine.

use crate::support::pair;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Runs the script for each index of the array. The task of the index in the file `killed` prints
/// and ends instead.
const SBATCH: &str = r#"#!/bin/sh
for argument; do
    case $argument in
    --array=*) array=${argument#--array=} ;;
    --output=*) log=${argument#--output=} ;;
    --refused) echo "sbatch: error: invalid partition" >&2; exit 1 ;;
    esac
    script=$argument
done
echo "$*" >>arguments
for range in $(echo "$array" | tr , ' '); do
    for index in $(seq "${range%-*}" "${range#*-}"); do
        out=$(echo "$log" | sed "s/%A/7/; s/%a/$index/")
        if [ "$(cat killed)" = "$index" ]; then echo "slurmstepd: error: oom kill" >"$out"; continue; fi
        SLURM_ARRAY_TASK_ID=$index SLURM_CPUS_PER_TASK= sh "$script" >"$out" 2>&1
    done
done
echo 7
"#;

/// Prints the file `queue`; without it, the job is not known any more.
const SQUEUE: &str = r#"#!/bin/sh
if [ -f down ]; then echo "slurm_load_jobs error: Unable to contact slurm controller" >&2; exit 1; fi
cat queue 2>/dev/null && exit
echo "slurm_load_jobs error: Invalid job id specified" >&2
exit 1
"#;

const SACCT: &str = "#!/bin/sh\necho '7_1|COMPLETED|0:0'\necho '7_2|OUT_OF_MEMORY|0:125'\n";

fn sweep(at: &Path, path: &str, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.arg("sweep").args(arguments).env("CALYX_CACHE", "off").env("PATH", path).current_dir(at);
    let output = command.output().expect("it starts");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

fn has(told: &str, expected: &[&str]) {
    for expected in expected {
        assert!(told.contains(expected), "`{expected}` is not in:\n{told}");
    }
}

#[test]
fn jobs_are_submitted_followed_and_collected() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let write = |name: &str, text: &str| fs::write(at.join(name), text).expect("written");
    write("model.cx", "param width = 2 mm in 0 mm .. 20 mm;\noutput area := width * width;\n");
    let arguments = ["model.cx", "--over", "width=1..5:5", "--out", "sweep", "--on", "slurm"];
    let on = |more: &[&str]| {
        sweep(at, &format!("{}:/usr/bin:/bin", at.join("bin").display()), &[&arguments, more].concat())
    };
    let (status, told) = sweep(at, "/nowhere", &[&arguments[..], &["--cases-per-index", "2"]].concat());
    assert_eq!(status, Some(1), "{told}");
    has(&told, &["error: cannot run `sbatch`", "or use `--plan` for another queue"]);
    fs::create_dir(at.join("bin")).expect("a folder");
    for (name, text) in [("sbatch", SBATCH), ("squeue", SQUEUE), ("sacct", SACCT)] {
        write(&format!("bin/{name}"), text);
        let mode = fs::Permissions::from_mode(0o755);
        fs::set_permissions(at.join("bin").join(name), mode).expect("executable");
    }
    write("killed", "2");
    let (status, told) = on(&["--slurm-options", "--refused"]);
    assert_eq!(status, Some(1), "{told}");
    has(
        &told,
        &["error: sbatch did not accept the job: sbatch: error: invalid partition", "  help: correct"],
    );

    // The second index is killed.
    let (status, told) = on(&["--slurm-options", "--time=1:00 --mem=1G"]);
    assert_eq!(status, Some(1), "{told}");
    has(
        &told,
        &[
            "submitted the job 7, array 1-3\n",
            "error: 2 of 5 cases are missing: index 2",
            "index 2: OUT_OF_MEMORY, exit status 0:125; the end of sweep/logs/7_2.log:\n  slurmstepd: error: oom kill\n",
            "error: the job 7 has ended, and 1 of 3 indices are not finished\n  help: submit them again by the same command with `--resubmit`",
        ],
    );
    let submitted = || fs::read_to_string(at.join("arguments")).expect("a file");
    has(&submitted(), &["--parsable --array=1-3 --job-name=model.cx --output=", "--time=1:00 --mem=1G /"]);
    assert_eq!(submitted().lines().count(), 1);

    // The same command submits nothing; while a task runs, neither does `--resubmit`.
    write("killed", "");
    let (status, told) = on(&["--slurm-options", "--time=1:00 --mem=1G"]);
    assert_eq!(status, Some(1), "{told}");
    assert!(!told.contains("submitted"), "{told}");
    write("queue", "RUNNING|None\n");
    let (status, told) = on(&["--resubmit"]);
    assert_eq!(status, Some(2), "{told}");
    has(&told, &["error: the job 7 has not ended", "or end it with `scancel 7`"]);
    fs::remove_file(at.join("queue")).expect("removed");
    write("down", "");
    let (status, told) = on(&["--resubmit"]);
    assert_eq!(status, Some(1), "{told}");
    has(&told, &["error: the state of the job 7 is not known: slurm_load_jobs error: Unable to contact"]);
    fs::remove_file(at.join("down")).expect("removed");
    assert_eq!(submitted().lines().count(), 1);

    let (status, told) = on(&["--resubmit", "--slurm-options", "--mem=8G"]);
    assert_eq!(status, Some(0), "{told}");
    has(&told, &["submitted the job 7, array 2\n", "table and plots are in sweep\n"]);
    has(&submitted(), &["--array=2 --job-name"]);
    let (status, told) = sweep(at, "/usr/bin:/bin", &["model.cx", "--over", "width=1..5:5", "--out", "here"]);
    assert_eq!(status, Some(0), "{told}");
    let table = |name: &str| fs::read(at.join(name).join("sweep.csv")).expect("a table");
    assert!(table("sweep") == table("here"));
    // Everything is solved: needs no Slurm.
    let (status, told) = sweep(at, "/nowhere", &arguments);
    assert_eq!(status, Some(0), "{told}");
}

/// Returns the process of the worker of an index.
fn worker(index: &str) -> Option<String> {
    let processes = fs::read_dir("/proc").expect("processes").filter_map(Result::ok);
    let is_worker = |name: &String| {
        let line = fs::read(format!("/proc/{name}/cmdline")).unwrap_or_default();
        let words: Vec<&[u8]> = line.split(|byte| *byte == 0).collect();
        words.first().is_some_and(|program| program.ends_with(b"calyx"))
            && words.windows(2).any(|pair| pair == [b"--index".as_slice(), index.as_bytes()])
    };
    processes.map(|entry| entry.file_name().to_string_lossy().into_owned()).find(is_worker)
}

/// 50 cases on a cluster, of which a worker is killed in its second case or later.
#[test]
#[ignore = "needs a Slurm cluster: `.ci/full slurm`"]
fn slurm_cluster_solves_all_cases_after_a_kill() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let analysis = "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 40), fidelity = \"analytic\", error_estimates = \"none\");\n";
    fs::write(at.join("pair.cx"), pair("", analysis)).expect("written");
    let path = std::env::var("PATH").unwrap_or_default();
    let axes = ["pair.cx", "--over", "torque=10..30:50"];
    let on = [&axes[..], &["--out", "cluster", "--on", "slurm", "--cases-per-index", "5"]].concat();
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.arg("sweep").args(&on).env("CALYX_CACHE", "off").current_dir(at);
    let child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("it starts");

    // Killed when it has solved a case.
    let journal = at.join("cluster/results/0004.1.jsonl");
    let started = Instant::now();
    while fs::read_to_string(&journal).unwrap_or_default().lines().count() < 2 {
        assert!(started.elapsed() < Duration::from_secs(300), "the job has not started");
        sleep(Duration::from_millis(5));
    }
    let process = worker("4").expect("a worker");
    let killed = Command::new("kill").args(["-9", &process]).status().expect("it starts");
    assert!(killed.success());
    let output = child.wait_with_output().expect("it ends");
    let told = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    has(&told, &["cases are missing: index 4", "1 of 10 indices are not finished", "with `--resubmit`"]);

    let (status, told) = sweep(at, &path, &[&on[..], &["--resubmit"]].concat());
    assert_eq!(status, Some(0), "{told}");
    has(&told, &["array 4\n"]);
    let first = fs::read_to_string(&journal).expect("a journal").lines().count();
    let second = fs::read_to_string(at.join("cluster/results/0004.2.jsonl")).expect("a journal");
    let solved = second.lines().count() - 1;
    assert!((1..5).contains(&solved) && first >= 2, "{first} lines, {solved} cases");
    let (status, told) = sweep(at, &path, &[&axes[..], &["--out", "here"]].concat());
    assert_eq!(status, Some(0), "{told}");
    for name in ["sweep.csv", "sweep.html"] {
        let read = |of: &str| fs::read(at.join(of).join(name)).expect(name);
        assert!(read("cluster") == read("here"), "{name} differs");
    }
    let table = fs::read_to_string(at.join("cluster/sweep.csv")).expect("a table");
    assert_eq!(table.lines().count(), 51);
}
