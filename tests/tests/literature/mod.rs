//! Closed forms and published numbers, one source a file.

mod barus_1893;
mod butenschoen_1976;
mod connecting_rod_bolts;
mod flexpde_2016;
mod fowell_2007;
mod ocvirk_1952;
mod pfeil_groove;
mod raimondi_boyd_1958;
mod rayleigh_1918;
mod short_bearing_finite_length;
mod short_crankshaft_bearing;
mod sommerfeld_1904;
mod swift_stieber_1932;
mod thermal_balance;
mod zharov_1996;
