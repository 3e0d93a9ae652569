//! A self-signed certificate, new at every start; the key is never stored on disk.

use std::net::IpAddr;
use std::sync::Arc;
use std::time::{Duration, SystemTime};

use rcgen::{CertificateParams, DnType, ExtendedKeyUsagePurpose, KeyPair, date_time_ymd};
use rustls::ServerConfig;
use rustls::pki_types::{PrivateKeyDer, PrivatePkcs8KeyDer};

/// Number of fingerprint bytes that people compare (chosen: eight pairs fit on a line).
const SHOWN: usize = 8;
/// Time before now from which the certificate is valid (chosen: a day, for phones whose clock is slow).
const VALID_BEFORE: Duration = Duration::from_secs(24 * 3600);
/// Time from now until which it is valid (chosen: more than a year of 366 days; phones refuse more than 825 days).
const VALID_AFTER: Duration = Duration::from_secs(370 * 24 * 3600);

/// Limits the validity of a certificate to a year around a date.
fn limit_validity(params: &mut CertificateParams, now: SystemTime) {
    let since = now.duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    // Certificates state whole seconds.
    let today = date_time_ymd(1970, 1, 1) + Duration::from_secs(since.as_secs());
    (params.not_before, params.not_after) = (today - VALID_BEFORE, today + VALID_AFTER);
}

/// Returns the TLS configuration and the first bytes of the certificate's SHA-256 fingerprint.
pub fn make(hosts: &[IpAddr]) -> Result<(Arc<ServerConfig>, String), Box<dyn std::error::Error>> {
    let mut names = vec!["localhost".to_owned()];
    names.extend(hosts.iter().map(IpAddr::to_string));
    let mut params = CertificateParams::new(names)?;
    params.distinguished_name.push(DnType::CommonName, "saute");
    params.extended_key_usages = vec![ExtendedKeyUsagePurpose::ServerAuth];
    limit_validity(&mut params, SystemTime::now());
    let key = KeyPair::generate()?;
    let certificate = params.self_signed(&key)?.der().clone();
    let digest = ring::digest::digest(&ring::digest::SHA256, &certificate);
    let pairs: Vec<String> = digest.as_ref()[..SHOWN].iter().map(|b| format!("{b:02X}")).collect();
    let private = PrivateKeyDer::Pkcs8(PrivatePkcs8KeyDer::from(key.serialize_der()));
    let config = ServerConfig::builder_with_provider(Arc::new(rustls::crypto::ring::default_provider()))
        .with_safe_default_protocol_versions()?
        .with_no_client_auth()
        .with_single_cert(vec![certificate], private)?;
    Ok((Arc::new(config), pairs.join(":")))
}

#[cfg(test)]
mod tests {
    use super::*;

    const DAY_S: i64 = 24 * 3600;

    /// Seconds from 1970 until noon of a date.
    fn noon(year: i32, month: u8, day: u8) -> i64 {
        date_time_ymd(year, month, day).unix_timestamp() + DAY_S / 2
    }

    #[test]
    fn a_certificate_is_valid_now_and_for_a_year_on_any_date() {
        let ends = [(2023, 12, 31), (2024, 12, 31), (2025, 1, 1), (2027, 12, 31), (2028, 2, 29), (2032, 12, 31)];
        let every_day = (0..4 * 366).map(|day| noon(2026, 1, 1) + day * DAY_S);
        for now in ends.map(|(y, m, d)| noon(y, m, d)).into_iter().chain(every_day) {
            let mut params = CertificateParams::default();
            limit_validity(&mut params, SystemTime::UNIX_EPOCH + Duration::from_secs(now as u64));
            let (from, until) = (params.not_before.unix_timestamp(), params.not_after.unix_timestamp());
            assert!(from < now && until >= now + 366 * DAY_S, "{now}: {from} to {until}");
            assert!(until - from < 825 * DAY_S, "phones refuse it");
        }
    }
}
