//! Tests of reading modified artifacts.

use super::*;
use crate::{Engine, Module};
use calyx_gears::library::externs;

const MODEL: &str = "units mm_N_s; param a = 2 mm in 1 mm .. 3 mm; param name = \"x\";
    function f(in n) { return if (n < 2) 1 else n * f(n - 1); }
    var x := a * sin(Time * (1 rad/s)); print(f(4), name, x at Time = 1 s);";

fn artifact() -> Vec<u8> {
    Module::from_text(&Engine::default(), "model.cx", MODEL).unwrap().serialize().unwrap()
}

/// Creates an artifact with a modified identity and a valid checksum.
fn with_identity(change: impl FnOnce(&mut Identity)) -> Vec<u8> {
    let artifact = artifact();
    let (mut identity, rest) = postcard::take_from_bytes::<Identity>(&artifact[BODY_AT..]).unwrap();
    change(&mut identity);
    framed(FORMAT, &[&postcard::to_stdvec(&identity).unwrap(), rest].concat())
}

/// Returns message and remedy of a rejected artifact.
fn refusal(bytes: &[u8]) -> (String, &'static str) {
    let error = read(bytes).map(|_| ()).unwrap_err();
    (error.to_string(), error.help())
}

#[test]
fn foreign_artifacts_are_refused() {
    let again = "compile the model again with this version of Calyx";
    let artifact = artifact();
    assert!(read(&artifact).is_ok());

    assert_eq!(
        refusal(&framed(7, &artifact[BODY_AT..])),
        ("the compiled module has the layout 7 and this version of Calyx reads the layout 1".into(), again)
    );
    let other = with_identity(|identity| identity.version = "9.9.9".into());
    let expected = format!("the module was compiled by Calyx 9.9.9 and this is Calyx {VERSION}");
    assert_eq!(refusal(&other), (expected, again));
    let other = with_identity(|identity| identity.engine = Fingerprint(0xabc));
    let expected = format!(
        "the module was compiled for an engine with the interface 0000000000000abc and this engine has {FINGERPRINT}"
    );
    assert_eq!(refusal(&other), (expected, again));
    let here = Machine::new(TargetCpu::Native).unwrap().triple;
    let other = with_identity(|identity| identity.machine.triple = "riscv64gc-unknown-linux-gnu".into());
    let expected =
        format!("the module was compiled for riscv64gc-unknown-linux-gnu and this machine is {here}");
    assert_eq!(refusal(&other), (expected, "compile the model on a machine of this kind"));
    let other = with_identity(|identity| identity.machine.features.push("has_wings".into()));
    let expected = "the module was compiled for a processor with has_wings, which this one lacks".to_owned();
    let help = "compile the model on this machine, or for every processor of this kind";
    assert_eq!(refusal(&other), (expected, help));
    // Code that requires fewer instruction sets than this machine has is accepted.
    assert!(read(&with_identity(|identity| identity.machine.features.clear())).is_ok());
}

#[test]
fn what_is_no_whole_artifact_is_refused() {
    let artifact = artifact();
    let copy = "copy it again from where it was made, as binary data, or compile the model again";
    for bytes in [&b""[..], b"\x7fELF", MODEL.as_bytes(), &artifact[1..], &artifact[..7]] {
        let help = "give what `Module::serialize` made, or compile the model's source";
        assert_eq!(refusal(bytes), ("this is not a compiled Calyx module".into(), help));
        assert!(!is_artifact(bytes));
    }
    for length in [8, 12, 30, BODY_AT, BODY_AT + 1, artifact.len() - 1] {
        let (message, help) = refusal(&artifact[..length]);
        assert!(message.starts_with("the compiled module is incomplete"), "{message}");
        assert_eq!(help, copy);
    }
    let longer = [&artifact[..], b"\n"].concat();
    let (message, help) = refusal(&longer);
    assert!(message.starts_with("the compiled module is followed by something else"), "{message}");
    assert_eq!(help, copy);
    // A transfer in text mode changes line ends.
    let text = [&artifact[..6], &artifact[7..]].concat();
    assert!(matches!(read(&text), Err(ArtifactError::NotAnArtifact)));
}

/// Rejects an artifact with a flipped bit anywhere in the header, or at locations throughout the
/// body.
#[test]
fn every_changed_byte_is_noticed() {
    let mut artifact = artifact();
    let step = (artifact.len() / 2000).max(1);
    for at in (0..BODY_AT).chain((BODY_AT..artifact.len()).step_by(step)) {
        for change in [1, 0x80, 0xff] {
            artifact[at] ^= change;
            assert!(read(&artifact).is_err(), "byte {at} changed by {change:#x}");
            artifact[at] ^= change;
        }
    }
    assert!(read(&artifact).is_ok());
}

/// Checks the decoder without the checksum: bodies are changed and given a matching checksum. No
/// code is run.
#[test]
fn no_contents_make_loading_panic() {
    let artifact = artifact();
    let mut state = 1_u64;
    let mut random = |limit: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % limit
    };
    // Most of the body is the sources of the library; the data after them exercises the decoder
    // more.
    let (_, rest) = postcard::take_from_bytes::<Identity>(&artifact[BODY_AT..]).unwrap();
    let (_, code) = postcard::take_from_bytes::<String>(rest).unwrap();
    let code_at = artifact.len() - code.len() - BODY_AT;
    let (mut refused, mut loaded) = (0, 0);
    for round in 0..2000 {
        let mut body = artifact[BODY_AT..].to_vec();
        for _ in 0..=random(3) {
            let at = if round % 4 == 0 { random(body.len()) } else { code_at + random(body.len() - code_at) };
            match random(8) {
                0 => body.truncate(at.max(code_at) + 1),
                1 => drop(body.remove(at)),
                2 => body.splice(at..at, [0xff; 9]).for_each(drop),
                _ => body[at] = random(256) as u8,
            }
        }
        let read = read(&framed(FORMAT, &body));
        // SAFETY: loading is sound for any code; the code is not run.
        match read.map(|contents| unsafe { calyx_codegen::load_code(&contents.code, externs()) }) {
            Ok(Ok(_)) => loaded += 1,
            _ => refused += 1,
        }
    }
    assert!(refused > 100 && loaded > 100, "{refused} refused, {loaded} loaded");
}
