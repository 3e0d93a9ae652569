//! A folder of static files at an address of this machine only.

use std::net::Ipv4Addr;
use std::path::Path;

use axum::Router;
use axum::http::{HeaderValue, header};
use tokio::net::TcpListener;
use tower_http::services::ServeDir;
use tower_http::set_header::SetResponseHeaderLayer;

use crate::error::{SiteError, at};

/// Serves until the program is stopped; prints the address to open.
pub fn serve(folder: &Path, port: u16, plain: bool) -> Result<(), SiteError> {
    std::fs::read_dir(folder).map_err(at(folder))?;
    let failed = |source| SiteError::Port { port, source };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_io().enable_time().build().map_err(failed)?;
    runtime.block_on(async {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).await.map_err(failed)?;
        println!("open http://{}/ (end with Ctrl+C)", listener.local_addr().map_err(failed)?);
        axum::serve(listener, routes(folder, plain)).await.map_err(failed)
    })
}

/// The browser checks each time whether a file has changed, so that a new build is seen at once.
fn routes(folder: &Path, plain: bool) -> Router {
    let files = ServeDir::new(folder);
    let files = if plain { files } else { files.precompressed_br().precompressed_gzip() };
    let fresh = SetResponseHeaderLayer::overriding(header::CACHE_CONTROL, HeaderValue::from_static("no-cache"));
    Router::new().fallback_service(files).layer(fresh)
}
