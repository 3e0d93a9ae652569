//! The address by which other machines reach this one.

use std::net::{IpAddr, UdpSocket};

/// Returns the address by which other machines reach this one if a socket is bound to all addresses.
pub fn reachable(bound: IpAddr) -> IpAddr {
    if !bound.is_unspecified() {
        return bound;
    }
    // Connecting a UDP socket sends nothing; it only selects the source address (192.0.2.1 is reserved for documentation).
    let local = UdpSocket::bind(("0.0.0.0", 0)).and_then(|s| s.connect(("192.0.2.1", 9)).and_then(|()| s.local_addr()));
    local.map_or(IpAddr::from([127, 0, 0, 1]), |a| a.ip())
}
