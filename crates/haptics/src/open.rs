//! Opens a device from NAME, FILE.toml or NAME@PLACE, and states how a person reaches it.

use std::net::{SocketAddr, ToSocketAddrs};
use std::path::Path;
use std::sync::mpsc::Receiver;

use saute_files::regular_file;
use saute_schema::InputError;
use serde::Serialize;

use crate::device::{Capabilities, HapticDevice};
use crate::library;
use crate::remote::{haply, osc, phone};
use crate::strings::geometry::Geometry;
use crate::strings::spidar::Spidar;
use crate::strings::wire::{SerialLink, UdpLink};

/// Baud rate of serial links [baud] (chosen: twice what a thousand frames per second each way need).
const BAUD: u32 = 2_000_000;
/// Largest geometry file [MiB] (chosen: the largest shipped one has 4 kB).
const LARGEST_MIB: u64 = 1;

/// All kinds of networked devices. To add one, write its file and list it here.
pub static NETWORKED: &[Networked] = &[phone::PHONE, haply::HAPLY, osc::OSC];

/// A kind of networked device.
#[derive(Clone, Copy, Debug)]
pub struct Networked {
    /// Name on the command line.
    pub id: &'static str,
    /// Default place, HOST:PORT.
    pub default_place: &'static str,
    /// Returns its capabilities.
    pub capabilities: fn() -> Capabilities,
    /// Opens the device at an address.
    pub open: fn(SocketAddr) -> Result<Opened, OpenError>,
}

/// Network reach of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reach {
    /// Connected by cable.
    Cable,
    /// Reachable by programs on this machine only.
    ThisMachine,
    /// Reachable by all machines on the network.
    Network,
}

/// How a person reaches a device.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Access {
    /// Address or port.
    pub place: String,
    /// Network reach.
    pub reach: Reach,
    /// Page to open on the device.
    pub url: Option<String>,
    /// Pairing code to enter or send.
    pub code: Option<String>,
    /// First bytes of the SHA-256 fingerprint of the page's certificate.
    pub fingerprint: Option<String>,
}

/// An open device.
pub struct Opened {
    /// The driver.
    pub device: Box<dyn HapticDevice>,
    /// How a person reaches it.
    pub access: Access,
    /// What its user should know, such as why messages are rejected: a line for each reason, of devices that report them.
    pub notices: Option<Receiver<String>>,
}

/// Why a device could not be opened.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OpenError {
    /// An invalid geometry file.
    #[error(transparent)]
    Geometry(#[from] InputError),
    /// An unusable name or place.
    #[error("{place}: {message}\n  remedy: {remedy}")]
    Place {
        /// The name or place.
        place: String,
        /// The problem.
        message: String,
        /// The remedy.
        remedy: String,
    },
}

/// The two kinds of devices.
#[derive(Clone, Debug)]
enum Build {
    /// A string device.
    Strings(Box<Geometry>),
    /// A networked device.
    Networked(Networked),
}

/// A device by name or file, with its place.
#[derive(Clone, Debug)]
pub struct Named {
    /// Device name or geometry file.
    pub name: String,
    build: Build,
    place: Option<String>,
}

impl OpenError {
    /// Creates the error of an unusable name or place.
    pub fn place(place: impl std::fmt::Display, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Place { place: place.to_string(), message: message.into(), remedy: remedy.into() }
    }
}

impl Access {
    /// Creates the access of a device at an address, without page or code.
    pub fn at(address: SocketAddr) -> Self {
        Self { place: address.to_string(), reach: Reach::of(address), url: None, code: None, fingerprint: None }
    }

    /// Returns the access in words, one fact per line.
    pub fn lines(&self) -> Vec<String> {
        let reach = match self.reach {
            Reach::Cable => "by cable",
            Reach::ThisMachine => "this machine alone",
            Reach::Network => "open to the network",
        };
        let mut lines = vec![format!("at {}, {reach}", self.place)];
        lines.extend(self.url.iter().map(|url| format!("open {url} on the device")));
        lines.extend(self.code.iter().map(|code| format!("pairing code {code}")));
        lines.extend(self.fingerprint.iter().map(|print| format!("certificate SHA-256 {print}…")));
        lines
    }
}

impl Reach {
    /// Returns the reach of an address.
    pub fn of(address: SocketAddr) -> Self {
        if address.ip().is_loopback() { Self::ThisMachine } else { Self::Network }
    }
}

/// Returns the names of all devices, string devices first.
pub fn names() -> Result<Vec<String>, OpenError> {
    let strings = library::devices()?.into_keys();
    Ok(strings.chain(NETWORKED.iter().map(|n| n.id.to_owned())).collect())
}

/// Opens a device from NAME, FILE.toml, NAME@HOST:PORT or NAME@SERIAL-PORT.
///
/// `pairing` is the code that a real string device shows, or 0 if it needs none.
pub fn open(text: &str, pairing: u32) -> Result<Opened, OpenError> {
    Named::parse(text)?.open(pairing)
}

impl Named {
    /// Parses NAME, FILE.toml, NAME@HOST:PORT or NAME@SERIAL-PORT.
    pub fn parse(text: &str) -> Result<Self, OpenError> {
        let (name, place) = text.split_once('@').map_or((text, None), |(n, p)| (n, Some(p.to_owned())));
        Ok(Self { name: name.to_owned(), build: Build::of(name)?, place })
    }

    /// Returns the geometry of a string device.
    pub fn geometry(&self) -> Option<&Geometry> {
        match &self.build {
            Build::Strings(geometry) => Some(geometry),
            Build::Networked(_) => None,
        }
    }

    /// Returns the device's capabilities.
    pub fn capabilities(&self) -> Capabilities {
        match &self.build {
            Build::Strings(geometry) => geometry.capabilities(),
            Build::Networked(networked) => (networked.capabilities)(),
        }
    }

    /// Returns true if the device can only be simulated: a string device without a place.
    pub fn is_simulated(&self) -> bool {
        self.place.is_none() && self.geometry().is_some()
    }

    /// Opens the device at its place; `pairing` is the code that a real string device shows.
    pub fn open(&self, pairing: u32) -> Result<Opened, OpenError> {
        match (&self.build, &self.place) {
            (Build::Networked(networked), place) => {
                let place = place.as_deref().unwrap_or(networked.default_place);
                (networked.open)(address_of(place, networked.default_place)?)
            }
            (Build::Strings(geometry), Some(place)) => strings_at(geometry, place, pairing),
            (Build::Strings(_), None) => {
                let remedy = format!("give its place: {}@HOST:PORT or {0}@SERIAL-PORT", self.name);
                Err(OpenError::place(&self.name, "is a string device, and no place is given", remedy))
            }
        }
    }

    /// Opens the device at an address, such as that of a simulator.
    pub fn open_at(&self, address: SocketAddr, pairing: u32) -> Result<Opened, OpenError> {
        match &self.build {
            Build::Strings(geometry) => strings_over_udp(geometry, address, pairing),
            Build::Networked(networked) => (networked.open)(address),
        }
    }
}

impl Build {
    fn of(name: &str) -> Result<Self, OpenError> {
        // Names come before files: a file that happens to be called `phone` is not a geometry.
        if let Some(networked) = NETWORKED.iter().find(|n| n.id == name) {
            return Ok(Self::Networked(*networked));
        }
        // A pipe or a device is no name of ours, and is refused as what it is.
        if Path::new(name).exists() && !Path::new(name).is_dir() {
            return Ok(Self::Strings(Box::new(Geometry::parse(&read(name)?, name)?)));
        }
        match library::devices()?.remove(name) {
            Some(geometry) => Ok(Self::Strings(Box::new(geometry))),
            None => {
                let known = names()?.join(", ");
                let remedy =
                    format!("use one of: {known}; or a geometry file; with @HOST:PORT or @SERIAL-PORT for a real one");
                Err(OpenError::place(format!("--device {name}"), "there is no such device", remedy))
            }
        }
    }
}

fn read(file: &str) -> Result<String, OpenError> {
    regular_file::read_text(Path::new(file), LARGEST_MIB)
        .map_err(|unread| OpenError::place(file, unread.to_string(), "give the path of a geometry file"))
}

/// Resolves HOST:PORT, or HOST with the default port.
fn address_of(place: &str, default_place: &str) -> Result<SocketAddr, OpenError> {
    let port = default_place.rsplit_once(':').map_or("", |(_, port)| port);
    let find = |text: &str| text.to_socket_addrs().ok().and_then(|mut found| found.next());
    find(place).or_else(|| find(&format!("{place}:{port}"))).ok_or_else(|| {
        OpenError::place(
            place,
            "is no address",
            format!("give HOST:PORT, such as {default_place} for this machine alone"),
        )
    })
}

fn strings_over_udp(geometry: &Geometry, address: SocketAddr, pairing: u32) -> Result<Opened, OpenError> {
    let link = UdpLink::connect(address).map_err(|e| {
        OpenError::place(address, format!("cannot be reached: {e}"), "check the address and the network")
    })?;
    let device = Box::new(Spidar::new(link, geometry.clone(), pairing));
    Ok(Opened { device, access: Access::at(address), notices: None })
}

fn strings_at(geometry: &Geometry, place: &str, pairing: u32) -> Result<Opened, OpenError> {
    if let Some(address) = place.to_socket_addrs().ok().and_then(|mut found| found.next()) {
        return strings_over_udp(geometry, address, pairing);
    }
    let link = SerialLink::open(place, BAUD).map_err(|e| {
        let remedy = "give HOST:PORT, or a serial port that you may open, such as /dev/ttyACM0";
        OpenError::place(place, format!("is no address and no serial port that can be opened: {e}"), remedy)
    })?;
    let access = Access { place: place.to_owned(), reach: Reach::Cable, url: None, code: None, fingerprint: None };
    Ok(Opened { device: Box::new(Spidar::new(link, geometry.clone(), pairing)), access, notices: None })
}
