//! Tests of sine and cosine against values of 400 digits, symmetries, and bitwise equality at every
//! width.

use super::{LIMIT, columns, ordinary, sincos, sincos_columns};

/// Angle; sine and the difference to the exact sine; the same for the cosine. Bits of doubles.
/// Among the angles are the doubles closest to multiples of pi/4 and pi/2, and some far outside the
/// range of the reduction.
#[rustfmt::skip]
const EXACT: [[u64; 5]; 69] = [
    [0x3e152e6b43e54e9c, 0x3e152e6b43e54e9c, 0xba38bf5016cc9b33, 0x3ff0000000000000, 0xbc2c0a603dcf7219],
    [0x3e1269e0d2ca264e, 0x3e1269e0d2ca264e, 0xba3042359791a181, 0x3ff0000000000000, 0xbc2530f67d6c8c5b],
    [0x3e1a6a3a4418b900, 0x3e1a6a3a4418b900, 0xba47ffacaf2f1c72, 0x3ff0000000000000, 0xbc35cdff511567d4],
    [0x3f7128b2f3a47e10, 0x3f7128afa99f2b3e, 0xbbd93a7689bc609f, 0x3fefffed991df731, 0xbc8d72c2328667f9],
    [0x3f7892f9023031d0, 0x3f7892ef58dc9484, 0x3c1a4b5ef053f66e, 0x3fefffda41d65543, 0xbc6cba93da7c0f1a],
    [0x3f75d9dc9f2a6330, 0x3f75d9d5d44f7097, 0x3bf4ac2d89983cb2, 0x3fefffe2288b0550, 0xbc8f063ee2db4bf5],
    [0x3fc0ed9047d1c4bb, 0x3fc0e0f13952efaa, 0x3c581348cd7a2c35, 0x3fefb877178addd9, 0x3c75ae766fa21ac8],
    [0x3fc81e74ee6decec, 0x3fc7f9fbc9726d53, 0x3c5411870716f94f, 0x3fef6effa3e08bbc, 0xbc5feb35d945bdcb],
    [0x3fc099950c2c0146, 0x3fc08dae1e5a1b0b, 0x3c61d090616528c4, 0x3fefbb3502de7f07, 0xbc5d5c488d8d9ebd],
    [0x3fe6f03674d61aa9, 0x3fe50615a4b62af8, 0xbc819bbbe8a95415, 0x3fe81fec648a4522, 0xbc83ef1653d81190],
    [0x3fe11e20b87b382e, 0x3fe0501bbc8e2c08, 0xbc859717b546ad2e, 0x3feb879f5d0064be, 0x3c7db46f2c0ba195],
    [0x3fe1738f7d1a22de, 0x3fe09960cd0fef30, 0x3c657f325f1188fe, 0x3feb5bb0331644bf, 0xbc8ebad1a56d1eb4],
    [0x3ff6cad4a21e43bb, 0x3fefa883987f9bff, 0x3c82a7f902e28545, 0x3fc2a822570d1f60, 0xbc67403bae967593],
    [0x3ffd3ac94b218326, 0x3feef4e95efd4f72, 0xbc89253ecf31aff6, 0xbfd0358679b1d4a2, 0xbc68e9eafecdcfc9],
    [0x3ff1fb17c3e51820, 0x3fecdb239d2bf7c3, 0xbc49cf2c55db9821, 0x3fdbaa19ee0f7b1c, 0xbc7fe0817de6223d],
    [0x400392630542e166, 0x3fe47ec262cac1e5, 0xbc8bf8f5bdea70f1, 0xbfe8934b45e5acfe, 0xbc7a3f4f4e67dbcd],
    [0x400a09f76b2a7e92, 0xbfbcefa5703f8222, 0xbc3b59ecffd8acc9, 0xbfefcb8026d1a994, 0x3c837226c4a5842a],
    [0x400f29d0da1fac62, 0xbfe5e6df4a873640, 0x3c8d2d97f315e4aa, 0xbfe7549764a48215, 0xbc85b8849969d766],
    [0x40193bd04d2bcc16, 0x3f99d4455ad8f415, 0x3c36b9e7dafeb3d3, 0x3feffd64bf44a6dc, 0x3c88e2c3dc727d67],
    [0x401658cda01963c5, 0xbfe4873d50d1a2e0, 0x3c7d3139d4310378, 0x3fe88c364bcf64f3, 0xbc8c58d4b5e440a3],
    [0x401f9ebdac7131a3, 0x3feff55518b71fa3, 0x3c7e2246bfc8981f, 0xbfaa1eda1e90bab7, 0xbc32973256a50ed4],
    [0x4030becd7b1d032e, 0xbfeb8dd75e564600, 0xbc7fc818c4979232, 0xbfe045987cc4e09c, 0x3c732316f8e282b1],
    [0x403dbc496c442f7d, 0xbfefced0f125051f, 0x3c80b2d9ae2d7c1b, 0xbfbc02a5350c2e57, 0x3c43d92018899c9a],
    [0x4034a23d58d69964, 0x3fef462ee14b64d1, 0x3c779ce887cbcbef, 0xbfcb1b9ed705ef0e, 0xbc6a14fd24bfc8bc],
    [0x40624ede6b14d4c8, 0x3fedb5d1d6528fde, 0x3c817b4be75defe4, 0xbfd7c62beaff4fa2, 0xbc7b1759e722a653],
    [0x4061e27a1d244ecc, 0xbfefb5876ebfd425, 0xbc3bb8c1c765ee71, 0x3fc13854bc6a36bb, 0xbc68c5886d15193c],
    [0x4064ef8aa31eda0a, 0xbfea993109ce0f32, 0xbc0568a1841935d7, 0xbfe1ca888bec4b2f, 0x3c608331708cfde1],
    [0x409d0eda835d2f75, 0xbfbbf7337c514356, 0xbc48bc61bc3c45ee, 0x3fefcef9389414b2, 0xbc8f82ea2fa530af],
    [0x4092e4415834c3b8, 0x3fdbcd02dc1c9d80, 0xbc380ef5f46372a4, 0xbfecd2bf23e378cc, 0x3c467a1a5b7a255b],
    [0x40994e3bf92474e6, 0xbfefed5080fadec0, 0x3c8527121cbb6414, 0x3fb147e5588bf601, 0x3c47797d9e29f6cd],
    [0x40ca38fd546030a2, 0xbfedaead8a0b4fa1, 0xbc784e58ff6d5a2b, 0x3fd7e9c0378be365, 0x3c77dfb5a17bde6c],
    [0x40c5f5572031e26c, 0x3fec36d2f9f75d45, 0x3c82b7d1dc49bcd0, 0xbfde326014c49b25, 0x3c72381938ebce6f],
    [0x40c8c38fb36c99c8, 0xbfd5a96fa536c8d2, 0xbc78850c22ddc977, 0x3fee1c7ec6d01a5a, 0xbc8010b968ec8412],
    [0x4101012f0320f4e2, 0xbfdf9d8fbfca31bf, 0xbc74ae175c9cdecd, 0xbfebd2ab8c40fc68, 0xbc844698a2f8ff31],
    [0x4100f4205b3ceed3, 0x3fdf9b5a9ba70115, 0xbc7998e47aa06699, 0x3febd34c1013aa75, 0x3c80777e79386a0f],
    [0x41034b9b5cfe2a0a, 0x3fef0f00bf4226f6, 0xbc27bcadc43dd016, 0x3fced1a7d55809af, 0x3be0af0c4a5850c8],
    [0x412ae2eb15103da2, 0xbfeb04d2f4306eb3, 0xbc7b13561301fd0d, 0xbfe1255a0f889f82, 0x3c767fc0ffdbf910],
    [0x4126d76b078df0ee, 0xbfe6585bfc1a8391, 0xbc8df9abc8345993, 0xbfe6e7fce29926cd, 0xbc8caa74d057037b],
    [0x412506bf2eee635e, 0x3fdfb0107cbc9885, 0x3c719597b09f4433, 0xbfebcd67e937b0c7, 0xbc78189aff8600e4],
    [0x3ff921fb54442d18, 0x3ff0000000000000, 0xb92377ce858a5d48, 0x3c91a62633145c07, 0xb91f1976b7ed8fbc],
    [0x400921fb54442d18, 0x3ca1a62633145c07, 0xb92f1976b7ed8fbd, 0xbff0000000000000, 0x394377ce858a5d48],
    [0x401921fb54442d18, 0xbcb1a62633145c07, 0x393f1976b7ed8fbf, 0x3ff0000000000000, 0xb96377ce858a5d48],
    [0x4041475cc9eedf00, 0x3cf6111d218effa2, 0x399753cfcc3193e6, 0xbff0000000000000, 0x39ee6f226a6598ca],
    [0x4036000000000000, 0xbf8220a29f6eb9f4, 0x3c1504b8bc40d505, 0xbfefffadd8d4acda, 0xbc2f6b2aa0db6ecd],
    [0x4076300000000000, 0xbeff9bd0307d1de3, 0x3b9894874d2528d2, 0xbfefffffffc18e4c, 0x3c6862265016699c],
    [0x4086300000000000, 0x3f0f9bd0303f6faf, 0x3b9203af947a249c, 0x3fefffffff063930, 0xbc88253939253a8e],
    [0x40f9639000000000, 0xbef40efdf1eb8de7, 0x3b9f636eaa54141c, 0x3fefffffffe6da77, 0x3c67035e9b2fcdec],
    [0x3fe921fb54442d18, 0x3fe6a09e667f3bcc, 0x3c87a7fb8d4bd43f, 0x3fe6a09e667f3bcd, 0xbc7ec4c7696139d5],
    [0x3fe921fb54442d19, 0x3fe6a09e667f3bcd, 0x3c63a4e169292f60, 0x3fe6a09e667f3bcc, 0x3c5ae2fbf2875bde],
    [0x412e848000000000, 0xbfd6664b2568d867, 0xbc7264732d26e9b9, 0x3fedf9df9906d32c, 0x3c8abb226a0c6680],
    [0x41392197e6666666, 0x3fec8b722f7b1b3c, 0x3c8f978e6da8a2c4, 0x3fdced6df1e11914, 0xbc71cb3933935930],
    [0x413921981999999a, 0x3feed96644ef95d7, 0xbc838fea68e0e055, 0x3fd102487888413e, 0x3c79790515a2b305],
    [0x415921fb54442d18, 0xbdf1a62633145c07, 0x3a7f1d0af6141a02, 0x3ff0000000000000, 0xbbe377ce858a5d48],
    [0x4202a05f20000000, 0xbfdf334c7896a4e3, 0xbc7332cd01b7d484, 0x3febf098901c931a, 0xbc8f366020f3b0f5],
    [0x4480f0cf064dd592, 0xbfeb453ab76bf397, 0xbc5f453790772648, 0x3fe0be2cef01c8f4, 0xbc8b2d1bc8018c4f],
    [0x7506ac5b262ca1ff, 0x3ff0000000000000, 0xb842b089ea1e692b, 0xbc214ae72e6ba22f, 0x38973eef1477d90e],
    [0x7fefffffffffffff, 0x3f7452fc98b34e97, 0xbc127bb193d960df, 0xbfefffe62ecfab75, 0xbc7e038d934070f1],
    [0x3ff921fb54442d18, 0x3ff0000000000000, 0xb92377ce858a5d48, 0x3c91a62633145c07, 0xb91f1976b7ed8fbc],
    [0x3fe921fb54442d18, 0x3fe6a09e667f3bcc, 0x3c87a7fb8d4bd43f, 0x3fe6a09e667f3bcd, 0xbc7ec4c7696139d5],
    [0x4012d97c7f3321d2, 0xbff0000000000000, 0x3955e6c8563ba8f1, 0xbcaa79394c9e8a0a, 0xb94456737b06ea19],
    [0x4002d97c7f3321d2, 0x3fe6a09e667f3bcd, 0x3c73267a12a5e3d6, 0xbfe6a09e667f3bcc, 0x3c44da530b7ba971],
    [0x40988b2f704a940a, 0x3d32c3beb21e1e21, 0x39d217b77be66c4a, 0x3ff0000000000000, 0xba6601c7d1da2ff3],
    [0x40888b2f704a940a, 0x3d22c3beb21e1e21, 0x39c217b77be73ac4, 0x3ff0000000000000, 0xba4601c7d1da2ff3],
    [0x41032cb07ebc9985, 0xbff0000000000000, 0x3b5f68c8b32193be, 0xbdafb40a31c55eec, 0x3a3746c9831630b8],
    [0x40f32cb07ebc9985, 0xbfe6a09e667fef24, 0x3c772bae4a3bfe11, 0x3fe6a09e667e8875, 0x3c83db6d9a5e2053],
    [0x412921f83004c290, 0xbff0000000000000, 0x3b7f0c472089bcdf, 0x3dbf85380360d4b7, 0x3a554d245183a5b8],
    [0x411921f83004c290, 0xbfe6a09e667dd730, 0x3c7cc35d8e561b3d, 0x3fe6a09e6680a069, 0x3c86a74122b4466f],
    [0x41391e728cec5382, 0x3db0d154a92b4b58, 0x3a5011165d0a46de, 0x3ff0000000000000, 0xbb61ad5c07da1904],
    [0x41291e728cec5382, 0x3da0d154a92b4b58, 0x3a401116f1af5776, 0x3ff0000000000000, 0xbb41ad5c07da1904],
];

/// Difference of two positive numbers, the second in two parts, in units in the last place of the
/// second.
fn error(value: f64, exact: f64, rest: f64) -> f64 {
    let unit = f64::from_bits(exact.abs().to_bits() + 1) - exact.abs();
    ((value - exact) - rest).abs() / unit
}

/// Reproducible angles of all magnitudes, uniform in the logarithm, of both signs.
fn angles(count: usize) -> impl Iterator<Item = f64> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    (0..count).map(move |_| {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        let random = state.wrapping_mul(0x2545_f491_4f6c_dd1d);
        let exponent = 1023 - 30 + (random >> 8) % 52;
        f64::from_bits(random & (1 << 63) | exponent << 52 | random >> 12)
    })
}

const SPECIAL: [f64; 10] =
    [0.0, -0.0, 5e-324, -2e-310, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, LIMIT, -LIMIT, f64::MAX];

fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan()
}

#[test]
fn errors_stay_below_one_unit_in_the_last_place() {
    let mut worst = 0.0_f64;
    for row in EXACT {
        let [angle, sine, sine_rest, cosine, cosine_rest] = row.map(f64::from_bits);
        let (s, c) = sincos(angle);
        let errors = error(s, sine, sine_rest).max(error(c, cosine, cosine_rest));
        // Beyond the limit the error is that of libm, below one unit.
        let bound = if angle <= LIMIT { 0.8 } else { 1.0 };
        assert!(errors <= bound, "{angle}: {errors}");
        worst = worst.max(errors);
    }
    assert!(worst > 0.4, "the table is too easy: {worst}");
}

/// Within one unit in the last place of `libm`, itself within one, over all magnitudes.
#[test]
fn no_angle_is_far_from_a_second_implementation() {
    for angle in angles(200_000) {
        let (s, c) = sincos(angle);
        for (value, reference) in [(s, libm::sin(angle)), (c, libm::cos(angle))] {
            let error = error(value.abs(), reference.abs(), 0.0);
            assert!(value * reference >= 0.0 && error <= 1.0, "{angle}: {value} and {reference}");
        }
    }
}

#[test]
fn exceptions_are_rare_and_those_expected() {
    let count = 100_000;
    let exceptions = angles(count).filter(|angle| angle.abs() <= LIMIT && !ordinary(*angle).2).count();
    assert!(exceptions < count / 1000, "{exceptions}");
    for angle in [0.0, -0.0, 5e-324, 1e-300, 0.5, 3.0, 1e6] {
        assert!(ordinary(angle).2, "{angle}");
    }
    for angle in [std::f64::consts::PI, f64::NAN, f64::INFINITY, 1e7, 1e300] {
        assert!(!ordinary(angle).2, "{angle}");
    }
}

#[test]
fn sine_is_odd_and_cosine_even_to_the_sign_of_a_zero() {
    for angle in angles(20_000).chain(SPECIAL) {
        let ((s, c), (t, d)) = (sincos(angle), sincos(-angle));
        assert!(same(s, -t) && same(c, d), "{angle}");
    }
    assert!(same(sincos(-0.0).0, -0.0) && sincos(0.0).1 == 1.0);
    assert!(same(sincos(-2e-310).0, -2e-310));
    assert!(sincos(f64::NAN).0.is_nan() && sincos(f64::INFINITY).1.is_nan());
}

#[test]
fn every_width_has_the_same_bits() {
    let angles: Vec<f64> =
        angles(30_000).chain(SPECIAL).chain(EXACT.map(|row| f64::from_bits(row[0]))).collect();
    let expected: Vec<(f64, f64)> = angles.iter().map(|&angle| sincos(angle)).collect();
    type Columns = fn(&[f64], &mut [f64], &mut [f64]);
    let widths: &[(&str, Columns)] = &[
        ("as this machine chooses", sincos_columns),
        ("baseline", |a, s, c| columns(a, s, c)),
        #[cfg(target_arch = "x86_64")]
        ("four lanes", |a, s, c| {
            if is_x86_feature_detected!("avx2") {
                // SAFETY: the machine reports these instructions.
                unsafe { super::four_lanes(a, s, c) }
            } else {
                columns(a, s, c);
            }
        }),
    ];
    for (name, compute) in widths {
        // Many lengths, so that loops have remainders; with and without exceptional angles.
        for length in [0, 1, 2, 3, 7, 8, 9, 31, 240, angles.len()] {
            for (chunk, expected) in
                angles.chunks(length.max(1)).zip(expected.chunks(length.max(1))).take(200)
            {
                let chunk = &chunk[..chunk.len().min(length)];
                let (mut sines, mut cosines) = (vec![7.0; chunk.len() + 1], vec![7.0; chunk.len() + 1]);
                compute(chunk, &mut sines, &mut cosines);
                for (i, &angle) in chunk.iter().enumerate() {
                    let (s, c) = expected[i];
                    assert!(same(sines[i], s) && same(cosines[i], c), "{name}: {angle}");
                }
                assert_eq!((sines[chunk.len()], cosines[chunk.len()]), (7.0, 7.0));
            }
        }
    }
}
