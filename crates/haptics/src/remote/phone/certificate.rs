//! A self-signed certificate, new at every start; the key is never stored on disk.

use std::net::IpAddr;
use std::sync::Arc;
use std::time::SystemTime;

use rcgen::{CertificateParams, DnType, ExtendedKeyUsagePurpose, KeyPair, date_time_ymd};
use rustls::ServerConfig;
use rustls::pki_types::{PrivateKeyDer, PrivatePkcs8KeyDer};

/// Number of fingerprint bytes that people compare (chosen: eight pairs fit on a line).
const SHOWN: usize = 8;
/// Mean Gregorian year [s].
const YEAR_S: u64 = 31_556_952;

/// Returns the TLS configuration and the first bytes of the certificate's SHA-256 fingerprint.
pub fn make(hosts: &[IpAddr]) -> Result<(Arc<ServerConfig>, String), Box<dyn std::error::Error>> {
    let mut names = vec!["localhost".to_owned()];
    names.extend(hosts.iter().map(IpAddr::to_string));
    let mut params = CertificateParams::new(names)?;
    params.distinguished_name.push(DnType::CommonName, "saute");
    params.extended_key_usages = vec![ExtendedKeyUsagePurpose::ServerAuth];
    // Phones refuse certificates that are valid for more than 825 days.
    let year = this_year();
    (params.not_before, params.not_after) = (date_time_ymd(year, 1, 1), date_time_ymd(year + 2, 1, 1));
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

fn this_year() -> i32 {
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    1970 + (since.as_secs() / YEAR_S) as i32
}
