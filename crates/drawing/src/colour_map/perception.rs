//! How colour maps are seen: lightness and distances in CAM02-UCS (Luo, Cui, Li 2006), and the three deficiencies by
//! the matrices of Machado, Oliveira, Fernandes (2009) at severity 1.

use super::ColourMap;

/// Matrices of linear sRGB for protanopia, deuteranopia and tritanopia.
const DEFICIENCIES: [[[f64; 3]; 3]; 3] = [
    [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
];
const TO_XYZ: [[f64; 3]; 3] = [[41.24, 35.76, 18.05], [21.26, 71.52, 7.22], [1.93, 11.92, 95.05]];
const CAT02: [[f64; 3]; 3] = [[0.7328, 0.4296, -0.1624], [-0.7036, 1.6975, 0.0061], [0.0030, 0.0136, 0.9834]];
/// Hunt-Pointer-Estevez times the inverse of CAT02.
const HUNT: [[f64; 3]; 3] =
    [[0.7409792, 0.2180250, 0.0410058], [0.2853532, 0.6242014, 0.0904454], [-0.0096280, -0.0056980, 1.0153260]];

fn times(matrix: &[[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|row| (0..3).map(|k| matrix[row][k] * vector[k]).sum())
}

fn linear(colour: [u8; 3]) -> [f64; 3] {
    colour.map(|part| {
        let part = f64::from(part) / 255.0;
        if part > 0.04045 { ((part + 0.055) / 1.055).powf(2.4) } else { part / 12.92 }
    })
}

/// J', a', b' of linear sRGB on a screen of 64 lx and a background of 20 %, average surround.
fn cam02_ucs(colour: [f64; 3]) -> [f64; 3] {
    let (adapting, background): (f64, f64) = (64.0 / std::f64::consts::PI / 5.0, 20.0);
    let white = times(&TO_XYZ, [1.0; 3]);
    let k = 1.0 / (5.0 * adapting + 1.0);
    let level = 0.2 * k.powi(4) * 5.0 * adapting + 0.1 * (1.0 - k.powi(4)).powi(2) * (5.0 * adapting).cbrt();
    let n: f64 = background / white[1];
    let (induction, base) = (0.725 * n.powf(-0.2), 1.48 + n.sqrt());
    let degree = 1.0 - (1.0 / 3.6) * ((-adapting - 42.0) / 92.0).exp();
    let sharp_white = times(&CAT02, white);
    let adapted = |xyz: [f64; 3]| {
        let sharp = times(&CAT02, xyz);
        let adapted = [0, 1, 2].map(|i| sharp[i] * (white[1] * degree / sharp_white[i] + 1.0 - degree));
        times(&HUNT, adapted).map(|part| {
            let power = (level * part.abs() / 100.0).powf(0.42);
            part.signum() * 400.0 * power / (27.13 + power) + 0.1
        })
    };
    let achromatic = |[r, g, b]: [f64; 3]| (2.0 * r + g + b / 20.0 - 0.305) * induction;
    let seen = adapted(times(&TO_XYZ, colour));
    let [r, g, b] = seen;
    let (red_green, yellow_blue) = (r - 12.0 * g / 11.0 + b / 11.0, (r + g - 2.0 * b) / 9.0);
    let hue = yellow_blue.atan2(red_green);
    let ratio: f64 = achromatic(seen) / achromatic(adapted(white));
    let lightness = 100.0 * ratio.max(0.0).powf(0.69 * base);
    let eccentricity = 0.25 * ((hue + 2.0).cos() + 3.8);
    let t = 50000.0 / 13.0 * induction * eccentricity * red_green.hypot(yellow_blue) / (r + g + 21.0 / 20.0 * b);
    let chroma = t.powf(0.9) * (lightness / 100.0).sqrt() * (1.64 - 0.29_f64.powf(n)).powf(0.73);
    let colourfulness = (1.0 + 0.0228 * chroma * level.powf(0.25)).ln() / 0.0228;
    [1.7 * lightness / (1.0 + 0.007 * lightness), colourfulness * hue.cos(), colourfulness * hue.sin()]
}

/// The colours of a map as they are seen: by normal vision (0) and with the deficiencies (1 to 3).
fn seen(map: ColourMap, vision: usize) -> Vec<[f64; 3]> {
    let colours = map.table().iter().map(|colour| linear(*colour));
    let altered = colours.map(|colour| match vision {
        0 => colour,
        _ => times(&DEFICIENCIES[vision - 1], colour).map(|part| part.clamp(0.0, 1.0)),
    });
    altered.map(cam02_ucs).collect()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Standard deviation of the steps over their mean.
fn variation(colours: &[[f64; 3]]) -> f64 {
    let steps: Vec<f64> = colours.windows(2).map(|pair| distance(pair[0], pair[1])).collect();
    let mean = steps.iter().sum::<f64>() / steps.len() as f64;
    let square = steps.iter().map(|step| (step - mean).powi(2)).sum::<f64>() / steps.len() as f64;
    square.sqrt() / mean
}

/// Halves of a diverging map, the whole of others.
fn branches(map: ColourMap, colours: Vec<[f64; 3]>) -> Vec<Vec<[f64; 3]>> {
    match map.is_diverging() {
        true => vec![colours[..17].to_vec(), colours[16..].to_vec()],
        false => vec![colours],
    }
}

/// How far the lightness runs back on its way.
fn backwards(colours: &[[f64; 3]]) -> f64 {
    let rises = colours[0][0] < colours[colours.len() - 1][0];
    let steps = colours.windows(2).map(|pair| pair[1][0] - pair[0][0]);
    steps.map(|step| if rises { -step } else { step }).fold(0.0, f64::max)
}

/// Values of colorspacious 1.1.2 for sRGB1 (0.5, 0.2, 0.8) and white.
#[test]
fn cam02_ucs_agrees_with_another_program() {
    let [j, a, b] = cam02_ucs([0.5f64, 0.2, 0.8].map(|part| ((part + 0.055) / 1.055).powf(2.4)));
    assert!(distance([j, a, b], [43.0153, 15.1754, -29.4794]) < 0.05, "{j} {a} {b}");
    assert!((cam02_ucs([1.0; 3])[0] - 100.0).abs() < 0.05);
}

#[test]
fn lightness_is_monotone_for_all_eyes() {
    for map in ColourMap::ALL {
        for vision in 0..4 {
            for branch in branches(map, seen(map, vision)) {
                assert!(backwards(&branch) <= 0.3, "{map:?}, vision {vision}: {}", backwards(&branch));
            }
        }
    }
}

#[test]
fn steps_are_even() {
    for map in ColourMap::ALL {
        let most = if map.is_diverging() { 0.20 } else { 0.15 };
        for branch in branches(map, seen(map, 0)) {
            assert!(variation(&branch) <= most, "{map:?}: {}", variation(&branch));
        }
    }
    // What is not even is noticed.
    assert!(variation(&[[0.0; 3], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]]) > 0.3);
    assert!(backwards(&[[0.0; 3], [2.0, 0.0, 0.0], [1.0, 0.0, 0.0], [3.0, 0.0, 0.0]]) == 1.0);
}

#[test]
fn the_diverging_map_is_white_at_zero_and_its_ends_differ() {
    assert_eq!(ColourMap::Vik.colour(0.5).0, [255; 3]);
    assert_eq!(ColourMap::Batlow.colour(f64::NAN), ColourMap::Batlow.colour(0.0));
    assert!(ColourMap::Batlow.colour(0.0).luminance() > 0.98);
    for vision in 0..4 {
        let colours = seen(ColourMap::Vik, vision);
        let most = (0..16).map(|k| distance(colours[k], colours[32 - k])).fold(0.0, f64::max);
        assert!(most > 37.0, "vision {vision}: {most}");
    }
}
