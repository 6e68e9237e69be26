//! Beams cut at their supports.

/// The shares of a load at z that supports at these growing places [m] bear, of beams cut at the supports between.
pub fn shares(supports: &[f64], z: f64) -> Vec<f64> {
    let mut shares = vec![0.0; supports.len()];
    if let [_] = supports {
        shares[0] = 1.0;
    }
    if supports.len() >= 2 {
        let behind = supports.partition_point(|support| *support <= z);
        let behind = behind.clamp(1, supports.len() - 1);
        let [from, to] = [supports[behind - 1], supports[behind]];
        let part = (z - from) / (to - from);
        (shares[behind - 1], shares[behind]) = (1.0 - part, part);
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_borne_by_the_mains_beside_them() {
        let between = shares(&[0.0, 0.1, 0.3], 0.15);
        assert!(between[0] == 0.0 && (between[1] - 0.75).abs() < 1e-15 && (between[2] - 0.25).abs() < 1e-15);
        assert_eq!(shares(&[0.0, 0.1, 0.3], 0.1), [0.0, 1.0, 0.0]);
        let beyond = shares(&[0.0, 0.1], 0.12);
        assert!((beyond[0] + 0.2).abs() < 1e-15 && (beyond[1] - 1.2).abs() < 1e-15);
        assert_eq!(shares(&[0.2], 0.12), [1.0]);
    }
}
