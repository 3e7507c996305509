//! `sonarium serve`.

use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;

use clap::Args;
use tokio::net::TcpListener;

use super::{Failure, cores, default_data, output};
use crate::api::{self, App};
use crate::catalog::Catalog;
use crate::render::{Backend, Renderer};
use crate::session::Lab;
use crate::store::Store;
use crate::stream::Frames;

#[derive(Args, Debug)]
pub(super) struct Arguments {
    /// Address and port to listen on; port 0 takes any free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:7380")]
    listen: String,
    /// Folder that holds sessions, logs and your own worlds [default: the user's data folder]
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
}

pub(super) fn serve(arguments: &Arguments) -> Result<(), Failure> {
    let runtime = tokio::runtime::Runtime::new()?;
    runtime.block_on(serve_until_told(arguments))
}

async fn serve_until_told(arguments: &Arguments) -> Result<(), Failure> {
    let listener = bind(&arguments.listen).await?;
    let address = listener.local_addr()?;
    let data = arguments.data.clone().unwrap_or_else(default_data);
    let store = Store::open(&data)?;
    let catalog = Catalog::load(Some(&data.join("worlds")))?;
    let backend = Backend::from_environment().map_err(|e| Failure::Input(e.to_string()))?;
    let renderer = Renderer::start(backend);
    output::line(&format!(
        "Sonarium {}: sessions in {}, pictures drawn by {}",
        crate::build(),
        data.display(),
        renderer.backend_name()
    ))?;
    output::line(&format!(
        "Sonarium is ready: open {} in a browser and choose an experiment (Ctrl-C stops it)",
        page(address)
    ))?;
    let app = App { lab: Lab::new(catalog, store, cores()), frames: Frames::new(renderer) };
    Ok(api::serve(listener, app, told_to_stop()).await?)
}

async fn bind(listen: &str) -> Result<TcpListener, Failure> {
    TcpListener::bind(listen).await.map_err(|error| {
        let advice = match error.kind() {
            io::ErrorKind::AddrInUse => {
                "another program, perhaps another Sonarium, has this port; choose another, e.g. \
                 --listen 127.0.0.1:7381"
            }
            io::ErrorKind::PermissionDenied => "choose a port above 1023",
            _ => "give an address of this machine and a port, e.g. --listen 127.0.0.1:7380",
        };
        Failure::Input(format!("--listen {listen}: {error}; {advice}"))
    })
}

/// Where the page is, for a browser on this machine.
fn page(address: SocketAddr) -> String {
    if address.ip().is_unspecified() {
        return format!("http://localhost:{}", address.port());
    }
    format!("http://{address}")
}

/// Waits for Ctrl-C or a request to terminate.
async fn told_to_stop() {
    let interrupted = async {
        // Without a handler the signal ends the process the hard way, which costs a second of log.
        if tokio::signal::ctrl_c().await.is_err() {
            std::future::pending::<()>().await;
        }
    };
    #[cfg(unix)]
    let terminated = async {
        use tokio::signal::unix::{SignalKind, signal};
        match signal(SignalKind::terminate()) {
            Ok(mut terminate) => drop(terminate.recv().await),
            Err(_) => std::future::pending().await,
        }
    };
    #[cfg(not(unix))]
    let terminated = std::future::pending::<()>();
    tokio::select! {
        () = interrupted => {}
        () = terminated => {}
    }
}
