//! One way to open a device: from NAME, FILE.toml or NAME@PLACE to a driver, and what a person must know to reach it.

use std::io::Read;
use std::net::{SocketAddr, ToSocketAddrs};
use std::path::Path;

use saute_kitchen::InputError;
use serde::Serialize;

use crate::device::{Capabilities, HapticDevice};
use crate::strings::geometry::Geometry;
use crate::library;
use crate::strings::spidar::Spidar;
use crate::strings::wire::{SerialLink, UdpLink};
use crate::remote::{haply, osc, phone};

/// Speed of serial lines [baud] (chosen: a thousand frames each way need one million).
const BAUD: u32 = 2_000_000;
/// Larger files are no geometry [bytes] (chosen: the largest shipped one has 4 kB).
const LARGEST: u64 = 1 << 20;

/// Kinds of devices that are reached over a network. To add one, write its file and name it here.
pub static NETWORKED: &[Networked] = &[phone::PHONE, haply::HAPLY, osc::OSC];

/// A kind of device that is reached over a network.
#[derive(Clone, Copy, Debug)]
pub struct Networked {
    /// Its name.
    pub id: &'static str,
    /// Where it is unless a place is given: HOST:PORT.
    pub default_place: &'static str,
    /// What it can do.
    pub capabilities: fn() -> Capabilities,
    /// Opens it at an address.
    pub open: fn(SocketAddr) -> Result<Opened, OpenError>,
}

/// Who can reach a device, or be reached by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reach {
    /// A cable.
    Cable,
    /// Programs of this machine.
    ThisMachine,
    /// All machines of the network.
    Network,
}

/// What a person must know to reach a device.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Access {
    /// Address or port.
    pub place: String,
    /// Who can reach it.
    pub reach: Reach,
    /// Page to open on the device.
    pub url: Option<String>,
    /// Pairing code to type or send.
    pub code: Option<String>,
    /// Beginning of the SHA-256 fingerprint of the certificate that the page shows.
    pub fingerprint: Option<String>,
}

/// A device that has been opened.
pub struct Opened {
    /// Its driver.
    pub device: Box<dyn HapticDevice>,
    /// What a person must know to reach it.
    pub access: Access,
}

/// Why a device cannot be opened.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OpenError {
    /// A geometry file that cannot be used.
    #[error(transparent)]
    Geometry(#[from] InputError),
    /// A name or a place that cannot be used.
    #[error("{place}: {message}\n  remedy: {remedy}")]
    Place {
        /// Which one.
        place: String,
        /// What is wrong.
        message: String,
        /// What to do instead.
        remedy: String,
    },
}

/// How a device is built.
#[derive(Clone, Debug)]
enum Build {
    /// Of strings.
    Strings(Box<Geometry>),
    /// As something on a network.
    Networked(Networked),
}

/// A device by name or file, and where it is.
#[derive(Clone, Debug)]
pub struct Named {
    /// Name or file.
    pub name: String,
    build: Build,
    place: Option<String>,
}

impl OpenError {
    /// A name or a place that cannot be used.
    pub fn place(place: impl std::fmt::Display, message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Place { place: place.to_string(), message: message.into(), remedy: remedy.into() }
    }
}

impl Access {
    /// What can be reached at an address, without page or code.
    pub fn at(address: SocketAddr) -> Self {
        Self { place: address.to_string(), reach: Reach::of(address), url: None, code: None, fingerprint: None }
    }

    /// In words, a line each.
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
    /// Who is reached by an address.
    pub fn of(address: SocketAddr) -> Self {
        if address.ip().is_loopback() { Self::ThisMachine } else { Self::Network }
    }
}

/// Names of all devices: those of strings first.
pub fn names() -> Result<Vec<String>, OpenError> {
    let strings = library::devices()?.into_keys();
    Ok(strings.chain(NETWORKED.iter().map(|n| n.id.to_owned())).collect())
}

/// Opens a device: NAME, FILE.toml, NAME@HOST:PORT or NAME@SERIAL-PORT; the pairing code is the one that a real device shows, 0
/// where it needs none.
pub fn open(text: &str, pairing: u32) -> Result<Opened, OpenError> {
    Named::parse(text)?.open(pairing)
}

impl Named {
    /// From NAME, FILE.toml, NAME@HOST:PORT or NAME@SERIAL-PORT.
    pub fn parse(text: &str) -> Result<Self, OpenError> {
        let (name, place) = text.split_once('@').map_or((text, None), |(n, p)| (n, Some(p.to_owned())));
        Ok(Self { name: name.to_owned(), build: Build::of(name)?, place })
    }

    /// How it is built of strings, if it is.
    pub fn geometry(&self) -> Option<&Geometry> {
        match &self.build {
            Build::Strings(geometry) => Some(geometry),
            Build::Networked(_) => None,
        }
    }

    /// What it can do.
    pub fn capabilities(&self) -> Capabilities {
        match &self.build {
            Build::Strings(geometry) => geometry.capabilities(),
            Build::Networked(networked) => (networked.capabilities)(),
        }
    }

    /// Whether it can only be simulated: strings at no place.
    pub fn is_simulated(&self) -> bool {
        self.place.is_none() && self.geometry().is_some()
    }

    /// Opens the device at its place; the pairing code is the one that a real device shows.
    pub fn open(&self, pairing: u32) -> Result<Opened, OpenError> {
        match (&self.build, &self.place) {
            (Build::Networked(networked), place) => {
                let place = place.as_deref().unwrap_or(networked.default_place);
                (networked.open)(address_of(place, networked.default_place)?)
            }
            (Build::Strings(geometry), Some(place)) => strings_at(geometry, place, pairing),
            (Build::Strings(_), None) => {
                let remedy = format!("say where it is: {}@HOST:PORT or {0}@SERIAL-PORT", self.name);
                Err(OpenError::place(&self.name, "is a device of strings, and no place is given", remedy))
            }
        }
    }

    /// Opens a device of strings at an address, such as that of a simulator.
    pub fn open_at(&self, address: SocketAddr, pairing: u32) -> Result<Opened, OpenError> {
        match &self.build {
            Build::Strings(geometry) => strings_over_udp(geometry, address, pairing),
            Build::Networked(networked) => (networked.open)(address),
        }
    }
}

impl Build {
    fn of(name: &str) -> Result<Self, OpenError> {
        // Before files: one that happens to be called `phone` here is no device of strings.
        if let Some(networked) = NETWORKED.iter().find(|n| n.id == name) {
            return Ok(Self::Networked(*networked));
        }
        if Path::new(name).is_file() {
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
    let mut text = String::new();
    let took = std::fs::File::open(file).and_then(|f| f.take(LARGEST).read_to_string(&mut text));
    took.map_err(|e| OpenError::place(file, format!("cannot be read: {e}"), "name a geometry file of your own"))?;
    Ok(text)
}

/// HOST:PORT, or a HOST with the usual port.
fn address_of(place: &str, usual: &str) -> Result<SocketAddr, OpenError> {
    let port = usual.rsplit_once(':').map_or("", |(_, port)| port);
    let find = |text: &str| text.to_socket_addrs().ok().and_then(|mut found| found.next());
    find(place).or_else(|| find(&format!("{place}:{port}"))).ok_or_else(|| {
        OpenError::place(place, "is no address", format!("give HOST:PORT, such as {usual} for this machine alone"))
    })
}

fn strings_over_udp(geometry: &Geometry, address: SocketAddr, pairing: u32) -> Result<Opened, OpenError> {
    let link = UdpLink::connect(address).map_err(|e| {
        OpenError::place(address, format!("cannot be reached: {e}"), "check the address and the network")
    })?;
    let device = Box::new(Spidar::new(link, geometry.clone(), pairing));
    Ok(Opened { device, access: Access::at(address) })
}

fn strings_at(geometry: &Geometry, place: &str, pairing: u32) -> Result<Opened, OpenError> {
    if let Some(address) = place.to_socket_addrs().ok().and_then(|mut found| found.next()) {
        return strings_over_udp(geometry, address, pairing);
    }
    let link = SerialLink::open(place, BAUD).map_err(|e| {
        let remedy = "give HOST:PORT, or a serial port that you may open, such as /dev/ttyACM0";
        OpenError::place(place, format!("is no address, and no serial port that can be opened: {e}"), remedy)
    })?;
    let access = Access { place: place.to_owned(), reach: Reach::Cable, url: None, code: None, fingerprint: None };
    Ok(Opened { device: Box::new(Spidar::new(link, geometry.clone(), pairing)), access })
}
