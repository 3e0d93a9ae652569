//! The graphics interface of the browser: WebGPU where there is one, else WebGL2.

use std::sync::Arc;

use egui_wgpu::{WgpuConfiguration, WgpuSetup, WgpuSetupCreateNew};

/// Which interface is requested.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Choice {
    /// The best that starts.
    Auto,
    /// This one or none.
    Only(Backend),
}

/// A graphics interface of browsers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Backend {
    /// WebGPU.
    WebGpu,
    /// WebGL2.
    WebGl2,
}

impl Choice {
    /// Reads a choice; an empty text means the best.
    pub fn read(text: &str) -> Result<Self, String> {
        match text {
            "" | "auto" => Ok(Self::Auto),
            "webgpu" => Ok(Self::Only(Backend::WebGpu)),
            "webgl2" => Ok(Self::Only(Backend::WebGl2)),
            other => Err(format!("backend: \"{other}\" is none of \"auto\", \"webgpu\" and \"webgl2\"")),
        }
    }

    /// The interface to start with. WebGPU counts as there if it gives an adapter.
    pub async fn resolve(self) -> Backend {
        match self {
            Self::Only(backend) => backend,
            Self::Auto if wgpu::util::is_browser_webgpu_supported().await => Backend::WebGpu,
            Self::Auto => Backend::WebGl2,
        }
    }
}

impl Backend {
    /// Its name, as scripts write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::WebGpu => "webgpu",
            Self::WebGl2 => "webgl2",
        }
    }

    /// How egui sets it up: with the limits that the renderer needs, which all WebGL2 browsers have.
    pub fn setup(self) -> WgpuConfiguration {
        let mut new = WgpuSetupCreateNew::without_display_handle();
        new.instance_descriptor.backends = match self {
            Self::WebGpu => wgpu::Backends::BROWSER_WEBGPU,
            Self::WebGl2 => wgpu::Backends::GL,
        };
        new.device_descriptor = Arc::new(|adapter| wgpu::DeviceDescriptor {
            label: Some("saute"),
            required_limits: wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
            ..Default::default()
        });
        WgpuConfiguration { wgpu_setup: WgpuSetup::CreateNew(new), ..WgpuConfiguration::default() }
    }
}
