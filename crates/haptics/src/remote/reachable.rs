//! By which address others reach this machine.

use std::net::{IpAddr, UdpSocket};

/// The address by which others reach this machine, where all of its addresses are listened at.
pub fn reachable(bound: IpAddr) -> IpAddr {
    if !bound.is_unspecified() {
        return bound;
    }
    // Nothing is sent: the system only says which of its addresses it would send from (192.0.2.1 is for documentation).
    let asked = UdpSocket::bind(("0.0.0.0", 0)).and_then(|s| s.connect(("192.0.2.1", 9)).and_then(|()| s.local_addr()));
    asked.map_or(IpAddr::from([127, 0, 0, 1]), |a| a.ip())
}
