//! Which device is meant, and how it is reached.

use std::net::{SocketAddr, ToSocketAddrs};
use std::path::Path;

use saute_haptics::device::HapticDevice;
use saute_haptics::wire::{SerialLink, UdpLink};
use saute_haptics::{Geometry, Spidar, shelf};

use crate::error::CliError;
use crate::text_file;

/// Speed of serial lines [baud] (chosen: a thousand frames each way need one million).
const BAUD: u32 = 2_000_000;

/// A device by name or file, and where it is; nowhere for a simulated one.
#[derive(Debug)]
pub struct Named {
    /// Name or file.
    pub name: String,
    /// How it is built.
    pub geometry: Geometry,
    place: Option<String>,
}

impl Named {
    /// From NAME, FILE.toml, NAME@HOST:PORT or NAME@SERIAL-PORT.
    pub fn parse(text: &str) -> Result<Self, CliError> {
        let (name, place) = text.split_once('@').map_or((text, None), |(n, p)| (n, Some(p.to_owned())));
        let geometry = if Path::new(name).is_file() {
            Geometry::parse(&text_file::read(Path::new(name))?, name)?
        } else {
            let mut known = shelf::devices()?;
            let names = known.keys().cloned().collect::<Vec<_>>().join(", ");
            let unknown = || {
                let remedy =
                    format!("use one of: {names}; or a geometry file; with @HOST:PORT or @SERIAL-PORT for a real one");
                CliError::place(format!("--device {name}"), "there is no such device", remedy)
            };
            known.remove(name).ok_or_else(unknown)?
        };
        Ok(Self { name: name.to_owned(), geometry, place })
    }

    /// Whether it must be simulated.
    pub fn is_simulated(&self) -> bool {
        self.place.is_none()
    }

    /// A driver for the device at an address.
    pub fn over_udp(&self, address: SocketAddr, pairing: u32) -> Result<Box<dyn HapticDevice>, CliError> {
        let link = UdpLink::connect(address).map_err(|e| {
            CliError::place(address, format!("cannot be reached: {e}"), "check the address and the network")
        })?;
        Ok(Box::new(Spidar::new(link, self.geometry.clone(), pairing)))
    }

    /// A driver for the device at its place.
    pub fn driver(&self, pairing: u32) -> Result<Box<dyn HapticDevice>, CliError> {
        let place = self.place.as_deref().unwrap_or_default();
        if let Some(address) = place.to_socket_addrs().ok().and_then(|mut found| found.next()) {
            return self.over_udp(address, pairing);
        }
        let link = SerialLink::open(place, BAUD).map_err(|e| {
            let remedy = "give HOST:PORT, or a serial port that you may open, such as /dev/ttyACM0";
            CliError::place(place, format!("is no address, and no serial port that can be opened: {e}"), remedy)
        })?;
        Ok(Box::new(Spidar::new(link, self.geometry.clone(), pairing)))
    }
}
